// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/greedy_refinement.h"

#include <algorithm>
#include <cmath>

#include "base/try.h"

namespace deltamesh {
namespace {

constexpr int kMostRuns = 12;
constexpr double kBatchShare = 0.25;  // of the anchors there are
/// For a maximum error, vertices above this share of it; for an LFE the largest come first in any case.
constexpr double kThreshold = 0.9;

}  // namespace

Result<Attempt> refine_greedily(const Attempt& start, std::uint64_t most_bytes, Trials& trials) {
  const Bounds& bounds = trials.bounds();
  Attempt attempt = start;
  for (int runs = 0; runs < kMostRuns; ++runs) {
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
