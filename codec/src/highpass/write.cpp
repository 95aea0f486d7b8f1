// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "entropy/planes.h"
#include "highpass/anchor_list.h"
#include "highpass/delta_symbols.h"
#include "highpass/diffusion.h"
#include "highpass/highpass.h"
#include "highpass/symbols.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/operator/delta.h"

namespace deltamesh {
namespace {

/// Deltas of float32 positions carry no more than this many bits below the longest side.
constexpr int kFinestDeltaBits = 40;

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

HighpassCoder::HighpassCoder(const Adjacency& graph, const Components& components, AnchorSequence& anchors,
                             std::span<const Vec3> positions, const Box& box)
    : graph_(graph),
      anchors_(anchors),
      positions_(positions),
      box_(box),
      part_(extract_solved_part(graph, components)),
      deltas_(delta_coordinates(part_, positions)),
      range_(delta_range(deltas_)),
      largest_(largest_component(deltas_)),
      solver_(part_.graph, part_.components) {}

double HighpassCoder::step_for_bits(int bits) const noexcept {
  const double finest = std::ldexp(box_.longest_side(), -kFinestDeltaBits);
  const double step = std::max(std::ldexp(range_, -bits), finest);
  return step > 0 ? step : 1.0;
}

Anchors HighpassCoder::anchors_for(const HighpassSettings& settings) {
  Anchors anchors = anchors_.first(graph_, settings.anchors);
  if (settings.more_anchors.empty()) return anchors;
  std::vector<std::uint32_t>& all = anchors.vertices;
  all.insert(all.end(), settings.more_anchors.begin(), settings.more_anchors.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  anchors.density = hop_density(graph_, all);
  return anchors;
}

/// Symbols chosen by price have other centroids than the nearest ones: theirs are found afterwards. Diffusion
/// must know the shift in advance, and takes that of the nearest.
Result<HighpassCoder::Quantized> HighpassCoder::quantize(const HighpassSettings& settings,
                                                         std::span<const Vec3> deltas) const {
  const bool shifts_afterwards = settings.rate_weight > 0 && !(settings.diffusion > 0);
  DeltaQuantizer quantizer{.step = settings.step};
  if (settings.centroids && !shifts_afterwards)
    quantizer.shift = BinErrors(settings.step, deltas).centroids();
  DELTAMESH_TRY(auto symbols,
                quantize_deltas(part_.graph, deltas, quantizer, settings.diffusion, settings.rate_weight));
  if (settings.centroids && shifts_afterwards)
    quantizer.shift = BinErrors(settings.step, deltas, symbols).centroids();
  return Quantized{.settings = settings, .symbols = std::move(symbols), .shift = quantizer.shift};
}

Result<void> HighpassCoder::quantize_own(const HighpassSettings& settings) {
  if (quantized_.settings.has_same_deltas(settings)) return {};
  quantized_ = {};
  DELTAMESH_TRY(quantized_, quantize(settings, deltas_));
  return {};
}

double HighpassCoder::delta_error(const HighpassSettings& settings) {
  if (!(settings.diffusion > 0) && !(settings.rate_weight > 0)) {
    const BinErrors errors(settings.step, deltas_);
    if (!(errors.largest_symbol() <= kLargestSymbol)) return std::numeric_limits<double>::infinity();
    return errors.rms(settings.centroids ? errors.centroids() : ReconstructionShift{});
  }
  if (!quantize_own(settings)) return std::numeric_limits<double>::infinity();
  return BinErrors(settings.step, deltas_, quantized_.symbols).rms(quantized_.shift);
}

HighpassSymbols HighpassCoder::symbols_for(const Quantized& quantized, const Anchors& anchors,
                                           int anchor_bits, std::span<const Vec3> positions) const {
  HighpassSymbols symbols{.deltas = SymbolRows(quantized.symbols), .anchors = anchors.vertices};
  const AnchorLattice lattice(box_, anchor_bits);
  symbols.cells.reserve(symbols.anchors.size());
  for (const std::uint32_t anchor : symbols.anchors)
    symbols.cells.push_back(lattice.cell_of(positions[anchor]));
  return symbols;
}

CodedHighpass HighpassCoder::coded(const HighpassParameters& parameters, const Quantized& quantized,
                                   const HighpassSymbols& symbols) const {
  const AnchorList list = list_anchors(symbols);
  return {.parameters = parameters,
          .deltas = write_deltas(quantized.symbols),
          .compact_deltas = write_compact_deltas(quantized.symbols, part_.graph),
          .anchors = write_plain_anchors(list),
          .compact_anchors = write_compact_anchors(list)};
}

HighpassParameters HighpassCoder::parameters_for(const HighpassSettings& settings, const Anchors& anchors,
                                                 const ReconstructionShift& shift, int cycles) {
  return {.step = settings.step,
          .shift = shift,
          .anchor_bits = static_cast<std::uint8_t>(settings.anchor_bits),
          .anchors = static_cast<std::uint32_t>(anchors.vertices.size()),
          .anchor_density = anchors.density,
          .cycles = static_cast<std::uint8_t>(cycles)};
}

Result<CodedHighpass> HighpassCoder::code_only(const HighpassSettings& settings) {
  const Anchors anchors = anchors_for(settings);
  DELTAMESH_CHECK(quantize_own(settings));
  return coded(parameters_for(settings, anchors, quantized_.shift, 0), quantized_,
               symbols_for(quantized_, anchors, settings.anchor_bits, positions_));
}

Result<CodedHighpass> HighpassCoder::code(const HighpassSettings& settings, Positions positions) {
  const Anchors anchors = anchors_for(settings);
  DELTAMESH_CHECK(quantize_own(settings));
  const HighpassSymbols symbols = symbols_for(quantized_, anchors, settings.anchor_bits, positions_);
  CodedHighpass result = coded(parameters_for(settings, anchors, quantized_.shift, 0), quantized_, symbols);
  if (positions == Positions::kDecoded) {
    DELTAMESH_TRY(result.positions, reconstruct_highpass(symbols, part_, solver_, box_, result.parameters));
  } else {
    DELTAMESH_TRY(result.positions,
                  settle_from(positions_, deltas_, symbols, part_, solver_, box_, result.parameters));
  }
  return result;
}

}  // namespace deltamesh
