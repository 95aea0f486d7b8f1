// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The step at which a bound is just kept.
#pragma once

#include <cstdint>
#include <optional>

#include "search/rate_goal.h"
#include "search/trial.h"

namespace deltamesh {

inline constexpr int kMostAnchorBits = 24;  ///< per axis, that a search goes to

/// Runs a coder for a goal, remembers the best stream so far.
class Trials {
 public:
  Trials(TrialCoder& coder, const RateGoal& goal) : coder_(coder), goal_(goal) {}

  TrialCoder& coder() noexcept { return coder_; }
  const RateGoal& goal() const noexcept { return goal_; }
  const Bounds& bounds() const noexcept { return goal_.bounds; }

  /// Errors: those of TrialCoder::run but kInvalidStream, which gives an attempt that does not decode.
  Result<Attempt> run(const HighpassSettings& settings);

  /// The smallest attempt that keeps all bounds. An attempt near a bound (load of at least kLandedLoad) is
  /// preferred if it takes at most kLandingWorth times the bytes and the target allows them. Empty if none
  /// keeps the bounds.
  const std::optional<Attempt>& best() const noexcept { return best_; }
  /// The attempt of smallest load, whether it keeps the bounds or not, without what was coded. Empty where
  /// none decodes.
  const std::optional<Attempt>& nearest() const noexcept { return nearest_; }
  /// Error of the last attempt that does not decode.
  const std::optional<Error>& failure() const noexcept { return failure_; }

  static constexpr double kLandedLoad = 0.87;
  static constexpr double kLandingWorth = 1.02;

 private:
  /// Bytes, or a little more where bounds are far from used up.
  double cost(const Attempt& attempt) const noexcept;

  TrialCoder& coder_;
  RateGoal goal_;
  std::optional<Attempt> best_;
  std::optional<Attempt> nearest_;
  std::optional<Error> failure_;
};

/// Which bounds a search looks at.
enum class Watch : std::uint8_t { kVisual, kAll };

/// How near a search comes.
struct StepGoal {
  double aim = 0.975;    ///< load that corrections aim at
  double tight = 0.955;  ///< a load between this and 1 ends the search
  int corrections = 5;   ///< at most, once the bound is kept
};

/// Starting at settings.step, corrects the step until the load of the watched bounds is between goal.tight
/// and 1. Each correction takes the load to be a power of the delta error (of exponent 1 until two runs
/// tell), so that one or two are enough wherever VDE is proportional to the step, and saturation at low rates
/// is seen in advance; a stream that does not decode has a step by far too large. Where shrinking the step no
/// longer helps, anchors get more bits. Ends at the coarsest step, where all symbols are 0, even if the load
/// is below goal.tight. Returns the run with the largest load of at most 1, else that with the smallest.
Result<Attempt> search_step(Trials& trials, HighpassSettings settings, Watch watch, const StepGoal& goal);

/// The step at which the delta error is `wanted`, all else as in `settings`, from whose step the search
/// starts; at most coarsest_step(). A few delta errors' cost.
double step_for_delta_error(TrialCoder& coder, HighpassSettings settings, double wanted);

/// At this step and above all symbols are 0.
double coarsest_step(TrialCoder& coder);

}  // namespace deltamesh
