// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "field/field_context.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "base/mean.h"

namespace deltamesh {
namespace {

constexpr unsigned kMostNeighbors = 16;  ///< so that no sum leaves 32 bits
static_assert(kMostNeighbors <= kMostMeaned);

void add(FieldMemory& sum, const FieldMemory& m) noexcept {
  for (std::size_t a = 0; a < 3; ++a) sum.q[a] += m.q[a];
  for (std::size_t a = 0; a < 3; ++a) sum.magnitude[a] += m.magnitude[a];
  for (std::size_t t = 0; t < 6; ++t) sum.moments[t] += m.moments[t];
}

/// 0.6 new + 0.4 old, as 5/8 and 3/8.
std::int32_t smooth(std::int32_t now, std::int32_t before) noexcept { return (5 * now + 3 * before) >> 3; }

}  // namespace

FieldNeighborhood FieldHistory::around(std::uint32_t vertex) const noexcept {
  FieldNeighborhood around;
  around.degree_class = std::clamp<std::uint32_t>(graph_.degree(vertex), 3, 10) - 3;
  unsigned count = 0;
  for (const std::uint32_t neighbor : graph_.of(vertex)) {
    if (neighbor >= vertex || count == kMostNeighbors) break;
    ++count;
    add(around.means, memories_[neighbor]);
  }
  if (count == 0) return around;
  around.empty = false;
  const auto divide = [count](std::int32_t& x) { x = static_cast<std::int32_t>(mean_of(x, count)); };
  for (std::int32_t& x : around.means.q) divide(x);
  for (std::int32_t& x : around.means.magnitude) divide(x);
  for (std::int32_t& x : around.means.moments) divide(x);
  return around;
}

void FieldHistory::remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& q,
                            const FieldNeighborhood& before) noexcept {
  FieldMemory& m = memories_[vertex];
  std::array<std::int32_t, 3> factor{};
  for (std::size_t a = 0; a < 3; ++a) {
    m.q[a] = std::clamp(q[a], -kLargestRemembered, kLargestRemembered) * kFieldUnit;
    m.magnitude[a] = std::abs(m.q[a]);
    factor[a] = std::clamp(q[a], -kLargestMultiplied, kLargestMultiplied);
  }
  std::size_t t = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a; b < 3; ++b) m.moments[t++] = factor[a] * factor[b] * kFieldUnit;
  if (before.empty) return;
  for (std::size_t a = 0; a < 3; ++a) m.magnitude[a] = smooth(m.magnitude[a], before.means.magnitude[a]);
  for (t = 0; t < 6; ++t) m.moments[t] = smooth(m.moments[t], before.means.moments[t]);
}

}  // namespace deltamesh
