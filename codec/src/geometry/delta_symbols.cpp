// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/delta_symbols.h"

#include "base/large_vector.h"
#include "base/try.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "field/field_coder.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

template <bool kLarge>
std::vector<std::byte> write_field(std::span<const std::int32_t> deltas, const Adjacency& graph) {
  CompactWriter writer;
  const auto n = static_cast<std::uint32_t>(graph.vertex_count());
  writer.reserve(9 * std::size_t{n});
  const std::uint32_t middle = middle_of(n);
  FieldCoder<CompactWriter, kLarge> field(writer, graph, middle);
  const auto at = [&](std::uint32_t v) {
    return FieldNumbers{deltas[v], deltas[std::size_t{n} + v], deltas[2 * std::size_t{n} + v]};
  };
  for (std::uint32_t v = 0; v < middle; ++v) {
    FieldNumbers q = at(v);
    if (middle + v == n) {
      field.code_vertex(v, q, 3);
      break;
    }
    FieldNumbers p = at(middle + v);
    field.code_pair(v, middle + v, q, p);
  }
  return writer.finish();
}

template <bool kLarge>
Result<std::vector<std::int32_t>> read_field(std::span<const std::byte> payload, const Adjacency& graph) {
  CompactReader reader(payload);
  const auto n = static_cast<std::uint32_t>(graph.vertex_count());
  const std::uint32_t middle = middle_of(n);
  FieldCoder<CompactReader, kLarge> field(reader, graph, middle);
  std::vector<std::int32_t> deltas;
  reserve_large(deltas, 3 * std::size_t{n});
  deltas.resize(3 * std::size_t{n});
  const auto put = [&](std::uint32_t v, const FieldNumbers& q) {
    for (std::size_t axis = 0; axis < 3; ++axis) deltas[axis * n + v] = q[axis];
  };
  for (std::uint32_t v = 0; v < middle && !reader.failed(); ++v) {
    FieldNumbers q{};
    FieldNumbers p{};
    const bool is_last = middle + v == n;
    if (!(is_last ? field.code_vertex(v, q, 3) : field.code_pair(v, middle + v, q, p)))
      return Error{.code = ErrorCode::kInvalidStream,
                   .message = "a delta beyond 2^30 steps",
                   .rule = "FLD-1",
                   .chunk_tag = kTagDeltas};
    put(v, q);
    if (!is_last) put(middle + v, p);
  }
  DELTAMESH_CHECK(reader.finish(kTagDeltas));
  return deltas;
}

bool is_large(const Adjacency& graph) noexcept { return graph.vertex_count() >= kFewestOfLargeField; }

}  // namespace

std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph) {
  return is_large(graph) ? write_field<true>(deltas, graph) : write_field<false>(deltas, graph);
}

Result<std::vector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph) {
  return is_large(graph) ? read_field<true>(payload, graph) : read_field<false>(payload, graph);
}

}  // namespace deltamesh
