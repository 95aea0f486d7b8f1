// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/anchor_bits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace deltamesh {
namespace {

constexpr int kMostAnchorBits = 24;

// One anchor for so many vertices.
constexpr std::uint32_t kSparse = 500;
constexpr std::uint32_t kForLfe = 200;
constexpr std::uint32_t kForMaxError = 50;

// Largest side of a lattice cell against each bound. A vertex that is coded as an anchor is off by half a
// side in the root mean square and by 0.87 sides at most; solved vertices feel a small part of it.
constexpr double kCellPerLfe = 0.5;
constexpr double kCellPerMaxError = 0.6;
constexpr double kCellPerVde = 8;
constexpr double kCellPerVdeOfSmall = 0.8;

}  // namespace

int anchor_bits_for(const Bounds& bounds, int least, TrialCoder& coder) {
  double side = std::numeric_limits<double>::infinity();
  if (bounds.lfe) side = std::min(side, kCellPerLfe * *bounds.lfe);
  if (bounds.max_error) side = std::min(side, kCellPerMaxError * *bounds.max_error);
  if (bounds.vde)
    side = std::min(side, (coder.has_small_components() ? kCellPerVdeOfSmall : kCellPerVde) * *bounds.vde);
  int bits = least;
  while (bits < kMostAnchorBits && coder.longest_side() > side * (std::ldexp(1.0, bits) - 1)) ++bits;
  return bits;
}

std::uint32_t usual_anchors(const Bounds& bounds, TrialCoder& coder) {
  const std::uint32_t vertices = bounds.max_error ? kForMaxError : bounds.lfe ? kForLfe : kSparse;
  const std::uint32_t wanted = coder.most_anchors() / vertices + 1;
  return std::clamp(wanted, coder.fewest_anchors(), std::max(coder.fewest_anchors(), coder.most_anchors()));
}

}  // namespace deltamesh
