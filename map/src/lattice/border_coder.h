// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codes which vertices of a decoded part are on its border, and the offsets of their lattice points [MAP-11].
// One template for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/numbers/zigzag.h"
#include "deltamesh/map/part.h"
#include "entropy/coder/counted_bit.h"
#include "entropy/coder/number_model.h"
#include "lattice/border_colors.h"
#include "support/open_edges.h"

namespace deltamesh {

/// The decoded mesh as the coder uses it.
struct BorderView {
  static constexpr std::uint32_t kMoved = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t kUnmoved = kMoved - 1;

  std::vector<LatticePoint> nearest;  ///< to every vertex
  /// Bit a is set where the coordinate of axis a is on no plane of voxels, as far as is known.
  std::vector<std::uint8_t> loose;
  bool follows = false;  ///< ways to the points are expected to be those of neighbours
  /// Beside a base, for every vertex: its index in `base_border`; kUnmoved, if it is where a vertex of the
  /// base is that is not on its border; else kMoved. Without a base empty.
  std::vector<std::uint32_t> former{};
  std::span<const BorderVertex> base_border{};
};

/// Adaptive models of the coder.
struct BorderModels {
  static constexpr std::size_t kPlaces = 7;  ///< 0, and 1 + 2 * 3 by neighbours
  BorderModels() {
    flags.fill(BitModel(1U << 15));
    flags[0] = BitModel(1U << 8);  // hardly ever inside
  }

  void limit_counts(std::uint8_t most) noexcept {
    twins.length.limit_count(most);
    for (NumberModel& model : ways) model.length.limit_count(most);
    colors.limit_counts(most);
  }

  std::array<BitModel, kPlaces> flags;
  NumberModel twins;
  std::array<NumberModel, 6> ways;  ///< by looseness and axis
  BorderColorModels colors;
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class BorderCoder {
 public:
  /// All arguments must outlive the coder.
  BorderCoder(Coder& coder, BorderModels& models, const BorderView& view, const OpenEdges& edges)
      : coder_(coder), models_(models), view_(view), edges_(edges), places_(view.nearest.size(), kInside) {
    unmoved_flags_.fill(CountedBit(2048));
    unmoved_flags_[0] = CountedBit(256);
  }

  /// Codes `vertex`, those before it being coded; a reader appends to `border`, a writer takes the vertex
  /// from place `next`, which moves on. False where a point is beyond the lattice.
  bool code(std::uint32_t vertex, std::vector<BorderVertex>& border, std::size_t& next) {
    const auto [context, before] = look_around(vertex);
    bool is_border = Coder::kWrites && next < border.size() && border[next].vertex == vertex;
    const std::uint32_t former = view_.former.empty() ? BorderView::kMoved : view_.former[vertex];
    if (former < view_.base_border.size()) {
      BorderVertex same = view_.base_border[former];
      same.vertex = vertex;
      if (coder_.bit(is_border && border[next] == same, is_same_)) {
        if constexpr (!Coder::kWrites) border.push_back(same);
        places_[vertex] = static_cast<std::uint32_t>(next++);
        return true;
      }
    }
    is_border = former == BorderView::kUnmoved ? coder_.bit(is_border, unmoved_flags_[context])
                                               : coder_.bit(is_border, models_.flags[context]);
    if (!is_border) return true;
    if constexpr (!Coder::kWrites) border.push_back({.vertex = vertex, .point = {}, .twin = 0});
    BorderVertex& coded = border[next];
    places_[vertex] = static_cast<std::uint32_t>(next++);
    coded.twin = coder_.number(coded.twin, models_.twins);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::int32_t expected = view_.nearest[vertex][axis];
      if (view_.follows && before != kInside)
        expected += border[places_[before]].point[axis] - view_.nearest[before][axis];
      const std::int32_t way =
          unzigzag(coder_.number(Coder::kWrites ? zigzag(coded.point[axis] - expected) : 0,
                                 models_.ways[3 * (view_.loose[vertex] >> axis & 1U) + axis]));
      const std::int64_t point = std::int64_t{expected} + way;
      if (point < -kMostLatticeSteps || point > kMostLatticeSteps) return false;
      coded.point[axis] = static_cast<std::int32_t>(point);
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kInside = std::numeric_limits<std::uint32_t>::max();

  struct Around {
    std::size_t context;
    std::uint32_t before;  ///< the last neighbour on the border, or kInside
  };

  /// By open edges: 0 without any, else 1, plus 1 if a neighbour before is not on the border, plus 2 for each
  /// that is, up to 2 of them.
  Around look_around(std::uint32_t vertex) const noexcept {
    const auto neighbors = edges_.of(vertex);
    std::uint32_t before = kInside;
    std::size_t on = 0;
    std::size_t off = 0;
    for (const std::uint32_t other : neighbors) {
      if (other >= vertex) continue;
      if (places_[other] == kInside) {
        off = 1;
      } else {
        on = on < 2 ? on + 1 : 2;
        before = other;
      }
    }
    return {neighbors.empty() ? 0 : 1 + off + 2 * on, before};
  }

  Coder& coder_;
  BorderModels& models_;
  const BorderView& view_;
  const OpenEdges& edges_;

  CountedBit is_same_{64000};                                    ///< of unmoved vertices of the base's border
  std::array<CountedBit, BorderModels::kPlaces> unmoved_flags_;  ///< of others that are unmoved
  std::vector<std::uint32_t> places_;                            ///< of every vertex coded, in the border
};

}  // namespace deltamesh
