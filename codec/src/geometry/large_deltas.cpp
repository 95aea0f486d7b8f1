// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/large_deltas.h"

#include <array>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/thread_team.h"
#include "base/try.h"
#include "entropy/pair_reader.h"
#include "entropy/pair_writer.h"
#include "field/large_field_coder.h"

namespace deltamesh {
namespace {

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

std::vector<std::byte> write_part(const DeltaColumns<const std::int32_t>& deltas, const Adjacency& graph,
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

/// From `payload`, from `begin` on `size` bytes.
Result<void> read_part(std::span<const std::byte> payload, std::size_t begin, std::size_t size,
                       const Adjacency& graph, const Part& part, const DeltaColumns<std::int32_t>& deltas) {
  const PairBytes bytes(payload.subspan(begin, size));
  PairReader reader(bytes);
  LargeFieldCoder field(reader, graph, part.begin, part.end);
  const std::uint32_t middle = part.middle();
  for (std::uint32_t v = 0; middle + v < part.end && !reader.failed(); ++v) {
    FieldNumbers q{};
    FieldNumbers p{};
    if (!field.code_pair(part.begin + v, middle + v, q, p)) return delta_beyond_range();
    deltas.put(part.begin + v, q);
    deltas.put(middle + v, p);
  }
  if ((part.end - part.begin) % 2 != 0 && !reader.failed()) {
    FieldNumbers q{};
    if (!field.code_last(middle - 1, q)) return delta_beyond_range();
    deltas.put(middle - 1, q);
  }
  return reader.finish(kTagDeltas, begin);
}

}  // namespace

std::vector<std::byte> write_large_deltas(const DeltaColumns<const std::int32_t>& deltas,
                                          const Adjacency& graph) {
  const auto parts = parts_of(deltas.rows);
  const std::vector<std::byte> first = write_part(deltas, graph, parts[0]);
  const std::vector<std::byte> second = write_part(deltas, graph, parts[1]);
  ByteWriter out;
  out.write(std::uint64_t{first.size()});
  out.write_bytes(first);
  out.write_bytes(second);
  return out.take();
}

Result<void> read_large_deltas(std::span<const std::byte> payload, const Adjacency& graph,
                               const DeltaColumns<std::int32_t>& deltas) {
  ByteReader in(payload, kTagDeltas);
  DELTAMESH_TRY(const std::uint64_t first_size, in.read<std::uint64_t>());
  const std::size_t begin = in.position();
  DELTAMESH_TRY(const auto first, in.read_bytes(first_size));
  const std::array<std::size_t, 3> begins = {begin, begin + first.size(), payload.size()};
  const auto parts = parts_of(deltas.rows);
  std::array<Result<void>, 2> are_read;
  share_work(2, [&](std::uint32_t i) {
    are_read[i] = read_part(payload, begins[i], begins[i + 1] - begins[i], graph, parts[i], deltas);
  });
  for (const Result<void>& is_read : are_read) DELTAMESH_CHECK(is_read);
  return {};
}

}  // namespace deltamesh
