// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What an encoder codes of normals: groups of equal ones, and of the lattice points within the bound the one
// nearest to the prediction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "attributes/normal_lattice.h"
#include "attributes/normal_prediction.h"
#include "base/large_vector.h"

namespace deltamesh {

/// The largest distance of unit vectors, at the bound in use.
struct NormalBound {
  double chord;  ///< of the whole bound
  double same;   ///< at most this far apart normals are one
};

/// The source of a NormalTraversal that writes.
class NormalChoice {
 public:
  /// `normals`: n x 3.
  NormalChoice(std::span<const float> normals, const NormalBound& bound, const NormalLattice& lattice)
      : bound_(bound), lattice_(lattice) {
    reserve_large(originals_, normals.size() / 3);
    for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
      Vec3 normal{normals[i], normals[i + 1], normals[i + 2]};
      normalize(normal);
      originals_.push_back(normal);
    }
  }

  /// Unit length or 0.
  const Vec3& original(std::uint32_t v) const noexcept { return originals_[v]; }

  bool is_zero(std::uint32_t v) const noexcept { return original(v) == Vec3{}; }
  bool same(std::uint32_t v, std::uint32_t u) const noexcept {
    if (is_zero(v) != is_zero(u)) return false;
    const Vec3 off = original(v) - original(u);
    return dot(off, off) <= bound_.same * bound_.same;
  }

  /// Of the lattice points within the bound of all `vertices`, which are same(), the one nearest to the
  /// prediction.
  LatticePoint choose(const NormalForecast& forecast, std::span<const std::uint32_t> vertices) const {
    const auto x = point_of(forecast.frame, original(vertices[0]));
    const double square = x[0] * x[0] + x[1] * x[1];
    // Further out the lattice is narrower on the sphere.
    const double reach = lattice_.radius() * (1 + std::fmin(square, 1)) * 1.0001;
    const double rows = lattice_.row_distance();
    const double places = lattice_.place_distance();
    LatticePoint best;
    double best_square = std::numeric_limits<double>::infinity();
    const auto last_row = static_cast<std::int32_t>(std::floor((x[0] + reach) / rows));
    for (auto row = static_cast<std::int32_t>(std::ceil((x[0] - reach) / rows)); row <= last_row; ++row) {
      const double off = x[0] - rows * row;
      const double width = std::sqrt(std::fmax(0, reach * reach - off * off));
      const double shift = (row & 1) != 0 ? 0.5 : 0.0;
      const auto last = static_cast<std::int32_t>(std::floor((x[1] + width) / places - shift));
      for (auto place = static_cast<std::int32_t>(std::ceil((x[1] - width) / places - shift)); place <= last;
           ++place) {
        const LatticePoint point{row, place};
        const auto at = lattice_.at(point);
        const double from_pole = static_cast<double>(at[0] * at[0] + at[1] * at[1]);
        if (from_pole >= best_square || !fits(forecast, point, vertices)) continue;
        best_square = from_pole;
        best = point;
      }
    }
    return best;
  }

 private:
  bool fits(const NormalForecast& forecast, const LatticePoint& point,
            std::span<const std::uint32_t> vertices) const {
    FourFloats direction{};
    if (!direction_at(forecast.frame, lattice_.at(point), direction)) return false;
    Vec3 decoded = widen(direction);
    normalize(decoded);
    return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
      const Vec3 off = decoded - original(v);
      return dot(off, off) <= bound_.chord * bound_.chord;
    });
  }

  std::vector<Vec3> originals_;
  NormalBound bound_;
  NormalLattice lattice_;
};

}  // namespace deltamesh
