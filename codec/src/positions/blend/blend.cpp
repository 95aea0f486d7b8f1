// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/blend/blend.h"

#include "base/numbers/mean.h"

namespace deltamesh {

constinit const BlendTable kUsualBlends = [] {
  constexpr std::array<std::int8_t, Surroundings::kMostKnown> kParallelogram = {45, 55, 50, 45};
  BlendTable table{};
  for (std::size_t row = 0; row < kBlends; ++row) table[row].parallelogram = kParallelogram[row / 6];
  return table;
}();

namespace {

/// Lanes for differences that are too large for 32 bits, as in coarse meshes on fine lattices.
using FourLongs = std::int64_t __attribute__((vector_size(32)));

/// In 1/16 steps, from the first known face's corner a.
template <class Lanes>
struct Means {
  Lanes neighbors{};
  Lanes parallelograms{};
  Lanes edges{};
  Lanes spread{};
};

// By reference, as 32 bytes are passed by value in more than one way.
[[gnu::always_inline]] inline void widen(FourInts lanes, FourLongs& result) noexcept {
  result = __builtin_convertvector(lanes, FourLongs);
}
/// What is not within kNear loses its high bits: nothing comes of it, but it must not overflow on the way.
[[gnu::always_inline]] inline void widen(FourInts lanes, FourInts& result) noexcept {
  constexpr int kUnused = 14;
  static_assert(kNear == 1 << (31 - kUnused));
  result = (lanes << kUnused) >> kUnused;
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

/// [POSN-4]. False where a corner is not within kNear of the base, which matters to lanes of 32 bits.
template <class Lanes>
[[gnu::always_inline]] inline bool take_means(const Surroundings& around, std::span<const Cell> cells,
                                              Means<Lanes>& means) noexcept {
  const FourInts base = four_ints(cells[around.known[0].a]);
  FourInts beyond{};
  const auto from_base = [&](std::uint32_t vertex, Lanes& result) {
    const FourInts difference = four_ints(cells[vertex]) - base;
    beyond |= difference + kNear;
    widen(difference, result);
  };
  std::array<Lanes, Surroundings::kMostKnown> corners;  // a + b - o
  unsigned count = 0;
  for (unsigned i = 0; i < around.known_count; ++i) {
    const KnownFace& face = around.known[i];
    Lanes a;
    Lanes b;
    from_base(face.a, a);
    from_base(face.b, b);
    b += a;
    means.neighbors += b;
    Lanes repeated;
    widen(FourInts{} + around.repeated[static_cast<int>(i)], repeated);
    means.neighbors -= a & repeated;
    if (face.opposite == kNoVertex) continue;
    from_base(face.opposite, a);
    means.edges += b;
    b -= a;
    means.parallelograms += b;
    corners[count++] = b;
  }
  means.neighbors <<= 4;
  divide(means.neighbors, around.neighbor_count);
  if (count == 0) {
    for (unsigned i = 0; i < around.known_count; ++i) {
      for (const std::uint32_t corner : {around.known[i].a, around.known[i].b}) {
        Lanes from;
        from_base(corner, from);
        add_size((from << 4) - means.neighbors, means.spread);
      }
    }
    divide(means.spread, 2 * around.known_count);
  } else {
    means.parallelograms <<= 4;
    means.edges <<= 3;
    if (count > 1) {
      if (count == 3) {
        divide(means.parallelograms, count);
        divide(means.edges, count);
      } else {  // the same, quicker
        means.parallelograms >>= count / 2;
        means.edges >>= count / 2;
      }
      for (unsigned i = 0; i < count; ++i) add_size((corners[i] << 4) - means.parallelograms, means.spread);
      if (count == 3) {
        divide(means.spread, count);
      } else {
        means.spread >>= count / 2;
      }
    }
  }
  return set_lanes((beyond & ~(2 * kNear - 1)) != 0) == 0;
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

[[gnu::noinline]] Expectation expect_far(const Surroundings& around, std::span<const Cell> cells,
                                         const BlendTable& table) noexcept {
  Means<FourLongs> means;
  take_means(around, cells, means);
  FourLongs place;
  blend_means(means, around, table, place);
  const Cell& base = cells[around.known[0].a];
  Expectation result;
  for (int axis = 0; axis < 3; ++axis) {
    result.whole[axis] = static_cast<std::int32_t>(std::clamp<std::int64_t>(
        base[static_cast<std::size_t>(axis)] + (place[axis] >> 4), -kFarthest, kFarthest));
    result.offset[axis] = static_cast<std::int32_t>(place[axis] & 15);
    result.spread[axis] = static_cast<std::int32_t>(std::min<std::int64_t>(means.spread[axis], kFarthest));
  }
  return result;
}

template <class Lanes>
LocalMeans local_means_of(const Means<Lanes>& means) noexcept {
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
  Means<FourInts> means;
  if (take_means(around, cells, means)) return local_means_of(means);
  Means<FourLongs> far;
  take_means(around, cells, far);
  return local_means_of(far);
}

Expectation expect_place(const Surroundings& around, std::uint32_t vertex, std::span<const Cell> cells,
                         const BlendTable& table) noexcept {
  Expectation result;
  if (around.known_count == 0) {
    if (vertex > 0) result.whole = four_ints(cells[vertex - 1]);
    return result;
  }
  Means<FourInts> means;
  if (!take_means(around, cells, means)) return expect_far(around, cells, table);
  result.whole = four_ints(cells[around.known[0].a]);
  blend_means(means, around, table, result.offset);
  result.spread = means.spread;
  return result;
}

}  // namespace deltamesh
