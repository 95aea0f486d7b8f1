// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/highpass_trials.h"

#include <algorithm>
#include <utility>

#include "base/try.h"
#include "format/vertex_positions.h"
#include "measure/error_peaks.h"
#include "measure/measure.h"
#include "search/bounds.h"

namespace deltamesh {
namespace {

struct HighpassTrial final : CodedTrial {
  HighpassTrial(CodedGeometry coded, LargeVector<Vec3> decoded)
      : geometry(std::move(coded)), positions(std::move(decoded)) {}

  CodedGeometry geometry;
  LargeVector<Vec3> positions;  ///< n
};

const HighpassTrial& trial_of(const Attempt& attempt) noexcept {
  return static_cast<const HighpassTrial&>(*attempt.figures.coded);
}

}  // namespace

HighpassTrials::HighpassTrials(const EncodeOptions& options, const SourceGeometry& source,
                               AnchorSequence& anchors, HighpassCoder& coder, const StreamRest& rest,
                               double most_left_out)
    : options_(options),
      source_(source),
      anchors_(anchors),
      rest_(rest),
      coder_(coder),
      most_left_out_(most_left_out) {}

Result<CodedGeometry> HighpassTrials::to_geometry(const CodedHighpass& coded) const {
  CodedGeometry geometry{.highpass = coded.parameters, .chunks = ChunkList(options_)};
  geometry.chunks.add(kTagDeltas, coded.deltas);
  geometry.chunks.add(kTagAnchors, coded.anchors);
  return geometry;
}

Result<TrialFigures> HighpassTrials::run(const HighpassSettings& settings) {
  if (cycles_ == 0 || settings.anchors != anchors_of_cycles_) {
    cycles_ = coder_.fewest_cycles(settings, most_left_out_, std::max(cycles_ - 1, 1));
    anchors_of_cycles_ = settings.anchors;
  }
  DELTAMESH_TRY(CodedHighpass coded, coder_.code(settings, cycles_));
  DELTAMESH_TRY(const auto decoded, to_float_positions(coded.positions));
  DELTAMESH_TRY(CodedGeometry geometry, to_geometry(coded));
  geometry.quality = measure_quality(source_.graph.graph(), source_.positions, decoded);
  if (!is_declarable(geometry.quality))
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "an error of the decoded positions is not a finite float32",
                 .rule = "HDR-9"};
  TrialFigures figures{.quality = geometry.quality,
                       .bytes = rest_.bytes_with(geometry),
                       .density = geometry.highpass.anchor_density};
  figures.coded = std::make_shared<const HighpassTrial>(std::move(geometry), std::move(coded.positions));
  return figures;
}

const CodedGeometry& HighpassTrials::geometry(const Attempt& attempt) noexcept {
  return trial_of(attempt).geometry;
}

Result<std::uint64_t> HighpassTrials::bytes(const HighpassSettings& settings) {
  DELTAMESH_TRY(const CodedHighpass coded, coder_.code_only(settings));
  DELTAMESH_TRY(const CodedGeometry geometry, to_geometry(coded));
  return rest_.bytes_with(geometry);
}

std::vector<std::uint32_t> HighpassTrials::worst_vertices(const Attempt& attempt, double threshold,
                                                          std::size_t count) {
  const std::span<const Vec3> positions = trial_of(attempt).positions;
  std::vector<double> errors(positions.size());
  for (std::size_t v = 0; v < errors.size(); ++v) {
    Vec3 decoded = positions[v];
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
