// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/delta_symbols.h"

#include "base/large_vector.h"
#include "base/try.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "field/field_coder.h"
#include "field/large_field_coder.h"
#include "format/tags.h"
#include "geometry/delta_columns.h"
#include "geometry/large_deltas.h"

namespace deltamesh {
namespace {

std::vector<std::byte> write_small(const DeltaColumns<const std::int32_t>& deltas, const Adjacency& graph) {
  CompactWriter writer;
  const auto n = static_cast<std::uint32_t>(deltas.rows);
  writer.reserve(9 * std::size_t{n});
  const std::uint32_t middle = middle_of(n);
  FieldCoder<CompactWriter> field(writer, graph, middle);
  for (std::uint32_t v = 0; v < middle; ++v) {
    FieldNumbers q = deltas.at(v);
    if (middle + v == n) {
      field.code_vertex(v, q, 3);
      break;
    }
    FieldNumbers p = deltas.at(middle + v);
    field.code_pair(v, middle + v, q, p);
  }
  return writer.finish();
}

Result<void> read_small(std::span<const std::byte> payload, const Adjacency& graph,
                        const DeltaColumns<std::int32_t>& deltas) {
  CompactReader reader(payload);
  const auto n = static_cast<std::uint32_t>(deltas.rows);
  const std::uint32_t middle = middle_of(n);
  FieldCoder<CompactReader> field(reader, graph, middle);
  for (std::uint32_t v = 0; v < middle && !reader.failed(); ++v) {
    FieldNumbers q{};
    FieldNumbers p{};
    const bool is_last = middle + v == n;
    if (!(is_last ? field.code_vertex(v, q, 3) : field.code_pair(v, middle + v, q, p)))
      return delta_beyond_range();
    deltas.put(v, q);
    if (!is_last) deltas.put(middle + v, p);
  }
  return reader.finish(kTagDeltas);
}

bool is_large(const Adjacency& graph) noexcept { return graph.vertex_count() >= kFewestOfLargeField; }

}  // namespace

std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph) {
  const DeltaColumns<const std::int32_t> columns{deltas.data(), graph.vertex_count()};
  return is_large(graph) ? write_large_deltas(columns, graph) : write_small(columns, graph);
}

Result<LargeVector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph) {
  LargeVector<std::int32_t> deltas(3 * graph.vertex_count());
  const DeltaColumns<std::int32_t> columns{deltas.data(), graph.vertex_count()};
  DELTAMESH_CHECK(is_large(graph) ? read_large_deltas(payload, graph, columns)
                                  : read_small(payload, graph, columns));
  return deltas;
}

}  // namespace deltamesh
