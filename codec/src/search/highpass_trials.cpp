// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/highpass_trials.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/try.h"
#include "format/vertex_positions.h"
#include "measure/error_peaks.h"
#include "measure/measure.h"

namespace deltamesh {
namespace {

/// Room for what planned cycles may add to the errors of settled ones that are to keep a bound.
constexpr double kPlanCost = 1.002;
/// Part of the bytes that they may add; and with anchors at what would be too large errors.
constexpr std::uint64_t kPlanByteShare = 500;
constexpr std::uint64_t kPeaksByteShare = 64;

/// Cycles that are tried there, and how often anchors are added for each.
constexpr std::array<int, 3> kPeaksCycles{4, 6, 8};
constexpr int kPeaksRounds = 10;
constexpr std::uint64_t kBytesPerAnchor = 4;  ///< at least
/// Of the largest error asked for, where anchors are added.
constexpr double kPeak = 0.97;

struct HighpassTrial final : CodedTrial {
  HighpassTrial(CodedGeometry coded, LargeVector<Vec3> positions)
      : geometry(std::move(coded)), settled(std::move(positions)) {}

  CodedGeometry geometry;
  LargeVector<Vec3> settled;  ///< n: without planned cycles, about
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
                               AnchorSequence& anchors, HighpassCoder& coder, const StreamRest& rest,
                               HighpassCoder::Positions positions)
    : options_(options),
      source_(source),
      anchors_(anchors),
      rest_(rest),
      coder_(coder),
      positions_(positions) {}

Result<CodedGeometry> HighpassTrials::to_geometry(const CodedHighpass& coded) const {
  CodedGeometry geometry{.highpass = coded.parameters, .chunks = ChunkList(options_)};
  DELTAMESH_CHECK(geometry.chunks.add(kTagDeltas, coded.deltas, coded.compact_deltas));
  DELTAMESH_CHECK(geometry.chunks.add(kTagAnchors, coded.anchors, coded.compact_anchors));
  return geometry;
}

Result<CodedGeometry> HighpassTrials::measured(const CodedHighpass& coded) const {
  DELTAMESH_TRY(const auto decoded, to_float_positions(coded.positions));
  DELTAMESH_TRY(CodedGeometry geometry, to_geometry(coded));
  geometry.quality = measure_quality(source_.graph.graph(), source_.positions, decoded);
  if (!is_declarable(geometry.quality))
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "an error of the decoded positions is not a finite float32",
                 .rule = "HDR-9"};
  return geometry;
}

Result<TrialFigures> HighpassTrials::run(const HighpassSettings& settings) {
  DELTAMESH_TRY(CodedHighpass coded, coder_.code(settings, positions_));
  DELTAMESH_TRY(CodedGeometry geometry, measured(coded));
  TrialFigures figures{.quality = after_planning(geometry.quality),
                       .bytes = rest_.bytes_with(geometry),
                       .density = geometry.highpass.anchor_density};
  figures.coded = std::make_shared<const HighpassTrial>(std::move(geometry), std::move(coded.positions));
  return figures;
}

const CodedGeometry& HighpassTrials::geometry(const Attempt& attempt) noexcept {
  return trial_of(attempt).geometry;
}

std::optional<CodedGeometry> HighpassTrials::fitting(const CodedHighpass& coded, const Bounds& bounds,
                                                     std::uint64_t most_bytes) const {
  const auto decoded = to_float_positions(coded.positions);
  if (!decoded) return std::nullopt;
  const Quality quality = measure_quality(source_.graph.graph(), source_.positions, *decoded);
  if (!is_declarable(quality) || bounds.load(quality) > 1) return std::nullopt;
  auto geometry = to_geometry(coded);
  if (!geometry || rest_.bytes_with(*geometry) > most_bytes) return std::nullopt;
  geometry->quality = quality;
  return *std::move(geometry);
}

std::optional<CodedGeometry> HighpassTrials::plan_peaks(HighpassSettings settings, const Bounds& bounds,
                                                        std::uint64_t bytes, std::uint64_t most_bytes) {
  const std::vector<std::uint32_t> anchors = settings.more_anchors;
  for (const int cycles : kPeaksCycles) {
    settings.more_anchors = anchors;
    const std::uint64_t more_bytes = most_bytes - std::min(bytes, most_bytes);
    auto room = static_cast<std::size_t>(
        std::min<std::uint64_t>(more_bytes / kBytesPerAnchor, source_.positions.size()));
    for (int round = 0; round < kPeaksRounds; ++round) {
      const auto coded = coder_.code_planned(settings, cycles);
      if (!coded) break;
      if (auto geometry = fitting(*coded, bounds, most_bytes)) return geometry;
      if (round + 1 == kPeaksRounds) break;
      const auto worst = peaks(settings, coded->positions, kPeak * *bounds.max_error, room + 1);
      if (worst.empty() || worst.size() > room) break;
      room -= worst.size();
      settings.more_anchors.insert(settings.more_anchors.end(), worst.begin(), worst.end());
    }
  }
  return std::nullopt;
}

/// Where anchors were added at the largest errors, deltas that are rounded anew would have them elsewhere:
/// then plan_peaks().
Result<CodedGeometry> HighpassTrials::plan(const Attempt& attempt, const Bounds& bounds,
                                           std::optional<std::uint64_t> most_bytes) {
  const HighpassTrial& trial = trial_of(attempt);
  const auto most = [&](std::uint64_t share) {
    const std::uint64_t hardly_more = attempt.figures.bytes + attempt.figures.bytes / share;
    return std::min(most_bytes.value_or(hardly_more), hardly_more);
  };
  std::optional<CodedGeometry> planned;
  if (bounds.max_error && !attempt.settings.more_anchors.empty()) {
    planned = plan_peaks(attempt.settings, bounds, attempt.figures.bytes, most(kPeaksByteShare));
  } else {
    coder_.plan(attempt.settings, trial.settled, [&](const CodedHighpass& coded) {
      planned = fitting(coded, bounds, most(kPlanByteShare));
      return planned.has_value();
    });
  }
  if (planned) return *std::move(planned);
  if (positions_ == HighpassCoder::Positions::kDecoded) return trial.geometry;
  DELTAMESH_TRY(const CodedHighpass coded, coder_.code(attempt.settings));
  return measured(coded);
}

Result<std::uint64_t> HighpassTrials::bytes(const HighpassSettings& settings) {
  DELTAMESH_TRY(const CodedHighpass coded, coder_.code_only(settings));
  DELTAMESH_TRY(const CodedGeometry geometry, to_geometry(coded));
  return rest_.bytes_with(geometry);
}

std::vector<std::uint32_t> HighpassTrials::worst_vertices(const Attempt& attempt, double threshold,
                                                          std::size_t count) {
  return peaks(attempt.settings, trial_of(attempt).settled, threshold, count);
}

std::vector<std::uint32_t> HighpassTrials::peaks(const HighpassSettings& settings,
                                                 std::span<const Vec3> positions, double threshold,
                                                 std::size_t count) {
  std::vector<double> errors(positions.size());
  for (std::size_t v = 0; v < errors.size(); ++v) {
    Vec3 decoded = positions[v];
    for (double& x : decoded) x = static_cast<float>(x);
    errors[v] = length(decoded - source_.positions[v]);
  }
  std::vector<std::uint8_t> excluded(errors.size(), 0);
  for (const std::uint32_t anchor : coder_.anchors_for(settings).vertices) excluded[anchor] = 1;
  return error_peaks(source_.graph.graph(), errors, excluded, threshold, count);
}

std::uint32_t HighpassTrials::anchors_for_density(std::uint32_t density) {
  return anchors_.count_for_density(source_.graph.graph(), density);
}

}  // namespace deltamesh
