// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/convergence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace deltamesh::settling {
namespace {

/// Of the errors to expect, that may be still to come.
constexpr double kShare = 0.05;

/// In units that no number of the problem is above 2 of: below the rounding of positions to floats.
constexpr double kInvisible = 0x1p-28;

/// What each step leaves of the size of the one before, at best and at worst, as far as it is believed.
constexpr double kLowestRate = 0.1;
constexpr double kHighestRate = 0.98;

/// Of the last step, the last two or four, whichever is worst. 0 stands for steps that there were none of.
double rate_of(double size, const std::array<double, 4>& last) noexcept {
  double rate = last[0] > 0 ? std::max(size / last[0], kLowestRate) : kHighestRate;
  if (last[1] > 0) rate = std::max(rate, std::sqrt(size / last[1]));
  if (last[3] > 0) rate = std::max(rate, std::sqrt(std::sqrt(size / last[3])));
  return std::min(rate, kHighestRate);
}

}  // namespace

Convergence::Convergence(const Components& components, std::size_t anchors, double noise)
    : components_(components),
      anchors_(static_cast<double>(anchors)),
      noise_(noise),
      last_(components.count),
      last_excess_(components.count, std::numeric_limits<double>::infinity()),
      excess_(components.count, 0.0) {}

bool Convergence::see(std::span<const Progress> progress) {
  double functional = 0;
  for (const Progress& p : progress) functional += std::max(p.functional - p.decrease, 0.0);
  const double noise = std::min(noise_, functional / (3 * anchors_));
  bool settled = true;
  for (std::size_t c = 0; c < components_.count; ++c) {
    const Progress& p = progress[c];
    const double expected = std::sqrt(3 * noise * p.probe);
    const double allowed = std::max(kShare * expected, kInvisible * std::sqrt(components_.size[c]));
    const auto squares = [&](const Double4& v) { return v.xy[0] + v.xy[1] + v.zw[0] + 3 * noise * v.zw[1]; };
    const double size = std::sqrt(std::max(squares(p.proposed), squares(p.taken)));
    const double rate = rate_of(size, last_[c]);
    last_[c] = {size, last_[c][0], last_[c][1], last_[c][2]};
    const double now = size * rate / (1 - rate) / allowed;
    excess_[c] = std::max(now, std::exchange(last_excess_[c], now));
    if (!(excess_[c] <= 1)) settled = false;  // NaN is not settled
  }
  return settled;
}

std::size_t Convergence::unsettled_vertices() const noexcept {
  std::size_t vertices = 0;
  for (std::size_t c = 0; c < components_.count; ++c) vertices += excess_[c] <= 1 ? 0 : components_.size[c];
  return vertices;
}

std::vector<std::uint8_t> Convergence::unsettled(double most) const {
  std::vector<std::uint8_t> marks;
  for (const double excess : excess_) marks.push_back(excess <= most ? 0 : 1);
  return marks;
}

}  // namespace deltamesh::settling
