// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is known around two children before the difference of their values is [HAAR-8, HAAR-9].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "attributes/haar/color_axes.h"
#include "attributes/haar/levels/levels.h"
#include "attributes/haar/log_class.h"
#include "base/simd/eight_shorts.h"
#include "base/simd/four_ints.h"

namespace deltamesh {

/// A node of the level that is being decoded, as far as it is known: before its parent is split, all is the
/// parent's.
struct HaarRecord {
  static constexpr std::size_t kSizes = 4;  ///< lane of the first size

  /// By axis: values in the first lanes; from kSizes on sizes of coefficients around here, 16ths of a step.
  /// All others 0.
  EightShorts lanes;
  HaarNode node;

  std::int16_t value(std::size_t axis) const noexcept { return lanes[axis]; }
  std::int16_t size(std::size_t axis) const noexcept { return lanes[kSizes + axis]; }
};

/// The lanes of a record, axis by axis. In two registers: what is stored in pieces is slow to load as a
/// whole.
class HaarLanes {
 public:
  /// Once for each axis.
  void set(std::size_t axis, std::int16_t value, std::int16_t size) noexcept {
    halves_[0] |= std::uint64_t{static_cast<std::uint16_t>(value)} << (16 * axis);
    halves_[1] |= std::uint64_t{static_cast<std::uint16_t>(size)} << (16 * axis);
  }
  EightShorts lanes() const noexcept { return std::bit_cast<EightShorts>(halves_); }

 private:
  static_assert(HaarRecord::kSizes == 4);
  std::array<std::uint64_t, 2> halves_{};
};

/// Shares of neighbours by the octaves of squared distances over that of the children: 128 / (d + 3/4)^2,
/// rounded down [HAAR-8]; 0 from 2 * kHaarShareReach on. All distances that there are have one.
inline constexpr std::uint32_t kHaarShareReach = 64;  ///< 16ths of an octave to both sides
inline constexpr auto kHaarShares = [] {
  std::array<std::uint16_t, 2048> shares{};
  for (std::uint32_t i = 0; i < 2 * kHaarShareReach; ++i) {
    const std::uint64_t d = std::uint64_t{16 + i % 16} << (i / 16);  // 256 times the ratio
    shares[i] = static_cast<std::uint16_t>((std::uint64_t{128} << 16) / ((d + 192) * (d + 192)));
  }
  return shares;
}();
inline constexpr std::uint32_t kHaarOwnShare = 38;  ///< of the parent's own value

struct HaarSurroundings {
  std::array<std::int32_t, kHaarAxes> difference{};  ///< expected, of the children's values
  std::array<std::uint32_t, kHaarAxes> spread{};     ///< mean size of differences to the parent's value
  std::array<std::uint32_t, kHaarAxes> sizes{};  ///< mean of the sizes around; own ones without neighbours
};

class HaarNeighborhood {
 public:
  /// `level`: of the children; `records`: of its nodes.
  HaarNeighborhood(const HaarLevel& level, const HaarRecord* records) noexcept
      : level_(level), records_(records) {}

  template <unsigned kAxes>
  HaarSurroundings look(const HaarChildren& pair, const HaarRecord& parent) const noexcept {
    const FourInts first = level_.nodes[pair.first].lanes();
    const FourInts second = level_.nodes[pair.second].lanes();
    const std::uint32_t unit = distance_class(first - second);
    const Sums a = sum(pair.first, pair.second, first, unit, parent);
    const Sums b = sum(pair.second, pair.first, second, unit, parent);
    HaarSurroundings around;
    const std::int64_t of_a = kOne / (a.shares + kHaarOwnShare);
    const std::int64_t of_b = kOne / (b.shares + kHaarOwnShare);
    const std::uint32_t shares = a.shares + b.shares;
    const std::uint64_t of_all = shares > 0 ? kOne / shares : 0;
    const FourInts spread = a.spread + b.spread;
    const FourInts sizes = a.sizes + b.sizes;
    for (std::size_t t = 0; t < kAxes; ++t) {
      around.difference[t] =
          static_cast<std::int32_t>(((a.values[t] * of_a - b.values[t] * of_b) * kDamping) >> (kOneBits + 8));
      around.spread[t] = mean(spread[t], of_all);
      around.sizes[t] = shares > 0 ? mean(sizes[t], of_all) : static_cast<std::uint32_t>(parent.size(t));
    }
    return around;
  }

 private:
  static constexpr unsigned kOneBits = 26;
  static constexpr std::uint32_t kOne = 1U << kOneBits;
  static constexpr std::int64_t kDamping = 182;  ///< 256ths

  static std::uint32_t mean(std::int32_t sum, std::uint64_t of_all) noexcept {
    return static_cast<std::uint32_t>((static_cast<std::uint32_t>(sum) * of_all) >> kOneBits);
  }

  /// Over the neighbours of a child, with their shares. 16 neighbours at most, shares of at most 193 and
  /// differences below 2^15: sums are below 2^30.
  struct Sums {
    std::uint32_t shares = 0;
    FourInts values{};  ///< differences to the parent's
    FourInts spread{};
    FourInts sizes{};
  };

  Sums sum(std::uint32_t child, std::uint32_t sibling, FourInts place, std::uint32_t unit,
           const HaarRecord& parent) const noexcept {
    Sums sums;
    const auto neighbors = level_.graph.of(child);
    // Two at once, the last with one of share 0.
    for (std::size_t k = 0; k < neighbors.size(); k += 2) {
      const bool has_second = k + 1 < neighbors.size();
      const std::uint32_t j = neighbors[k];
      const std::uint32_t l = neighbors[has_second ? k + 1 : k];
      const std::int32_t share_of_j = share(j, place, unit, j == sibling);
      const std::int32_t share_of_l = share(l, place, unit, !has_second | (l == sibling));
      const EightShorts shares = in_turns(share_of_j, share_of_l);
      sums.shares += static_cast<std::uint32_t>(share_of_j + share_of_l);
      const EightShorts way_of_j = way(records_[j], parent);
      const EightShorts way_of_l = way(records_[l], parent);
      sums.values += weighted_sums(way_of_j, way_of_l, shares);
      sums.spread += weighted_sums(lane_sizes(way_of_j), lane_sizes(way_of_l), shares);
      sums.sizes += weighted_high_sums(records_[j].lanes, records_[l].lanes, shares);
    }
    return sums;
  }

  static std::uint32_t distance_class(FourInts difference) noexcept {
    return log_class<4>(std::max(squared_distance(difference), 1.0));
  }
  /// `is_none`: then it is so far off that its share is 0.
  std::int32_t share(std::uint32_t neighbor, FourInts place, std::uint32_t unit,
                     bool is_none) const noexcept {
    constexpr std::uint32_t kFarOff = kHaarShares.size() / 2;
    const std::uint32_t octaves = distance_class(records_[neighbor].node.lanes() - place) + kHaarShareReach;
    return kHaarShares[octaves - std::min(octaves, unit) + (is_none ? kFarOff : 0)];
  }

  static EightShorts way(const HaarRecord& record, const HaarRecord& parent) noexcept {
    return wrapped_difference(record.lanes, parent.lanes);
  }

  const HaarLevel& level_;
  const HaarRecord* records_;
};

}  // namespace deltamesh
