// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From seeds the surface grows from cube to cube: which cubes have faces, which of their corners are outside
// and what the faces are [GRD-2 .. GRD-7]. One template for both directions.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "entropy/coder/held_coder.h"
#include "grid/bricks.h"
#include "grid/known/growth.h"
#include "grid/models.h"
#include "grid/pattern_coder.h"
#include "grid/surface.h"
#include "grid/waiting_cubes.h"
#include "grid/window.h"

namespace deltamesh::grid {

/// `Source`: what a writer codes; a reader's has no members that are used.
template <class Coder, class Source>
class Growth {
 public:
  /// `known`: of what a reader has.
  Growth(Coder& coder, GrowthModels& models, const Source& source, const Limits& limits, Surface& surface,
         KnownGrowth& known)
      : coder_(coder), models_(models), source_(source), limits_(limits), surface_(surface), known_(known) {}

  /// All of the surface. Null, or the rule that a stream breaks.
  const char* grow() {
    known_.begin(surface_.bricks, waiting_);
    code_waiting();
    for (std::size_t seed = 0;; ++seed) {
      bool is_seed = false;
      if constexpr (Coder::kWrites) {
        const auto& seeds = source_.cubes();
        while (seed < seeds.size() && is_seen(seeds[seed])) ++seed;
        is_seed = seed < seeds.size();
        if (is_seed) next_seed_ = seeds[seed];
      }
      if (!coder_.bit(is_seed, models_.seeds.is_seed) || broken_ != nullptr || coder_.failed())
        return broken_;
      code_seed();
      code_waiting();
    }
  }

 private:
  bool is_seen(const CubePlace& cube) const noexcept {
    const Brick* const brick = surface_.bricks.find(cube.brick);
    return brick != nullptr && (brick->cubes[cube.place] & Brick::kSeen) != 0;
  }

  /// The place of a cube with faces, as a difference to the last such place [GRD-7].
  void code_seed() {
    const auto& size = limits_.bricks;
    const auto index_of = [&](const Bricks::Place& at) {
      return (static_cast<std::uint32_t>(at[2]) * size[1] + static_cast<std::uint32_t>(at[1])) * size[0] +
             static_cast<std::uint32_t>(at[0]);
    };
    const std::uint32_t brick_step =
        coder_.number(Coder::kWrites ? index_of(next_seed_.brick) - seed_brick_ : 0, models_.seeds.brick);
    seed_brick_ += brick_step;
    if (brick_step != 0) seed_place_ = 0;
    seed_place_ += coder_.number(Coder::kWrites ? next_seed_.place - seed_place_ : 0, models_.seeds.cube);
    if (seed_place_ >= kPlaces || seed_brick_ / size[0] / size[1] >= size[2]) return refuse("GRD-7");
    Brick& brick = surface_.bricks.get({static_cast<std::int32_t>(seed_brick_ % size[0]),
                                        static_cast<std::int32_t>(seed_brick_ / size[0] % size[1]),
                                        static_cast<std::int32_t>(seed_brick_ / size[0] / size[1])});
    if ((brick.cubes[seed_place_] & Brick::kSeen) != 0) return refuse("GRD-7");
    brick.cubes[seed_place_] |= Brick::kSeen;
    code_with_faces(coder_, brick, seed_place_, Corners(brick, seed_place_));
  }

  void code_waiting() {
    while (!waiting_.empty() && broken_ == nullptr && !coder_.failed()) code_some();
  }

  /// First in, first out. In turns of some, like a loop's body: see DELTAMESH_LOOP_BODY.
  [[gnu::noinline]] void code_some() {
    constexpr unsigned kTurn = 256;
    Held<Coder> coder = coder_;
    for (unsigned left = kTurn; left > 0 && !waiting_.empty() && broken_ == nullptr && !coder.failed();
         --left) {
      const auto [brick, place] = waiting_.take();
      code_cube(coder, *brick, place);
    }
    write_back<Coder>(coder, coder_);
  }

  [[gnu::always_inline]] void code_cube(Coder& coder, Brick& brick, unsigned place) {
    const Corners corners(brick, place);
    bool has_faces = false;
    if constexpr (Coder::kWrites) has_faces = source_.find(brick.at, place) != Source::kNone;
    const unsigned faceless = brick.cubes[place] & Brick::kFaceless;
    CountedBit* const known = known_.flag_model(brick, place, corners, faceless >> 3);
    CountedBit& model = known != nullptr ? *known : models_.flags[corners.known() << 6 | faceless];
    if (!coder.bit(has_faces, model)) return waiting_.count_faceless(brick, place);
    code_with_faces(coder, brick, place, corners);
  }

  [[gnu::always_inline]] void code_with_faces(Coder& coder, Brick& brick, unsigned place,
                                              const Corners& corners) {
    if constexpr (Coder::kWrites) cube_ = source_.find(brick.at, place);
    const Signs signs = corners.known() == 255 ? corners.outside : code_signs(coder, brick, place, corners);
    const ListedPattern* const former = code_former(coder, brick, place, signs);
    const ListedPattern& pattern = former != nullptr ? *former : code_pattern(coder, signs);
    if constexpr (Coder::kWrites) surface_.cubes.push_back(cube_);
    surface_.add_faces(brick, place, pattern);
    if (pattern.pattern.has_inner()) [[unlikely]]
      code_inner(coder, brick, spot_of(place));
    if (is_too_large()) [[unlikely]]
      refuse("GRD-8");
    waiting_.add_across(brick, place, kCrossedFaces[signs]);
  }

  /// Null if the pattern is another than the former one [MAP-28].
  [[gnu::always_inline]] const ListedPattern* code_former(Coder& coder, const Brick& brick, unsigned place,
                                                          Signs signs) {
    const auto former = known_.former(brick, place, signs);
    if (former.pattern == nullptr) [[likely]]
      return nullptr;
    bool is_it = false;
    if constexpr (Coder::kWrites) is_it = source_.pattern(cube_) == *former.pattern;
    if (!coder.bit(is_it, *former.model)) return nullptr;
    former_ = ListedPattern(*former.pattern);
    return &former_;
  }

  /// Those of the corners that are not known [GRD-4].
  [[gnu::always_inline]] Signs code_signs(Coder& coder, Brick& brick, unsigned place, Corners corners) {
    const Window window(brick, place);
    for (unsigned unknown = ~corners.known() & 255; unknown != 0; unknown &= unknown - 1) {
      const auto corner = static_cast<unsigned>(std::countr_zero(unknown));
      const unsigned thirds = kThirds[corner][corners.inside] + 2U * kThirds[corner][corners.outside];
      bool is_outside = false;
      if constexpr (Coder::kWrites) is_outside = (source_.signs(cube_) >> corner & 1) != 0;
      const unsigned majority = window.majority(corner);
      CountedBit* const known = known_.sign_model(brick, place, corners, corner, majority);
      is_outside = coder.bit(is_outside, known != nullptr ? *known : models_.signs[3 * thirds + majority]);
      corners.outside |= (is_outside ? 1U : 0U) << corner;
      corners.inside |= (is_outside ? 0U : 1U) << corner;
    }
    surface_.bricks.set_corners(brick, place, corners.outside, corners.inside);
    return corners.outside;
  }

  [[gnu::always_inline]] const ListedPattern& code_pattern(Coder& coder, Signs signs) {
    KnownPatterns& known = models_.known[signs];
    std::uint32_t rank = 0;
    if constexpr (Coder::kWrites) {
      while (rank < known.count && models_.patterns[known.numbers[rank]].pattern != source_.pattern(cube_))
        ++rank;
    }
    if (known.count > 0 && !coder.bit(rank != 0, known.is_other)) [[likely]]
      return models_.patterns[known.numbers[0]];
    return rarely(coder, [&]() -> const ListedPattern& { return code_other_pattern(signs, rank); });
  }

  /// Not the first one that is known.
  [[gnu::noinline]] const ListedPattern& code_other_pattern(Signs signs, std::uint32_t rank) {
    KnownPatterns& known = models_.known[signs];
    if (known.count > 0) {
      const unsigned symbol = rank < known.count ? rank : KnownPatterns::kMost;
      rank = coder_.symbol(symbol, Mixture<1>{{&models_.rank}});
      if (rank == 0) refuse("GRD-5");
    }
    if (known.count > 0 && rank < known.count) {
      std::swap(known.numbers[rank], known.numbers[rank - (rank > 0 ? 1 : 0)]);
      return models_.patterns[known.numbers[rank - (rank > 0 ? 1 : 0)]];
    }
    Pattern wanted;
    if constexpr (Coder::kWrites) wanted = source_.pattern(cube_);
    auto coded = code_new_pattern(coder_, signs, wanted, models_.pattern);
    if (!coded) refuse("GRD-6");
    return models_.add(signs, coded.value_or(Pattern{}));
  }

  /// Where the vertex inside a cube is: raw bits [GRD-6].
  [[gnu::noinline]] void code_inner(const Brick& brick, const Spot& spot) {
    InnerVertex inner{.vertex = surface_.vertex_count - 1, .brick = brick.at, .spot = spot};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::uint32_t offset = 0;
      if constexpr (Coder::kWrites) offset = source_.inner_offset(cube_, axis);
      inner.offset[axis] = coder_.bits(offset, static_cast<unsigned>(std::bit_width(limits_.voxel - 1)));
      if (inner.offset[axis] >= limits_.voxel) refuse("GRD-6");
    }
    surface_.inner.push_back(inner);
  }
  void code_inner(Coder& coder, const Brick& brick, const Spot& spot) {
    rarely(coder, [&] { return code_inner(brick, spot), 0; });
  }

  /// A rare step, on `coder_` itself.
  template <class Code>
  [[gnu::always_inline]] decltype(auto) rarely(Coder& coder, Code code) {
    write_back<Coder>(coder, coder_);
    decltype(auto) result = code();
    write_back<Coder>(coder_, coder);
    return result;
  }

  bool is_too_large() const noexcept {
    return surface_.triangles.size() > limits_.triangles || surface_.vertex_count > limits_.vertices ||
           surface_.bricks.count() > limits_.most_bricks;
  }
  void refuse(const char* rule) noexcept {
    if (broken_ == nullptr) broken_ = rule;
  }

  Coder& coder_;
  GrowthModels& models_;
  const Source& source_;
  const Limits& limits_;
  Surface& surface_;
  KnownGrowth& known_;
  ListedPattern former_;
  const char* broken_ = nullptr;
  WaitingCubes waiting_{surface_.bricks};
  std::uint32_t seed_brick_ = 0;
  std::uint32_t seed_place_ = 0;
  CubePlace next_seed_{};   ///< a writer's
  std::uint32_t cube_ = 0;  ///< of a writer's source, with faces
};

}  // namespace deltamesh::grid
