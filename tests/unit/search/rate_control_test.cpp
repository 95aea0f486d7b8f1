// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/rate_control.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers/short_float.h"
#include "search/step_search.h"
#include "search/visual_control.h"
#include "support/formula_coder.h"

namespace deltamesh {
namespace {

using test::FormulaCoder;

void expect_landed(double achieved, double asked, double least) {
  EXPECT_LE(achieved, asked);
  EXPECT_GE(achieved, least * asked);
}

TEST(RateControl, VdeLandsWithinTwoCorrections) {
  for (const double vde : {1e-3, 1e-4, 1e-5, 1e-6}) {
    FormulaCoder coder;
    const auto kept = control_rate({.bounds = {.vde = vde}}, coder);
    ASSERT_TRUE(kept) << vde;
    EXPECT_LE(coder.runs, 3);
    EXPECT_EQ(kept->settings.diffusion, 0);
    expect_landed(kept->figures.quality.vde_rms, vde, 0.95);
  }
}

TEST(RateControl, LfeAloneLandsUnderFullDiffusion) {
  for (const double lfe : {1e-2, 1e-3, 1e-4}) {
    FormulaCoder coder;
    const auto kept = control_rate({.bounds = {.lfe = lfe}}, coder);
    ASSERT_TRUE(kept) << lfe;
    EXPECT_EQ(kept->settings.diffusion, 1);
    expect_landed(kept->figures.quality.lfe_rms, lfe, 0.88);
  }
}

TEST(RateControl, BothLandTogetherWhicheverBinds) {
  for (const double ratio : {1.0, 3.0, 8.0, 20.0, 40.0, 60.0}) {
    FormulaCoder coder;
    const double vde = 2e-5;
    const auto kept = control_rate({.bounds = {.vde = vde, .lfe = ratio * vde}}, coder);
    ASSERT_TRUE(kept) << ratio;
    const Quality& quality = kept->figures.quality;
    EXPECT_LE(quality.vde_rms, vde) << ratio;
    expect_landed(quality.lfe_rms, ratio * vde, 0.85);
    if (ratio > 4) {
      EXPECT_GE(quality.vde_rms, 0.9 * vde) << ratio;
    }
  }
}

TEST(RateControl, MaxErrorIsNeverExceeded) {
  for (const double max_error : {1e-1, 1e-2, 1e-3, 1e-4}) {
    for (const int effort : {0, 5, 9}) {
      FormulaCoder coder;
      const auto kept = control_rate({.bounds = {.max_error = max_error}, .effort = effort}, coder);
      ASSERT_TRUE(kept);
      EXPECT_LE(kept->figures.quality.max_error, max_error);
    }
  }
}

/// A mesh where a few vertices stick out until they are anchors themselves.
class PeakyCoder final : public FormulaCoder {
 public:
  static constexpr std::size_t kPeaks = 20;

  Result<TrialFigures> run(const HighpassSettings& settings) override {
    DELTAMESH_TRY(TrialFigures figures, FormulaCoder::run(settings));
    if (settings.more_anchors.size() < kPeaks) figures.quality.max_error *= 4;
    return figures;
  }
};

TEST(RateControl, PeaksBecomeAnchorsBeforeTheStepShrinks) {
  PeakyCoder steady;
  const auto by_steady = control_rate({.bounds = {.max_error = 1e-3}, .effort = 2}, steady);
  ASSERT_TRUE(by_steady);
  EXPECT_TRUE(by_steady->settings.more_anchors.empty());
  PeakyCoder mended;
  const auto by_mended = control_rate({.bounds = {.max_error = 1e-3}, .effort = 5}, mended);
  ASSERT_TRUE(by_mended);
  EXPECT_GE(by_mended->settings.more_anchors.size(), PeakyCoder::kPeaks);
  EXPECT_GT(by_mended->settings.step, 2 * by_steady->settings.step);
  EXPECT_LT(by_mended->figures.bytes, by_steady->figures.bytes);
  EXPECT_LE(by_mended->figures.quality.max_error, 1e-3);
}

TEST(RateControl, FixedStepIsKeptAndAnchorsMove) {
  for (const double lfe : {1e-2, 2e-3, 3e-4, 1.1e-4}) {
    FormulaCoder coder;
    const auto kept = control_rate({.bounds = {.lfe = lfe}, .step = 1e-4}, coder);
    ASSERT_TRUE(kept) << lfe;
    EXPECT_EQ(kept->settings.step, 1e-4);
    EXPECT_LE(kept->figures.quality.lfe_rms, lfe);
  }
}

TEST(RateControl, WithoutAQualityOneRunIsMade) {
  FormulaCoder coder;
  const auto kept = control_rate({.step = 1e-3, .anchors = 50}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(coder.runs, 1);
  EXPECT_EQ(kept->settings.step, 1e-3);
  EXPECT_EQ(kept->settings.anchors, 50U);
}

TEST(RateControl, FixedAnchorsAreKept) {
  FormulaCoder coder;
  const auto kept = control_rate({.bounds = {.vde = 1e-4}, .anchors = 77}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->settings.anchors, 77U);
}

TEST(RateControl, EffortZeroTakesFewRuns) {
  FormulaCoder quick;
  const auto by_quick = control_rate({.bounds = {.vde = 2e-5, .lfe = 1e-4}, .effort = 0}, quick);
  ASSERT_TRUE(by_quick);
  FormulaCoder usual;
  const auto by_usual = control_rate({.bounds = {.vde = 2e-5, .lfe = 1e-4}, .effort = 5}, usual);
  ASSERT_TRUE(by_usual);
  EXPECT_LE(quick.runs, 3);
  EXPECT_LT(quick.runs, usual.runs);
}

TEST(RateControl, ARivalFarAheadEndsTheSearchBeforeItStarts) {
  for (const Bounds& bounds : {Bounds{.vde = 2e-5}, Bounds{.vde = 2e-5, .lfe = 1e-4}}) {
    for (const int effort : {0, 5}) {
      FormulaCoder coder;
      const auto lost = control_rate({.bounds = bounds, .effort = effort, .rival_bytes = 5000}, coder);
      ASSERT_FALSE(lost);
      EXPECT_EQ(lost.error().code, ErrorCode::kUnmetRequest);
      EXPECT_EQ(coder.runs, 0);
      EXPECT_TRUE(control_rate({.bounds = bounds, .effort = effort, .rival_bytes = 90000}, coder));
    }
  }
}

TEST(RateControl, ARivalAheadSavesTrials) {
  for (const Bounds& bounds : {Bounds{.lfe = 1e-3}, Bounds{.max_error = 4e-3}}) {
    FormulaCoder alone;
    const auto by_alone = control_rate({.bounds = bounds}, alone);
    ASSERT_TRUE(by_alone);
    FormulaCoder beaten;
    const auto by_beaten = control_rate({.bounds = bounds, .rival_bytes = 2000}, beaten);
    ASSERT_TRUE(by_beaten);
    EXPECT_LT(beaten.runs, alone.runs);
    EXPECT_LE(bounds.load(by_beaten->figures.quality), 1);
  }
}

TEST(RateControl, NothingWorseThanAllZeros) {
  FormulaCoder coder;  // 0.76 * 0.4 of the largest delta is the worst VDE there is
  const auto kept = control_rate({.bounds = {.vde = 1}}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->settings.anchors, coder.fewest_anchors());
  EXPECT_NEAR(kept->figures.quality.vde_rms, 0.304 * FormulaCoder::kLargestDelta, 1e-4);
}

TEST(RateControl, BeyondFloatPrecisionSaysWhatCanBeHad) {
  FormulaCoder coder;
  const auto result = control_rate({.bounds = {.vde = 1e-9}}, coder);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(result.error().best_value, 1e-9);
  EXPECT_LT(result.error().best_value, 5e-8);
  EXPECT_GT(result.error().best_bytes, 0U);
}

TEST(RateControl, ByteBudgetIsUsedUpAndKept) {
  for (const std::uint64_t target : {2000U, 9000U, 30000U, 60000U}) {
    FormulaCoder coder;
    const auto kept = control_rate({.target_bytes = target}, coder);
    ASSERT_TRUE(kept) << target;
    EXPECT_EQ(coder.runs, 1);
    const std::uint64_t bytes = kept->figures.bytes;
    EXPECT_LE(bytes, target);
    EXPECT_GE(static_cast<double>(bytes), 0.97 * static_cast<double>(target));
  }
}

TEST(RateControl, TooSmallABudgetTellsTheLeast) {
  FormulaCoder coder;
  const auto result = control_rate({.target_bytes = 100}, coder);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(result.error().best_bytes, 200U);
}

TEST(RateControl, QualityBeyondTheBudgetTellsTheSize) {
  FormulaCoder coder;
  const auto result = control_rate({.bounds = {.vde = 1e-6}, .target_bytes = 10000}, coder);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(result.error().best_bytes, 10000U);
}

/// Coordinates leave float32 where the step is too large for the anchors.
class WildCoder final : public FormulaCoder {
 public:
  double largest_step = 0;
  Error error{.code = ErrorCode::kInvalidStream, .rule = "DELT-3"};

  Result<TrialFigures> run(const HighpassSettings& settings) override {
    const double anchors = settings.anchors;
    if (settings.step * std::sqrt(kVertices / anchors) > largest_step) return error;
    return FormulaCoder::run(settings);
  }
};

TEST(RateControl, TrialsThatDoNotDecodeEndNoSearch) {
  for (const Bounds& bounds :
       {Bounds{.vde = 1e-3}, Bounds{.vde = 1}, Bounds{.lfe = 1e-3}, Bounds{.max_error = 4e-3},
        Bounds{.vde = 1e-4, .lfe = 1e-4}, Bounds{.vde = 1e-4, .lfe = 1e-2}, Bounds{.vde = 1e-4, .lfe = 1}}) {
    for (const double largest_step : {3e-2, 1e-2, 2e-3, 1e-4}) {
      for (const int effort : {0, 5, 9}) {
        WildCoder coder;
        coder.largest_step = largest_step;
        const auto kept = control_rate({.bounds = bounds, .effort = effort}, coder);
        ASSERT_TRUE(kept) << largest_step << ' ' << effort << ' ' << describe(kept.error());
        EXPECT_LE(bounds.load(kept->figures.quality), 1);
      }
    }
  }
}

TEST(RateControl, FixedStepThatDoesNotDecodeTakesMoreAnchors) {
  WildCoder coder;
  coder.largest_step = 3e-4;
  const auto kept = control_rate({.bounds = {.lfe = 1e-2}, .step = 1e-4}, coder);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->settings.step, 1e-4);
}

TEST(RateControl, NoTrialThatDecodesTellsTheRule) {
  for (const RateGoal& goal : {RateGoal{.bounds = {.vde = 1e-3}}, RateGoal{.bounds = {.lfe = 1e-3}},
                               RateGoal{.bounds = {.vde = 1e-4, .lfe = 1e-4}},
                               RateGoal{.bounds = {.max_error = 1e-3}}, RateGoal{.target_bytes = 30000}}) {
    WildCoder coder;
    const auto result = control_rate(goal, coder);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidStream);
    EXPECT_STREQ(result.error().rule, "DELT-3");
  }
}

TEST(RateControl, OtherErrorsEndTheSearch) {
  WildCoder coder;
  coder.error = {.code = ErrorCode::kOutOfMemory};
  EXPECT_EQ(control_rate({.bounds = {.vde = 1e-3}}, coder).error().code, ErrorCode::kOutOfMemory);
}

/// Says what the next run will give.
class ScriptedCoder final : public FormulaCoder {
 public:
  TrialFigures next{};
  Result<TrialFigures> run(const HighpassSettings&) override { return next; }
};

TEST(Trials, LandingIsWorthBytesOnlyWithinTheTarget) {
  const TrialFigures fits{.quality = {.vde_rms = 0.5}, .bytes = 990};
  const TrialFigures lands{.quality = {.vde_rms = 0.95}, .bytes = 1005};
  const auto best_bytes = [&](std::optional<std::uint64_t> target, bool landed_first) {
    ScriptedCoder coder;
    Trials trials(coder, {.bounds = {.vde = 1}, .target_bytes = target});
    for (const bool landed : {landed_first, !landed_first}) {
      coder.next = landed ? lands : fits;
      EXPECT_TRUE(trials.run({}));
    }
    return trials.best()->figures.bytes;
  };
  for (const bool landed_first : {false, true}) {
    EXPECT_EQ(best_bytes(std::nullopt, landed_first), 1005U);
    EXPECT_EQ(best_bytes(1010, landed_first), 1005U);
    EXPECT_EQ(best_bytes(1000, landed_first), 990U);
    EXPECT_EQ(best_bytes(900, landed_first), 990U);  // the size that a refusal tells
  }
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

TEST(StepSearch, ModelInvertsTheDeltaError) {
  FormulaCoder coder;
  for (const double start : {1e-7, 1e-4, 0.02}) {
    for (const double error : {1e-6, 1e-4, 2e-3}) {
      const double step = step_for_delta_error(coder, {.step = start}, error);
      EXPECT_NEAR(coder.delta_error({.step = step}), error, 0.005 * error);
    }
  }
  // More than all zeros: the coarsest step.
  EXPECT_GE(step_for_delta_error(coder, {.step = 1e-4}, 1), 0.99 * coarsest_step(coder));
}

TEST(StepSearch, FloorOfTheAnchorsTakesMoreBits) {
  FormulaCoder coder;
  Trials trials(coder, {.bounds = {.lfe = 2e-6}});
  const auto attempt = search_step(trials, {.step = 1e-4, .anchors = 100, .anchor_bits = 8}, Watch::kAll, {});
  ASSERT_TRUE(attempt);
  EXPECT_GT(attempt->settings.anchor_bits, 8);
  EXPECT_LE(attempt->figures.quality.lfe_rms, 2e-6);
}

TEST(VisualControl, LowRatesWeighBytes) {
  FormulaCoder coder;
  EXPECT_EQ(settings_for_vde(coder, {.step = 1e-3}, 1.5e-3, 5).rate_weight, kRateWeight);
  EXPECT_EQ(settings_for_vde(coder, {.step = 1e-3}, 1.5e-3, 0).rate_weight, 0);
  EXPECT_EQ(settings_for_vde(coder, {.step = 1e-3}, 1e-6, 5).rate_weight, 0);
}

}  // namespace
}  // namespace deltamesh
