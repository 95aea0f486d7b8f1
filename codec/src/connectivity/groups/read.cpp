// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/broken_rule.h"
#include "base/try.h"
#include "connectivity/groups/coder.h"
#include "connectivity/groups/groups.h"
#include "connectivity/plain_forms.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Errors: kTruncated, kInvalidStream [FGRP-1 .. 3, CMP-3].
Result<std::vector<std::uint32_t>> read_compact_groups(std::span<const std::byte> bytes,
                                                       std::span<const std::uint32_t> triangles,
                                                       std::uint32_t vertex_count) {
  std::vector<std::uint32_t> groups(triangles.size() / 3);
  CompactReader reader(bytes);
  const char* const broken = FaceGroupCoder<CompactReader>(reader, triangles, vertex_count).code(groups);
  if (reader.failed() || broken == nullptr) DELTAMESH_CHECK(reader.finish(kTagFaceGroups));
  if (broken != nullptr) return broken_rule("not the number of a group of faces", broken, kTagFaceGroups);
  return groups;
}

}  // namespace

Result<std::vector<std::uint32_t>> read_face_groups(Payload payload, std::span<const std::uint32_t> triangles,
                                                    std::uint32_t vertex_count) {
  if (payload.bytes.empty()) return std::vector<std::uint32_t>();
  if (payload.is_compact) return read_compact_groups(payload.bytes, triangles, vertex_count);
  return read_plain_groups(payload.bytes, static_cast<std::uint32_t>(triangles.size() / 3));
}

}  // namespace deltamesh
