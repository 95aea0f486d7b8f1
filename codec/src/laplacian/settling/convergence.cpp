// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/convergence.h"

#include <algorithm>
#include <cmath>

namespace deltamesh::settling {
namespace {

/// Largest error that may remain, as a share of the errors to expect.
constexpr double kShare = 0.06;

/// Of positions, where no number of the problem is above 2: smaller moves vanish when positions are rounded
/// to floats.
constexpr double kInvisible = 0x1p-28;

/// What each step leaves of the size of the one before, at best, as far as it is believed.
constexpr double kLowestRate = 0.3;

/// Of the last step, the last two or four, whichever is worst. 0 stands for steps that there were none of.
double rate_of(double size, const std::array<double, 4>& last, double highest) noexcept {
  double rate = last[0] > 0 ? std::max(size / last[0], kLowestRate) : highest;
  if (last[1] > 0) rate = std::max(rate, std::sqrt(size / last[1]));
  if (last[3] > 0) rate = std::max(rate, std::sqrt(std::sqrt(size / last[3])));
  return std::min(rate, highest);
}

double probe_of(const Double4& squares) noexcept { return squares.zw[1]; }

}  // namespace

Convergence::Convergence(const Components& components, std::span<const std::uint32_t> anchors, double noise,
                         double highest_rate)
    : components_(components),
      noise_(noise),
      highest_rate_(highest_rate),
      anchors_(components.count, 0.0),
      history_(components.count),
      excess_(components.count, 0.0) {
  for (const std::uint32_t anchor : anchors) ++anchors_[components.label[anchor]];
}

bool Convergence::see(std::span<const Progress> progress) {
  std::vector<double> expected;  // squares
  double all = 0;
  for (std::size_t c = 0; c < components_.count; ++c) {
    const Progress& p = progress[c];
    const double left =
        std::max(p.functional - p.decrease, 0.0);  // the next step may lower it by as much again
    expected.push_back(3 * std::min(noise_, left / (3 * anchors_[c])) * p.probe);
    all += expected.back();
  }
  const double mean = all / static_cast<double>(components_.label.size());
  bool settled = true;
  for (std::size_t c = 0; c < components_.count; ++c) {
    const Progress& p = progress[c];
    const double size = std::sqrt(std::max(sum_of_axes(p.proposed), sum_of_axes(p.taken)));
    const double probe_size = std::sqrt(std::max(probe_of(p.proposed), probe_of(p.taken)));
    const double rate = history_[c].see(size, probe_size, highest_rate_);
    const double vertices = components_.size[c];
    const double allowed = std::max(kShare * std::sqrt(std::max(expected[c], mean * vertices)),
                                    kInvisible * std::sqrt(vertices));
    excess_[c] = size * rate / (1 - rate) / allowed;
    if (!(excess_[c] <= 1)) settled = false;  // NaN is not settled
  }
  return settled;
}

/// The rate at which sizes fall, from now on.
double Convergence::History::see(double size, double probe_size, double highest_rate) noexcept {
  const double rate =
      std::max(rate_of(size, sizes, highest_rate), rate_of(probe_size, probe_sizes, highest_rate));
  sizes = {size, sizes[0], sizes[1], sizes[2]};
  probe_sizes = {probe_size, probe_sizes[0], probe_sizes[1], probe_sizes[2]};
  return rate;
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
