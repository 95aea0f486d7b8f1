// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Settings of the highpass coder that a request or a step's effect on the deltas tells: no solve is needed.
#pragma once

#include "search/highpass_trials.h"

namespace deltamesh {

/// One anchor for so many vertices: with fewer, what is saved is under 0.1 bits per vertex of a VDE; near
/// what is best on open maps of an LFE and a largest error.
inline constexpr std::uint32_t kForVde = 500;
inline constexpr std::uint32_t kForLfe = 200;
inline constexpr std::uint32_t kForMaxError = 50;

/// One for so many vertices, within what the mesh allows.
std::uint32_t usual_anchors(std::uint32_t vertices_per_anchor, HighpassTrials& trials);

/// What `request` says, and where it says nothing, what a search starts from.
HighpassSettings first_settings(const Request& request, HighpassTrials& trials);

/// VDE over the delta error, within a few per cent on every mesh and at every rate (Table 1: one more bit
/// halves both).
inline constexpr double kVdePerDeltaError = 0.76;

/// From here on all symbols are 0.
double coarsest_step(HighpassTrials& trials);
/// The least that makes sense: below, float32 positions or symbols end.
double finest_step(HighpassTrials& trials);

/// HighpassTrials::delta_error without diffusion, whose cost is a factor.
double plain_delta_error(HighpassSettings settings, double step, HighpassTrials& trials);

/// The step at which plain_delta_error() is `wanted`, all else as in `settings`; at most coarsest_step(). A
/// few delta errors' cost.
double step_for_delta_error(const HighpassSettings& settings, double wanted, HighpassTrials& trials);

/// With the step for `vde`. Below 7 bits of the range symbols are chosen by rate too, which saves 1 to 7 % of
/// the deltas' bytes; above, the nearest symbols are best.
HighpassSettings settings_for_vde(HighpassSettings settings, double vde, HighpassTrials& trials);

struct BudgetStep {
  double step = 0;
  bool fits = false;
  std::uint64_t fewest_bytes = 0;  ///< of the streams tried
};

/// The finest step whose stream has at most `budget` bytes, all else as in `settings`. Some 10 codings.
Result<BudgetStep> step_for_bytes(HighpassSettings settings, std::uint64_t budget, HighpassTrials& trials);

}  // namespace deltamesh
