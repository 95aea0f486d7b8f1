// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Predicts a vertex: a blend of parallelograms, of their edges and of coded neighbours, with weights by the
// numbers of parallelograms and of faces [POSN-4]. Integers only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "positions/surroundings.h"

namespace deltamesh {

/// Lattice coordinates; the decoder's are within 0 to kMostCells.
using Cell = std::array<std::int32_t, 3>;

inline constexpr int kBlendUnit = 64;       ///< weights are in parts of this
inline constexpr std::size_t kBlends = 24;  ///< 4 numbers of parallelograms x 6 of faces

struct Blend {
  std::int8_t parallelogram = kBlendUnit;  ///< of the mean parallelogram, from the neighbours' mean
  std::int8_t edge = 0;                    ///< of the mean of the parallelograms' edges, likewise
  bool operator==(const Blend&) const = default;
};
using BlendTable = std::array<Blend, kBlends>;

/// The default weights of a stream: about the means over scans, CAD parts and maps [POSN-8].
extern const BlendTable kUsualBlends;

/// The table's row for a vertex with `parallelograms`, at least one, and `faces`.
inline std::size_t blend_row(unsigned parallelograms, std::uint32_t faces) noexcept {
  return std::size_t{6} * (parallelograms - 1) + std::clamp(faces, 3U, 8U) - 3;
}
inline std::size_t blend_row(const Surroundings& around) noexcept {
  return blend_row(around.parallelogram_count, around.faces);
}

/// Corners as near to each other need no more than 32 bits: in 1/16 steps, sums of four a + b - o are below
/// 12 * 2^21, means of them within 3 * 2^21 and a neighbour's within 2^21, so that a blend is below
/// 128 * (4 + 2) * 2^21 < 2^31.
inline constexpr std::int32_t kNear = 1 << 17;

/// Means around a vertex, in 1/16 steps, from the first known face's corner a.
struct LocalMeans {
  std::array<std::int64_t, 3> neighbors{};
  std::array<std::int64_t, 3> parallelograms{};
  std::array<std::int64_t, 3> edges{};
};

/// Precondition: there is a parallelogram.
LocalMeans local_means(const Surroundings& around, std::span<const Cell> cells) noexcept;

/// An expected place and how far its sources lie apart, per axis; the fourth lanes of `whole` and
/// `offset` are 0.
struct Expectation {
  FourInts whole{};   ///< a lattice point
  FourInts offset{};  ///< from there to the place, 1/16 steps; less than 2^26 in size
  FourInts spread{};  ///< mean distance of the sources from their mean, 1/16 steps; at most 2^30
};

/// Without known faces the vertex before, or 0.
Expectation expect_place(const Surroundings& around, std::uint32_t vertex, std::span<const Cell> cells,
                         const BlendTable& table) noexcept;

}  // namespace deltamesh
