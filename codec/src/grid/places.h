// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where edges are cut, all nodes and faces being known [GRD-9, GRD-10]. One template for both directions.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "base/memory/large_vector.h"
#include "entropy/coder/held_coder.h"
#include "entropy/coder/symbol_models.h"
#include "grid/place_context.h"
#include "grid/surface.h"
#include "positions/blend/blend.h"

namespace deltamesh::grid {

/// Models of the levels on edges, of which there are `levels`.
struct PlaceModels {
  /// So many low bits of a level are raw.
  static unsigned raw_bits(std::uint32_t levels) noexcept {
    const auto bits = static_cast<unsigned>(std::bit_width((levels - 1) / kSymbols));
    return bits;
  }
  explicit PlaceModels(std::uint32_t levels)
      : ends(kEndContexts, even_model(((levels - 1) >> raw_bits(levels)) + 1)),
        smooth(kSmoothContexts, even_model(((levels - 1) >> raw_bits(levels)) + 1)) {}

  SymbolModels ends;
  SymbolModels smooth;
  std::array<MixWeights, kPlaceWeights> weights;
};

template <class Coder>
class PlaceCoder {
 public:
  PlaceCoder(Coder& coder, PlaceModels& models, std::uint32_t levels, Surface& surface,
             const std::array<std::uint32_t, 3>& most)
      : coder_(coder),
        models_(models),
        levels_(static_cast<std::int32_t>(levels)),
        raw_bits_(PlaceModels::raw_bits(levels)),
        one_over_levels_((std::uint64_t{1} << kOneBits) / levels + 1),
        most_(most),
        surface_(surface),
        places_(surface.vertex_count) {}

  /// `cells`: a writer's are read, a reader's are made; of all vertices but those inside cubes. Null, or the
  /// rule that a stream breaks.
  const char* code(std::span<Cell> cells) {
    const auto window = std::make_unique<PlaceWindow>();
    for (const Brick* const brick : surface_.bricks.in_order()) {
      if (!has_cuts(*brick)) continue;
      window->load(*brick, surface_.bricks, places_);
      code_brick(*brick, *window, cells);
      if (coder_.failed() || is_beyond_) break;
    }
    return is_beyond_ ? "GRD-9" : nullptr;
  }

 private:
  static constexpr unsigned kOneBits = 46;

  static bool has_cuts(const Brick& brick) noexcept {
    std::uint64_t any = 0;
    for (const std::uint64_t cut : brick.cut) any |= cut;
    return any != 0;
  }

  void code_brick(const Brick& brick, PlaceWindow& window, std::span<Cell> cells) {
    Held<Coder> coder = coder_;
    for (int z = 0; z < kSide; ++z) {
      for (int y = 0; y < kSide; ++y) {
        const std::uint64_t row = brick.cut[static_cast<std::size_t>(y + kSide * z)];
        constexpr std::uint64_t kOfAxis = 0xffff;
        for (std::uint64_t cut = row & kOfAxis; cut != 0; cut &= cut - 1)
          code_edge<0>(coder, brick, {std::countr_zero(cut), y, z}, window, cells);
        for (std::uint64_t cut = row >> kSide & kOfAxis; cut != 0; cut &= cut - 1)
          code_edge<1>(coder, brick, {std::countr_zero(cut), y, z}, window, cells);
        for (std::uint64_t cut = row >> 2 * kSide; cut != 0; cut &= cut - 1)
          code_edge<2>(coder, brick, {std::countr_zero(cut), y, z}, window, cells);
      }
    }
    write_back<Coder>(coder, coder_);
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] void code_edge(Coder& coder, const Brick& brick, const Spot& spot,
                                        PlaceWindow& window, std::span<Cell> cells) {
    const std::uint32_t vertex = surface_.bricks.vertex(brick, place_of(spot), kAxis);
    const int index = PlaceWindow::at(spot);
    std::int32_t level = 0;
    if constexpr (Coder::kWrites) level = cells[vertex][kAxis] % (2 * levels_) / 2;
    if (levels_ > 1) {
      const PlaceSurroundings<kAxis> around(window, index);
      const auto seen = [&](std::int32_t l) { return around.is_outside() ? levels_ - 1 - l : l; };
      level = seen(code_level(coder, around.context(), seen(level)));
      if (static_cast<std::uint32_t>(level) >= static_cast<std::uint32_t>(levels_)) [[unlikely]] {
        is_beyond_ = true;
        level = 0;
      }
    }
    const auto place = static_cast<std::int8_t>(place_of_level(level) - kHalfEdge);
    places_[vertex] = place;
    window.set(kAxis, index, place);
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = (brick.at[axis] * kSide + spot[axis]) * 2 * levels_;
      if (axis == kAxis) cell[axis] += 2 * level + 1;
      is_beyond_ |= static_cast<std::uint32_t>(cell[axis]) > most_[axis];
    }
    cells[vertex] = cell;
  }

  [[gnu::always_inline]] std::int32_t code_level(Coder& coder, const PlaceContext& context,
                                                 std::int32_t level) {
    const Mixture<2> mixture{{&models_.ends[context.ends], &models_.smooth[context.smooth]},
                             &models_.weights[context.weights]};
    const unsigned symbol = coder.symbol(static_cast<unsigned>(level) >> raw_bits_, mixture);
    if (raw_bits_ == 0) [[likely]]
      return static_cast<std::int32_t>(symbol);
    const std::uint32_t low =
        coder.bits(static_cast<std::uint32_t>(level) & ((1U << raw_bits_) - 1), raw_bits_);
    return static_cast<std::int32_t>(symbol << raw_bits_ | low);
  }

  /// floor(32 (2 level + 1) / levels): of its middle from the edge's beginning, 64ths.
  int place_of_level(std::int32_t level) const noexcept {
    const std::uint64_t parts = (2 * static_cast<std::uint64_t>(level) + 1) << 5;
    return static_cast<int>(parts * one_over_levels_ >> kOneBits);
  }

  Coder& coder_;
  PlaceModels& models_;
  std::int32_t levels_;
  unsigned raw_bits_;
  std::uint64_t one_over_levels_;
  std::array<std::uint32_t, 3> most_;
  bool is_beyond_ = false;
  Surface& surface_;
  LargeVector<std::int8_t> places_;  ///< by vertex
};

}  // namespace deltamesh::grid
