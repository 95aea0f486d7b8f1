// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Fine lattice coordinates of vertices of which most are on the edges of a voxel grid [VOX-*]. One template
// for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/memory/large_vector.h"
#include "base/numbers/zigzag.h"
#include "base/small_code.h"
#include "positions/blend/blend.h"
#include "positions/grid/faces.h"
#include "positions/grid/level_coder.h"
#include "positions/grid/models.h"
#include "positions/grid/view.h"
#include "positions/residual_coder.h"

namespace deltamesh {

template <class Coder>
class VoxelCoder {
 public:
  /// `largest`: the most that a coordinate may be, per axis. `start`: null for fresh models.
  VoxelCoder(Coder& coder, const VoxelFaces& faces, const std::array<std::uint32_t, 3>& largest,
             std::uint32_t levels, const VoxelModels* start = nullptr)
      : coder_(coder),
        faces_(faces),
        largest_(largest),
        grid_(levels),
        levels_(coder, levels, start != nullptr ? start->levels : VoxelLevelModels()),
        residuals_(coder, start != nullptr ? start->residuals : ResidualModels()),
        spots_(std::size_t{faces.vertex_count()} + kNoCube.size() + 1),
        nodes_(spots_.size()),
        models_(start != nullptr ? *start : VoxelModels()) {
    spots_[faces.none()] = kOffEdges;
    nodes_[faces.none()] = kNowhere;
    for (std::size_t i = 0; i < kNoCube.size(); ++i) {
      nodes_[faces.none() + 1 + i] = kNoCube[i];
      spots_[faces.none() + 1 + i] = spot_of({kNoCube[i][0], kNoCube[i][1], kNoCube[i][2]}, 0, 0);
    }
  }

  VoxelModels models() const {
    VoxelModels learnt = models_;
    learnt.levels = levels_.models();
    learnt.residuals = residuals_.models();
    return learnt;
  }

  /// The vertex of this step in the first sequence, from 0, and the one in the second; those of the steps
  /// before are coded. A reader fills their cells in. The rule that a stream breaks here, or null.
  DELTAMESH_LOOP_BODY const char* code_step(std::uint32_t step, std::span<Cell> cells) {
    const std::uint32_t other = faces_.second_sequence() + step;
    const bool is_alone = other >= faces_.vertex_count();
    Vertex first(*this, step, cells);
    Vertex second(*this, is_alone ? step : other, cells);
    Corners corners = {corners_of(first.number), corners_of(second.number)};
    std::optional<VoxelCubes> cubes = VoxelCubes::find(corners, places());
    if (!cubes) [[unlikely]] {
      first.has_cube = find_cube(corners[0]);
      second.has_cube = find_cube(corners[1]);
      cubes = VoxelCubes::find(corners, places());
    }
    VoxelPair pair(*cubes, corners, spots_);
    const char* const broken = code_vertex(0, *cubes, pair, corners, first, cells);
    return broken != nullptr || is_alone ? broken : code_vertex(1, *cubes, pair, corners, second, cells);
  }

 private:
  using Corners = std::array<VoxelCorners, 2>;

  /// While it is coded.
  struct Vertex {
    [[gnu::always_inline]] Vertex(const VoxelCoder& coder, std::uint32_t vertex, std::span<const Cell> cells)
        : number(vertex) {
      if constexpr (Coder::kWrites) {
        cut = coder.grid_.cut_of(cells[vertex]);
        if (cut) told = spot_of(cut->node, cut->axis, coder.grid_.part_of(cut->level));
      }
    }

    std::uint32_t number;
    bool has_cube = true;
    bool is_near = false;               ///< of a writer's, to the first corner
    std::optional<VoxelGrid::Cut> cut;  ///< of a writer's, where the vertex is on an edge; and its spot
    VoxelSpot told;
  };

  static constexpr unsigned kFree = 3;
  /// Two edges of one cube, for faces of vertices without a cube.
  static constexpr std::array<FourInts, 2> kNoCube = {FourInts{0, 0, 0, 0}, FourInts{0, 1, 1, 0}};

  VoxelPlaces places() const noexcept { return {spots_, nodes_}; }

  [[gnu::always_inline]] VoxelCorners corners_of(std::uint32_t vertex) const noexcept {
    return seen_by(faces_.star(vertex));
  }
  [[gnu::always_inline]] VoxelCorners seen_by(const VoxelFaces::Star& star) const noexcept {
    const std::uint32_t across = faces_.across(star[0], star[1]);
    const bool is_far = set_lanes(far_lanes(nodes_[across], nodes_[star[0]])) != 0;
    return {star, choose(is_far, faces_.none(), across)};
  }

  /// Makes `corners` such that VoxelCubes::find() succeeds. False if they are not the vertex' own corners any
  /// more.
  [[gnu::noinline]] bool find_cube(VoxelCorners& corners) const noexcept {
    const std::uint32_t a = corners.star[0];
    const std::uint32_t b = corners.star[1];
    if (VoxelCubes::find({corners, corners}, places())) return true;
    corners.star = {{a, b, a, b}};
    if (VoxelCubes::find({corners, corners}, places())) return true;
    const std::uint32_t none = faces_.none();
    corners = {{{none + 1, none + 2, none + 1, none + 2}}, none};
    return false;
  }

  [[gnu::always_inline]] unsigned code_edge(std::size_t i, VoxelCubes& cubes, VoxelPair& pair,
                                            const Corners& corners, Vertex& vertex) {
    if constexpr (Coder::kWrites)
      vertex.is_near =
          vertex.cut && set_lanes(far_lanes(four_ints(vertex.cut->node), nodes_[corners[i].star[0]])) == 0;
    const unsigned number = code_number(i, pair, vertex);
    return number == VoxelPair::kOpen ? code_in_higher(i, cubes, pair, corners, vertex) : number;
  }

  [[gnu::noinline]] unsigned code_in_higher(std::size_t i, VoxelCubes& cubes, VoxelPair& pair,
                                            const Corners& corners, const Vertex& vertex) {
    if (!pair.is_open(i)) return VoxelPair::kOpen;
    cubes = cubes.with_higher(i);
    pair = VoxelPair(cubes, corners, spots_);
    return code_number(i, pair, vertex);
  }

  [[gnu::always_inline]] unsigned code_number(std::size_t i, const VoxelPair& pair, const Vertex& vertex) {
    unsigned number = voxel::kNoEdge;
    if constexpr (Coder::kWrites) {
      if (vertex.is_near) number = pair.number_of(i, vertex.told);
      if (vertex.is_near && number == voxel::kNoEdge && pair.is_open(i) && pair.higher_has(i, vertex.told))
        number = VoxelPair::kOpen;
    }
    SymbolModel& model = models_.edges.of(pair.kind(i), pair.likely(i), pair.opposite(i));
    return coder_.symbol(number, Mixture<1>{{&model}});
  }

  [[gnu::always_inline]] const char* code_vertex(std::size_t i, VoxelCubes& cubes, VoxelPair& pair,
                                                 const Corners& corners, Vertex& vertex,
                                                 std::span<Cell> cells) {
    const unsigned number = vertex.has_cube ? code_edge(i, cubes, pair, corners, vertex) : voxel::kNoEdge;
    return code_rest(i, pair, corners, vertex, number, cells);
  }

  /// Codes what follows the edge's number.
  [[gnu::always_inline]] const char* code_rest(std::size_t i, const VoxelPair& pair, const Corners& corners,
                                               const Vertex& vertex, unsigned number, std::span<Cell> cells) {
    if (number >= voxel::kEdges) [[unlikely]]
      return number == voxel::kNoEdge ? code_elsewhere(vertex.number, cells) : "VOX-4";
    const unsigned edge = pair.edge_of(i, number);
    std::int32_t level = 0;
    if constexpr (Coder::kWrites) level = vertex.cut->level;
    level = levels_.code(level, pair.mean_on(i, edge), pair.plane_on(i, edge));
    nodes_[vertex.number] = nodes_[corners[i].star[0]] + pair.steps_to(i, edge);
    spots_[vertex.number] = pair.spot_on(i, edge, grid_.part_of(level));
    return settle(vertex.number, edge / 4, level, cells[vertex.number]);
  }

  /// The rule that is broken where this is beyond the edge or the lattice, or null.
  [[gnu::always_inline]] const char* settle(std::uint32_t vertex, std::size_t axis, std::int32_t level,
                                            Cell& cell) const noexcept {
    if (level >= grid_.levels()) [[unlikely]]
      return "VOX-6";
    const FourInts lanes = grid_.cell_of(nodes_[vertex], axis, level);
    store_three(lanes, cell);
    const FourInts largest = four_ints(std::bit_cast<Cell>(largest_));
    return set_lanes(lanes | (largest - lanes)) == 0 ? nullptr : "POSN-7";
  }

  /// An edge by its axis and its lower node, from the node at what is expected; or a vertex on none.
  /// Kept out of the way of the vertices on a cube's edges, which are most.
  [[gnu::noinline]] const char* code_elsewhere(std::uint32_t vertex, std::span<Cell> cells) {
    // Nothing comes before the first one of a sequence.
    const std::uint32_t after = vertex == faces_.second_sequence() ? 0 : vertex;
    const Surroundings around = faces_.around(vertex);
    const Expectation expected = expect_place(around, after, cells, kUsualBlends);
    const std::array<std::int64_t, 3> place = expected.place();
    std::optional<VoxelGrid::Cut> cut;
    if constexpr (Coder::kWrites) cut = grid_.cut_of(cells[vertex]);
    const unsigned start =
        coder_.symbol(cut ? static_cast<unsigned>(cut->axis) : kFree, Mixture<1>{{&models_.start}});
    if (start > kFree) return "VOX-1";
    if (start == kFree) return code_free(vertex, around, expected, cells[vertex]);
    VoxelGrid::Node node{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t nodes = largest_[a] / static_cast<std::uint32_t>(grid_.voxel());
      const std::int64_t below = (place[a] >> 4) / grid_.voxel();
      const std::uint32_t code = cut ? zigzag(static_cast<std::int32_t>(cut->node[a] - below)) : 0;
      const std::int64_t coded = below + unzigzag(coder_.number(code, models_.start_nodes[a]));
      if (coded < 0 || coded > nodes) return "VOX-5";
      node[a] = static_cast<std::int32_t>(coded);
    }
    const std::int32_t level =
        levels_.code(cut ? cut->level : 0, VoxelPair::kMiddlePlace, VoxelPair::kMiddlePlace);
    nodes_[vertex] = FourInts{node[0], node[1], node[2], 0};
    spots_[vertex] = spot_of(node, start, grid_.part_of(level));
    return settle(vertex, start, level, cells[vertex]);
  }

  const char* code_free(std::uint32_t vertex, const Surroundings& around, const Expectation& expected,
                        Cell& cell) {
    if (!history_) history_.emplace(faces_.vertex_count(), ResidualRecord{});  // 0 of those on edges
    spots_[vertex] = kOffEdges;
    nodes_[vertex] = kNowhere;
    ResidualTurn turn(history_->outlook(around, expected), FourInts{},
                      four_ints({largest_[0], largest_[1], largest_[2], 0U}));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ResidualPrediction prediction = turn.prediction(axis);
      const std::int64_t q = prediction.whole + residuals_.code(cell[axis] - prediction.whole, prediction);
      if (q < 0 || q > largest_[axis]) return "POSN-7";
      cell[axis] = static_cast<std::int32_t>(q);
      turn.learn(axis, cell[axis], prediction);
    }
    history_->end(vertex, turn, four_ints(cell));
    return nullptr;
  }

  Coder& coder_;
  const VoxelFaces& faces_;
  std::array<std::uint32_t, 3> largest_;
  VoxelGrid grid_;
  VoxelLevelCoder<Coder> levels_;
  std::optional<ResidualHistory> history_;  ///< of vertices on no edge, once there is one
  ResidualCoder<Coder> residuals_;
  LargeVector<VoxelSpot> spots_;  ///< then kOffEdges and kNoCube
  LargeVector<FourInts> nodes_;   ///< likewise
  VoxelModels models_;            ///< but for those of levels_ and residuals_
};

}  // namespace deltamesh
