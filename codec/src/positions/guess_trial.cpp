// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/guess_trial.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "base/numbers/portable_math.h"
#include "positions/guesses.h"

namespace deltamesh {
namespace {

constexpr std::size_t kSampledCells = 256;
/// Bits that guesses have to save for each bit of saying which are right. The line was drawn through what
/// both ways take on the corpus.
constexpr double kWorth = 1.15;

/// Straight lines between powers of two.
double about_log2(std::uint64_t x) noexcept {
  const int whole = static_cast<int>(std::bit_width(x)) - 1;
  return whole - 1 + static_cast<double>(x) / static_cast<double>(std::uint64_t{1} << whole);
}

/// Bits of choosing between two things of which one has this share.
double entropy(double share) noexcept {
  return share > 0 && share < 1 ? -share * portable_log2(share) - (1 - share) * portable_log2(1 - share) : 0;
}

}  // namespace

bool guesses_pay(const KnownFaces& faces, std::span<const Cell> cells,
                 const std::array<std::uint32_t, 3>& largest, const BlendTable& blends) {
  double saved = 0;  // bits of residuals that need not be coded
  double hits = 0;
  double count = 0;
  const FourInts most = four_ints({largest[0], largest[1], largest[2], 0U});
  const std::size_t stride = 1 + cells.size() / kSampledCells;
  for (std::size_t i = 0; i < cells.size(); i += stride) {
    const auto vertex = static_cast<std::uint32_t>(i);
    const Surroundings around = faces.around(vertex);
    if (around.known_count == 0) continue;
    const Expectation place = expect_place(around, vertex, cells, blends);
    const FourInts nearest = place.whole + ((place.offset + 8) >> 4);
    const FourInts expected = smaller_lanes(larger_lanes(nearest, FourInts{}), most);
    const Guesses guesses = guesses_around(around, cells, expected, most);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t value = cells[i][axis];
      const auto off = static_cast<std::uint64_t>(std::abs(value - expected[static_cast<int>(axis)]));
      const double bits = about_log2(1 + 2 * off);
      const bool hit = guesses.symbol_of(axis, value) != 0;
      count += 1;
      hits += hit ? 1 : 0;
      saved += hit ? bits : 0;
    }
  }
  return saved > kWorth * count * entropy(hits / std::max(count, 1.0));
}

}  // namespace deltamesh
