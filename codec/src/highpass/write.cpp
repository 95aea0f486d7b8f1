// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "entropy/coder/writer.h"
#include "field/field_coder.h"
#include "highpass/compact.h"
#include "highpass/diffusion.h"
#include "highpass/highpass.h"
#include "highpass/plain/plain.h"
#include "highpass/symbols.h"
#include "laplacian/anchors/anchors.h"
#include "laplacian/operator/delta.h"

namespace deltamesh {
namespace {

/// Deltas of float32 positions carry no more than this many bits below the longest side.
constexpr int kFinestDeltaBits = 40;

/// Of compensation: each leaves a tenth or less.
constexpr int kMostRounds = 4;
/// Of the longest side: above it what is left out is more than rounding.
constexpr double kConverged = 0x1p-12;

double largest_component(std::span<const Vec3> deltas) noexcept {
  double largest = 0;
  for (const Vec3& delta : deltas)
    for (const double x : delta) largest = std::max(largest, std::abs(x));
  return largest;
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

std::vector<std::byte> write_compact_anchors(AnchorList list) {
  CompactWriter writer;
  code_anchors(writer, list);
  return writer.finish();
}

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

HighpassCoder::HighpassCoder(const Adjacency& graph, const Components& components, AnchorSequence& anchors,
                             std::span<const Vec3> positions, const Box& box, bool is_plain)
    : graph_(graph),
      anchors_(anchors),
      positions_(positions),
      box_(box),
      is_plain_(is_plain),
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
Result<void> HighpassCoder::quantize(const HighpassSettings& settings, std::span<const Vec3> deltas,
                                     Quantized& kept) const {
  if (kept.settings.has_same_deltas(settings)) return {};
  kept = {};
  const bool shifts_afterwards = settings.rate_weight > 0 && !(settings.diffusion > 0);
  DeltaQuantizer quantizer{.step = settings.step};
  if (settings.centroids && !shifts_afterwards)
    quantizer.shift = BinErrors(settings.step, deltas).centroids();
  DELTAMESH_TRY(auto symbols,
                quantize_deltas(part_.graph, deltas, quantizer, settings.diffusion, settings.rate_weight));
  if (settings.centroids && shifts_afterwards)
    quantizer.shift = BinErrors(settings.step, deltas, symbols).centroids();
  kept = {.settings = settings, .symbols = std::move(symbols), .shift = quantizer.shift};
  return {};
}

double HighpassCoder::delta_error(const HighpassSettings& settings) {
  if (!(settings.diffusion > 0) && !(settings.rate_weight > 0)) {
    const BinErrors errors(settings.step, deltas_);
    if (!(errors.largest_symbol() <= kLargestSymbol)) return std::numeric_limits<double>::infinity();
    return errors.rms(settings.centroids ? errors.centroids() : ReconstructionShift{});
  }
  if (!quantize(settings, deltas_, quantized_)) return std::numeric_limits<double>::infinity();
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

CodedHighpass HighpassCoder::coded(const HighpassParameters& parameters, Quantized& quantized,
                                   const HighpassSymbols& symbols) const {
  if (!quantized.payload)
    quantized.payload = is_plain_ ? write_plain_deltas(quantized.symbols)
                                  : write_compact_deltas(quantized.symbols, part_.graph);
  return {.parameters = parameters,
          .deltas = *quantized.payload,
          .anchors = is_plain_ ? write_plain_anchors(symbols.anchors, symbols.cells)
                               : write_compact_anchors(list_anchors(symbols))};
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
  DELTAMESH_CHECK(quantize(settings, deltas_, quantized_));
  return coded(parameters_for(settings, anchors, quantized_.shift, 1), quantized_,
               symbols_for(quantized_, anchors, settings.anchor_bits, positions_));
}

Compensation HighpassCoder::uncompensated() const {
  return {part_, positions_, middle(box_), AnchorLattice::cube_over(box_)};
}

std::vector<std::uint32_t> HighpassCoder::first_anchor_rows(const HighpassSettings& settings) {
  return anchor_rows(anchors_.first(graph_, settings.anchors).vertices, part_);
}

Result<double> HighpassCoder::left_out_by(const HighpassSettings& settings, int cycles) {
  std::vector<std::uint32_t> rows = first_anchor_rows(settings);
  if (!source_ || source_->cycles != cycles || source_->rows != rows) {
    source_.reset();
    source_ = Source{.rows = std::move(rows), .cycles = cycles, .compensation = uncompensated()};
  }
  if (source_->rounds == 0) {
    DELTAMESH_CHECK(compensate_once());
    source_->left_out_at_first = source_->left_out.largest;
  }
  return source_->left_out_at_first;
}

Result<void> HighpassCoder::compensate_once() {
  DELTAMESH_TRY(source_->left_out, source_->compensation.improve(solver_, source_->rows, source_->cycles));
  source_->quantized = {};
  ++source_->rounds;
  return {};
}

Result<void> HighpassCoder::compensate(const HighpassSettings& settings, int cycles) {
  DELTAMESH_TRY(const double left_out_at_first, left_out_by(settings, cycles));
  while (source_->rounds < kMostRounds && source_->left_out.largest > settings.step)
    DELTAMESH_CHECK(compensate_once());
  const double left_out = source_->left_out.largest;
  if (left_out > left_out_at_first && left_out > kConverged * box_.longest_side())
    return Error{
        .code = ErrorCode::kInvalidStream, .message = "planned cycles do not converge", .rule = "DELT-7"};
  return {};
}

Result<CodedHighpass> HighpassCoder::code(const HighpassSettings& settings, int cycles) {
  DELTAMESH_CHECK(compensate(settings, cycles));
  DELTAMESH_CHECK(quantize(settings, source_->compensation.deltas(), source_->quantized));
  Quantized& quantized = source_->quantized;
  const Anchors anchors = anchors_for(settings);
  const HighpassSymbols symbols =
      symbols_for(quantized, anchors, settings.anchor_bits, source_->compensation.positions());
  CodedHighpass result =
      coded(parameters_for(settings, anchors, quantized.shift, cycles), quantized, symbols);
  DELTAMESH_TRY(result.positions, reconstruct_highpass(symbols, part_, solver_, box_, result.parameters));
  return result;
}

Result<CodedHighpass> HighpassCoder::code(const HighpassSettings& settings) {
  DELTAMESH_TRY(const int cycles, fewest_cycles(settings, std::numeric_limits<double>::infinity()));
  return code(settings, cycles);
}

}  // namespace deltamesh
