// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "base/zigzag.h"
#include "entropy/planes.h"
#include "geometry/anchor_list.h"
#include "geometry/delta_symbols.h"
#include "geometry/highpass.h"
#include "geometry/highpass_symbols.h"
#include "laplacian/anchors.h"
#include "laplacian/delta.h"

namespace deltamesh {
namespace {

constexpr double kLargestSymbol = 1 << 30;

/// Deltas of float32 positions carry no more than this many bits below the longest side.
constexpr int kFinestBits = 40;

/// Deltas over the rows of `part`.
std::vector<Vec3> solved_deltas(const SolvedPart& part, std::span<const Vec3> positions) {
  std::vector<Vec3> solved(part.vertices.size());
  for (std::size_t i = 0; i < solved.size(); ++i) solved[i] = positions[part.vertices[i]];
  return delta_coordinates(part.graph, solved);
}

/// Model units, above 0: range / 2^bits, or what was asked. A flat graph, all deltas equal, gets a step that
/// rounds nothing but noise.
double choose_step(const HighpassRequest& request, std::span<const Vec3> deltas, const Box& box) {
  if (request.step) return *request.step;
  const double step = std::ldexp(delta_range(deltas), -*request.bits);
  const double finest = std::ldexp(box.longest_side(), -kFinestBits);
  const double chosen = std::max(step, finest);
  return chosen > 0 ? chosen : 1.0;
}

Result<std::vector<std::int32_t>> quantize(std::span<const Vec3> deltas, double step) {
  std::vector<std::int32_t> symbols(3 * deltas.size());
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double rounded = std::round(deltas[i][axis] / step);
      if (!(std::abs(rounded) <= kLargestSymbol))
        return Error{.code = ErrorCode::kInvalidArgument,
                     .message = "the step is too small for this mesh: deltas exceed 2^30 steps"};
      symbols[axis * deltas.size() + i] = static_cast<std::int32_t>(rounded);
    }
  }
  return symbols;
}

std::vector<std::byte> write_deltas(std::span<const std::int32_t> deltas) {
  std::vector<std::uint32_t> codes(deltas.size());
  for (std::size_t i = 0; i < deltas.size(); ++i) codes[i] = zigzag(deltas[i]);
  ByteWriter out;
  write_planes(out, codes);
  return out.take();
}

AnchorList list_anchors(const HighpassSymbols& symbols) {
  const std::size_t count = symbols.anchors.size();
  AnchorList list{.gaps = std::vector<std::uint32_t>(count), .steps = std::vector<std::uint32_t>(3 * count)};
  std::uint32_t expected = 0;
  AnchorCell previous{};
  for (std::size_t i = 0; i < count; ++i) {
    list.gaps[i] = symbols.anchors[i] - expected;
    expected = symbols.anchors[i] + 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      list.steps[axis * count + i] =
          zigzag(static_cast<std::int32_t>(symbols.cells[i][axis] - previous[axis]));
    previous = symbols.cells[i];
  }
  return list;
}

}  // namespace

Result<CodedHighpass> write_highpass(const Adjacency& graph, const Components& components,
                                     std::span<const Vec3> positions, const Box& box,
                                     const HighpassRequest& request) {
  const SolvedPart part = extract_solved_part(graph, components);
  const std::vector<Vec3> deltas = solved_deltas(part, positions);
  CodedHighpass coded;
  HighpassParameters& parameters = coded.parameters;
  parameters.bits = static_cast<std::uint8_t>(request.bits.value_or(0));
  parameters.step = choose_step(request, deltas, box);
  parameters.anchor_bits = static_cast<std::uint8_t>(request.anchor_bits);

  HighpassSymbols symbols;
  DELTAMESH_TRY(symbols.deltas, quantize(deltas, parameters.step));
  Anchors anchors =
      place_anchors(graph, components, {.count = request.anchors, .density = request.anchor_density});
  parameters.anchors = static_cast<std::uint32_t>(anchors.vertices.size());
  parameters.anchor_density = anchors.density;
  symbols.anchors = std::move(anchors.vertices);
  const AnchorLattice lattice(box, request.anchor_bits);
  symbols.cells.reserve(symbols.anchors.size());
  for (const std::uint32_t anchor : symbols.anchors)
    symbols.cells.push_back(lattice.cell_of(positions[anchor]));

  coded.deltas = write_deltas(symbols.deltas);
  coded.compact_deltas = write_compact_deltas(symbols.deltas, part.graph);
  const AnchorList list = list_anchors(symbols);
  coded.anchors = write_plain_anchors(list);
  coded.compact_anchors = write_compact_anchors(list);
  DELTAMESH_TRY(coded.positions, reconstruct_highpass(symbols, part, box, parameters));
  return coded;
}

}  // namespace deltamesh
