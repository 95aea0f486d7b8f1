// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "base/try.h"
#include "highpass/cycle_plan.h"
#include "highpass/highpass.h"
#include "highpass/symbols.h"

namespace deltamesh {
namespace {

/// Of compensation, for each number of cycles: the second is nearly exact.
constexpr int kMostRounds = 2;

/// What makes a difference to the cost of a plan; and how many numbers of cycles are tried in a row where
/// compensation makes none: these have converged, or diverge, and more of them are no better.
constexpr double kGain = 0.002;
constexpr int kMostInVain = 2;

/// Distance that is small against the rounding of positions to floats, over the longest side.
constexpr double kInvisible = 0x1p-26;

/// What planned cycles can keep in 32 bits [DELT-7].
bool can_be_planned(std::span<const std::int32_t> deltas) noexcept {
  return std::all_of(deltas.begin(), deltas.end(),
                     [](std::int32_t q) { return std::abs(q) < kLargestPlannedSymbol; });
}

Error too_large_to_plan() {
  return {.code = ErrorCode::kInvalidArgument,
          .message = "deltas are too large for planned cycles",
          .rule = "DELT-7"};
}

}  // namespace

HighpassCoder::Attempt HighpassCoder::plan_for(int cycles, const HighpassSettings& settings,
                                               const Anchors& anchors, const PlanJudge& judge,
                                               const std::function<bool(const CodedHighpass&)>& accepts) {
  Attempt attempt;
  PlanCost plain;
  const std::vector<std::uint32_t> rows = anchor_rows(anchors.vertices, part_);
  Compensation source(part_, positions_, middle(box_));
  for (int round = 0; round <= kMostRounds; ++round) {
    if (round > 0 && !source.improve(solver_, rows, cycles)) break;
    const auto quantized = quantize(settings, source.deltas());
    if (!quantized || !can_be_planned(quantized->symbols)) break;
    const HighpassSymbols symbols =
        symbols_for(*quantized, anchors, settings.anchor_bits, source.positions());
    const HighpassParameters parameters = parameters_for(settings, anchors, quantized->shift, cycles);
    auto positions = reconstruct_highpass(symbols, part_, solver_, box_, parameters);
    if (!positions) break;
    const PlanCost cost = judge.cost(*positions);
    if (cost.is_fair()) {
      attempt.coded = coded(parameters, *quantized, symbols);
      attempt.coded->positions = *std::move(positions);
      if (accepts(*attempt.coded)) return attempt;
      attempt.coded.reset();
    }
    if (round == 0) {
      plain = cost;
      continue;
    }
    attempt.gains |= cost.rms < plain.rms - kGain || cost.roughness < plain.roughness - kGain;
    if (!cost.is_close()) break;
  }
  return attempt;
}

std::optional<CodedHighpass> HighpassCoder::plan(const HighpassSettings& settings,
                                                 std::span<const Vec3> settled,
                                                 const std::function<bool(const CodedHighpass&)>& accepts) {
  if (part_.row_count == 0) return std::nullopt;
  const PlanJudge judge(part_, positions_, settled, kInvisible * box_.longest_side());
  const Anchors anchors = anchors_for(settings);
  int in_vain = 0;
  for (int cycles = 1; cycles <= kMostCyclesTried && in_vain < kMostInVain; ++cycles) {
    Attempt attempt = plan_for(cycles, settings, anchors, judge, accepts);
    if (attempt.coded) return std::move(attempt.coded);
    in_vain = attempt.gains ? 0 : in_vain + 1;
  }
  return std::nullopt;
}

Result<CodedHighpass> HighpassCoder::code_planned(const HighpassSettings& settings, int cycles) {
  const Anchors anchors = anchors_for(settings);
  DELTAMESH_CHECK(quantize_own(settings));
  if (!can_be_planned(quantized_.symbols)) return too_large_to_plan();
  const std::vector<std::uint32_t> rows = anchor_rows(anchors.vertices, part_);
  Compensation source(part_, positions_, middle(box_));
  for (int round = 0; round < kMostRounds; ++round) DELTAMESH_CHECK(source.improve(solver_, rows, cycles));
  const HighpassSymbols symbols = symbols_for(quantized_, anchors, settings.anchor_bits, source.positions());
  const HighpassParameters parameters = parameters_for(settings, anchors, quantized_.shift, cycles);
  CodedHighpass result = coded(parameters, quantized_, symbols);
  DELTAMESH_TRY(result.positions, reconstruct_highpass(symbols, part_, solver_, box_, parameters));
  return result;
}

}  // namespace deltamesh
