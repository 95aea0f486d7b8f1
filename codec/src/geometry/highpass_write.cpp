// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/try.h"
#include "base/zigzag.h"
#include "entropy/planes.h"
#include "geometry/anchor_list.h"
#include "geometry/cycle_plan.h"
#include "geometry/delta_symbols.h"
#include "geometry/diffusion.h"
#include "geometry/highpass.h"
#include "geometry/highpass_symbols.h"
#include "laplacian/anchors.h"
#include "laplacian/delta.h"

namespace deltamesh {
namespace {

/// Deltas of float32 positions carry no more than this many bits below the longest side.
constexpr int kFinestBits = 40;

/// Distance that is small against the rounding of positions to floats, over the longest side.
constexpr double kInvisible = 0x1p-26;

/// Deltas over the rows of `part`.
std::vector<Vec3> solved_deltas(const SolvedPart& part, std::span<const Vec3> positions) {
  if (part.is_whole()) return delta_coordinates(part.graph, positions);
  std::vector<Vec3> solved(part.row_count);
  for (std::size_t i = 0; i < solved.size(); ++i) solved[i] = positions[part.vertex(i)];
  return delta_coordinates(part.graph, solved);
}

double largest_component(std::span<const Vec3> deltas) noexcept {
  double largest = 0;
  for (const Vec3& delta : deltas)
    for (const double x : delta) largest = std::max(largest, std::abs(x));
  return largest;
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

HighpassCoder::HighpassCoder(const Adjacency& graph, const Components& components,
                             std::span<const Vec3> positions, const Box& box)
    : positions_(positions),
      box_(box),
      part_(extract_solved_part(graph, components)),
      deltas_(solved_deltas(part_, positions)),
      range_(delta_range(deltas_)),
      largest_(largest_component(deltas_)),
      solver_(part_) {}

double HighpassCoder::step_for_bits(int bits) const noexcept {
  const double finest = std::ldexp(box_.longest_side(), -kFinestBits);
  const double step = std::max(std::ldexp(range_, -bits), finest);
  return step > 0 ? step : 1.0;
}

/// Symbols chosen by price have other centroids than the nearest ones: theirs are found afterwards. Diffusion
/// must know the shift in advance, and takes that of the nearest.
Result<void> HighpassCoder::quantize(const HighpassSettings& settings) {
  if (quantized_.is_for(settings)) return {};
  quantized_ = {};
  const bool shifts_afterwards = settings.rate_weight > 0 && !(settings.diffusion > 0);
  DeltaQuantizer quantizer{.step = settings.step};
  if (settings.centroids && !shifts_afterwards)
    quantizer.shift = BinErrors(settings.step, deltas_).centroids();
  DELTAMESH_TRY(auto symbols,
                quantize_deltas(part_.graph, deltas_, quantizer, settings.diffusion, settings.rate_weight));
  if (settings.centroids && shifts_afterwards)
    quantizer.shift = BinErrors(settings.step, deltas_, symbols).centroids();
  quantized_ = {.step = settings.step,
                .rate_weight = settings.rate_weight,
                .diffusion = settings.diffusion,
                .centroids = settings.centroids,
                .symbols = std::move(symbols),
                .shift = quantizer.shift};
  return {};
}

double HighpassCoder::delta_error(const HighpassSettings& settings) {
  if (!(settings.diffusion > 0) && !(settings.rate_weight > 0)) {
    const BinErrors errors(settings.step, deltas_);
    if (!(errors.largest_symbol() <= kLargestSymbol)) return std::numeric_limits<double>::infinity();
    return errors.rms(settings.centroids ? errors.centroids() : ReconstructionShift{});
  }
  if (!quantize(settings)) return std::numeric_limits<double>::infinity();
  return BinErrors(settings.step, deltas_, quantized_.symbols).rms(quantized_.shift);
}

HighpassParameters HighpassCoder::parameters_for(const HighpassSettings& settings) const {
  return {.step = settings.step,
          .shift = quantized_.shift,
          .anchor_bits = static_cast<std::uint8_t>(settings.anchor_bits),
          .anchors = static_cast<std::uint32_t>(settings.anchors.vertices.size()),
          .anchor_density = settings.anchors.density};
}

HighpassSymbols HighpassCoder::symbols_for(const HighpassSettings& settings) const {
  HighpassSymbols symbols{.deltas = SymbolRows(quantized_.symbols), .anchors = settings.anchors.vertices};
  const AnchorLattice lattice(box_, settings.anchor_bits);
  symbols.cells.reserve(symbols.anchors.size());
  for (const std::uint32_t anchor : symbols.anchors)
    symbols.cells.push_back(lattice.cell_of(positions_[anchor]));
  return symbols;
}

Result<CodedHighpass> HighpassCoder::code_only(const HighpassSettings& settings) {
  DELTAMESH_CHECK(quantize(settings));
  const HighpassSymbols symbols = symbols_for(settings);
  const AnchorList list = list_anchors(symbols);
  return CodedHighpass{.parameters = parameters_for(settings),
                       .deltas = write_deltas(quantized_.symbols),
                       .compact_deltas = write_compact_deltas(quantized_.symbols, part_.graph),
                       .anchors = write_plain_anchors(list),
                       .compact_anchors = write_compact_anchors(list)};
}

Result<CodedHighpass> HighpassCoder::code(const HighpassSettings& settings) {
  DELTAMESH_TRY(CodedHighpass coded, code_only(settings));
  DELTAMESH_TRY(coded.positions,
                reconstruct_highpass(symbols_for(settings), part_, solver_, box_, coded.parameters));
  return coded;
}

Result<int> HighpassCoder::plan(const HighpassSettings& settings, std::span<const Vec3> settled,
                                const std::function<bool(std::span<const Vec3>)>& accepts) {
  solver_.forget();  // what settles takes other levels
  DELTAMESH_CHECK(quantize(settings));
  const HighpassSymbols symbols = symbols_for(settings);
  HighpassParameters parameters = parameters_for(settings);
  return fewest_half_cycles([&](int half_cycles) {
    parameters.half_cycles = static_cast<std::uint8_t>(half_cycles);
    const auto positions = reconstruct_highpass(symbols, part_, solver_, box_, parameters);
    return positions &&
           is_as_good(part_, positions_, settled, *positions, kInvisible * box_.longest_side()) &&
           accepts(*positions);
  });
}

Result<CodedHighpass> write_highpass(const Adjacency& graph, const Components& components,
                                     std::span<const Vec3> positions, const Box& box,
                                     const HighpassRequest& request) {
  HighpassCoder coder(graph, components, positions, box);
  HighpassSettings settings{.anchor_bits = request.anchor_bits};
  settings.step = request.step ? *request.step : coder.step_for_bits(*request.bits);
  settings.anchors =
      place_anchors(graph, components, {.count = request.anchors, .density = request.anchor_density});
  DELTAMESH_TRY(auto coded, coder.code(settings));
  const LargeVector<Vec3> settled = coded.positions;
  DELTAMESH_TRY(const int half_cycles, coder.plan(settings, settled, [&](std::span<const Vec3> planned) {
    coded.positions.assign(planned.begin(), planned.end());
    return true;
  }));
  coded.parameters.half_cycles = static_cast<std::uint8_t>(half_cycles);
  coded.parameters.bits = static_cast<std::uint8_t>(request.bits.value_or(0));
  return coded;
}

}  // namespace deltamesh
