// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/highpass_trials.h"

#include <algorithm>

#include "base/try.h"
#include "format/vertex_positions.h"
#include "quality/error_peaks.h"
#include "quality/measure.h"

namespace deltamesh {
namespace {

/// Room for what planned cycles may add to the errors of settled ones that are to keep a bound.
constexpr double kPlanCost = 1.002;
/// Part of the bytes that they may add.
constexpr std::uint64_t kPlanByteShare = 500;

struct HighpassTrial final : CodedTrial {
  HighpassTrial(CodedGeometry coded, LargeVector<Vec3> positions)
      : geometry(std::move(coded)), settled(std::move(positions)) {}

  CodedGeometry geometry;
  LargeVector<Vec3> settled;  ///< n: without planned cycles
};

const HighpassTrial& trial_of(const Attempt& attempt) noexcept {
  return static_cast<const HighpassTrial&>(*attempt.figures.coded);
}

Quality after_planning(const Quality& settled) noexcept {
  return {.vde_rms = kPlanCost * settled.vde_rms,
          .lfe_rms = kPlanCost * settled.lfe_rms,
          .max_error = kPlanCost * settled.max_error};
}

}  // namespace

HighpassTrials::HighpassTrials(const EncodeOptions& options, const SourceGeometry& source,
                               AnchorSequence& anchors, const StreamRest& rest)
    : options_(options),
      source_(source),
      anchors_(anchors),
      rest_(rest),
      coder_(source.graph.graph(), source.graph.components(), anchors, source.positions, source.box) {}

Result<CodedGeometry> HighpassTrials::to_geometry(const CodedHighpass& coded) const {
  CodedGeometry geometry{.highpass = coded.parameters, .chunks = ChunkList(options_)};
  DELTAMESH_CHECK(geometry.chunks.add(kTagDeltas, coded.deltas, coded.compact_deltas));
  DELTAMESH_CHECK(geometry.chunks.add(kTagAnchors, coded.anchors, coded.compact_anchors));
  return geometry;
}

Result<TrialFigures> HighpassTrials::run(const HighpassSettings& settings) {
  DELTAMESH_TRY(CodedHighpass coded, coder_.code(settings));
  DELTAMESH_TRY(const auto decoded, to_float_positions(coded.positions));
  DELTAMESH_TRY(CodedGeometry geometry, to_geometry(coded));
  geometry.quality = measure_quality(source_.graph.graph(), source_.positions, decoded);
  if (!is_declarable(geometry.quality))
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "an error of the decoded positions is not a finite float32",
                 .rule = "HDR-9"};
  TrialFigures figures{.quality = after_planning(geometry.quality),
                       .bytes = rest_.bytes_with(geometry),
                       .density = geometry.highpass.anchor_density};
  figures.coded = std::make_shared<const HighpassTrial>(std::move(geometry), std::move(coded.positions));
  return figures;
}

const CodedGeometry& HighpassTrials::geometry(const Attempt& attempt) noexcept {
  return trial_of(attempt).geometry;
}

CodedGeometry HighpassTrials::plan(const Attempt& attempt, const Bounds& bounds,
                                   std::optional<std::uint64_t> most_bytes) {
  const HighpassTrial& trial = trial_of(attempt);
  const std::uint64_t hardly_more = attempt.figures.bytes + attempt.figures.bytes / kPlanByteShare;
  const std::uint64_t most = std::min(most_bytes.value_or(hardly_more), hardly_more);
  CodedGeometry geometry = trial.geometry;
  const auto accepts = [&](const CodedHighpass& coded) {
    const auto decoded = to_float_positions(coded.positions);
    if (!decoded) return false;
    const Quality quality = measure_quality(source_.graph.graph(), source_.positions, *decoded);
    if (!is_declarable(quality) || bounds.load(quality) > 1) return false;
    auto planned = to_geometry(coded);
    if (!planned || rest_.bytes_with(*planned) > most) return false;
    geometry = *std::move(planned);
    geometry.quality = quality;
    return true;
  };
  coder_.plan(attempt.settings, trial.settled, accepts);
  return geometry;
}

Result<std::uint64_t> HighpassTrials::bytes(const HighpassSettings& settings) {
  DELTAMESH_TRY(const CodedHighpass coded, coder_.code_only(settings));
  DELTAMESH_TRY(const CodedGeometry geometry, to_geometry(coded));
  return rest_.bytes_with(geometry);
}

std::vector<std::uint32_t> HighpassTrials::worst_vertices(const Attempt& attempt, double threshold,
                                                          std::size_t count) {
  const LargeVector<Vec3>& settled = trial_of(attempt).settled;
  std::vector<double> errors(settled.size());
  for (std::size_t v = 0; v < errors.size(); ++v) {
    Vec3 decoded = settled[v];
    for (double& x : decoded) x = static_cast<float>(x);
    errors[v] = length(decoded - source_.positions[v]);
  }
  std::vector<std::uint8_t> excluded(errors.size(), 0);
  for (const std::uint32_t anchor : coder_.anchors_for(attempt.settings).vertices) excluded[anchor] = 1;
  return error_peaks(source_.graph.graph(), errors, excluded, threshold, count);
}

std::uint32_t HighpassTrials::anchors_for_density(std::uint32_t density) {
  return anchors_.count_for_density(source_.graph.graph(), density);
}

}  // namespace deltamesh
