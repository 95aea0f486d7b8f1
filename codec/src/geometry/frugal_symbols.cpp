// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/frugal_symbols.h"

namespace deltamesh {

std::array<std::int32_t, 3> FrugalSymbols::choose(std::uint32_t vertex,
                                                  const std::array<std::int32_t, 3>& nearest,
                                                  const Vec3& target) {
  return field_.choose_vertex(vertex, [&](unsigned axis, const auto& price) {
    const std::int32_t symbol = nearest[axis];
    if (symbol == 0) return symbol;
    const std::int32_t smaller = symbol > 0 ? symbol - 1 : symbol + 1;
    const auto cost = [&](std::int32_t q) {
      const double error = (target[axis] - quantizer_.value(q)) / quantizer_.step;
      return error * error + weight_ * price(q);
    };
    return cost(smaller) < cost(symbol) ? smaller : symbol;
  });
}

}  // namespace deltamesh
