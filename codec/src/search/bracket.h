// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The search for one setting by trials: a step, a number of levels or anchors, a scale of errors. Whoever
// looks for the cheapest setting that keeps a bound, or for the best that fits a number of bytes, uses it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/numbers/portable_math.h"

namespace deltamesh {

/// What is known before the first trial. An *excess* says how far a trial is from what is asked for: 0 or
/// less where it keeps it. It is taken to be a line over the binary logarithm of the setting; the binary
/// logarithm of an error over its bound nearly is one, and so is excess_of_bytes().
struct BracketPlan {
  double first = 1;  ///< of the first trial, above 0
  double least = 0;  ///< settings that make sense
  double most = std::numeric_limits<double>::infinity();
  bool whole = false;  ///< settings are whole numbers
  /// Forecast of what the excess grows by where the setting doubles. Above 0: the largest setting that keeps
  /// is looked for; below 0: the smallest.
  double slope = 1;
  double aim = 0;        ///< excess that forecasts aim at, 0 or less
  double tolerance = 0;  ///< an excess between this, 0 or less, and 0 ends the search
  /// Octaves: the search ends when a setting that keeps and one that does not are nearer than this.
  double narrowest = 0.0015;
  int trials = 8;  ///< at most, once one keeps; three times as many where none does
};

class Bracket {
 public:
  explicit Bracket(const BracketPlan& plan) noexcept : plan_(plan), slope_(plan.slope) {
    move_to(plan.first);
  }

  /// Of the next trial.
  double setting() const noexcept { return setting_; }
  bool is_done() const noexcept { return done_; }
  bool has_kept() const noexcept { return has_kept_; }
  /// The best setting that keeps what is asked; where none has been found, the last one tried.
  double best() const noexcept { return has_kept_ ? kept_ : setting_; }

  /// What came of the trial at setting(); may be infinite. Returns whether it is the best so far.
  bool tell(double excess) noexcept {
    ++trials_;
    const Point now{portable_log2(setting_), excess, true};
    const bool keeps = excess <= 0;
    if (keeps) kept_ = setting_;
    has_kept_ |= keeps;
    learn_slope(now);
    const bool is_same_side = last_.known && (last_.excess <= 0) == keeps;
    same_side_ = is_same_side ? same_side_ + 1 : 1;
    const bool is_short = std::abs(now.at - last_.at) < 0.9 * kStride || fell_short_ > kStuck;
    fell_short_ = is_same_side && is_short ? fell_short_ + 1 : 0;
    last_ = now;
    (keeps ? good_ : bad_) = now;
    done_ = keeps ? excess >= plan_.tolerance || is_at(best_end()) || trials_ >= plan_.trials
                  : is_at(safe_end()) || trials_ >= (has_kept_ ? 1 : 3) * plan_.trials;
    if (!done_) done_ = !move_to(portable_exp2(next(now)));
    return keeps;
  }

 private:
  struct Point {
    double at = 0;  ///< binary logarithm of a setting
    double excess = 0;
    bool known = false;
  };
  static constexpr double kStride = 3;      ///< octaves, at most, that a forecast moves by
  static constexpr double kFlattest = 0.3;  ///< of the slope forecast
  static constexpr double kSteepest = 2;    ///< likewise
  static constexpr double kEdge = 0.04;     ///< share of the bracket that no trial comes nearer to its ends
  static constexpr int kStuck = 3;          ///< trials on one side, after which the bracket is halved
  static constexpr double kStretch = 0.25;  ///< octaves that a move is at least after kStuck short ones

  double best_end() const noexcept { return plan_.slope > 0 ? plan_.most : plan_.least; }
  double safe_end() const noexcept { return plan_.slope > 0 ? plan_.least : plan_.most; }
  bool is_at(double end) const noexcept { return setting_ == end; }

  void learn_slope(const Point& now) noexcept {
    if (!last_.known || !std::isfinite(now.excess) || !std::isfinite(last_.excess)) return;
    const double moved = now.at - last_.at;
    if (std::abs(moved) < 0.01) return;
    const double share = (now.excess - last_.excess) / moved / plan_.slope;
    slope_ = plan_.slope * std::clamp(share, kFlattest, kSteepest);
  }

  /// As a logarithm.
  double next(const Point& now) const noexcept {
    const double towards_best = plan_.slope > 0 ? 1 : -1;
    double move = (now.excess > 0 ? -towards_best : towards_best) * kStride;
    if (std::isfinite(now.excess)) move = std::clamp((plan_.aim - now.excess) / slope_, -kStride, kStride);
    // Forecasts that fall short again and again: a floor, or hardly anything left that depends on the
    // setting. Then least moves double.
    if (!good_.known || !bad_.known) {
      if (fell_short_ < kStuck) return now.at + move;
      const double least = std::min(kStretch * portable_exp2(fell_short_ - kStuck), kStride);
      return now.at + std::copysign(std::max(std::abs(move), least), move);
    }
    if (same_side_ >= kStuck || !std::isfinite(now.excess)) return (good_.at + bad_.at) / 2;
    const double low = std::min(good_.at, bad_.at);
    const double width = std::abs(good_.at - bad_.at);
    return std::clamp(now.at + move, low + kEdge * width, low + (1 - kEdge) * width);
  }

  /// False where there is nothing between what has been tried.
  bool move_to(double setting) noexcept {
    setting = std::clamp(setting, plan_.least, plan_.most);
    if (plan_.whole) {
      setting = std::round(setting);
      if (last_.known && setting == setting_) setting += (last_.excess <= 0) == (plan_.slope > 0) ? 1 : -1;
    }
    if (good_.known && bad_.known) {
      if (plan_.whole) {
        const double low = std::round(portable_exp2(std::min(good_.at, bad_.at)));
        const double high = std::round(portable_exp2(std::max(good_.at, bad_.at)));
        if (high - low < 1.5) return false;
        setting = std::clamp(setting, low + 1, high - 1);
      } else if (std::abs(good_.at - bad_.at) < plan_.narrowest) {
        return false;
      }
    }
    if (last_.known && setting == setting_) return false;
    setting_ = setting;
    return true;
  }

  BracketPlan plan_;
  double setting_ = 1;
  double slope_;
  bool done_ = false;
  int trials_ = 0;
  int same_side_ = 0;
  int fell_short_ = 0;  ///< short moves one after another that stayed on one side
  double kept_ = 0;
  bool has_kept_ = false;
  Point last_;
  Point good_;  ///< the last trial that keeps
  Point bad_;   ///< the last that does not
};

/// The excess of a load: an achieved error over its bound.
inline double excess_of_load(double load) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!(load > 0)) return -kInfinity;
  return std::isfinite(load) ? portable_log2(load) : kInfinity;
}

/// Of bytes over a budget. Numbers of a spread s take about b = log2(1 + s / step) bits each: so 2^b - 1, b
/// being the bits per coordinate of `vertices`, halves where the step doubles, at all rates.
inline double excess_of_bytes(std::uint64_t bytes, std::uint64_t budget, std::uint64_t vertices) noexcept {
  const double coordinates = 3 * static_cast<double>(std::max<std::uint64_t>(vertices, 1));
  const auto log_spread = [&](std::uint64_t count) {
    const double bits = 8 * static_cast<double>(std::max<std::uint64_t>(count, 1)) / coordinates;
    return bits + portable_log2(1 - portable_exp2(-bits));
  };
  return log_spread(bytes) - log_spread(budget);
}

}  // namespace deltamesh
