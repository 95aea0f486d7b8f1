// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/unmet.h"

#include "base/try.h"

namespace deltamesh {
namespace {

constexpr double kHopelessShare = 1.25;

Error unmet(const char* message, double best_value, std::uint64_t best_bytes) noexcept {
  return {.code = ErrorCode::kUnmetRequest,
          .message = message,
          .best_value = best_value,
          .best_bytes = best_bytes};
}

}  // namespace

Result<void> check_met(const Trials& trials) noexcept {
  const RateGoal& goal = trials.goal();
  if (const auto& best = trials.best()) {
    if (goal.target_bytes && best->figures.bytes > *goal.target_bytes)
      return unmet("the quality asked for needs more bytes than allowed", 0, best->figures.bytes);
    return {};
  }
  if (!trials.nearest()) return *trials.failure();
  const Bounds& bounds = goal.bounds;
  const TrialFigures& nearest = trials.nearest()->figures;
  const Quality& quality = nearest.quality;
  const double worst = bounds.load(quality);
  if (bounds.vde && bounds.visual_load(quality) >= worst)
    return unmet("the VDE asked for cannot be had for this mesh", quality.vde_rms, nearest.bytes);
  if (bounds.lfe && Bounds{.lfe = bounds.lfe}.load(quality) >= worst)
    return unmet("the LFE asked for cannot be had for this mesh", quality.lfe_rms, nearest.bytes);
  return unmet("the maximum error asked for cannot be had for this mesh", quality.max_error, nearest.bytes);
}

Result<void> check_rival(const HighpassSettings& settings, Trials& trials) {
  const RateGoal& goal = trials.goal();
  if (!goal.rival_bytes) return {};
  DELTAMESH_TRY(const std::uint64_t bytes, trials.coder().bytes(settings));
  if (!goal.loses(bytes, goal.effort <= kOnePassEffort ? 1 : kHopelessShare)) return {};
  return unmet("another coder makes a smaller stream", 0, bytes);
}

Error too_few_bytes(std::uint64_t bytes) noexcept {
  return unmet("no stream of this mesh is so small", 0, bytes);
}

}  // namespace deltamesh
