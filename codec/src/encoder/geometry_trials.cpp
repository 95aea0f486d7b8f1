// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/geometry_trials.h"

#include <algorithm>

#include "base/try.h"
#include "geometry/vertex_positions.h"
#include "laplacian/hop_density.h"
#include "quality/bounds.h"
#include "quality/error_peaks.h"
#include "quality/measure.h"

namespace deltamesh {
namespace {

/// Room for what planned cycles may add to the errors of settled ones that are to keep a bound.
constexpr double kPlanCost = 1.002;
/// Part of the bytes that they may add.
constexpr std::uint64_t kPlanByteShare = 500;

Quality after_planning(const Quality& settled) noexcept {
  return {.vde_rms = kPlanCost * settled.vde_rms,
          .lfe_rms = kPlanCost * settled.lfe_rms,
          .max_error = kPlanCost * settled.max_error};
}

}  // namespace

GeometryTrials::GeometryTrials(const GeometryInput& input, const StreamFrame& frame)
    : input_(input), frame_(frame), coder_(input.graph, input.components, input.positions, input.box) {}

HighpassSettings GeometryTrials::highpass_settings(const CoderSettings& settings) {
  HighpassSettings result{.step = settings.step,
                          .rate_weight = settings.rate_weight,
                          .diffusion = settings.diffusion,
                          .centroids = settings.centroids,
                          .anchors = input_.anchors.first(input_.graph, settings.anchors),
                          .anchor_bits = settings.anchor_bits};
  if (settings.more_anchors.empty()) return result;
  std::vector<std::uint32_t>& all = result.anchors.vertices;
  all.insert(all.end(), settings.more_anchors.begin(), settings.more_anchors.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  result.anchors.density = hop_density(input_.graph, all);
  return result;
}

Result<GeometryChoice> GeometryTrials::to_choice(const CodedHighpass& coded) const {
  GeometryChoice choice{.highpass = coded.parameters, .chunks = frame_.before.fresh()};
  DELTAMESH_CHECK(choice.chunks.add(kTagDeltas, coded.deltas, coded.compact_deltas));
  DELTAMESH_CHECK(choice.chunks.add(kTagAnchors, coded.anchors, coded.compact_anchors));
  return choice;
}

Result<TrialFigures> GeometryTrials::run(const CoderSettings& settings) {
  HighpassSettings highpass = highpass_settings(settings);
  DELTAMESH_TRY(CodedHighpass coded, coder_.code(highpass));
  LargeVector<Vec3> settled = std::move(coded.positions);
  DELTAMESH_TRY(const auto decoded, to_float_positions(settled));
  const Quality quality = measure_quality(input_.graph, input_.positions, decoded);
  if (!is_declarable(quality))
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "an error of the decoded positions is not a finite float32",
                 .rule = "HDR-9"};
  errors_.resize(decoded.size());
  for (std::size_t v = 0; v < decoded.size(); ++v) errors_[v] = length(decoded[v] - input_.positions[v]);
  DELTAMESH_TRY(GeometryChoice choice, to_choice(coded));
  choice.quality = quality;
  const TrialFigures figures{.quality = after_planning(quality),
                             .bytes = frame_.bytes_with(choice),
                             .density = choice.highpass.anchor_density};
  last_ = std::make_shared<const Trial>(
      Trial{.settings = std::move(highpass), .settled = std::move(settled), .choice = std::move(choice)});
  return figures;
}

GeometryChoice GeometryTrials::plan_kept(const Bounds& bounds, std::optional<std::uint64_t> most_bytes) {
  const std::uint64_t kept_bytes = frame_.bytes_with(kept_->choice);
  const std::uint64_t hardly_more = kept_bytes + kept_bytes / kPlanByteShare;
  const std::uint64_t most = std::min(most_bytes.value_or(hardly_more), hardly_more);
  GeometryChoice choice = kept_->choice;
  const auto accepts = [&](const CodedHighpass& coded) {
    const auto decoded = to_float_positions(coded.positions);
    if (!decoded) return false;
    const Quality quality = measure_quality(input_.graph, input_.positions, *decoded);
    if (!is_declarable(quality) || bounds.load(quality) > 1) return false;
    auto planned = to_choice(coded);
    if (!planned || frame_.bytes_with(*planned) > most) return false;
    choice = *std::move(planned);
    choice.quality = quality;
    return true;
  };
  coder_.plan(kept_->settings, kept_->settled, accepts);
  return choice;
}

Result<std::uint64_t> GeometryTrials::bytes(const CoderSettings& settings) {
  DELTAMESH_TRY(CodedHighpass coded, coder_.code_only(highpass_settings(settings)));
  DELTAMESH_TRY(const GeometryChoice choice, to_choice(coded));
  return frame_.bytes_with(choice);
}

double GeometryTrials::delta_error(const CoderSettings& settings) {
  return coder_.delta_error({.step = settings.step,
                             .rate_weight = settings.rate_weight,
                             .diffusion = settings.diffusion,
                             .centroids = settings.centroids});
}

std::vector<std::uint32_t> GeometryTrials::worst_vertices(double threshold, std::size_t count) {
  std::vector<std::uint8_t> excluded(errors_.size(), 0);
  for (const std::uint32_t anchor : last_->settings.anchors.vertices) excluded[anchor] = 1;
  return error_peaks(input_.graph, errors_, excluded, threshold, count);
}

std::uint32_t GeometryTrials::anchors_for_density(std::uint32_t density) {
  return input_.anchors.count_for_density(input_.graph, density);
}

}  // namespace deltamesh
