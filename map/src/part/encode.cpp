// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "part/encode.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/encode.h"
#include "lattice/border_order.h"
#include "lattice/border_payload.h"
#include "lattice/known_base.h"
#include "lattice/place_border.h"
#include "lattice/source_colors.h"
#include "part/as_primer.h"
#include "part/measure.h"
#include "search/bracket.h"
#include "search/request.h"
#include "support/color_value.h"
#include "support/errors.h"

namespace deltamesh {
namespace {

/// Of the bounds, that a stream is asked for at least; 0.97 of what would just do; and how often.
constexpr double kFinestShare = 1.0 / 512;
constexpr double kAim = -0.044;
constexpr int kTrials = 2;

/// `share`: of the quality's bounds. Where nothing is said of colours they are exact: a part alone does not
/// tell labels from photographs.
EncodeOptions options_for(const MapDescription& description, const PartQuality& quality, double share = 1) {
  EncodeOptions options;
  options.grid = description.grid;
  options.quality = quality.bounds;
  for (auto* bound : {&options.quality.vde, &options.quality.lfe, &options.quality.max_error})
    if (*bound) (*bound)->value *= share;
  options.attributes = quality.attributes;
  if (!options.attributes.color_rms && !options.attributes.color_error) options.attributes.color_error = 0;
  options.geometry = quality.geometry;
  options.effort = quality.effort;
  return options;
}

Result<void> check_part(const MapPart& part, const MapDescription& description) {
  const MapLattice& lattice = description.lattice;
  if (part.key.level > kMostPartLevel) return invalid_mesh("a part's level is above 24");
  if (part.mesh.origin != lattice.origin) return invalid_mesh("a part's origin is not that of its map");
  if (part.mesh.triangles.empty()) return invalid_mesh("a part without faces");
  if (!std::ranges::equal(part.mesh.attributes, description.attributes,
                          [](const Attribute& a, const MapAttribute& b) {
                            return a.kind == b.kind && a.type == b.type && a.components == b.components &&
                                   a.normalized == b.normalized && a.name == b.name && a.linear == b.linear;
                          }))
    return invalid_mesh("a part's attributes are not those of its map");
  std::uint64_t least = 0;
  for (const BorderVertex& border : part.border) {
    if (border.vertex < least || border.vertex >= part.mesh.vertex_count())
      return invalid_mesh("border vertices that are not ascending vertices of the mesh", WhereKind::kVertex,
                          border.vertex);
    least = std::uint64_t{border.vertex} + 1;
    if (!std::ranges::all_of(
            border.point, [](std::int32_t x) { return x >= -kMostLatticeSteps && x <= kMostLatticeSteps; }))
      return invalid_mesh("a border vertex beyond the lattice", WhereKind::kVertex, border.vertex);
  }
  return {};
}

/// The largest, 255ths. `order`: the row of `source` for each of `decoded`.
double color_error(const Attribute& source, const Attribute& decoded, std::span<const std::uint32_t> order) {
  double most = 0;
  for (std::size_t v = 0; v < order.size(); ++v)
    most = std::max(most, color_difference(source, order[v], decoded, v));
  return most;
}

/// One way to code a part, and what a receiver gets.
struct PartCandidate {
  DecodedPart result;
  double load = 0;  ///< the worst achieved error over its bound
};

class PartEncoder {
 public:
  PartEncoder(const MapCodec::State& state, const MapPart& part, const PartQuality& quality,
              const PartUse& use)
      : state_(state),
        part_(part),
        quality_(quality),
        use_(use),
        measure_(part.mesh),
        rounded_(with_border_colors(part, quality.attributes)),
        source_(rounded_) {
    source_.origin = {};  // which all parts share
    if (use.base != nullptr) known_.emplace(*use.base);
    bounds_ = bounds_in_model_units(quality.bounds, measure_.geometric_count(), measure_.diagonal(),
                                    measure_.diagonal());
  }

  /// Border vertices are where their lattice points are, whatever was asked of the stream, so that it may
  /// have to be better than asked.
  Result<DecodedPart> run() {
    Bracket bracket({.first = 1,
                     .least = kFinestShare,
                     .most = 1,
                     .aim = kAim,
                     .tolerance = -std::numeric_limits<double>::infinity(),
                     .trials = kTrials});
    std::optional<PartCandidate> best;
    for (int i = 0; !bracket.is_done(); ++i) {
      EncodeOptions options = options_for(state_.description, quality_, bracket.setting());
      options.known = known();
      if (i > kTrials) options.geometry = GeometryCoder::kPredictive;
      DELTAMESH_TRY(PartCandidate candidate, code(options));
      if (bracket.tell(excess_of_load(candidate.load))) return std::move(candidate.result);
      if (!best || candidate.load < best->load) best = std::move(candidate);
    }
    const Quality& achieved = best->result.coded.quality;
    return Error{.code = ErrorCode::kUnmetRequest,
                 .message = "the map's lattice is too coarse for the quality asked of a part",
                 .rule = "MAP-8",
                 .best_value = bounds_.vde   ? achieved.vde_rms
                               : bounds_.lfe ? achieved.lfe_rms
                                             : achieved.max_error,
                 .best_bytes = best->result.coded.bytes.size()};
  }

 private:
  /// A part that is one of the primers costs no more than its number.
  Result<PartCandidate> code(EncodeOptions options) {
    for (std::size_t i = 0; !known_ && i < state_.primers.size(); ++i) {
      if (!may_be(state_.primers[i])) continue;
      options.starting_states = state_.models[i].start();
      DELTAMESH_TRY(Encoded encoded, encode(source_, options));
      if (encoded.bytes != state_.description.primers[i].stream) continue;
      DELTAMESH_TRY(PartCandidate candidate, finish(std::move(encoded), i));
      if (!candidate.result.coded.bytes.empty()) return candidate;
    }
    options.starting_states = state_.models.back().start();
    DELTAMESH_TRY(Encoded encoded, encode(source_, options));
    return finish(std::move(encoded), std::nullopt);
  }

  bool may_be(const StreamInfo& primer) const noexcept {
    return primer.triangles == part_.mesh.triangle_count() &&
           primer.geometric_vertices == measure_.geometric_count();
  }

  /// `primer`: which one `encoded` is, if any. No bytes where the border is not the primer's.
  Result<PartCandidate> finish(Encoded encoded, std::optional<std::size_t> primer) {
    const CodecModels& models = primer ? state_.models[*primer] : state_.models.back();
    DELTAMESH_TRY(Mesh decoded, decode(encoded.bytes, {.starting_states = models.start(), .known = known()}));
    auto border = border_in_order(part_, encoded.order);
    const MapLattice& lattice = state_.description.lattice;
    DELTAMESH_TRY(const BorderView view, view_border(encoded.bytes, decoded, lattice, use_.base));
    const auto payload = write_border(decoded, view, border, models.border,
                                      border_colors(part_.mesh, border, encoded.order, quality_.attributes));
    PartCandidate candidate;
    const PartPlace place = state_.place_of(part_.key, use_.base);
    if (primer && payload != state_.description.primers[*primer].border) return candidate;
    if (primer) {
      candidate.result.coded.bytes = write_primer_part(place, *primer);
    } else {
      DELTAMESH_TRY(candidate.result.coded.bytes, write_part(place, encoded.bytes, payload));
    }
    auto streamed_border = positions_of(decoded, border);
    place_border(decoded, border, lattice, view.follows);
    candidate.result.coded.quality = measure(decoded, encoded.order);
    candidate.load = bounds_.load(candidate.result.coded.quality);
    for (std::size_t i = 0; i < decoded.attributes.size(); ++i)
      candidate.result.coded.attribute_errors.push_back(
          is_color(decoded.attributes[i])
              ? color_error(part_.mesh.attributes[i], decoded.attributes[i], encoded.order)
              : encoded.report.stream.attributes[i].error);
    candidate.result.coded.color_rms = color_rms(part_.mesh, decoded, encoded.order);
    decoded.origin = lattice.origin;
    candidate.result.part = {part_.key, std::move(decoded), std::move(border), std::move(streamed_border)};
    candidate.result.order = std::move(encoded.order);
    candidate.result.is_grid = encoded.report.stream.geometry == "grid";
    return candidate;
  }

  Quality measure(const Mesh& decoded, std::span<const std::uint32_t> order) const {
    if (use_.is_joined.empty()) return measure_.compare(decoded.positions, order);
    std::vector<float> positions = decoded.positions;
    for (std::size_t v = 0; v < order.size(); ++v)
      for (std::size_t k = 0; use_.is_joined[order[v]] != 0 && k < 3; ++k)
        positions[3 * v + k] = part_.mesh.positions[3 * std::size_t{order[v]} + k];
    return measure_.compare(positions, order);
  }

  const KnownMesh* known() const noexcept { return known_ ? known_->mesh() : nullptr; }

  const MapCodec::State& state_;
  const MapPart& part_;
  const PartQuality& quality_;
  const PartUse& use_;
  std::optional<KnownBase> known_;
  PartMeasure measure_;
  Mesh rounded_;
  MeshView source_;
  Bounds bounds_;
};

}  // namespace

Result<MapPrimer> make_primer(const MapCodec& codec, const MapPart& part, const PartQuality& quality) {
  const MapCodec::State& state = codec.state();
  DELTAMESH_CHECK(check_part(part, state.description));
  const CodecModels& models = state.models.back();
  EncodeOptions options = options_for(state.description, quality);
  options.starting_states = models.start();
  const Mesh mesh = with_border_colors(part, quality.attributes);
  MeshView source(mesh);
  source.origin = {};
  DELTAMESH_TRY(Encoded encoded, encode(source, options));
  DELTAMESH_TRY(Mesh decoded, decode(encoded.bytes, {.starting_states = models.start()}));
  DELTAMESH_TRY(const BorderView view, view_border(encoded.bytes, decoded, state.description.lattice));
  const auto border = border_in_order(part, encoded.order);
  auto coded = write_border(decoded, view, border, models.border,
                            border_colors(part.mesh, border, encoded.order, quality.attributes));
  return MapPrimer{std::move(encoded.bytes), std::move(coded)};
}

Result<DecodedPart> encode_part(const MapCodec::State& state, const MapPart& part, const PartQuality& quality,
                                const PartUse& use) {
  if (quality.bounds.target_bytes)
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "a part cannot be asked for a number of bytes"};
  DELTAMESH_CHECK(check_part(part, state.description));
  DELTAMESH_TRY(DecodedPart result, PartEncoder(state, part, quality, use).run());
  if (result.coded.bytes.size() > kMostPartBytes)
    return Error{.code = ErrorCode::kLimitExceeded,
                 .message = "a part of more than 65536 bytes; split the map into smaller ones",
                 .rule = "MAP-7",
                 .best_bytes = result.coded.bytes.size()};
  return result;
}

Result<CodedPart> MapCodec::encode(const MapPart& part, const PartQuality& quality) const noexcept {
  return guarded([&]() -> Result<CodedPart> {
    DELTAMESH_TRY(DecodedPart result, encode_part(*state_, part, quality));
    return std::move(result.coded);
  });
}

}  // namespace deltamesh
