// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/lattice/exact_lattice.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace deltamesh {
namespace {

constexpr int kMostDecimals = 9;
constexpr double kBitsOfDigit = 3.33;
constexpr double kBitsOfPatch = 45;
constexpr std::size_t kOneIn = 10;  ///< coordinates that may be off

/// One axis of a lattice.
struct Comb {
  double origin;
  double step;
  std::int64_t first;
  std::int64_t cells;

  double at(std::int64_t q) const noexcept { return origin + step * static_cast<double>(first + q); }
};

bool is_same_float(double value, double coordinate) noexcept {
  return std::bit_cast<std::uint32_t>(static_cast<float>(value)) ==
         std::bit_cast<std::uint32_t>(static_cast<float>(coordinate));
}

/// How the coordinates of an axis lie on a comb.
struct CombFit {
  std::size_t off = 0;      ///< coordinates that are not on it
  std::int64_t common = 0;  ///< greatest common divisor of the others' steps from the origin
};

/// Empty as soon as too many are off.
std::optional<CombFit> fit_comb(std::span<const Vec3> positions, std::size_t axis,
                                const Comb& comb) noexcept {
  constexpr std::size_t kSpared = 16;
  CombFit fit;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double x = positions[v][axis];
    const auto q = static_cast<std::int64_t>(std::round((x - comb.origin) / comb.step)) - comb.first;
    if (is_same_float(comb.at(q), x)) {
      fit.common = std::gcd(fit.common, q);
    } else if (++fit.off > kSpared + v / kOneIn) {
      return std::nullopt;
    }
  }
  return fit;
}

/// Of multiples of 1 / unit. Empty where it has too many points.
std::optional<Comb> comb_of(const Box& box, std::size_t axis, double unit) noexcept {
  const double least = std::round(box.min[axis] * unit);
  const double cells = std::round(box.max[axis] * unit) - least;
  if (!(cells <= kMostCells) || !(std::abs(least) <= kMostFirst)) return std::nullopt;
  return Comb{0, 1 / unit, static_cast<std::int64_t>(least), static_cast<std::int64_t>(cells)};
}

/// The comb whose points and exceptions take least, of decimals; then coarser by what all steps share.
std::optional<Comb> find_comb(std::span<const Vec3> positions, const Box& box, std::size_t axis) {
  std::optional<Comb> best;
  CombFit best_fit;
  double least = 0;
  double unit = 1;
  for (int decimals = 0; decimals <= kMostDecimals; ++decimals, unit *= 10) {
    const auto comb = comb_of(box, axis, unit);
    const auto fit = comb ? fit_comb(positions, axis, *comb) : std::nullopt;
    if (!fit) continue;
    const double bits = kBitsOfDigit * decimals * static_cast<double>(positions.size()) +
                        kBitsOfPatch * static_cast<double>(fit->off);
    if (best && bits >= least) continue;
    best = comb;
    best_fit = *fit;
    least = bits;
    if (fit->off == 0) break;
  }
  if (!best || best_fit.common < 2 || best_fit.off > 0) return best;
  Comb coarse{best->at(0), best->step * static_cast<double>(best_fit.common), 0,
              best->cells / best_fit.common};
  if (best->first % best_fit.common == 0) {
    coarse.first = best->first / best_fit.common;
    coarse.origin = 0;
  }
  const auto fit = fit_comb(positions, axis, coarse);
  return fit && fit->off == 0 ? coarse : best;
}

}  // namespace

std::optional<PositionLattice> find_exact_lattice(std::span<const Vec3> positions, const Box& box) {
  if (positions.empty()) return std::nullopt;
  PositionLattice lattice;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto comb = find_comb(positions, box, axis);
    if (!comb) return std::nullopt;
    lattice.origin[axis] = comb->origin;
    lattice.first[axis] = comb->first;
    lattice.step[axis] = comb->step;
    lattice.cells[axis] = static_cast<std::uint32_t>(comb->cells);
  }
  return lattice;
}

std::vector<Replacement> find_replacements(std::span<const Vec3> positions, std::span<const Vec3> decoded) {
  std::vector<Replacement> replacements;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_same_float(decoded[v][axis], positions[v][axis])) continue;
      replacements.push_back({.coordinate = 3 * v + axis, .value = static_cast<float>(positions[v][axis])});
    }
  }
  return replacements;
}

}  // namespace deltamesh
