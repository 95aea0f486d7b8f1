// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/highpass_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/try.h"
#include "search/bracket.h"
#include "search/highpass_step.h"

namespace deltamesh {
namespace {

/// Where a bracket lands: loads of 0.975, and between 0.955 and 1.
constexpr double kAim = -0.0365;
constexpr double kTight = -0.0664;
constexpr double kWide = -0.2;        ///< 0.87: where the setting costs few bytes
constexpr double kQuickAim = -0.152;  ///< 0.9, at effort 0, where anything that keeps the bounds will do
constexpr double kAnything = -std::numeric_limits<double>::infinity();

/// LFE of full diffusion over that of none, and the delta error of it over that of none.
constexpr double kDiffusedLfe = 0.2;
constexpr double kDiffusedDeltaError = 1.14;

class HighpassSearch {
 public:
  HighpassSearch(const Request& request, HighpassTrials& trials, std::uint64_t most_bytes)
      : request_(request),
        bounds_(request.bounds),
        trials_(trials),
        record_(request, trials),
        most_bytes_(most_bytes) {}

  Result<Candidate> run() {
    const HighpassSettings settings = first_settings(request_, trials_);
    if (!request_.has_bounds()) {
      if (!request_.target_bytes) {
        DELTAMESH_TRY([[maybe_unused]] const Loads loads, record_.make(settings));
      } else {
        DELTAMESH_CHECK(fit_bytes(settings));
      }
    } else if (fixed_step()) {
      DELTAMESH_CHECK(keep_by_anchors(settings, 1));
    } else if (bounds_.vde) {
      DELTAMESH_CHECK(keep_vde(settings));
    } else {
      DELTAMESH_CHECK(keep_positions(settings));
    }
    return record_.result();
  }

 private:
  bool fixed_step() const noexcept { return request_.step || request_.bits; }
  bool fixed_anchors() const noexcept { return request_.anchors || request_.anchor_density; }
  bool is_quick() const noexcept { return request_.effort < kSearchEffort; }

  /// Whether nothing keeps the bounds yet, and what came last has too many bytes already: all that is left to
  /// do adds to them.
  bool is_hopeless() const noexcept {
    return !record_.best() && record_.last() && record_.last()->bytes >= most_bytes_;
  }

  bool is_over() const noexcept { return record_.best() || is_hopeless(); }

  /// Of a search at a step that keeps VDE, or nearly.
  static double positional_excess(const Loads& loads) noexcept {
    return excess_of_load(loads.visual > 1 ? loads.all() : loads.positional);
  }

  enum class Watch : std::uint8_t { kVisual, kAll };

  /// The largest step whose candidate keeps the watched bounds, from the one with this delta error. Empty
  /// where none does. Anchors get more bits where the step alone does not do.
  Result<std::optional<HighpassSettings>> find_step(HighpassSettings settings, double error, Watch watch) {
    const double most = plain_delta_error(settings, coarsest_step(trials_), trials_);
    const bool grows_again = watch == Watch::kAll && bounds_.max_error;
    for (;;) {
      Bracket bracket({.first = std::min(error, most > 0 ? most : error),
                       .least = std::min(error, finest_step(trials_) / 4),
                       .most = most > 0 ? most : error,
                       .aim = is_quick() ? kQuickAim : kAim,
                       .tolerance = is_quick()    ? kAnything
                                    : grows_again ? kWide
                                                  : kTight,
                       .trials = 5});
      std::optional<HighpassSettings> kept;
      while (!bracket.is_done()) {
        settings.step = bracket.setting() < most ? step_for_delta_error(settings, bracket.setting(), trials_)
                                                 : coarsest_step(trials_);
        DELTAMESH_TRY(const Loads loads, record_.make(settings));
        const double load = watch == Watch::kAll ? loads.all() : loads.visual;
        if (bracket.tell(excess_of_load(load))) kept = settings;
        if (load > 1 && is_hopeless()) return kept;
      }
      if (kept || settings.anchor_bits >= kMostAnchorBits) return kept;
      settings.anchor_bits = kMostAnchorBits;
      error = bracket.setting();
    }
  }

  /// VDE sets the step, without diffusion; where that breaks a positional bound, anchors are added, then
  /// diffusion, and at last the step shrinks: always where VDE takes no delta at all, so that only positional
  /// bounds count.
  Result<void> keep_vde(const HighpassSettings& base) {
    const double aim = portable_exp2(is_quick() ? kQuickAim : kAim) * *bounds_.vde;
    const HighpassSettings first = settings_for_vde(base, aim, trials_);
    DELTAMESH_TRY(auto found, find_step(first, aim / kVdePerDeltaError, Watch::kVisual));
    if (!found) return {};
    HighpassSettings settings = *found;
    const bool is_moot = settings.step >= coarsest_step(trials_);  // VDE is kept with all deltas 0
    if (is_moot && !fixed_anchors() && !is_quick()) {
      HighpassSettings fewest = settings;  // nothing but anchors is left to be saved
      fewest.anchors = trials_.fewest_anchors();
      DELTAMESH_TRY([[maybe_unused]] const Loads loads, record_.make(fewest));
    }
    if (is_over()) return {};
    if (!fixed_anchors()) {
      DELTAMESH_CHECK(keep_by_anchors(settings, bounds_.lfe ? kForLfe : kForMaxError));
      if (is_over()) return {};
      settings.anchors = usual_anchors(bounds_.lfe ? kForLfe : kForMaxError, trials_);
    }
    DELTAMESH_CHECK(keep_by_diffusion(settings));
    if (is_hopeless() || (record_.best() && (is_quick() || !is_moot))) return {};
    settings.rate_weight = 0;
    return keep_positions(settings);
  }

  /// The fewest anchors that keep all bounds, up to one for so many vertices.
  Result<void> keep_by_anchors(HighpassSettings settings, std::uint32_t vertices_per_anchor) {
    const double most =
        std::max<double>(settings.anchors, fixed_anchors() ? 0 : usual_anchors(vertices_per_anchor, trials_));
    // LFE goes with the distance between anchors.
    Bracket bracket({.first = static_cast<double>(settings.anchors),
                     .least = static_cast<double>(settings.anchors),
                     .most = most,
                     .whole = true,
                     .slope = -0.5,
                     .aim = kAim,
                     .tolerance = is_quick() ? kAnything : kWide,
                     .trials = 6});
    while (!bracket.is_done() && !is_hopeless()) {
      settings.anchors = static_cast<std::uint32_t>(bracket.setting());
      DELTAMESH_TRY(const Loads loads, record_.make(settings));
      bracket.tell(positional_excess(loads));
    }
    return {};
  }

  /// The weakest diffusion that keeps the positional bounds, at a step that makes up for what it adds to VDE.
  /// The search is for the part of LFE that diffusion leaves.
  Result<void> keep_by_diffusion(HighpassSettings settings) {
    const double rate_weight = settings.rate_weight;
    constexpr int kMostCorrections = 2;
    double error = plain_delta_error(settings, settings.step, trials_);
    const double most = plain_delta_error(settings, coarsest_step(trials_), trials_);
    Bracket bracket({.first = is_quick() ? kDiffusedLfe : 0.6,
                     .least = kDiffusedLfe,
                     .most = 1,
                     .aim = kAim,
                     .tolerance = is_quick() ? kAnything : kWide,
                     .trials = 5});
    while (!bracket.is_done() && !is_hopeless()) {
      settings.diffusion = (1 - bracket.setting()) / (1 - kDiffusedLfe);
      settings.rate_weight = rate_weight * (1 - settings.diffusion);  // what prices save costs more diffusion
      const double diffused = 1 + (kDiffusedDeltaError - 1) * settings.diffusion;
      settings.step = step_for_delta_error(settings, error / diffused, trials_);
      DELTAMESH_TRY(Loads loads, record_.make(settings));
      for (int corrections = 0; corrections < kMostCorrections; ++corrections) {
        const double off = excess_of_load(loads.visual);
        if (!std::isfinite(off) || (off <= 0 && (off >= kTight || is_quick()))) break;
        const double corrected = error * portable_exp2(kAim - off);
        if (off <= 0 && corrected >= most) break;  // all deltas would be 0, and VDE says no more of the step
        error = corrected;
        settings.step = step_for_delta_error(settings, error / diffused, trials_);
        DELTAMESH_TRY(loads, record_.make(settings));
      }
      bracket.tell(positional_excess(loads));
    }
    return {};
  }

  /// Full diffusion, the step follows all bounds. With it LFE is some 3 VDE, and the largest error 4 LFE.
  Result<void> keep_positions(HighpassSettings settings) {
    settings.diffusion = 1;
    settings.mends = bounds_.max_error && !is_quick();
    settings.centroids = false;  // they lower VDE, but LFE rises by as much at low rates
    if (!fixed_anchors())
      settings.anchors = usual_anchors(bounds_.max_error ? kForMaxError : kForLfe, trials_);
    double lfe = trials_.longest_side();
    if (bounds_.lfe) lfe = std::min(lfe, *bounds_.lfe);
    if (bounds_.max_error) lfe = std::min(lfe, *bounds_.max_error / 4);
    if (!(lfe > 0)) lfe = 1;
    double vde = lfe / 3;
    if (bounds_.vde) vde = std::min(vde, *bounds_.vde);
    DELTAMESH_TRY(const auto landed,
                  find_step(settings, vde / (kVdePerDeltaError * kDiffusedDeltaError), Watch::kAll));
    if (landed && landed->mends) return mend_larger_steps(*landed);
    return {};
  }

  /// The largest error of a mesh is a matter of chance: a step that keeps all vertices within the bound is
  /// needlessly small for nearly all of them, while an anchor costs as much as a thousandth of a step for
  /// thousands of vertices. So the step grows, and anchors mend what sticks out, as long as the stream
  /// shrinks.
  Result<void> mend_larger_steps(HighpassSettings settings) {
    constexpr double kGrowth = 1.4;
    constexpr int kMostGrowths = 3;
    for (int i = 0; i < kMostGrowths && settings.step < coarsest_step(trials_); ++i) {
      const std::uint64_t bytes_before = record_.best()->bytes;
      settings.step *= kGrowth;
      DELTAMESH_CHECK(mend(settings));
      if (record_.best()->bytes >= bytes_before) break;
      settings.step = record_.best()->settings.step;
      settings.more_anchors = record_.best()->settings.more_anchors;
    }
    return {};
  }

  /// Adds anchors where the error is largest, until the bounds are kept or the stream is larger than the best
  /// (Yang, Li et al., section 4).
  Result<void> mend(HighpassSettings settings) {
    constexpr int kMostRounds = 6;
    constexpr double kBatchShare = 0.4;  // of the anchors there are
    constexpr double kThreshold = 0.9;   // of the largest error
    constexpr double kHopelessLoad = 2;
    for (int round = 0; round < kMostRounds; ++round) {
      DELTAMESH_TRY(const Loads loads, record_.make(settings));
      if (!(loads.all() > 1) || loads.all() > kHopelessLoad || record_.last()->bytes >= record_.best()->bytes)
        break;
      const auto anchors = static_cast<double>(settings.anchors + settings.more_anchors.size());
      const auto worst = trials_.worst_vertices(*record_.last(), kThreshold * *bounds_.max_error,
                                                static_cast<std::size_t>(std::ceil(kBatchShare * anchors)));
      if (worst.empty()) break;
      settings.more_anchors.insert(settings.more_anchors.end(), worst.begin(), worst.end());
    }
    return {};
  }

  /// The finest step whose stream fits; with the fewest anchors where none does.
  Result<void> fit_bytes(HighpassSettings settings) {
    const std::uint64_t budget = *request_.target_bytes;
    DELTAMESH_TRY(BudgetStep found, step_for_bytes(settings, budget, trials_));
    if (!found.fits && settings.anchors > trials_.fewest_anchors() && !fixed_anchors()) {
      settings.anchors = trials_.fewest_anchors();
      DELTAMESH_TRY(found, step_for_bytes(settings, budget, trials_));
    }
    if (!found.fits) return too_few_bytes(found.fewest_bytes);
    settings.step = found.step;
    // Deltas of displaced positions may take more bytes than those the step was chosen by, and do not shrink
    // quite as forecast: hence further each time.
    constexpr int kMostCorrections = 5;
    for (int i = 0;; ++i) {
      DELTAMESH_TRY([[maybe_unused]] const Loads loads, record_.make(settings));
      if (!record_.last() || record_.last()->bytes <= budget) return {};
      if (i == kMostCorrections) return too_few_bytes(record_.last()->bytes);
      const double over =
          excess_of_bytes(record_.last()->bytes, budget - budget / 500, trials_.most_anchors());
      settings.step = std::min(settings.step * portable_exp2((1 + i) * over), coarsest_step(trials_));
    }
  }

  const Request& request_;
  const Bounds& bounds_;
  HighpassTrials& trials_;
  HighpassRecord record_;
  std::uint64_t most_bytes_;
};

}  // namespace

Result<Candidate> search_highpass(const Request& request, HighpassTrials& trials, std::uint64_t most_bytes) {
  return HighpassSearch(request, trials, most_bytes).run();
}

Result<std::uint64_t> forecast_highpass_bytes(const Request& request, double vde, HighpassTrials& trials) {
  return trials.bytes(settings_for_vde(first_settings(request, trials), vde, trials));
}

}  // namespace deltamesh
