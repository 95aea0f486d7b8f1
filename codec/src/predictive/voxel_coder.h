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
#include <vector>

#include "base/large_vector.h"
#include "base/zigzag.h"
#include "predictive/residual_coder.h"
#include "predictive/voxel_view.h"

namespace deltamesh {

template <class Coder>
class VoxelCoder {
 public:
  /// `largest`: the most that a coordinate may be, per axis.
  VoxelCoder(Coder& coder, const KnownFaces& faces, const std::array<std::uint32_t, 3>& largest,
             std::uint32_t levels, const BlendTable& blends)
      : coder_(coder),
        faces_(faces),
        largest_(largest),
        grid_(levels),
        blends_(blends),
        history_(faces.vertex_count()),
        residuals_(coder),
        spots_(faces.vertex_count()),
        nodes_(faces.vertex_count()),
        corner_models_(kCornerContexts, kFreshEdge) {
    edge_models_.reserve(kEdgeContexts);
    for (std::size_t i = 0; i < kEdgeContexts; ++i) {
      // Those of the first kind again for the others.
      constexpr std::size_t kOfKind = kEdgeContexts / voxel::kPairKinds;
      const std::size_t nearest = i / (kEdgeSlots * kMostLikely);
      edge_models_.push_back(i < kOfKind ? fresh_edges(nearest, i % kEdgeSlots) : edge_models_[i - kOfKind]);
    }
    while ((levels - 1) >> low_bits_ >= kSymbols) ++low_bits_;
    std::array<std::uint8_t, kSymbols> weights{};
    for (std::uint32_t i = 0; i <= (levels - 1) >> low_bits_; ++i) weights[i] = 1;
    level_models_.assign(kMeanBins * kPlaneBins, SymbolModel(weights));
  }

  /// The vertex of this turn in the first walk, from 0, and the one in the second; those of the turns before
  /// are coded. A reader fills their cells in. The rule that a stream breaks here, or null.
  const char* code_turn(std::uint32_t turn, std::span<Cell> cells) {
    if (std::uint64_t{faces_.second_walk()} + turn >= cells.size()) return code_alone(turn, cells);
    const std::uint32_t other = faces_.second_walk() + turn;
    Vertex first(*this, turn, cells);
    Vertex second(*this, other, cells);
    if (!first.is_sure() || !second.is_sure()) {
      const char* const broken = code_alone(turn, cells);
      return broken != nullptr ? broken : code_alone(other, cells);
    }
    first.view.look(first.around, spots_, blends_);
    second.view.look(second.around, spots_, blends_);
    const unsigned first_number = code_edge(first);
    const unsigned second_number = code_edge(second);
    const char* const broken = code_rest(first, first_number, cells);
    return broken != nullptr ? broken : code_rest(second, second_number, cells);
  }

 private:
  /// While it is coded.
  struct Vertex {
    [[gnu::always_inline]] Vertex(const VoxelCoder& coder, std::uint32_t vertex, std::span<const Cell> cells)
        : number(vertex), around(coder.faces_.around(vertex)) {
      has_cube = view.find(around, coder.spots_);
      if constexpr (Coder::kWrites) {
        cut = coder.grid_.cut_of(cells[vertex]);
        if (cut) told = spot_of(cut->node, cut->axis, coder.grid_.part_of(cut->level));
      }
    }
    bool is_sure() const noexcept { return has_cube && !view.is_open(); }

    std::uint32_t number;
    Surroundings around;
    VoxelView view;
    bool has_cube;
    std::optional<VoxelGrid::Cut> cut;  ///< of a writer's, where the vertex is on an edge; and its spot
    VoxelSpot told;
  };

  static constexpr std::size_t kMostLikely = 4;
  static constexpr std::size_t kMostFaces = 9;
  static constexpr std::size_t kEdgeSlots = voxel::kEdges + 1;  ///< with none
  static constexpr std::size_t kEdgeContexts = voxel::kPairKinds * voxel::kEdges * kMostLikely * kEdgeSlots;
  static constexpr std::size_t kCornerContexts = voxel::kPairKinds * kEdgeSlots * (kMostFaces + 1);
  static constexpr std::size_t kMeanBins = 40;
  static constexpr std::size_t kPlaneBins = 20;
  static constexpr unsigned kFree = 3;
  static constexpr SymbolModel kFreshEdge{{8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 1, 0, 0, 0}};
  static constexpr SymbolModel kFreshStart{{8, 8, 8, 8, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  /// The rule that is broken where this is beyond the lattice, or null.
  const char* settle(std::uint32_t vertex, std::size_t axis, std::int32_t level, Cell& cell) const noexcept {
    const FourInts& node = nodes_[vertex];
    cell = grid_.cell_of({node[0], node[1], node[2]}, axis, level);
    bool is_within = true;
    for (std::size_t a = 0; a < 3; ++a) is_within &= static_cast<std::uint32_t>(cell[a]) <= largest_[a];
    return is_within ? nullptr : "POSN-7";
  }

  static SymbolModel fresh_edges(std::size_t nearest, std::size_t next) {
    std::array<std::uint8_t, kSymbols> weights = {2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 1};
    weights[nearest] = 100;
    if (next != voxel::kNoEdge) weights[next] = 20;
    return SymbolModel(weights);
  }

  const char* code_alone(std::uint32_t number, std::span<Cell> cells) {
    Vertex vertex(*this, number, cells);
    if (!vertex.has_cube) return code_elsewhere(vertex.number, cells);
    if (vertex.view.is_open())
      vertex.view.choose(coder_.bit(vertex.cut && vertex.view.higher_has(vertex.told), higher_));
    vertex.view.look(vertex.around, spots_, blends_);
    return code_rest(vertex, code_edge(vertex), cells);
  }

  [[gnu::always_inline]] unsigned code_edge(const Vertex& vertex) {
    const VoxelView& view = vertex.view;
    const std::size_t likely = std::min<std::size_t>(view.likely(), kMostLikely) - 1;
    const std::size_t degree = std::min<std::size_t>(vertex.around.faces, kMostFaces);
    const std::size_t edge =
        ((view.kind() * voxel::kEdges + view.nearest()) * kMostLikely + likely) * kEdgeSlots + view.next();
    const std::size_t corner = (view.kind() * kEdgeSlots + view.opposite()) * (kMostFaces + 1) + degree;
    unsigned number = voxel::kNoEdge;
    if constexpr (Coder::kWrites)
      if (vertex.cut) number = view.number_of(vertex.told);
    return coder_.symbol(number, Mixture<2>{{&edge_models_[edge], &corner_models_[corner]},
                                            &edge_weights_[std::min(vertex.around.known_count, 3U) - 1]});
  }

  /// What follows the edge's number.
  [[gnu::always_inline]] const char* code_rest(const Vertex& vertex, unsigned number, std::span<Cell> cells) {
    if (number >= voxel::kEdges)
      return number == voxel::kNoEdge ? code_elsewhere(vertex.number, cells) : "VOX-4";
    const VoxelView& view = vertex.view;
    const unsigned edge = view.edge_of(number);
    std::int32_t level = 0;
    if constexpr (Coder::kWrites) level = vertex.cut->level;
    level = code_level(level, view.mean_on(edge), view.plane_on(edge));
    nodes_[vertex.number] = nodes_[view.corner()] + view.steps_to(edge);
    spots_[vertex.number] = view.spot_on(edge, grid_.part_of(level));
    return settle(vertex.number, edge / 4, level, cells[vertex.number]);
  }

  /// An edge by its axis and its lower node, from the node below what is expected; or a vertex on none.
  /// Kept out of the way of the vertices on a cube's edges, which are most.
  [[gnu::noinline]] const char* code_elsewhere(std::uint32_t vertex, std::span<Cell> cells) {
    // Nothing comes before the first one of a walk.
    const std::uint32_t after = vertex == faces_.second_walk() ? 0 : vertex;
    const Surroundings around = faces_.around(vertex);
    const Expectation expected = expect_place(around, after, cells, blends_);
    const std::array<std::int64_t, 3> place = expected.place();
    std::optional<VoxelGrid::Cut> cut;
    if constexpr (Coder::kWrites) cut = grid_.cut_of(cells[vertex]);
    const unsigned start =
        coder_.symbol(cut ? static_cast<unsigned>(cut->axis) : kFree, Mixture<1>{{&start_}, &start_weights_});
    if (start > kFree) return "VOX-1";
    if (start == kFree) return code_free(vertex, around, expected, cells[vertex]);
    VoxelGrid::Node node{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t nodes = largest_[a] / static_cast<std::uint32_t>(grid_.voxel());
      const std::int64_t below = std::clamp<std::int64_t>((place[a] >> 4) / grid_.voxel(), 0, nodes);
      const std::uint32_t code = cut ? zigzag(static_cast<std::int32_t>(cut->node[a] - below)) : 0;
      const std::int64_t coded = below + unzigzag(coder_.number(code, start_nodes_[a]));
      if (coded < 0 || coded > nodes) return "VOX-5";
      node[a] = static_cast<std::int32_t>(coded);
    }
    const std::int32_t level = code_level(cut ? cut->level : 0, kVoxelMiddle, kVoxelMiddle);
    nodes_[vertex] = FourInts{node[0], node[1], node[2], 0};
    spots_[vertex] = spot_of(node, start, grid_.part_of(level));
    return settle(vertex, start, level, cells[vertex]);
  }

  /// What is remembered is of such vertices only.
  const char* code_free(std::uint32_t vertex, Surroundings around, const Expectation& expected, Cell& cell) {
    const unsigned count = around.known_count;
    around.known_count = 0;
    for (unsigned i = 0; i < count; ++i) {
      const KnownFace face = around.known[i];
      const bool has_a = !spots_[face.a].on_edge();
      const bool has_b = !spots_[face.b].on_edge();
      if (!has_a && !has_b) continue;
      around.known[around.known_count++] = {has_a ? face.a : face.b, has_b ? face.b : face.a, face.opposite};
    }
    spots_[vertex] = kOffEdges;
    ResidualTurn turn = history_.begin(around, expected);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ResidualForecast forecast = turn.forecast(axis, 0, largest_[axis]);
      const std::int64_t q = forecast.whole + residuals_.code(cell[axis] - forecast.whole, forecast);
      if (q < 0 || q > largest_[axis]) return "POSN-7";
      cell[axis] = static_cast<std::int32_t>(q);
      turn.learn(axis, cell[axis], forecast);
    }
    history_.end(vertex, turn, four_ints(cell));
    return nullptr;
  }

  /// Which of the levels along its edge a vertex is at. `mean` and `plane`: where it is expected, parts of
  /// a voxel.
  std::int32_t code_level(std::int32_t level, std::int32_t mean, std::int32_t plane) {
    if (grid_.levels() == 1) return 0;
    const auto bin = [](std::int32_t along, int shift, std::size_t bins) {
      const std::int32_t from_first = (along + kVoxelParts / 8) >> shift;
      return static_cast<std::size_t>(std::clamp(from_first, 0, static_cast<std::int32_t>(bins) - 1));
    };
    SymbolModel& model = level_models_[bin(mean, 2, kMeanBins) * kPlaneBins + bin(plane, 3, kPlaneBins)];
    const auto high = static_cast<std::int32_t>(
        coder_.symbol(static_cast<unsigned>(level) >> low_bits_, Mixture<1>{{&model}, &level_weights_}));
    if (low_bits_ == 0) return std::min(high, grid_.levels() - 1);
    const std::uint32_t low = static_cast<std::uint32_t>(level) & ((1U << low_bits_) - 1);
    return std::min(high << low_bits_ | static_cast<std::int32_t>(coder_.bits(low, low_bits_)),
                    grid_.levels() - 1);
  }

  Coder& coder_;
  const KnownFaces& faces_;
  std::array<std::uint32_t, 3> largest_;
  VoxelGrid grid_;
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  LargeVector<VoxelSpot> spots_;
  LargeVector<FourInts> nodes_;  ///< of those on edges; the last lanes are 0
  unsigned low_bits_ = 0;        ///< of a level, outside its symbol
  BitModel higher_;
  std::vector<SymbolModel> edge_models_;
  std::vector<SymbolModel> corner_models_;
  std::array<MixWeights<2>, 3> edge_weights_;
  std::vector<SymbolModel> level_models_;
  MixWeights<1> level_weights_;
  SymbolModel start_{kFreshStart};
  MixWeights<1> start_weights_;
  std::array<NumberModel, 3> start_nodes_;
};

}  // namespace deltamesh
