// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/convergence.h"

#include <algorithm>

namespace deltamesh::settling {
namespace {

/// Of the functional, that may be still to come; and that is tolerable where no more can be done. Less where
/// there are few anchors, as chance may have made the functional large.
constexpr double kShare = 0.01;
constexpr double kManyAnchors = 64;
constexpr double kTolerable = 0.5;

/// For each anchor, in units that no number of the problem is above 2 of: far below the rounding of positions
/// to floats.
constexpr double kInvisible = 0x1p-60;

/// What each step leaves of the size of the one before, at best and at worst, as far as it is believed.
constexpr double kLowestRate = 0.1;
constexpr double kHighestRate = 0.98;

/// A length that is so far from 1 tells of a proposal that was wrong about what is left.
constexpr double kPoorMatch = 0.5;
constexpr double kSmall = 0.1;  ///< of what is allowed: then proposals may be wrong

}  // namespace

Convergence::Convergence(const Components& components, std::span<const std::uint32_t> anchors)
    : components_(components),
      anchors_(components.count, 0),
      anchor_count_(static_cast<std::uint32_t>(anchors.size())),
      last_(components.count, 0.0),
      excess_(components.count, 0.0) {
  for (const std::uint32_t anchor : anchors) ++anchors_[components.label[anchor]];
}

bool Convergence::see(std::span<const Progress> progress) {
  double functional = 0;
  for (const Progress& p : progress) functional += p.functional;
  const double mean = functional / anchor_count_;
  const double share = kShare * std::min(1.0, anchor_count_ / kManyAnchors);
  bool settled = true;
  for (std::size_t c = 0; c < components_.count; ++c) {
    const Progress& p = progress[c];
    const double allowed =
        std::max(share * std::max(mean * anchors_[c], p.functional), kInvisible * anchors_[c]);
    const double size = std::max(p.decrease, p.proposed);
    const double rate = std::clamp(last_[c] > 0 ? size / last_[c] : kHighestRate, kLowestRate, kHighestRate);
    last_[c] = size;
    excess_[c] = size * rate / (1 - rate) / allowed;
    if (p.mismatch > kPoorMatch && p.proposed > kSmall * allowed)
      excess_[c] = std::max(excess_[c], 1 + p.proposed / allowed);
    if (!(excess_[c] <= 1)) settled = false;  // NaN is not settled
  }
  return settled;
}

std::size_t Convergence::unsettled_vertices() const noexcept {
  std::size_t vertices = 0;
  for (std::size_t c = 0; c < components_.count; ++c) vertices += excess_[c] <= 1 ? 0 : components_.size[c];
  return vertices;
}

std::vector<std::uint8_t> Convergence::unsettled(bool tolerantly) const {
  const double most = tolerantly ? kTolerable / kShare : 1;
  std::vector<std::uint8_t> marks;
  for (const double excess : excess_) marks.push_back(excess <= most ? 0 : 1);
  return marks;
}

}  // namespace deltamesh::settling
