// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/byte_budget.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers/portable_math.h"
#include "base/try.h"
#include "search/unmet.h"
#include "search/visual_control.h"

namespace deltamesh {
namespace {

constexpr int kMostCodings = 9;
constexpr double kTightShare = 0.995;  // of the target: near enough
constexpr double kByteAim = 0.998;
constexpr double kSameStep = 1.0001;
constexpr int kFinestBudgetBits = 24;  // below the range of deltas: beyond float32 positions
constexpr double kRateWeights[] = {0, kRateWeight};

/// The finest step whose stream fits, between a coarse one that does and a fine one that is taken not to.
class FinestFit {
 public:
  FinestFit(std::uint64_t target, const HighpassSettings& settings, TrialCoder& coder)
      : target_(static_cast<double>(target)), settings_(settings), coder_(coder) {}

  /// Empty where the coarsest step does not fit; coarsest_bytes() is known afterwards.
  Result<std::optional<HighpassSettings>> run() {
    settings_.step = coarsest_step(coder_);
    DELTAMESH_TRY(coarsest_bytes_, coder_.bytes(settings_));
    Point fits{settings_.step, static_cast<double>(coarsest_bytes_)};
    if (fits.bytes > target_) return std::optional<HighpassSettings>();
    Point fails{std::ldexp(std::max(coder_.delta_range(), 1e-3 * settings_.step), -kFinestBudgetBits), 0};
    for (int i = 0; i < kMostCodings && fits.bytes < kTightShare * target_; ++i) {
      if (fits.step < fails.step * kSameStep) break;
      // A guess that falls on the same side as the one before it makes little way: halve then.
      const bool stuck = moves_on_one_side_ >= 2 && fails.bytes > 0;
      settings_.step = stuck ? std::sqrt(fits.step * fails.step) : next_step(fits, fails);
      DELTAMESH_TRY(const std::uint64_t bytes, coder_.bytes(settings_));
      const Point point{settings_.step, static_cast<double>(bytes)};
      const bool fit = point.bytes <= target_;
      moves_on_one_side_ = fit == last_fit_ && !stuck ? moves_on_one_side_ + 1 : 1;
      last_fit_ = fit;
      (fit ? fits : fails) = point;
    }
    settings_.step = fits.step;
    return std::optional<HighpassSettings>(settings_);
  }

  std::uint64_t coarsest_bytes() const noexcept { return coarsest_bytes_; }

 private:
  struct Point {
    double step = 0;
    double bytes = 0;  ///< 0 where not measured
  };

  double next_step(const Point& fits, const Point& fails) const {
    const double middle = std::sqrt(fits.step * fails.step);
    if (!(fails.bytes > 0)) {
      // Nothing beyond the coarsest is known yet: the range over 2^6; or a bit less for each bit to spare.
      if (fits.bytes <= static_cast<double>(coarsest_bytes_))
        return std::clamp(coder_.delta_range() / 64, fails.step, fits.step);
      const double spare =
          8 * (target_ - fits.bytes) / (3.0 * std::max<std::uint32_t>(coder_.most_anchors(), 1));
      return std::max(fits.step * portable_exp2(-spare - 0.1), fails.step);
    }
    // Bytes against the logarithm of the step are close to a line.
    const double share = (kByteAim * target_ - fits.bytes) / (fails.bytes - fits.bytes);
    const double guess =
        fits.step * portable_exp2(std::clamp(share, 0.02, 0.98) * portable_log2(fails.step / fits.step));
    return guess > fails.step && guess < fits.step ? guess : middle;
  }

  double target_;
  HighpassSettings settings_;
  TrialCoder& coder_;
  std::uint64_t coarsest_bytes_ = 0;
  int moves_on_one_side_ = 0;
  bool last_fit_ = false;
};

}  // namespace

Result<void> fit_bytes(std::uint64_t target, const HighpassSettings& settings, Trials& trials) {
  TrialCoder& coder = trials.coder();
  std::optional<HighpassSettings> best;
  double least_error = 0;
  std::uint64_t coarsest_bytes = 0;
  for (const double rate_weight : kRateWeights) {
    HighpassSettings candidate = settings;
    candidate.rate_weight = rate_weight;
    FinestFit search(target, candidate, coder);
    DELTAMESH_TRY(const auto fit, search.run());
    coarsest_bytes = search.coarsest_bytes();
    if (!fit) break;
    const double error = coder.delta_error(*fit);
    if (best && error >= least_error) break;
    best = fit;
    least_error = error;
    if (trials.goal().effort < kFrugalEffort) break;
  }
  if (!best && settings.anchors > coder.fewest_anchors()) {
    HighpassSettings fewer = settings;
    fewer.anchors = coder.fewest_anchors();
    return fit_bytes(target, fewer, trials);
  }
  if (!best) return too_few_bytes(coarsest_bytes);
  DELTAMESH_TRY([[maybe_unused]] const Attempt attempt, trials.run(*best));
  return {};
}

}  // namespace deltamesh
