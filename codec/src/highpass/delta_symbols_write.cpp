// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/coder/writer.h"
#include "field/field_coder.h"
#include "highpass/delta_symbols.h"

namespace deltamesh {

std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph) {
  const std::size_t n = graph.vertex_count();
  CompactWriter writer;
  writer.reserve(9 * n);
  FieldCoder<CompactWriter> field(writer, graph);
  for (std::uint32_t v = 0; v < n; ++v) {
    FieldNumbers q = {deltas[v], deltas[n + v], deltas[2 * n + v]};
    field.code_vertex(v, q);
  }
  return writer.finish();
}

}  // namespace deltamesh
