// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/geometry_task.h"

#include <optional>

#include "base/try.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "search/bounds.h"
#include "search/highpass_trials.h"
#include "search/predictive_search.h"
#include "search/rate_control.h"

namespace deltamesh {
namespace {

constexpr int kDefaultBits = 8;
constexpr int kDefaultLatticeBits = 12;

Bounds bounds_of(const GeometryTask& task) {
  const SourceGeometry& source = task.source;
  return bounds_in_model_units(task.options.quality, source.positions.size(), source.box.diagonal());
}

/// Where no quality is asked for, 8 bits and one anchor for 200 vertices stand in for what is not said.
RateGoal rate_goal(const GeometryTask& task, std::optional<std::uint64_t> rival_bytes,
                   HighpassTrials& trials) {
  const EncodeOptions& options = task.options;
  RateGoal goal{.bounds = bounds_of(task),
                .target_bytes = options.quality.target_bytes,
                .step = options.step,
                .anchors = options.anchors,
                .anchor_bits = options.anchor_bits,
                .effort = options.effort,
                .rival_bytes = rival_bytes};
  if (options.bits) goal.step = trials.step_for_bits(*options.bits);
  if (options.anchor_density) goal.anchors = trials.anchors_for_density(*options.anchor_density);
  if (!options.quality.empty()) return goal;
  if (!goal.step) goal.step = trials.step_for_bits(kDefaultBits);
  if (!goal.anchors) goal.anchors = default_anchor_count(trials.most_anchors());
  return goal;
}

/// What is larger than the rival has no plan: it will not be written.
Result<CodedGeometry> search_highpass(const RateGoal& goal, HighpassTrials& trials) {
  DELTAMESH_TRY(const Attempt best, control_rate(goal, trials));
  if (goal.loses(best.figures.bytes, 1)) return HighpassTrials::geometry(best);
  return trials.plan(best, goal.bounds, goal.target_bytes);
}

/// `rival_bytes`: RateGoal::rival_bytes.
Result<CodedGeometry> code_highpass(const GeometryTask& task,
                                    std::optional<std::uint64_t> rival_bytes = std::nullopt) {
  const EncodeOptions& options = task.options;
  AnchorContainers own_containers;
  AnchorContainers& containers = options.anchor_containers ? *options.anchor_containers : own_containers;
  const SourceGeometry& source = task.source;
  const LazyGraph& graph = source.graph;
  AnchorSequence& sequence = containers.impl().sequence(graph.graph(), graph.components());
  HighpassCoder coder(graph.graph(), graph.components(), sequence, source.positions, source.box);
  const auto search = [&](HighpassCoder::Positions positions) {
    HighpassTrials trials(options, source, sequence, coder, task.rest, positions);
    return search_highpass(rate_goal(task, rival_bytes, trials), trials);
  };
  Result<CodedGeometry> found = search(HighpassCoder::Positions::kApproximate);
  if (found ? bounds_of(task).load(found->quality) > 1 : found.error().code == ErrorCode::kInvalidStream)
    found = search(HighpassCoder::Positions::kDecoded);
  DELTAMESH_TRY(CodedGeometry geometry, std::move(found));
  if (options.bits || (!options.step && options.quality.empty()))
    geometry.highpass.bits = static_cast<std::uint8_t>(options.bits.value_or(kDefaultBits));
  return geometry;
}

Result<CodedGeometry> code_predictive(const GeometryTask& task, const PredictiveTrials& trials) {
  const EncodeOptions& options = task.options;
  if (options.lossless) return trials.code_exactly();
  if (options.step) return trials.code_step(*options.step);
  if (options.quality.empty()) {
    const int bits = options.bits.value_or(kDefaultLatticeBits);
    DELTAMESH_TRY(auto choice, trials.code_step(trials.step_for_bits(bits)));
    choice.predictive.bits = static_cast<std::uint8_t>(bits);
    return choice;
  }
  const Bounds bounds = bounds_of(task);
  const auto& target = options.quality.target_bytes;
  if (!bounds.vde && !bounds.positional()) return fit_bytes(*target, trials);
  CodedGeometry choice = keep_bounds(bounds, trials);
  const std::uint64_t bytes = task.rest.bytes_with(choice);
  if (target && bytes > *target)
    return Error{.code = ErrorCode::kUnmetRequest,
                 .message = "the quality asked for needs more bytes than allowed",
                 .best_bytes = bytes};
  return choice;
}

/// Whether the request leaves the coder open.
bool may_choose(const EncodeOptions& options) noexcept {
  return options.geometry == GeometryCoder::kAuto && !options.quality.empty() && !options.bits &&
         !options.step && !options.anchors && !options.anchor_density &&
         options.profile == Profile::kSmallest;
}

/// Error::best_bytes.
std::optional<std::uint64_t> known_bytes(const Error& error) noexcept {
  return error.best_bytes > 0 ? std::optional(error.best_bytes) : std::nullopt;
}

/// Of the errors of two coders, the one to tell: that which comes nearer to the request, in fewer bytes.
Error nearer(const Error& a, const Error& b) noexcept {
  if (a.code != ErrorCode::kUnmetRequest) return b;
  if (b.code != ErrorCode::kUnmetRequest) return a;
  constexpr std::uint64_t kUnknown = ~std::uint64_t{0};
  return known_bytes(a).value_or(kUnknown) <= known_bytes(b).value_or(kUnknown) ? a : b;
}

/// How many bytes fewer the attributes take on the positions of `predictive` than on none.
Result<std::int64_t> attribute_gain(const GeometryTask& task, const CodedGeometry& predictive) {
  if (!task.attribute_bytes) return 0;
  DELTAMESH_TRY(const std::uint64_t on_none, task.attribute_bytes({}));
  DELTAMESH_TRY(const std::uint64_t on_these, task.attribute_bytes(predictive.positions));
  return static_cast<std::int64_t>(on_none) - static_cast<std::int64_t>(on_these);
}

/// Predictive coding is quick; so it comes first, and highpass need not go on where it cannot win. At effort
/// 0 statistics of the mesh say which of the two is tried.
Result<CodedGeometry> code_smaller(const GeometryTask& task) {
  const QualityRequest& quality = task.options.quality;
  const bool bytes_alone = !quality.vde && !quality.lfe && !quality.max_error;
  const PredictiveTrials trials(task.options, task.source, task.rest);
  const bool is_forecast = task.options.effort == 0 && !quality.target_bytes;
  if (is_forecast && !suits_predictive(bounds_of(task), trials)) {
    auto highpass = code_highpass(task);
    if (highpass) return highpass;
  }
  auto predictive = code_predictive(task, trials);
  if (is_forecast && predictive) return predictive;
  if (!predictive) {
    const Error& error = predictive.error();
    const bool too_many_bytes =
        !bytes_alone && error.code == ErrorCode::kUnmetRequest && !(error.best_value > 0);
    auto other = code_highpass(task, too_many_bytes ? known_bytes(error) : std::nullopt);
    return other ? std::move(other) : nearer(error, other.error());
  }
  const bool positional = (quality.lfe || quality.max_error) && !quality.vde;
  if (positional && task.options.effort <= kOnePassEffort) return predictive;  // mostly the smaller by far
  if (bytes_alone) {
    auto highpass = code_highpass(task);
    const bool better = !highpass || predictive->quality.vde_rms < highpass->quality.vde_rms;
    return better ? std::move(predictive) : std::move(highpass);
  }
  // What a highpass stream may take: attributes gain nothing from its positions.
  DELTAMESH_TRY(const std::int64_t gain, attribute_gain(task, *predictive));
  const std::int64_t rival_bytes = static_cast<std::int64_t>(task.rest.bytes_with(*predictive)) - gain;
  if (rival_bytes <= 0) return predictive;
  auto highpass = code_highpass(task, static_cast<std::uint64_t>(rival_bytes));
  if (!highpass) return predictive;
  const bool better = static_cast<std::uint64_t>(rival_bytes) < task.rest.bytes_with(*highpass);
  return better ? std::move(predictive) : std::move(highpass);
}

}  // namespace

Result<CodedGeometry> code_geometry(const GeometryTask& task) {
  const EncodeOptions& options = task.options;
  const auto code = [&]() -> Result<CodedGeometry> {
    if (options.geometry == GeometryCoder::kPredictive || options.lossless)
      return code_predictive(task, PredictiveTrials(options, task.source, task.rest));
    return may_choose(options) ? code_smaller(task) : code_highpass(task);
  };
  auto coded = code();
  // The stream of a finite mesh breaks a rule only where numbers leave the range of floats, or where so few
  // anchors hold so much that no solution is found.
  const bool leaves_range =
      coded ? !is_declarable(coded->quality) : coded.error().code == ErrorCode::kInvalidStream;
  if (leaves_range)
    return Error{.code = ErrorCode::kInvalidMesh,
                 .message =
                     "the coordinates are too large, or differ too much in size, for float32; or there are "
                     "too few anchors"};
  return coded;
}

}  // namespace deltamesh
