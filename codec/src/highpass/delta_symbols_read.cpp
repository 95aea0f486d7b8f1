// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/broken_rule.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "field/field_coder.h"
#include "format/chunk/tags.h"
#include "highpass/delta_symbols.h"

namespace deltamesh {

Result<LargeVector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph) {
  const std::size_t n = graph.vertex_count();
  LargeVector<std::int32_t> deltas(3 * n);
  CompactReader reader(payload);
  FieldCoder<CompactReader> field(reader, graph);
  for (std::uint32_t v = 0; v < n && !reader.failed(); ++v) {
    FieldNumbers q{};
    if (!field.code_vertex(v, q)) return broken_rule("a delta beyond 2^30 steps", "FLD-1", kTagDeltas);
    for (std::size_t axis = 0; axis < q.size(); ++axis) deltas[axis * n + v] = q[axis];
  }
  DELTAMESH_CHECK(reader.finish(kTagDeltas));
  return deltas;
}

}  // namespace deltamesh
