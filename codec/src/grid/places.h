// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where edges are cut, all nodes and faces being known [GRD-9, GRD-10]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "base/memory/large_vector.h"
#include "base/small_code.h"
#include "entropy/coder/held_coder.h"
#include "entropy/coder/symbol_models.h"
#include "grid/known/places.h"
#include "grid/models.h"
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
  /// That are left of levels without these.
  static unsigned symbols(std::uint32_t levels) noexcept { return ((levels - 1) >> raw_bits(levels)) + 1; }
  explicit PlaceModels(std::uint32_t levels) : smooth(kSmoothContexts) {
    const unsigned count = symbols(levels);
    const SymbolModel even = even_model(count);
    ends = SymbolModels(kEndContexts, even);
    smooth.fill(0, kOfSmoothClass, even);
    for (unsigned c = 1; c < kSmoothClasses; ++c)
      smooth.fill(c * kOfSmoothClass, kOfSmoothClass, near_model(count, smooth_of_class(c)));
  }

  void limit_counts(std::uint8_t most) noexcept {
    ends.limit_counts(most);
    smooth.limit_counts(most);
  }

  SymbolModels ends{0};
  SymbolModels smooth;
  std::array<MixWeights, kPlaceWeights> weights;

 private:
  /// Most likely near `place`, 64ths of an edge from its middle: weights fall with the square of the
  /// distance.
  static SymbolModel near_model(unsigned symbols, int place) noexcept {
    std::array<std::uint8_t, kSymbols> weights{};
    for (unsigned s = 0; s < symbols; ++s) {
      const int way = static_cast<int>(32 * (2 * s + 1) / symbols) - kHalfEdge - place;
      weights[s] = static_cast<std::uint8_t>(std::max(3072 / (64 + way * way), 1));
    }
    return SymbolModel(weights);
  }
};

template <class Coder>
class PlaceCoder {
 public:
  PlaceCoder(Coder& coder, PlaceModels& models, std::uint32_t levels, Surface& surface,
             const std::array<std::uint32_t, 3>& most, KnownPlaces& known)
      : coder_(coder),
        models_(models),
        levels_(static_cast<std::int32_t>(levels)),
        raw_bits_(PlaceModels::raw_bits(levels)),
        one_over_levels_((std::uint64_t{1} << kOneBits) / levels + 1),
        most_(most),
        surface_(surface),
        known_(known),
        places_(surface.vertex_count) {}

  /// `cells`: a writer's are read, a reader's are made; of all vertices but those inside cubes. Null, or the
  /// rule that a stream breaks.
  const char* code(std::span<Cell> cells) {
    const auto window = std::make_unique<PlaceWindow>();
    for (const Brick* const brick : surface_.bricks.in_order()) {
      if (!has_cuts(*brick)) continue;
      window->load(*brick, surface_.bricks, places_);
      known_.load(*brick);
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

  /// What edges of a brick have in common that begin at nodes with the same y and z.
  struct Row {
    const Brick& brick;
    unsigned slot;
    int y;
    int z;
    int index;  ///< in the window
    Cell cell;
  };

  DELTAMESH_LOOP_BODY void code_brick(const Brick& brick, PlaceWindow& window, std::span<Cell> cells) {
    Held<Coder> coder = coder_;
    for (int z = 0; z < kSide; ++z) {
      for (int y = 0; y < kSide; ++y) {
        const std::uint64_t cut = brick.cut[static_cast<std::size_t>(y + kSide * z)];
        if (cut == 0) continue;
        const Row row{.brick = brick,
                      .slot = row_slot(y, z),
                      .y = y,
                      .z = z,
                      .index = PlaceWindow::at({0, y, z}),
                      .cell = {brick.at[0] * kSide * 2 * levels_, (brick.at[1] * kSide + y) * 2 * levels_,
                               (brick.at[2] * kSide + z) * 2 * levels_}};
        for (std::size_t axis = 1; axis < 3; ++axis) check(row.cell, axis);
        code_row<0>(coder, row, cut & 0xffff, window, cells);
        code_row<1>(coder, row, cut >> kSide & 0xffff, window, cells);
        code_row<2>(coder, row, cut >> 2 * kSide, window, cells);
      }
    }
    write_back<Coder>(coder, coder_);
  }

  void check(const Cell& cell, std::size_t axis) noexcept {
    is_beyond_ |= static_cast<std::uint32_t>(cell[axis]) > most_[axis];
  }

  /// `cut`: a bit for every x.
  template <unsigned kAxis>
  [[gnu::always_inline]] void code_row(Coder& coder, const Row& row, std::uint64_t cut, PlaceWindow& window,
                                       std::span<Cell> cells) {
    for (; cut != 0; cut &= cut - 1) code_edge<kAxis>(coder, row, std::countr_zero(cut), window, cells);
  }

  template <unsigned kAxis>
  [[gnu::always_inline]] void code_edge(Coder& coder, const Row& row, int x, PlaceWindow& window,
                                        std::span<Cell> cells) {
    const unsigned slot = row.slot + kSlots[0][static_cast<std::size_t>(x)];
    const std::uint32_t vertex = surface_.bricks.vertex(row.brick, slot, kAxis);
    const int index = row.index + x;
    std::int32_t level = 0;
    if constexpr (Coder::kWrites) level = cells[vertex][kAxis] % (2 * levels_) / 2;
    const KnownEdge* const known = known_.find(row.y, row.z, static_cast<unsigned>(x), slot, kAxis);
    if (levels_ > 1) {
      const PlaceSurroundings<kAxis> around(window, index);
      // -1 if the edge is seen from its other end.
      const std::int32_t turned = around.is_outside();
      const auto seen = [&](std::int32_t l) { return (l ^ turned) + (levels_ & turned); };
      if (known != nullptr) [[unlikely]] {
        const auto former = seen(static_cast<std::int32_t>(known->level));
        const Motion motion = known_.motion(window, index, kAxis, turned);
        level = seen(code_known_level(coder, around.context().expected(), former, motion, seen(level)));
      } else {
        level = seen(code_level(coder, around.context(), seen(level)));
      }
      if (static_cast<std::uint32_t>(level) >= static_cast<std::uint32_t>(levels_)) [[unlikely]] {
        is_beyond_ = true;
        level = 0;
      }
    }
    const auto place = static_cast<std::int8_t>(place_of_level(level) - kHalfEdge);
    places_[vertex] = place;
    window.set(kAxis, index, place);
    Cell cell = row.cell;
    cell[0] += x * 2 * levels_;
    cell[kAxis] += 2 * level + 1;
    check(cell, 0);
    if (kAxis != 0) check(cell, kAxis);
    cells[vertex] = cell;
  }

  [[gnu::always_inline]] std::int32_t code_level(Coder& coder, const PlaceContext& context,
                                                 std::int32_t level) {
    const Mixture<2> mixture{{&models_.ends[context.ends], &models_.smooth[context.smooth]},
                             &models_.weights[context.weights]};
    const unsigned symbol = coder.symbol(static_cast<unsigned>(level) >> raw_bits_, mixture);
    return code_raw_bits(coder, symbol, level);
  }

  /// `former`: the level that the known surface has there [MAP-29].
  std::int32_t code_known_level(Coder& coder, int expected, std::int32_t former, const Motion& motion,
                                std::int32_t level) {
    const unsigned former_symbol = static_cast<unsigned>(former) >> raw_bits_;
    const unsigned symbol =
        known_.code_symbol(coder, expected, motion, former_symbol, static_cast<unsigned>(level) >> raw_bits_);
    const bool may_be_same = raw_bits_ > 0 && symbol == former_symbol;
    if (may_be_same && coder.bit(level == former, known_.is_former(motion))) return former;
    return code_raw_bits(coder, symbol, level);
  }

  [[gnu::always_inline]] std::int32_t code_raw_bits(Coder& coder, unsigned symbol, std::int32_t level) {
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
  KnownPlaces& known_;
  LargeVector<std::int8_t> places_;  ///< by vertex
};

}  // namespace deltamesh::grid
