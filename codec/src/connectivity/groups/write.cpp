// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/groups/coder.h"
#include "connectivity/groups/groups.h"
#include "entropy/coder/writer.h"

namespace deltamesh {

std::vector<std::byte> write_face_groups(std::vector<std::uint32_t> groups,
                                         std::span<const std::uint32_t> triangles,
                                         std::uint32_t vertex_count) {
  if (groups.empty()) return {};
  CompactWriter writer;
  FaceGroupCoder<CompactWriter>(writer, triangles, vertex_count).code(groups);
  return writer.finish();
}

}  // namespace deltamesh
