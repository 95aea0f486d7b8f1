// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/peak_control.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"

namespace deltamesh {
namespace {

constexpr StepGoal kAnyStepThatKeeps{.aim = 0.8, .tight = 0, .corrections = 0};
constexpr int kGreedyEffort = 3;
constexpr int kThinningEffort = 5;
/// What mending saves at most, and a little more.
constexpr double kRivalShare = 1.2;
constexpr double kFirstLoad = 1.6;  ///< of the first step that is mended
constexpr double kLastLoad = 1;
constexpr double kLoadBackoff = 0.8;
constexpr double kHopelessLoad = 3.5;
constexpr double kGrowth = 1.2;  ///< of the step from then on
constexpr int kMostGrowths = 8;
constexpr std::uint32_t kFewerAnchors = 3;

/// Runs `settings` and mends them. Whether the stream is smaller than `best`, which it then replaces.
Result<bool> mend(const HighpassSettings& settings, Attempt& best, Trials& trials) {
  DELTAMESH_TRY(const Attempt broken, trials.run(settings));
  if (trials.bounds().load(broken.figures.quality) > kHopelessLoad) return false;
  DELTAMESH_TRY(Attempt mended, refine_greedily(broken, best.figures.bytes, trials));
  const bool better =
      trials.bounds().load(mended.figures.quality) <= 1 && mended.figures.bytes < best.figures.bytes;
  if (better) best = std::move(mended);
  return better;
}

/// The step that keeps the bounds grows until they are broken by kFirstLoad or so, less where that cannot be
/// mended, then on by kGrowth.
Result<void> grow_step(Attempt& best, Trials& trials) {
  const Attempt landed = best;
  const double load_at_landing = trials.bounds().load(landed.figures.quality);
  const double coarsest = coarsest_step(trials.coder());
  if (landed.settings.step >= coarsest || !(load_at_landing > 0)) return {};
  bool better = false;
  for (double load = kFirstLoad; !better && load > kLastLoad; load *= kLoadBackoff) {
    HighpassSettings settings = landed.settings;
    settings.step = std::min(settings.step * load / load_at_landing, coarsest);
    DELTAMESH_TRY(better, mend(settings, best, trials));
  }
  for (int growths = 0; better && growths < kMostGrowths; ++growths) {
    HighpassSettings settings = best.settings;
    settings.step *= kGrowth;
    DELTAMESH_TRY(better, mend(settings, best, trials));
  }
  return {};
}

constexpr int kMostRefinements = 12;
constexpr double kBatchShare = 0.25;  // of the anchors there are
/// For a maximum error, vertices above this share of it; for an LFE the largest come first in any case.
constexpr double kThreshold = 0.9;

}  // namespace

Result<void> control_peaks(const HighpassSettings& settings, Trials& trials) {
  const RateGoal& goal = trials.goal();
  DELTAMESH_TRY(Attempt best, search_step(trials, settings, Watch::kAll, kAnyStepThatKeeps));
  if (trials.bounds().load(best.figures.quality) > 1 || goal.effort < kGreedyEffort) return {};
  if (goal.loses(best.figures.bytes, kRivalShare)) return {};
  DELTAMESH_CHECK(grow_step(best, trials));
  while (goal.effort >= kThinningEffort && best.settings.anchors > trials.coder().fewest_anchors()) {
    HighpassSettings fewer = best.settings;
    fewer.anchors = std::max(fewer.anchors / kFewerAnchors, trials.coder().fewest_anchors());
    DELTAMESH_TRY(const bool better, mend(fewer, best, trials));
    if (!better) break;
  }
  return {};
}

Result<Attempt> refine_greedily(const Attempt& start, std::uint64_t most_bytes, Trials& trials) {
  const Bounds& bounds = trials.bounds();
  Attempt attempt = start;
  for (int runs = 0; runs < kMostRefinements; ++runs) {
    if (!attempt.decodes()) return attempt;
    const Quality& quality = attempt.figures.quality;
    if (bounds.load(quality) <= 1 || bounds.visual_load(quality) > 1) return attempt;
    if (most_bytes > 0 && attempt.figures.bytes >= most_bytes) return attempt;
    const double anchors =
        attempt.settings.anchors + static_cast<double>(attempt.settings.more_anchors.size());
    const auto batch = static_cast<std::size_t>(std::ceil(kBatchShare * anchors));
    const double lfe_threshold = bounds.lfe ? *bounds.lfe : quality.max_error;
    const double threshold =
        std::min(lfe_threshold, kThreshold * bounds.max_error.value_or(quality.max_error));
    const auto worst = trials.coder().worst_vertices(attempt, threshold, batch);
    if (worst.empty()) return attempt;
    HighpassSettings settings = attempt.settings;
    settings.more_anchors.insert(settings.more_anchors.end(), worst.begin(), worst.end());
    DELTAMESH_TRY(attempt, trials.run(settings));
  }
  return attempt;
}

}  // namespace deltamesh
