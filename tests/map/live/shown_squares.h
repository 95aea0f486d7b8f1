// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a receiver shows of a world of squares.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "deltamesh/map/receiver.h"
#include "map/map_world.h"

namespace deltamesh::test {

using Heights = std::array<float, 4>;

struct ShownSquares {
  std::map<Square, Heights> heights;  ///< NaN where no vertex is at the corner
  std::string wrong;                  ///< empty: nothing
};

/// With a crack, or two parts in one place, `wrong` says so.
inline ShownSquares squares_of(const MapReceiver& receiver) {
  ShownSquares shown;
  std::map<std::pair<float, float>, float> corners;
  const auto keys = receiver.shown();
  for (const PartKey& key : keys) {
    for (const PartKey& other : keys)
      if (other != key && overlap(key, other)) shown.wrong = "two parts in one place";
    const Mesh& mesh = receiver.find(key)->mesh;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      const float* p = &mesh.positions[3 * v];
      const std::pair corner(std::round(p[0]), std::round(p[1]));
      if (corners.try_emplace(corner, p[2]).first->second != p[2])
        shown.wrong = "a crack at " + std::to_string(corner.first) + ", " + std::to_string(corner.second);
    }
    for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
      std::array<float, 2> sum{};
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t axis = 0; axis < 2; ++axis)
          sum[axis] += mesh.positions[3 * std::size_t{mesh.triangles[3 * f + c]} + axis];
      shown.heights[{static_cast<std::int32_t>(std::floor(sum[0] / 3)),
                     static_cast<std::int32_t>(std::floor(sum[1] / 3)), 0}] = {};
    }
  }
  for (auto& [square, heights] : shown.heights)
    for (int i = 0; i < 4; ++i) {
      const auto corner =
          corners.find({static_cast<float>(square[0] + i % 2), static_cast<float>(square[1] + i / 2)});
      heights[static_cast<std::size_t>(i)] = corner == corners.end() ? std::nanf("") : corner->second;
    }
  return shown;
}

/// What squares were at which times.
class WorldHistory {
 public:
  void add(const World& world, double now) {
    for (int x = 0; x < world.edge(); ++x)
      for (int y = 0; y < world.edge(); ++y) {
        auto& versions = versions_[{x, y, 0}];
        const auto heights = world.heights_of({x, y, 0});
        if (versions.empty() || versions.back().second != heights) versions.emplace_back(now, heights);
      }
  }

  /// Since when something newer than what is shown there has been; nothing: the newest is shown.
  std::optional<double> outdated_since(const Square& square, const ShownSquares& shown, float error) const {
    const auto found = shown.heights.find(square);
    std::optional<double> since;
    const auto& versions = versions_.at(square);
    for (auto version = versions.rbegin(); version != versions.rend(); ++version) {
      const auto& [time, heights] = *version;
      const bool is_it =
          found == shown.heights.end() ? !heights : heights && near(*heights, found->second, error);
      if (is_it) return since;
      since = time;
    }
    return since;
  }

 private:
  static bool near(const Heights& a, const Heights& b, float error) {
    for (std::size_t i = 0; i < 4; ++i)
      if (!(std::abs(a[i] - b[i]) <= error)) return false;
    return true;
  }

  std::map<Square, std::vector<std::pair<double, std::optional<Heights>>>> versions_;
};

}  // namespace deltamesh::test
