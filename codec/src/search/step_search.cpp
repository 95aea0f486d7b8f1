// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/step_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers/portable_math.h"
#include "base/try.h"

namespace deltamesh {
namespace {

/// Steps below this share of the longest side are beyond float32 positions.
constexpr int kFinestStepBits = 36;
constexpr int kMostSymbolBits = 28;  // of the largest symbol
constexpr int kMoreAnchorBits = 3;

constexpr int kModelSteps = 12;
constexpr double kModelTolerance = 2e-3;

/// A load that falls less than this power of the delta error has reached a floor.
constexpr double kFloorSlope = 0.35;
constexpr double kSteepestSlope = 1.6;
constexpr double kSameError = 0.03;  // of the binary logarithm: too near for a slope
constexpr double kBackOff = 1.0 / 16;
constexpr int kMostSearchRuns = 24;

/// The delta error as a power of the step: of exponent 1 until two points tell.
class PowerLaw {
 public:
  /// Where it leads from here. All above 0 and finite.
  double step_for(double wanted, double step, double error) noexcept {
    const double log_step = portable_log2(step);
    const double log_error = portable_log2(error);
    if (const double moved = log_step - log_step_; is_known_ && std::abs(moved) > kSmallestMove)
      exponent_ = std::clamp((log_error - log_error_) / moved, kLeastExponent, kLargestExponent);
    is_known_ = true;
    log_step_ = log_step;
    log_error_ = log_error;
    return step * portable_exp2((portable_log2(wanted) - log_error) / exponent_);
  }

 private:
  static constexpr double kSmallestMove = 1e-3;
  static constexpr double kLeastExponent = 0.5;
  static constexpr double kLargestExponent = 2;

  bool is_known_ = false;
  double log_step_ = 0;
  double log_error_ = 0;
  double exponent_ = 1;
};

/// One search; see search_step().
class StepSearch {
 public:
  StepSearch(Trials& trials, const HighpassSettings& settings, Watch watch, const StepGoal& goal)
      : trials_(trials), coder_(trials.coder()), settings_(settings), watch_(watch), goal_(goal) {
    coarsest_ = coarsest_step(coder_);
    finest_ = std::min(coarsest_, std::max(std::ldexp(coder_.longest_side(), -kFinestStepBits),
                                           std::ldexp(coder_.largest_delta(), -kMostSymbolBits)));
    settings_.step = settings_.step > 0 ? std::clamp(settings_.step, finest_, coarsest_) : coarsest_;
  }

  Result<Attempt> run() {
    for (int runs = 0; runs < kMostSearchRuns; ++runs) {
      const double error = coder_.delta_error(settings_);
      DELTAMESH_TRY(const Attempt attempt, trials_.run(settings_));
      const double load = load_of(attempt);
      note(attempt, load);
      const bool kept = kept_.has_value();
      if (load <= 1 && (load >= goal_.tight || settings_.step >= coarsest_)) break;
      if (kept && runs >= goal_.corrections) break;
      if (!correct(error, load)) break;
    }
    return kept_ ? *kept_ : *broken_;
  }

 private:
  double load_of(const Attempt& attempt) const noexcept {
    const Quality& quality = attempt.figures.quality;
    return watch_ == Watch::kAll ? trials_.bounds().load(quality) : trials_.bounds().visual_load(quality);
  }

  void note(const Attempt& attempt, double load) {
    if (load <= 1) {
      low_ = std::max(low_, attempt.settings.step);
      if (!kept_ || load > kept_load_) {
        kept_ = attempt;
        kept_load_ = load;
      }
    } else {
      high_ = std::min(high_, attempt.settings.step);
      if (!broken_ || load < broken_load_) {
        broken_ = attempt;
        broken_load_ = load;
      }
    }
  }

  /// Sets the next step; false where there is nothing left to try.
  bool correct(double error, double load) {
    if (std::isinf(load)) return back_off();
    double slope = 1;
    if (last_load_ > 0 && load > 0 && std::abs(portable_log2(error / last_error_)) > kSameError) {
      const double measured = portable_log2(load / last_load_) / portable_log2(error / last_error_);
      if (load > 1 && measured < kFloorSlope) return add_anchor_bits();
      slope = std::clamp(measured, kFloorSlope, kSteepestSlope);
    } else if (load > 1 && !(error > 0)) {
      return add_anchor_bits();
    }
    last_error_ = error;
    last_load_ = load;
    const double factor = load > 0 ? portable_exp2(portable_log2(goal_.aim / load) / slope) : 1e6;
    double next = error > 0 ? step_for_delta_error(coder_, settings_, error * factor) : coarsest_;
    if (next <= low_ || next >= high_) {
      if (!(low_ > 0))
        next = 0.5 * std::min(next, high_);
      else
        next = std::isinf(high_) ? coarsest_ : std::sqrt(low_ * high_);
    }
    if (low_ > 0 && high_ / low_ < 1 + kModelTolerance) return false;
    if (next < finest_) {
      if (settings_.step <= finest_) return add_anchor_bits();
      next = finest_;
    }
    settings_.step = std::min(next, coarsest_);
    return true;
  }

  /// From a step whose stream does not decode.
  bool back_off() {
    last_load_ = 0;
    if (low_ > 0 && high_ / low_ < 1 + kModelTolerance) return false;
    const double next = low_ > 0 ? std::sqrt(low_ * high_) : kBackOff * settings_.step;
    if (next < finest_) return false;
    settings_.step = next;
    return true;
  }

  bool add_anchor_bits() {
    if (settings_.anchor_bits >= kMostAnchorBits) return false;
    settings_.anchor_bits = std::min(settings_.anchor_bits + kMoreAnchorBits, kMostAnchorBits);
    last_load_ = 0;
    high_ = std::numeric_limits<double>::infinity();
    return true;
  }

  Trials& trials_;
  TrialCoder& coder_;
  HighpassSettings settings_;
  Watch watch_;
  StepGoal goal_;
  double coarsest_ = 0;
  double finest_ = 0;
  double low_ = 0;                                         ///< largest step that keeps the bounds
  double high_ = std::numeric_limits<double>::infinity();  ///< smallest that breaks them
  double last_error_ = 0;
  double last_load_ = 0;
  std::optional<Attempt> kept_;
  std::optional<Attempt> broken_;
  double kept_load_ = 0;
  double broken_load_ = 0;
};

}  // namespace

Result<Attempt> Trials::run(const HighpassSettings& settings) {
  Attempt attempt{.settings = settings};
  const auto figures = coder_.run(settings);
  if (!figures) {
    if (figures.error().code != ErrorCode::kInvalidStream) return figures.error();
    failure_ = figures.error();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    attempt.figures = {.quality = {kInfinity, kInfinity, kInfinity},
                       .bytes = std::numeric_limits<std::uint64_t>::max()};
    return attempt;
  }
  attempt.figures = *figures;
  const double load = bounds().load(attempt.figures.quality);
  if (!nearest_ || load < bounds().load(nearest_->figures.quality)) {
    nearest_ = attempt;
    nearest_->figures.coded = nullptr;
  }
  if (load <= 1 && (!best_ || cost(attempt) < cost(*best_))) best_ = attempt;
  return attempt;
}

double Trials::cost(const Attempt& attempt) const noexcept {
  const Quality& quality = attempt.figures.quality;
  const bool landed = bounds().positional() ? bounds().positional_load(quality) >= kLandedLoad
                                            : bounds().visual_load(quality) >= kLandedLoad;
  const bool fits = !goal_.target_bytes || attempt.figures.bytes <= *goal_.target_bytes;
  return static_cast<double>(attempt.figures.bytes) * (landed && fits ? 1 : kLandingWorth);
}

double coarsest_step(TrialCoder& coder) {
  const double largest = coder.largest_delta();
  // Below half a step a delta is coded as 0; diffusion may add as much again.
  return largest > 0 ? 8 * largest : 1;
}

double step_for_delta_error(TrialCoder& coder, HighpassSettings settings, double wanted) {
  const double coarsest = coarsest_step(coder);
  double low = 0;
  double high = coarsest;
  double step = settings.step > 0 ? std::min(settings.step, coarsest) : coarsest;
  PowerLaw law;
  for (int i = 0; i < kModelSteps && high - low > kModelTolerance * high; ++i) {
    settings.step = step;
    const double error = coder.delta_error(settings);
    if (std::abs(error - wanted) <= kModelTolerance * wanted) return step;
    const bool too_fine = error < wanted || std::isinf(error);  // infinite: beyond what symbols can say
    if (too_fine && step >= coarsest) return coarsest;
    (too_fine ? low : high) = step;
    double next = error > 0 && std::isfinite(error) ? law.step_for(wanted, step, error) : step * 2;
    if (too_fine && next >= high) next = high < coarsest ? 0.5 * (low + high) : coarsest;
    if (!too_fine && next <= low) next = low > 0 ? std::sqrt(low * high) : 0.5 * high;
    step = next;
  }
  return step;
}

Result<Attempt> search_step(Trials& trials, HighpassSettings settings, Watch watch, const StepGoal& goal) {
  return StepSearch(trials, settings, watch, goal).run();
}

}  // namespace deltamesh
