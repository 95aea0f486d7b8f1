// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/blend.h"

#include <algorithm>

#include "base/mean.h"

namespace deltamesh {

constinit const BlendTable kUsualBlends = [] {
  constexpr std::array<std::int8_t, Surroundings::kMostKnown> kParallelogram = {45, 55, 50, 45};
  BlendTable table{};
  for (std::size_t row = 0; row < kBlends; ++row) table[row].parallelogram = kParallelogram[row / 6];
  return table;
}();

std::size_t blend_row(const Surroundings& around) noexcept {
  return std::size_t{6} * (around.parallelogram_count - 1) + std::clamp(around.faces, 3U, 8U) - 3;
}

namespace {

constexpr unsigned kMost = Surroundings::kMostKnown;

/// Lanes for differences that are too large for 32 bits, as in coarse meshes on fine lattices.
using FourLongs = std::int64_t __attribute__((vector_size(32)));

/// Known faces' corners, from the first one's corner a.
struct KnownCells {
  FourInts base;
  std::array<FourInts, kMost> a;
  std::array<FourInts, kMost> b;
  std::array<FourInts, kMost> opposite;
  bool are_near;  ///< all within kNear of the base: means and blends of them do with 32 bits
};

/// In 1/16 steps, sums of four a + b - o are below 12 * 2^21, means of them within 3 * 2^21 and a neighbour's
/// within 2^21, so that a blend is below 128 * (4 + 2) * 2^21 < 2^31.
constexpr std::int32_t kNear = 1 << 17;

[[gnu::always_inline]] inline KnownCells known_cells(const Surroundings& around,
                                                     std::span<const Cell> cells) noexcept {
  KnownCells known;
  known.base = four_ints(cells[around.known[0].a]);
  FourInts beyond{};
  const auto from_base = [&](std::uint32_t vertex) {
    const FourInts difference = four_ints(cells[vertex]) - known.base;
    beyond |= difference + kNear;
    return difference;
  };
  for (unsigned i = 0; i < around.known_count; ++i) {
    const KnownFace& face = around.known[i];
    known.a[i] = from_base(face.a);
    known.b[i] = from_base(face.b);
    known.opposite[i] = face.opposite != kNoVertex ? from_base(face.opposite) : FourInts{};
  }
  known.are_near = set_lanes((beyond & ~(2 * kNear - 1)) != 0) == 0;
  return known;
}

/// In 1/16 steps, from the base.
template <class Lanes>
struct Means {
  Lanes neighbors{};
  Lanes parallelograms{};
  Lanes edges{};
  Lanes spread{};
};

// By reference, as 32 bytes are passed by value in more than one way.
template <class Lanes>
[[gnu::always_inline]] inline void widen(FourInts lanes, Lanes& result) noexcept {
  result = __builtin_convertvector(lanes, Lanes);
}
[[gnu::always_inline]] inline void divide(FourInts& sum, unsigned count) noexcept {
  sum = mean_lanes(sum, count);
}
[[gnu::always_inline]] inline void divide(FourLongs& sum, unsigned count) noexcept {
  sum = (sum * kOneOver[count]) >> 16;
}
template <class Lanes>
[[gnu::always_inline]] inline void add_size(const Lanes& lanes, Lanes& sum) noexcept {
  const Lanes sign = lanes < 0;
  sum += (lanes ^ sign) - sign;
}

/// [POSN-4]
template <class Lanes>
[[gnu::always_inline]] inline void take_means(const Surroundings& around, const KnownCells& known,
                                              Means<Lanes>& means) noexcept {
  std::array<Lanes, kMost> corners;  // a + b - o
  std::array<Lanes, 2 * kMost> all;  // a and b
  unsigned count = 0;
  for (unsigned i = 0; i < around.known_count; ++i) {
    Lanes& a = all[std::size_t{2} * i];
    Lanes& b = all[std::size_t{2} * i + 1];
    widen(known.a[i], a);
    widen(known.b[i], b);
    const Lanes ends = a + b;
    means.neighbors += ends;
    if (around.repeated[static_cast<int>(i)] != 0) means.neighbors -= a;
    if (around.known[i].opposite == kNoVertex) continue;
    widen(known.opposite[i], corners[count]);
    corners[count] = ends - corners[count];
    means.edges += ends;
    means.parallelograms += corners[count];
    ++count;
  }
  means.neighbors <<= 4;
  divide(means.neighbors, around.neighbor_count);
  if (count == 0) {
    for (unsigned i = 0; i < 2 * around.known_count; ++i)
      add_size((all[i] << 4) - means.neighbors, means.spread);
    divide(means.spread, 2 * around.known_count);
    return;
  }
  means.parallelograms <<= 4;
  divide(means.parallelograms, count);
  means.edges <<= 3;
  divide(means.edges, count);
  for (unsigned i = 0; i < count; ++i) add_size((corners[i] << 4) - means.parallelograms, means.spread);
  divide(means.spread, count);
}

/// Where `means` lead, from the base.
template <class Lanes>
[[gnu::always_inline]] inline void blend_means(const Means<Lanes>& means, const Surroundings& around,
                                               const BlendTable& table, Lanes& place) noexcept {
  place = means.neighbors;
  if (around.parallelogram_count == 0) return;
  const Blend& blend = table[blend_row(around)];
  place += ((means.parallelograms - means.neighbors) * blend.parallelogram +
            (means.edges - means.neighbors) * blend.edge) >>
           6;
}

constexpr std::int64_t kFarthest = std::int64_t{1} << 30;  ///< lattice points; a spread's 1/16 steps

[[gnu::noinline]] Expectation expect_far(const Surroundings& around, const KnownCells& known,
                                         const BlendTable& table) noexcept {
  Means<FourLongs> means;
  take_means(around, known, means);
  FourLongs place;
  blend_means(means, around, table, place);
  Expectation result;
  for (int axis = 0; axis < 3; ++axis) {
    result.whole[axis] = static_cast<std::int32_t>(
        std::clamp<std::int64_t>(known.base[axis] + (place[axis] >> 4), -kFarthest, kFarthest));
    result.offset[axis] = static_cast<std::int32_t>(place[axis] & 15);
    result.spread[axis] = static_cast<std::int32_t>(std::min<std::int64_t>(means.spread[axis], kFarthest));
  }
  return result;
}

template <class Lanes>
LocalMeans local_means_of(const Surroundings& around, const KnownCells& known) noexcept {
  Means<Lanes> means;
  take_means(around, known, means);
  LocalMeans result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    result.neighbors[a] = means.neighbors[axis];
    result.parallelograms[a] = means.parallelograms[axis];
    result.edges[a] = means.edges[axis];
  }
  return result;
}

}  // namespace

LocalMeans local_means(const Surroundings& around, std::span<const Cell> cells) noexcept {
  const KnownCells known = known_cells(around, cells);
  if (known.are_near) return local_means_of<FourInts>(around, known);
  return local_means_of<FourLongs>(around, known);
}

Expectation expect_place(const Surroundings& around, std::uint32_t vertex, std::span<const Cell> cells,
                         const BlendTable& table) noexcept {
  Expectation result;
  if (around.known_count == 0) {
    if (vertex > 0) result.whole = four_ints(cells[vertex - 1]);
    return result;
  }
  const KnownCells known = known_cells(around, cells);
  if (!known.are_near) return expect_far(around, known, table);
  Means<FourInts> means;
  take_means(around, known, means);
  result.whole = known.base;
  blend_means(means, around, table, result.offset);
  result.spread = means.spread;
  return result;
}

}  // namespace deltamesh
