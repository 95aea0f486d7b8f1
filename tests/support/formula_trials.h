// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A highpass coder made of formulas, for tests of its search.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/try.h"
#include "search/highpass_trials.h"

namespace deltamesh::test {

/// 10000 vertices in a unit cube. VDE is proportional to the step until everything is zero, LFE to VDE and to
/// the anchors' distance; diffusion takes four fifths of LFE and adds 15 % of VDE; anchors add their own
/// rounding.
class FormulaTrials : public HighpassTrials {
 public:
  static constexpr double kVertices = 10000;
  static constexpr double kLargestDelta = 0.01;

  int runs = 0;
  int codings = 0;
  double float_noise = 1e-8;  ///< no error is smaller
  bool anchor_floor = false;  ///< anchors of fewer than 24 bits leave a VDE of 1e-4

  Result<Candidate> make(const HighpassSettings& settings) override {
    ++runs;
    const double vde = 0.76 * delta_error(settings);
    const double anchors = settings.anchors + static_cast<double>(settings.more_anchors.size());
    const double distance = std::sqrt(kVertices / anchors);
    const double cell = std::ldexp(1.0, -settings.anchor_bits);
    Candidate candidate;
    candidate.settings = settings;
    candidate.quality.vde_rms =
        std::hypot(vde, anchor_floor && settings.anchor_bits < 24 ? 1e-4 : 0.02 * cell, float_noise);
    candidate.quality.lfe_rms =
        std::hypot(vde * distance * (1 - 0.8 * settings.diffusion), 0.2 * cell, float_noise);
    candidate.quality.max_error = 4 * candidate.quality.lfe_rms;
    DELTAMESH_TRY(candidate.bytes, bytes(settings));
    return candidate;
  }

  Result<std::uint64_t> bytes(const HighpassSettings& settings) override {
    ++codings;
    const double bits = std::log2(1 + (1 - settings.rate_weight) * kLargestDelta / settings.step);
    const double anchors = settings.anchors + static_cast<double>(settings.more_anchors.size());
    return static_cast<std::uint64_t>(200 + kVertices * 3 * bits / 8 +
                                      anchors * (3 * settings.anchor_bits + 6) / 8);
  }

  double delta_error(const HighpassSettings& settings) override {
    if (settings.step < std::ldexp(kLargestDelta, -30)) return std::numeric_limits<double>::infinity();
    const double uniform = settings.step * (0.5 + 0.3 * settings.rate_weight);
    return std::min(uniform * (1 + 0.15 * settings.diffusion), 0.4 * kLargestDelta);
  }

  std::vector<std::uint32_t> worst_vertices(const Candidate&, double, std::size_t count) override {
    return std::vector<std::uint32_t>(count, 0);
  }
  std::uint32_t anchors_for_density(std::uint32_t density) override {
    return std::max(2U, static_cast<std::uint32_t>(kVertices / (1.7 * density * density)));
  }
  std::uint32_t fewest_anchors() override { return 2; }
  std::uint32_t most_anchors() override { return static_cast<std::uint32_t>(kVertices); }
  double step_for_bits(int bits) override { return std::ldexp(2 * kLargestDelta, -bits); }
  double largest_delta() override { return kLargestDelta; }
  double delta_range() override { return 2 * kLargestDelta; }
  double longest_side() override { return 1; }
  bool has_small_components() override { return false; }
};

}  // namespace deltamesh::test
