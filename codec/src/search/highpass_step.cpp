// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/highpass_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers/portable_math.h"
#include "search/bracket.h"

namespace deltamesh {
namespace {

// Largest side of a lattice cell against each bound. A vertex that is coded as an anchor is off by half a
// side in the root mean square and by 0.87 sides at most; solved vertices feel a small part of it.
constexpr double kCellPerLfe = 0.5;
constexpr double kCellPerMaxError = 0.6;
constexpr double kCellPerVde = 8;
constexpr double kCellPerVdeOfSmall = 0.8;

/// Bits per axis at which the anchors' own rounding uses up only a part of each bound.
int anchor_bits(const Request& request, HighpassTrials& trials) {
  const Bounds& bounds = request.bounds;
  double side = std::numeric_limits<double>::infinity();
  if (bounds.lfe) side = std::min(side, kCellPerLfe * *bounds.lfe);
  if (bounds.max_error) side = std::min(side, kCellPerMaxError * *bounds.max_error);
  if (bounds.vde)
    side = std::min(side, (trials.has_small_components() ? kCellPerVdeOfSmall : kCellPerVde) * *bounds.vde);
  int bits = request.anchor_bits;
  while (bits < kMostAnchorBits && trials.longest_side() > side * (std::ldexp(1.0, bits) - 1)) ++bits;
  return bits;
}

constexpr int kFinestStepBits = 26;    // of the longest side
constexpr int kFinestBudgetBits = 24;  // below the range of deltas: beyond float32 positions
constexpr int kMostSymbolBits = 22;    // of the largest symbol
constexpr double kStepPerDeltaError = 2;

constexpr double kLowRateBits = 7;
/// Best within 0.5 % on all meshes from 3 to 6 bits.
constexpr double kRateWeight = 0.12;

}  // namespace

std::uint32_t usual_anchors(std::uint32_t vertices_per_anchor, HighpassTrials& trials) {
  const std::uint32_t fewest = trials.fewest_anchors();
  return std::clamp(trials.most_anchors() / vertices_per_anchor + 1, fewest,
                    std::max(fewest, trials.most_anchors()));
}

HighpassSettings first_settings(const Request& request, HighpassTrials& trials) {
  const bool searches = request.has_bounds() || request.target_bytes;
  HighpassSettings settings;
  settings.centroids = searches;
  settings.anchor_bits = anchor_bits(request, trials);
  settings.anchors = usual_anchors(searches ? kForVde : kForLfe, trials);
  if (request.anchor_density) settings.anchors = trials.anchors_for_density(*request.anchor_density);
  if (request.anchors) settings.anchors = *request.anchors;
  settings.step = request.step.value_or(trials.step_for_bits(request.bits.value_or(kDefaultDeltaBits)));
  return settings;
}

double coarsest_step(HighpassTrials& trials) {
  const double largest = trials.largest_delta();
  // Below half a step a delta is coded as 0; diffusion may add as much again.
  return largest > 0 ? 8 * largest : 1;
}

double finest_step(HighpassTrials& trials) {
  return std::min(coarsest_step(trials), std::max(std::ldexp(trials.longest_side(), -kFinestStepBits),
                                                  std::ldexp(trials.largest_delta(), -kMostSymbolBits)));
}

double plain_delta_error(HighpassSettings settings, double step, HighpassTrials& trials) {
  settings.step = step;
  settings.diffusion = 0;
  return trials.delta_error(settings);
}

double step_for_delta_error(const HighpassSettings& settings, double wanted, HighpassTrials& trials) {
  Bracket bracket({.first = kStepPerDeltaError * wanted,
                   .least = finest_step(trials),
                   .most = coarsest_step(trials),
                   .aim = -0.0015,
                   .tolerance = -0.003,
                   .trials = 12});
  while (!bracket.is_done()) {
    const double error = plain_delta_error(settings, bracket.setting(), trials);
    // Infinite: beyond what symbols can say.
    bracket.tell(std::isinf(error) ? -error : excess_of_load(error / wanted));
  }
  return bracket.best();
}

HighpassSettings settings_for_vde(HighpassSettings settings, double vde, HighpassTrials& trials) {
  const double error = vde / kVdePerDeltaError;
  settings.rate_weight = 0;
  settings.step = step_for_delta_error(settings, error, trials);
  if (portable_log2(trials.delta_range() / settings.step) >= kLowRateBits) return settings;
  settings.rate_weight = kRateWeight;
  settings.step = step_for_delta_error(settings, error, trials);
  return settings;
}

Result<BudgetStep> step_for_bytes(HighpassSettings settings, std::uint64_t budget, HighpassTrials& trials) {
  const double coarsest = coarsest_step(trials);
  const double range = std::max(trials.delta_range(), 1e-3 * coarsest);
  const std::uint64_t vertices = trials.most_anchors();
  Bracket bracket({.first = range / 64,
                   .least = std::ldexp(range, -kFinestBudgetBits),
                   .most = coarsest,
                   .slope = -1,
                   .aim = excess_of_bytes(budget, budget + budget / 500, vertices),
                   .tolerance = excess_of_bytes(budget, budget + budget / 200, vertices),
                   .trials = 10});
  BudgetStep found{.fewest_bytes = std::numeric_limits<std::uint64_t>::max()};
  while (!bracket.is_done()) {
    settings.step = bracket.setting();
    const auto bytes = trials.bytes(settings);
    if (!bytes && bytes.error().code != ErrorCode::kInvalidArgument) return bytes.error();
    if (bytes) found.fewest_bytes = std::min(found.fewest_bytes, *bytes);
    bracket.tell(bytes ? excess_of_bytes(*bytes, budget, vertices) : std::numeric_limits<double>::infinity());
  }
  found.step = bracket.best();
  found.fits = bracket.has_kept();
  return found;
}

}  // namespace deltamesh
