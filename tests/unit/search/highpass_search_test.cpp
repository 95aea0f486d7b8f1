// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/highpass_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers/short_float.h"
#include "search/highpass_step.h"
#include "support/formula_trials.h"

namespace deltamesh {
namespace {

using test::FormulaTrials;

void expect_landed(double achieved, double asked, double least) {
  EXPECT_LE(achieved, asked);
  EXPECT_GE(achieved, least * asked);
}

TEST(HighpassSearch, VdeLandsWithinTwoCorrections) {
  for (const double vde : {1e-3, 1e-4, 1e-5, 1e-6}) {
    FormulaTrials coder;
    const auto kept = search_highpass({.bounds = {.vde = vde}}, coder);
    ASSERT_TRUE(kept) << vde;
    EXPECT_LE(coder.runs, 3);
    EXPECT_EQ(kept->settings.diffusion, 0);
    expect_landed(kept->quality.vde_rms, vde, 0.95);
  }
}

TEST(HighpassSearch, LfeAloneLandsUnderFullDiffusion) {
  for (const double lfe : {1e-2, 1e-3, 1e-4}) {
    FormulaTrials coder;
    const auto kept = search_highpass({.bounds = {.lfe = lfe}}, coder);
    ASSERT_TRUE(kept) << lfe;
    EXPECT_EQ(kept->settings.diffusion, 1);
    expect_landed(kept->quality.lfe_rms, lfe, 0.84);
  }
}

TEST(HighpassSearch, BothLandTogetherWhicheverBinds) {
  for (const double ratio : {1.0, 3.0, 8.0, 20.0, 40.0, 60.0}) {
    FormulaTrials coder;
    const double vde = 2e-5;
    const auto kept = search_highpass({.bounds = {.vde = vde, .lfe = ratio * vde}}, coder);
    ASSERT_TRUE(kept) << ratio;
    const Quality& quality = kept->quality;
    EXPECT_LE(quality.vde_rms, vde) << ratio;
    EXPECT_LE(quality.lfe_rms, ratio * vde) << ratio;
    // One anchor for 500 vertices is few enough.
    if (kept->settings.anchors > FormulaTrials::kVertices / 500 + 1)
      expect_landed(quality.lfe_rms, ratio * vde, 0.8);
    if (ratio > 4) {
      EXPECT_GE(quality.vde_rms, 0.9 * vde) << ratio;
    }
  }
}

TEST(HighpassSearch, MaxErrorIsNeverExceeded) {
  for (const double max_error : {1e-1, 1e-2, 1e-3, 1e-4}) {
    for (const int effort : {0, 1, 2}) {
      FormulaTrials coder;
      const auto kept = search_highpass({.bounds = {.max_error = max_error}, .effort = effort}, coder);
      ASSERT_TRUE(kept);
      EXPECT_LE(kept->quality.max_error, max_error);
    }
  }
}

/// Diffusion does not help deltas that all become 0: what it carries on adds up.
class ZeroingTrials final : public FormulaTrials {
 public:
  Result<Candidate> make(const HighpassSettings& settings) override {
    DELTAMESH_TRY(Candidate figures, FormulaTrials::make(settings));
    if (settings.step < kLargestDelta || settings.diffusion == 0) return figures;
    figures.quality.vde_rms *= 8 * settings.diffusion;
    figures.quality.lfe_rms *= 40;
    figures.quality.max_error *= 40;
    return figures;
  }
};

TEST(HighpassSearch, AVdeThatTakesNoDeltaCostsNothing) {
  for (const double max_error : {5e-2, 2e-2, 1e-2, 5e-3}) {
    ZeroingTrials alone;
    const auto by_error = search_highpass({.bounds = {.max_error = max_error}}, alone);
    ASSERT_TRUE(by_error);
    ZeroingTrials both;
    const auto by_both = search_highpass({.bounds = {.vde = 0.004, .max_error = max_error}}, both);
    ASSERT_TRUE(by_both);
    EXPECT_LE(by_both->bytes, by_error->bytes * 101 / 100) << max_error;
    EXPECT_LE(by_both->quality.max_error, max_error);
  }
}

/// A mesh where a few vertices stick out until they are anchors themselves.
class PeakyTrials final : public FormulaTrials {
 public:
  static constexpr std::size_t kPeaks = 20;

  Result<Candidate> make(const HighpassSettings& settings) override {
    DELTAMESH_TRY(Candidate figures, FormulaTrials::make(settings));
    if (settings.more_anchors.size() < kPeaks) figures.quality.max_error *= 1.8;
    return figures;
  }
};

TEST(HighpassSearch, PeaksBecomeAnchorsBeforeTheStepShrinks) {
  PeakyTrials steady;
  const auto by_steady = search_highpass({.bounds = {.max_error = 1e-3}, .effort = 0}, steady);
  ASSERT_TRUE(by_steady);
  EXPECT_TRUE(by_steady->settings.more_anchors.empty());
  PeakyTrials mended;
  const auto by_mended = search_highpass({.bounds = {.max_error = 1e-3}, .effort = 1}, mended);
  ASSERT_TRUE(by_mended);
  EXPECT_GE(by_mended->settings.more_anchors.size(), PeakyTrials::kPeaks);
  EXPECT_GT(by_mended->settings.step, 1.2 * by_steady->settings.step);
  EXPECT_LT(by_mended->bytes, by_steady->bytes);
  EXPECT_LE(by_mended->quality.max_error, 1e-3);
}

TEST(HighpassSearch, FixedStepIsKeptAndAnchorsMove) {
  for (const double lfe : {1e-2, 2e-3, 3e-4, 1.1e-4}) {
    FormulaTrials coder;
    const auto kept = search_highpass({.bounds = {.lfe = lfe}, .step = 1e-4}, coder);
    ASSERT_TRUE(kept) << lfe;
    EXPECT_EQ(kept->settings.step, 1e-4);
    EXPECT_LE(kept->quality.lfe_rms, lfe);
  }
}

TEST(HighpassSearch, WithoutAQualityOneRunIsMade) {
  FormulaTrials coder;
  const auto kept = search_highpass({.step = 1e-3, .anchors = 50}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(coder.runs, 1);
  EXPECT_EQ(kept->settings.step, 1e-3);
  EXPECT_EQ(kept->settings.anchors, 50U);
}

TEST(HighpassSearch, FixedAnchorsAreKept) {
  FormulaTrials coder;
  const auto kept = search_highpass({.bounds = {.vde = 1e-4}, .anchors = 77}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->settings.anchors, 77U);
}

TEST(HighpassSearch, EffortZeroTakesFewRuns) {
  FormulaTrials quick;
  const auto by_quick = search_highpass({.bounds = {.vde = 2e-5, .lfe = 1e-4}, .effort = 0}, quick);
  ASSERT_TRUE(by_quick);
  FormulaTrials usual;
  const auto by_usual = search_highpass({.bounds = {.vde = 2e-5, .lfe = 1e-4}, .effort = 1}, usual);
  ASSERT_TRUE(by_usual);
  EXPECT_LE(quick.runs, 3);
  EXPECT_LT(quick.runs, usual.runs);
}

TEST(HighpassSearch, NothingWorseThanAllZeros) {
  FormulaTrials coder;  // 0.76 * 0.4 of the largest delta is the worst VDE there is
  const auto kept = search_highpass({.bounds = {.vde = 1}}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->settings.anchors, coder.fewest_anchors());
  EXPECT_NEAR(kept->quality.vde_rms, 0.304 * FormulaTrials::kLargestDelta, 1e-4);
}

TEST(HighpassSearch, BeyondFloatPrecisionSaysWhatCanBeHad) {
  FormulaTrials coder;
  const auto result = search_highpass({.bounds = {.vde = 1e-9}}, coder);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(result.error().best_value, 1e-9);
  EXPECT_LT(result.error().best_value, 5e-8);
  EXPECT_GT(result.error().best_bytes, 0U);
}

TEST(HighpassSearch, ByteBudgetIsUsedUpAndKept) {
  for (const std::uint64_t target : {2000U, 9000U, 30000U, 60000U}) {
    FormulaTrials coder;
    const auto kept = search_highpass({.target_bytes = target}, coder);
    ASSERT_TRUE(kept) << target;
    EXPECT_EQ(coder.runs, 1);
    const std::uint64_t bytes = kept->bytes;
    EXPECT_LE(bytes, target);
    EXPECT_GE(static_cast<double>(bytes), 0.97 * static_cast<double>(target));
  }
}

/// What planned cycles make of the deltas takes more bytes than the deltas that a step is chosen by.
class DisplacedTrials final : public FormulaTrials {
 public:
  double share = 0.01;  ///< by which it is more

  Result<Candidate> make(const HighpassSettings& settings) override {
    DELTAMESH_TRY(Candidate candidate, FormulaTrials::make(settings));
    candidate.bytes += static_cast<std::uint64_t>(share * static_cast<double>(candidate.bytes));
    return candidate;
  }
};

TEST(HighpassSearch, ByteBudgetIsKeptWhereDisplacedDeltasTakeMore) {
  for (const double share : {0.0005, 0.004, 0.03, 0.1}) {
    for (const std::uint64_t target : {2000U, 9000U, 30000U, 60000U}) {
      DisplacedTrials coder;
      coder.share = share;
      const auto kept = search_highpass({.target_bytes = target}, coder);
      ASSERT_TRUE(kept) << target << " " << share;
      EXPECT_LE(coder.runs, 4);
      EXPECT_LE(kept->bytes, target);
      EXPECT_GE(static_cast<double>(kept->bytes), 0.95 * static_cast<double>(target))
          << target << " " << share;
    }
  }
}

TEST(HighpassSearch, TooSmallABudgetTellsTheLeast) {
  FormulaTrials coder;
  const auto result = search_highpass({.target_bytes = 100}, coder);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(result.error().best_bytes, 200U);
}

TEST(HighpassSearch, QualityBeyondTheBudgetTellsTheSize) {
  FormulaTrials coder;
  const auto result = search_highpass({.bounds = {.vde = 1e-6}, .target_bytes = 10000}, coder);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(result.error().best_bytes, 10000U);
}

/// Coordinates leave float32 where the step is too large for the anchors.
class WildTrials final : public FormulaTrials {
 public:
  double largest_step = 0;
  Error error{.code = ErrorCode::kInvalidStream, .rule = "DELT-3"};

  Result<Candidate> make(const HighpassSettings& settings) override {
    const double anchors = settings.anchors;
    if (settings.step * std::sqrt(kVertices / anchors) > largest_step) return error;
    return FormulaTrials::make(settings);
  }
};

TEST(HighpassSearch, TrialsThatDoNotDecodeEndNoSearch) {
  for (const Bounds& bounds :
       {Bounds{.vde = 1e-3}, Bounds{.vde = 1}, Bounds{.lfe = 1e-3}, Bounds{.max_error = 4e-3},
        Bounds{.vde = 1e-4, .lfe = 1e-4}, Bounds{.vde = 1e-4, .lfe = 1e-2}, Bounds{.vde = 1e-4, .lfe = 1}}) {
    for (const double largest_step : {3e-2, 1e-2, 2e-3, 1e-4}) {
      for (const int effort : {0, 1, 2}) {
        WildTrials coder;
        coder.largest_step = largest_step;
        const auto kept = search_highpass({.bounds = bounds, .effort = effort}, coder);
        ASSERT_TRUE(kept) << largest_step << ' ' << effort << ' ' << describe(kept.error());
        EXPECT_LE(bounds.load(kept->quality), 1);
      }
    }
  }
}

TEST(HighpassSearch, FixedStepThatDoesNotDecodeTakesMoreAnchors) {
  WildTrials coder;
  coder.largest_step = 3e-4;
  const auto kept = search_highpass({.bounds = {.lfe = 1e-2}, .step = 1e-4}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->settings.step, 1e-4);
}

TEST(HighpassSearch, NoTrialThatDecodesTellsTheRule) {
  for (const Request& goal : {Request{.bounds = {.vde = 1e-3}}, Request{.bounds = {.lfe = 1e-3}},
                              Request{.bounds = {.vde = 1e-4, .lfe = 1e-4}},
                              Request{.bounds = {.max_error = 1e-3}}, Request{.target_bytes = 30000}}) {
    WildTrials coder;
    const auto result = search_highpass(goal, coder);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidStream);
    EXPECT_STREQ(result.error().rule, "DELT-3");
  }
}

TEST(HighpassSearch, OtherErrorsEndTheSearch) {
  WildTrials coder;
  coder.error = {.code = ErrorCode::kOutOfMemory};
  EXPECT_EQ(search_highpass({.bounds = {.vde = 1e-3}}, coder).error().code, ErrorCode::kOutOfMemory);
}

TEST(Bounds, AreKeptByTheDeclaredFloatToo) {
  const double bound = 0.1;  // the next float is larger
  EXPECT_GT(static_cast<double>(short_float_above(bound)), bound);
  EXPECT_GT((Bounds{.vde = bound}.load({.vde_rms = bound})), 1);
  EXPECT_GT((Bounds{.lfe = bound}.load({.lfe_rms = bound * (1 - 1e-12)})), 1);
  EXPECT_GT((Bounds{.max_error = bound}.load({.max_error = bound})), 1);
  EXPECT_LE((Bounds{.max_error = bound}.load({.max_error = bound * (1 - 0x1p-15)})), 1);
  EXPECT_EQ((Bounds{.max_error = 0.25}.load({.max_error = 0.25})), 1);
  EXPECT_DOUBLE_EQ((Bounds{.max_error = 0.25}.load({.max_error = 0.125})), 0.5);
  EXPECT_TRUE(std::isinf(short_float_above(1e39)));
  EXPECT_TRUE(std::isinf(Bounds{.vde = bound}.load({.vde_rms = 0.01, .max_error = 1e39})));
}

TEST(HighpassStep, InvertsTheDeltaError) {
  FormulaTrials trials;
  for (const double error : {1e-6, 1e-4, 2e-3}) {
    const double step = step_for_delta_error({}, error, trials);
    EXPECT_NEAR(trials.delta_error({.step = step}), error, 0.005 * error);
  }
  // More than all zeros: the coarsest step.
  EXPECT_GE(step_for_delta_error({}, 1, trials), 0.99 * coarsest_step(trials));
}

TEST(HighpassStep, LowRatesWeighBytes) {
  FormulaTrials trials;
  EXPECT_GT(settings_for_vde({}, 1.5e-3, trials).rate_weight, 0);
  EXPECT_EQ(settings_for_vde({}, 1e-6, trials).rate_weight, 0);
}

TEST(HighpassSearch, FloorOfTheAnchorsTakesMoreBits) {
  FormulaTrials trials;
  trials.anchor_floor = true;
  const auto kept = search_highpass({.bounds = {.vde = 1e-5}, .effort = 1}, trials);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->settings.anchor_bits, 24);
}

TEST(HighpassSearch, ForecastIsNearTheSearch) {
  for (const double vde : {1e-3, 1e-5}) {
    FormulaTrials trials;
    const Request request{.bounds = {.vde = vde}};
    const auto forecast = forecast_highpass_bytes(request, vde, trials);
    EXPECT_EQ(trials.runs, 0);
    const auto kept = search_highpass(request, trials);
    ASSERT_TRUE(forecast && kept);
    EXPECT_NEAR(static_cast<double>(*forecast), static_cast<double>(kept->bytes),
                0.05 * static_cast<double>(*forecast));
  }
}

}  // namespace
}  // namespace deltamesh
