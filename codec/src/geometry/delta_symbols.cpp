// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/delta_symbols.h"

#include "base/try.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "field/field_coder.h"
#include "format/tags.h"

namespace deltamesh {

std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph) {
  CompactWriter writer;
  FieldCoder field(writer, graph);
  const std::size_t n = graph.vertex_count();
  for (std::uint32_t v = 0; v < n; ++v) {
    std::array<std::int32_t, 3> q = {deltas[v], deltas[n + v], deltas[2 * n + v]};
    field.code_vertex(v, q, 3);
  }
  return writer.finish();
}

Result<std::vector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph) {
  CompactReader reader(payload);
  FieldCoder field(reader, graph);
  const std::size_t n = graph.vertex_count();
  std::vector<std::int32_t> deltas(3 * n);
  for (std::uint32_t v = 0; v < n && !reader.failed(); ++v) {
    std::array<std::int32_t, 3> q{};
    if (!field.code_vertex(v, q, 3))
      return Error{.code = ErrorCode::kInvalidStream,
                   .message = "a delta beyond 2^30 steps",
                   .rule = "FLD-1",
                   .chunk_tag = kTagDeltas};
    for (std::size_t axis = 0; axis < 3; ++axis) deltas[axis * n + v] = q[axis];
  }
  DELTAMESH_CHECK(reader.finish(kTagDeltas));
  return deltas;
}

}  // namespace deltamesh
