// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/thinning.h"

#include <algorithm>
#include <cmath>

#include "base/numbers/portable_math.h"
#include "base/try.h"
#include "search/lfe_fit.h"

namespace deltamesh {
namespace {

constexpr double kThinningAim = 0.95;
constexpr double kThinningVisualAim = 0.985;
constexpr int kMostThinningRuns = 9;
constexpr int kMostAnchorFits = 2;
constexpr std::uint32_t kFirstDivisor = 4;
constexpr int kFewestAnchorBits = 4;
constexpr double kFirstCell = 0.1;  // side of the anchors' lattice over the error they may add

/// The search of thin_anchors().
class Thinning {
 public:
  Thinning(const Attempt& start, Trials& trials)
      : trials_(trials), fewest_(trials.coder().fewest_anchors()), kept_(start), pair_(pair_of(start)) {
    bits_ = portable_log2(trials.coder().delta_range() / start.settings.step);
  }

  Result<Attempt> run() {
    std::uint32_t count = kept_.settings.anchors / kFirstDivisor;
    for (int runs = 0; runs < kMostThinningRuns; ++runs) {
      const std::uint32_t least = broken_ ? broken_->settings.anchors + 1 : fewest_;
      if (kept_.settings.anchors <= least) break;
      count = std::clamp(count, least, kept_.settings.anchors - 1);
      HighpassSettings settings = kept_.settings;
      settings.anchors = count;
      settings.step *= step_share_;
      DELTAMESH_TRY(const Attempt attempt, trials_.run(settings));
      if (!attempt.decodes()) break;
      if (const double visual = visual_load_of(attempt); visual > 1) {  // fewer anchors cost VDE a little
        step_share_ *= kThinningVisualAim / visual;
        continue;
      }
      step_share_ = 1;
      const double load = trials_.bounds().load(attempt.figures.quality);
      (load <= 1 ? kept_ : broken_.emplace()) = attempt;
      if (load <= 1 && load_of(attempt) >= Trials::kLandedLoad) return kept_;
      count = runs < kMostAnchorFits ? fitted_count(attempt) : halfway();
      if (count >= kept_.settings.anchors || (broken_ && count <= broken_->settings.anchors))
        count = halfway();
      pair_ = pair_of(attempt);
    }
    if (load_of(kept_) >= Trials::kLandedLoad) return kept_;
    DELTAMESH_CHECK(coarsen_anchors());
    return broken_ && load_of(kept_) < Trials::kLandedLoad ? *broken_ : kept_;
  }

 private:
  /// Takes bits from the anchors while the bounds are kept. What is wanted for a bound of 1: the errors of
  /// the deltas and of the anchors add up as squares.
  Result<void> coarsen_anchors() {
    const Bounds& bounds = trials_.bounds();
    const double bound = bounds.lfe ? *bounds.lfe : *bounds.max_error;
    const double room = bound * std::sqrt(1 - load_of(kept_) * load_of(kept_));
    const double cells = trials_.coder().longest_side() / (kFirstCell * room);
    HighpassSettings settings = kept_.settings;
    settings.anchor_bits =
        std::clamp(static_cast<int>(portable_log2(cells + 1)), kFewestAnchorBits, settings.anchor_bits);
    for (; settings.anchor_bits >= kFewestAnchorBits; --settings.anchor_bits) {
      DELTAMESH_TRY(const Attempt attempt, trials_.run(settings));
      if (bounds.load(attempt.figures.quality) > 1) break;
      kept_ = attempt;
      if (load_of(attempt) >= Trials::kLandedLoad) break;
    }
    return {};
  }

  double visual_load_of(const Attempt& attempt) const noexcept {
    return trials_.bounds().visual_load(attempt.figures.quality);
  }

  double load_of(const Attempt& attempt) const noexcept {
    return trials_.bounds().positional_load(attempt.figures.quality);
  }

  /// The positional load stands for M: the fitting function is the same in any unit.
  DensityPair pair_of(const Attempt& attempt) const noexcept {
    return {std::max(1.0, static_cast<double>(attempt.figures.density)), load_of(attempt)};
  }

  std::uint32_t fitted_count(const Attempt& attempt) {
    const double density = density_for_lfe(pair_, pair_of(attempt), bits_, kThinningAim);
    return trials_.coder().anchors_for_density(static_cast<std::uint32_t>(std::lround(density)));
  }

  std::uint32_t halfway() const noexcept {
    const double low = broken_ ? broken_->settings.anchors : fewest_;
    return static_cast<std::uint32_t>(std::lround(std::sqrt(low * kept_.settings.anchors)));
  }

  Trials& trials_;
  std::uint32_t fewest_;
  Attempt kept_;
  std::optional<Attempt> broken_;
  DensityPair pair_;
  double bits_ = 0;
  double step_share_ = 1;  ///< of the kept attempt's step, for the next run
};

}  // namespace

Result<Attempt> thin_anchors(const Attempt& start, Trials& trials) { return Thinning(start, trials).run(); }

}  // namespace deltamesh
