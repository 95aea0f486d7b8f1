// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/broken_rule.h"
#include "base/try.h"
#include "connectivity/groups/coder.h"
#include "connectivity/groups/groups.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
Result<std::vector<std::uint32_t>> read_face_groups(std::span<const std::byte> payload,
                                                    std::span<const std::uint32_t> triangles,
                                                    std::uint32_t vertex_count) {
  if (payload.empty()) return std::vector<std::uint32_t>();
  std::vector<std::uint32_t> groups(triangles.size() / 3);
  CompactReader reader(payload);
  const char* const broken = FaceGroupCoder<CompactReader>(reader, triangles, vertex_count).code(groups);
  if (reader.failed() || broken == nullptr) DELTAMESH_CHECK(reader.finish(kTagFaceGroups));
  if (broken != nullptr) return broken_rule("not the number of a group of faces", broken, kTagFaceGroups);
  return groups;
}

}  // namespace deltamesh
