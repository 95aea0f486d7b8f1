// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "adapt/known_positions.h"

#include <algorithm>
#include <cmath>

#include "base/numbers/vec3.h"

namespace deltamesh {
namespace {

constexpr double kLeastWidth = 1.0 / (1 << 30);  // lattice steps; of a cell, so that its numbers have 54 bits

}  // namespace

KnownPositions::KnownPositions(double tolerance, double step)
    : tolerance_(tolerance), width_(std::max(4 * tolerance, kLeastWidth * step)) {}

KnownPositions::GridCell KnownPositions::cell_of(const Position& position, double shift) const noexcept {
  GridCell cell{};
  for (std::size_t k = 0; k < 3; ++k)
    cell[k] = static_cast<std::int64_t>(std::floor((double{position[k]} + shift) / width_));
  return cell;
}

KnownPositions::Known* KnownPositions::nearest(const Position& position) {
  Known* best = nullptr;
  double least = tolerance_ * tolerance_;
  const GridCell low = cell_of(position, -tolerance_);
  const GridCell high = cell_of(position, tolerance_);
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const auto [begin, end] = known_.equal_range({x, y, z});
        for (auto i = begin; i != end; ++i) {
          Known& known = i->second;
          const double distance = squared_distance(known.position, position);
          if (distance > least) continue;
          if (best != nullptr && distance == least && best->position < known.position) continue;
          best = &known;
          least = distance;
        }
      }
    }
  }
  return best;
}

KnownPositions::Position KnownPositions::settle(const Position& position, std::vector<Position>& used) {
  Known* known = nearest(position);
  if (known == nullptr) known = &known_.emplace(cell_of(position, 0), Known{position})->second;
  if (known->uses == 0 || known->last_used != block_) {
    ++known->uses;
    known->last_used = block_;
    used.push_back(known->position);
  }
  return known->position;
}

void KnownPositions::release(const std::vector<Position>& used) {
  for (const Position& position : used) {
    const auto [begin, end] = known_.equal_range(cell_of(position, 0));
    const auto found = std::find_if(begin, end, [&](const auto& k) { return k.second.position == position; });
    if (--found->second.uses == 0) known_.erase(found);
  }
}

}  // namespace deltamesh
