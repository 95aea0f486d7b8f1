// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/gluing.h"

#include "base/try.h"
#include "base/zigzag.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

Error invalid(const char* message) noexcept {
  return {.code = ErrorCode::kInvalidStream,
          .message = message,
          .rule = "CONN-11",
          .chunk_tag = kTagConnectivity};
}

}  // namespace

Result<void> check_glue_count(std::uint64_t count, std::uint32_t manifold_count, std::uint32_t vertex_count) {
  if (count > manifold_count) return invalid("more glued vertices than vertices");
  if (manifold_count - count > vertex_count) return invalid("more vertices than declared");
  return {};
}

Result<std::vector<std::uint32_t>> glue_vertices(const GlueList& list, std::uint32_t manifold_count,
                                                 std::uint32_t vertex_count) {
  DELTAMESH_CHECK(check_glue_count(list.gaps.size(), manifold_count, vertex_count));
  std::vector<std::uint32_t> vertex;
  vertex.reserve(manifold_count);
  std::uint32_t fresh = 0;
  std::uint32_t target = 0;
  for (std::size_t i = 0; i < list.gaps.size(); ++i) {
    if (list.gaps[i] >= manifold_count - vertex.size()) return invalid("glued vertex beyond the last");
    for (std::uint32_t k = 0; k < list.gaps[i]; ++k) vertex.push_back(fresh++);
    target += static_cast<std::uint32_t>(unzigzag(list.targets[i]));
    if (target >= fresh) return invalid("glued to a vertex yet to come");
    vertex.push_back(target);
  }
  while (vertex.size() < manifold_count) vertex.push_back(fresh++);
  return vertex;
}

void write_compact_gluing(CompactWriter& writer, const GlueList& list) {
  NumberModel counts;
  writer.number(static_cast<std::uint32_t>(list.gaps.size()), counts);
  NumberModel gaps;
  NumberModel targets;
  for (std::size_t i = 0; i < list.gaps.size(); ++i) {
    writer.number(list.gaps[i], gaps);
    writer.number(list.targets[i], targets);
  }
}

Result<GlueList> read_compact_gluing(CompactReader& reader, std::uint32_t manifold_count,
                                     std::uint32_t vertex_count) {
  NumberModel counts;
  const std::uint32_t count = reader.number(0, counts);
  DELTAMESH_CHECK(check_glue_count(count, manifold_count, vertex_count));
  GlueList list;
  NumberModel gaps;
  NumberModel targets;
  for (std::uint32_t i = 0; i < count && !reader.failed(); ++i) {
    list.gaps.push_back(reader.number(0, gaps));
    list.targets.push_back(reader.number(0, targets));
  }
  return list;
}

}  // namespace deltamesh
