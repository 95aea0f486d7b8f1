// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which pair of steps to code for a value that may be off by half a cell's diagonal, and what the payload of
// such values is. Encoder only.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/prediction/pair_coder.h"

namespace deltamesh {

/// Chooses one of the four lattice points around a place, in steps from the prediction: the one nearest to
/// the prediction for which will_do() is true. The circle of the bound contains at least one of them, as the
/// cell's diagonal is its diameter; if none passes because of rounding, the one nearest to the place.
template <class WillDo>
NumberPair choose_pair(const std::array<double, 2>& steps, WillDo will_do) {
  const auto whole = [](double x) { return static_cast<std::int32_t>(x); };
  const auto square = [](const NumberPair& pair) {
    return static_cast<double>(pair[0]) * pair[0] + static_cast<double>(pair[1]) * pair[1];
  };
  NumberPair best = {whole(std::round(steps[0])), whole(std::round(steps[1]))};
  double least = square(best);
  for (std::int32_t k = 0; k < 4; ++k) {
    const NumberPair pair = {whole(std::floor(steps[0])) + (k & 1), whole(std::floor(steps[1])) + (k >> 1)};
    if (square(pair) >= least || !will_do(pair)) continue;
    best = pair;
    least = square(pair);
  }
  return best;
}

/// `step`, then the compact stream [ATTR-31, ATTR-38].
inline std::vector<std::byte> step_and_stream(float step, std::span<const std::byte> stream) {
  std::vector<std::byte> bytes(sizeof step + stream.size());
  const auto bits = std::bit_cast<std::uint32_t>(step);
  for (std::size_t k = 0; k < sizeof step; ++k) bytes[k] = static_cast<std::byte>(bits >> (8 * k));
  std::copy(stream.begin(), stream.end(), bytes.begin() + sizeof step);
  return bytes;
}

}  // namespace deltamesh
