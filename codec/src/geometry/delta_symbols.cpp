// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/delta_symbols.h"

#include <array>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/large_vector.h"
#include "base/thread_team.h"
#include "base/try.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "entropy/pair_reader.h"
#include "entropy/pair_writer.h"
#include "field/field_coder.h"
#include "field/large_field_coder.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

/// x of all vertices, then y, then z.
template <class Number>
struct Columns {
  Number* values;
  std::size_t rows;

  FieldNumbers at(std::uint32_t v) const noexcept {
    return {values[v], values[rows + v], values[2 * rows + v]};
  }
  void put(std::uint32_t v, const FieldNumbers& q) const noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) values[axis * rows + v] = q[axis];
  }
};

Error beyond_range() noexcept {
  return {.code = ErrorCode::kInvalidStream,
          .message = "a delta beyond 2^30 steps",
          .rule = "FLD-1",
          .chunk_tag = kTagDeltas};
}

std::vector<std::byte> write_small(const Columns<const std::int32_t>& deltas, const Adjacency& graph) {
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
                        const Columns<std::int32_t>& deltas) {
  CompactReader reader(payload);
  const auto n = static_cast<std::uint32_t>(deltas.rows);
  const std::uint32_t middle = middle_of(n);
  FieldCoder<CompactReader> field(reader, graph, middle);
  for (std::uint32_t v = 0; v < middle && !reader.failed(); ++v) {
    FieldNumbers q{};
    FieldNumbers p{};
    const bool is_last = middle + v == n;
    if (!(is_last ? field.code_vertex(v, q, 3) : field.code_pair(v, middle + v, q, p))) return beyond_range();
    deltas.put(v, q);
    if (!is_last) deltas.put(middle + v, p);
  }
  return reader.finish(kTagDeltas);
}

/// A part of a large field [FLD-9].
struct Part {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t middle() const noexcept { return begin + middle_of(end - begin); }
};

std::array<Part, 2> parts_of(std::size_t rows) noexcept {
  const auto n = static_cast<std::uint32_t>(rows);
  return {{{0, middle_of(n)}, {middle_of(n), n}}};
}

std::vector<std::byte> write_part(const Columns<const std::int32_t>& deltas, const Adjacency& graph,
                                  const Part& part) {
  PairWriter writer;
  writer.reserve(6 * std::size_t{part.end - part.begin});
  LargeFieldCoder field(writer, graph, part.begin, part.end);
  const std::uint32_t middle = part.middle();
  for (std::uint32_t v = 0; middle + v < part.end; ++v) {
    FieldNumbers q = deltas.at(part.begin + v);
    FieldNumbers p = deltas.at(middle + v);
    field.code_pair(part.begin + v, middle + v, q, p);
  }
  if ((part.end - part.begin) % 2 != 0) {
    FieldNumbers q = deltas.at(middle - 1);
    field.code_last(middle - 1, q);
  }
  return writer.finish();
}

Result<void> read_part(std::span<const std::byte> bytes, const Adjacency& graph, const Part& part,
                       const Columns<std::int32_t>& deltas) {
  PairReader reader(bytes);
  LargeFieldCoder field(reader, graph, part.begin, part.end);
  const std::uint32_t middle = part.middle();
  for (std::uint32_t v = 0; middle + v < part.end && !reader.failed(); ++v) {
    FieldNumbers q{};
    FieldNumbers p{};
    if (!field.code_pair(part.begin + v, middle + v, q, p)) return beyond_range();
    deltas.put(part.begin + v, q);
    deltas.put(middle + v, p);
  }
  if ((part.end - part.begin) % 2 != 0) {
    FieldNumbers q{};
    if (!field.code_last(middle - 1, q)) return beyond_range();
    deltas.put(middle - 1, q);
  }
  return reader.finish(kTagDeltas);
}

std::vector<std::byte> write_large(const Columns<const std::int32_t>& deltas, const Adjacency& graph) {
  const auto parts = parts_of(deltas.rows);
  const std::vector<std::byte> first = write_part(deltas, graph, parts[0]);
  const std::vector<std::byte> second = write_part(deltas, graph, parts[1]);
  ByteWriter out;
  out.write(std::uint64_t{first.size()});
  out.write_bytes(first);
  out.write_bytes(second);
  return out.take();
}

Result<void> read_large(std::span<const std::byte> payload, const Adjacency& graph,
                        const Columns<std::int32_t>& deltas) {
  ByteReader in(payload, kTagDeltas);
  DELTAMESH_TRY(const std::uint64_t first_size, in.read<std::uint64_t>());
  DELTAMESH_TRY(const auto first, in.read_bytes(first_size));
  const std::array<std::span<const std::byte>, 2> streams = {first, payload.subspan(in.position())};
  const auto parts = parts_of(deltas.rows);
  std::array<Result<void>, 2> are_read;
  share_work(2, [&](std::uint32_t i) { are_read[i] = read_part(streams[i], graph, parts[i], deltas); });
  for (const Result<void>& is_read : are_read) DELTAMESH_CHECK(is_read);
  return {};
}

bool is_large(const Adjacency& graph) noexcept { return graph.vertex_count() >= kFewestOfLargeField; }

}  // namespace

std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph) {
  const Columns<const std::int32_t> columns{deltas.data(), graph.vertex_count()};
  return is_large(graph) ? write_large(columns, graph) : write_small(columns, graph);
}

Result<std::vector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph) {
  std::vector<std::int32_t> deltas;
  reserve_large(deltas, 3 * graph.vertex_count());
  deltas.resize(3 * graph.vertex_count());
  const Columns<std::int32_t> columns{deltas.data(), graph.vertex_count()};
  DELTAMESH_CHECK(is_large(graph) ? read_large(payload, graph, columns) : read_small(payload, graph, columns));
  return deltas;
}

}  // namespace deltamesh
