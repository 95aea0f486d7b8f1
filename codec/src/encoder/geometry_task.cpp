// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/geometry_task.h"

#include <optional>

#include "base/try.h"
#include "encoder/geometry_trials.h"
#include "encoder/predictive_trials.h"
#include "laplacian/anchor_sequence.h"
#include "quality/bounds.h"
#include "quality/rate_control.h"

namespace deltamesh {
namespace {

constexpr int kDefaultBits = 8;
constexpr int kDefaultLatticeBits = 12;

Bounds bounds_of(const GeometryTask& task) {
  const FileHeader& header = task.frame.header;
  return bounds_in_model_units(task.options.quality, header.geometric_vertices, header.box().diagonal());
}

RateGoal rate_goal(const GeometryTask& task, std::optional<std::uint64_t> rival_bytes,
                   GeometryTrials& trials) {
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
  return goal;
}

/// What bits, step, anchors and density say; 8 bits and one anchor for 200 vertices where they say nothing.
CoderSettings plain_settings(const EncodeOptions& options, GeometryTrials& trials) {
  CoderSettings settings{.centroids = false, .anchor_bits = options.anchor_bits};
  settings.step = options.step ? *options.step : trials.step_for_bits(options.bits.value_or(kDefaultBits));
  settings.anchors = default_anchor_count(trials.most_anchors());
  if (options.anchors) settings.anchors = *options.anchors;
  if (options.anchor_density) settings.anchors = trials.anchors_for_density(*options.anchor_density);
  return settings;
}

/// `rival_bytes`: RateGoal::rival_bytes. What is larger has no plan: it will not be written.
Result<GeometryChoice> code_highpass(const GeometryTask& task,
                                     std::optional<std::uint64_t> rival_bytes = std::nullopt) {
  const EncodeOptions& options = task.options;
  AnchorContainers own_containers;
  AnchorContainers& containers = options.anchor_containers ? *options.anchor_containers : own_containers;
  const Adjacency& graph = task.graph.graph();
  const Components& components = task.graph.components();
  AnchorSequence& sequence = containers.impl().sequence(graph, components);
  const GeometryInput input{graph, components, task.positions, task.frame.header.box(), sequence};
  GeometryTrials trials(input, task.frame);
  if (options.quality.empty()) {
    DELTAMESH_TRY([[maybe_unused]] const auto figures, trials.run(plain_settings(options, trials)));
    trials.keep();
  } else {
    DELTAMESH_CHECK(control_rate(rate_goal(task, rival_bytes, trials), trials));
  }
  GeometryChoice choice = trials.kept();
  const bool loses = rival_bytes && task.frame.bytes_with(choice) > *rival_bytes;
  if (!loses) choice = trials.plan_kept(bounds_of(task), options.quality.target_bytes);
  if (options.bits || (!options.step && options.quality.empty()))
    choice.highpass.bits = static_cast<std::uint8_t>(options.bits.value_or(kDefaultBits));
  return choice;
}

PredictiveTrials predictive_trials(const GeometryTask& task) {
  return {{task.triangles, task.graph, task.edges, task.positions, task.frame.header.box()},
          task.frame,
          task.options.effort};
}

Result<GeometryChoice> code_predictive(const GeometryTask& task, const PredictiveTrials& trials) {
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
  if (!bounds.vde && !bounds.positional()) return trials.fit_bytes(*target);
  DELTAMESH_TRY(auto choice, trials.keep_bounds(bounds));
  const std::uint64_t bytes = task.frame.bytes_with(choice);
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
Result<std::int64_t> attribute_gain(const GeometryTask& task, const GeometryChoice& predictive) {
  if (!task.attribute_bytes) return 0;
  DELTAMESH_TRY(const std::uint64_t on_none, task.attribute_bytes({}));
  DELTAMESH_TRY(const std::uint64_t on_these, task.attribute_bytes(predictive.positions));
  return static_cast<std::int64_t>(on_none) - static_cast<std::int64_t>(on_these);
}

/// Predictive coding is quick; so it comes first, and highpass need not go on where it cannot win. At effort
/// 0 statistics of the mesh say which of the two is tried.
Result<GeometryChoice> code_smaller(const GeometryTask& task) {
  const QualityRequest& quality = task.options.quality;
  const bool bytes_alone = !quality.vde && !quality.lfe && !quality.max_error;
  const PredictiveTrials trials = predictive_trials(task);
  const bool is_forecast = task.options.effort == 0 && !quality.target_bytes;
  if (is_forecast && !trials.suits(bounds_of(task))) {
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
    return better ? predictive : highpass;
  }
  // What a highpass stream may take: attributes gain nothing from its positions.
  DELTAMESH_TRY(const std::int64_t gain, attribute_gain(task, *predictive));
  const std::int64_t rival_bytes = static_cast<std::int64_t>(task.frame.bytes_with(*predictive)) - gain;
  if (rival_bytes <= 0) return predictive;
  auto highpass = code_highpass(task, static_cast<std::uint64_t>(rival_bytes));
  if (!highpass) return predictive;
  const bool better = static_cast<std::uint64_t>(rival_bytes) < task.frame.bytes_with(*highpass);
  return better ? predictive : highpass;
}

}  // namespace

Result<GeometryChoice> code_geometry(const GeometryTask& task) {
  if (task.options.geometry == GeometryCoder::kPredictive || task.options.lossless)
    return code_predictive(task, predictive_trials(task));
  return may_choose(task.options) ? code_smaller(task) : code_highpass(task);
}

}  // namespace deltamesh
