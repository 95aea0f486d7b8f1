// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <vector>

#include "base/try.h"
#include "highpass/cycles/compensation.h"
#include "highpass/cycles/plan.h"
#include "highpass/highpass.h"
#include "highpass/symbols.h"

namespace deltamesh {
namespace {

/// The encoder takes no more, although streams may have up to kMostCycles.
constexpr int kMostCyclesTried = 16;
/// More of them hardly ever lower the errors that rounding adds.
constexpr int kBestCycles = 10;
/// LeftOut::lost over the roughness that rounding adds, which is half a step where few deltas are 0.
constexpr double kMostLost = 0.085;
/// Of rounding errors, what is left out before the last step of compensation, which leaves a tenth of it.
constexpr double kMostLeft = 0.5;
/// Of a coded stream: its roughness over that of rounding errors, and the bytes of its deltas over those
/// without compensation. LFE is not compared, as it depends too much on chance.
constexpr double kMostRough = 1.02;
constexpr double kMostBytes = 1.003;
constexpr std::size_t kFewBytes = 16;  ///< differ by chance

/// Distance that is small against the rounding of positions to floats, over the longest side.
constexpr double kInvisible = 0x1p-26;

}  // namespace

double HighpassCoder::invisible() const noexcept { return kInvisible * box_.longest_side(); }

Result<std::vector<PlanErrors>> HighpassCoder::rounding_errors(const HighpassSettings& settings) {
  const Anchors anchors = anchors_for(settings);
  DELTAMESH_CHECK(quantize(settings, deltas_, quantized_));
  const HighpassSymbols symbols = symbols_for(quantized_, anchors, settings.anchor_bits, positions_);
  std::vector<PlanErrors> errors;
  DELTAMESH_CHECK(follow_rounding(positions_, deltas_, symbols, part_, solver_, box_,
                                  parameters_for(settings, anchors, quantized_.shift, kBestCycles),
                                  [&](int cycles, std::span<const Vec3> found) {
                                    errors.push_back(errors_of(part_.graph, found));
                                    return cycles < kBestCycles;
                                  }));
  return errors;
}

Result<int> HighpassCoder::first_that_leave_little(const HighpassSettings& settings, double most_left_out,
                                                   double most_lost) {
  const FlatDeltas flat(part_.graph, quantized_.symbols);
  int first = 1;
  const auto look = [&](int cycles, std::span<const Vec3> errors) {
    first = cycles;
    const LeftOut left = flat.left_out(errors);
    const bool is_little = left.largest <= most_left_out && left.lost <= most_lost;
    return !is_little && cycles < kMostCyclesTried;
  };
  DELTAMESH_CHECK(uncompensated().follow(solver_, first_anchor_rows(settings), look));
  return first;
}

bool HighpassCoder::serve(const HighpassSettings& settings, int cycles, const PlanErrors& rounding,
                          std::size_t most_bytes) {
  const auto result = code(settings, cycles);
  if (!result || result->deltas.size() > most_bytes) return false;
  std::vector<Vec3> errors(part_.row_count);
  for (std::uint32_t row = 0; row < errors.size(); ++row)
    errors[row] = result->positions[part_.vertex(row)] - positions_[part_.vertex(row)];
  return source_->left_out.rms <= std::max(kMostLeft * rounding.rms, invisible()) &&
         errors_of(part_.graph, errors).roughness <= std::max(kMostRough * rounding.roughness, invisible());
}

Result<int> HighpassCoder::fewest_cycles(const HighpassSettings& settings, double most_left_out) {
  if (part_.row_count == 0) return 1;
  source_.reset();
  DELTAMESH_TRY(const std::vector<PlanErrors> rounding, rounding_errors(settings));
  const PlanErrors& least = rounding.back();
  DELTAMESH_TRY(int cycles, first_that_leave_little(settings, most_left_out,
                                                    std::max(kMostLost * least.roughness, invisible())));
  const auto are_fair = [&](int so_many) {
    return so_many >= kBestCycles ||
           rounding[static_cast<std::size_t>(so_many - 1)].are_fair(least, invisible());
  };
  while (!are_fair(cycles)) ++cycles;
  DELTAMESH_TRY(const CodedHighpass plain, code_only(settings));
  const auto most_bytes =
      static_cast<std::size_t>(kMostBytes * static_cast<double>(plain.deltas.size())) + kFewBytes;
  for (int stride = 1; cycles < kMostCyclesTried && !serve(settings, cycles, least, most_bytes); stride *= 2)
    cycles = std::min(cycles + stride, kMostCyclesTried);
  return cycles;
}

}  // namespace deltamesh
