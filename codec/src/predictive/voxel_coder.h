// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Fine lattice coordinates of vertices of which most are on the edges of a voxel grid [VOX-*]. One template
// for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/zigzag.h"
#include "predictive/residual_coder.h"
#include "predictive/voxel_edges.h"

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
        edges_(faces.vertex_count()) {
    for (std::size_t i = 0; i < ranks_.size(); ++i) ranks_[i].assign(kRankContexts[i], kFreshRank);
    for (std::size_t i = 0; i < cuts_.size(); ++i) cuts_[i].assign(kCutContexts[i], kFreshCut);
  }

  /// Codes cells[vertex]; those before it are coded. A reader fills it in. The rule that a stream breaks
  /// here, or null.
  const char* code_vertex(std::uint32_t vertex, std::span<Cell> cells) {
    const Surroundings around = faces_.around(vertex);
    const Expectation expected = expect_place(around, vertex, cells, blends_);
    const Place place = expected.place();
    history_.begin(around, expected);
    Cell& cell = cells[vertex];
    std::optional<EdgePlace> edge;
    if constexpr (Coder::kWrites) edge = grid_.edge_of(cell);
    if (const char* broken = code_place(around, place, cell, edge)) return broken;
    if (edge) code_cut(around, place, *edge, cell);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (cell[axis] < 0 || static_cast<std::uint32_t>(cell[axis]) > largest_[axis]) return "POSN-7";
    history_.end(vertex, cell);
    edges_[vertex] = edge ? edge : grid_.edge_of(cell);
    return nullptr;
  }

 private:
  using Place = std::array<std::int64_t, 3>;  ///< 1/16 fine steps

  static constexpr std::array<std::uint32_t, 4> kRankContexts = {4 * 16 * 6, 10 * 4, 6 * 4 * 8, 16 * 10};
  static constexpr std::array<std::uint32_t, 2> kCutContexts = {20, 40 * 4};
  static constexpr unsigned kNotRanked = 15;
  static constexpr unsigned kFree = 3;
  static constexpr SymbolModel kFreshRank{{100, 30, 20, 10, 8, 6, 4, 3, 3, 2, 2, 2, 1, 1, 1, 8}};
  static constexpr SymbolModel kFreshCut{{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
  static constexpr SymbolModel kFreshStart{{8, 8, 8, 8, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  /// The edge, or where the vertex is on none, its cell.
  const char* code_place(const Surroundings& around, const Place& expected, Cell& cell,
                         std::optional<EdgePlace>& edge) {
    const EdgeCandidates candidates(around, edges_, expected, grid_);
    if (candidates.size() > 0) {
      std::optional<unsigned> rank;
      if (edge) rank = candidates.rank_of(*edge, kNotRanked);
      const unsigned coded = code_rank(rank.value_or(kNotRanked), around, candidates);
      if (coded != kNotRanked) {
        if (coded >= candidates.size()) return "VOX-4";
        edge = candidates.ranked(coded);
        return nullptr;
      }
    }
    const unsigned start = coder_.symbol(edge ? static_cast<unsigned>(axis_of(*edge)) : kFree,
                                         Mixture<1>{{&start_}, &start_weights_});
    if (start > kFree) return "VOX-1";
    return start == kFree ? code_free(cell) : code_start(start, expected, edge);
  }

  unsigned code_rank(unsigned rank, const Surroundings& around, const EdgeCandidates& candidates) {
    const unsigned doubt = candidates.doubt();
    const unsigned likely = std::min(candidates.likely(), 15U);
    const unsigned degree = std::min(around.faces, 9U);
    const unsigned faces = candidates.faces();
    const std::array<unsigned, 4> contexts = {
        (faces * 16 + likely) * 6 + doubt, degree * 4 + faces,
        (doubt * 4 + faces) * 8 + std::min(around.parallelogram_count, 7U), likely * 10 + degree};
    return coder_.symbol(rank, Mixture<4>{{&ranks_[0][contexts[0]], &ranks_[1][contexts[1]],
                                           &ranks_[2][contexts[2]], &ranks_[3][contexts[3]]},
                                          &rank_weights_[faces]});
  }

  /// An edge by its axis and its lower node, from the node below what is expected.
  const char* code_start(unsigned axis, const Place& expected, std::optional<EdgePlace>& edge) {
    EdgePlace place{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t nodes = largest_[a] / static_cast<std::uint32_t>(grid_.voxel());
      const std::int64_t below = std::clamp<std::int64_t>((expected[a] >> 4) / grid_.voxel(), 0, nodes);
      const std::uint32_t code = edge ? zigzag(static_cast<std::int32_t>((*edge)[a] / 2 - below)) : 0;
      const std::int64_t node = below + unzigzag(coder_.number(code, nodes_[a]));
      if (node < 0 || node > nodes) return "VOX-5";
      place[a] = static_cast<std::int32_t>(2 * node + (a == axis ? 1 : 0));
    }
    edge = place;
    return nullptr;
  }

  /// Kept out of the way of the vertices on edges, which are most.
  [[gnu::noinline]] const char* code_free(Cell& cell) {
    return code_free<0>(cell) && code_free<1>(cell) && code_free<2>(cell) ? nullptr : "POSN-7";
  }

  /// False where a coordinate is beyond the lattice.
  template <std::size_t kAxis>
  bool code_free(Cell& cell) {
    const ResidualForecast forecast = history_.template forecast<kAxis>(0, largest_[kAxis]);
    const std::int64_t q = forecast.whole + residuals_.code(cell[kAxis] - forecast.whole, forecast);
    if (q < 0 || q > largest_[kAxis]) return false;
    cell[kAxis] = static_cast<std::int32_t>(q);
    history_.template learn<kAxis>(cell[kAxis], forecast);
    return true;
  }

  /// Which of the levels along its edge the vertex is at; sets the cell.
  void code_cut(const Surroundings& around, const Place& expected, const EdgePlace& edge, Cell& cell) {
    const std::size_t axis = axis_of(edge);
    const std::int32_t before = cell[axis];
    for (std::size_t a = 0; a < 3; ++a) cell[a] = (edge[a] >> 1) * grid_.voxel();
    const std::int32_t levels = grid_.levels();
    std::int32_t level = 0;
    if constexpr (Coder::kWrites) level = (before - cell[axis]) / 2;
    if (levels > 1) level = code_level(level, levels, around, expected[axis] - 16 * std::int64_t{cell[axis]});
    cell[axis] += 2 * level + 1;
  }

  /// `along`: where on the edge the vertex is expected, 1/16 fine steps.
  std::int32_t code_level(std::int32_t level, std::int32_t levels, const Surroundings& around,
                          std::int64_t along) {
    // Half sixteenths of the edge; what is far off is all one.
    const std::int32_t near = static_cast<std::int32_t>(
        std::clamp<std::int64_t>(along, -64 * std::int64_t{levels}, 64 * std::int64_t{levels}));
    const std::int32_t halves = near / levels;
    const auto sixteenth = static_cast<std::size_t>(std::clamp(halves / 2 + 2, 0, 19));
    const auto half = static_cast<std::size_t>(std::clamp(halves + 4, 0, 39));
    const std::int32_t group = (levels + 15) / 16;
    const unsigned symbol = coder_.symbol(
        static_cast<unsigned>(level / group),
        Mixture<2>{{&cuts_[0][sixteenth], &cuts_[1][half * 4 + std::min(around.parallelogram_count, 3U)]},
                   &cut_weights_});
    const auto first = static_cast<std::int32_t>(symbol) * group;
    if (first >= levels) return levels - 1;  // a symbol that no encoder writes
    if (group == 1) return first;
    const auto range = static_cast<std::uint32_t>(std::min(group, levels - first));
    return first +
           static_cast<std::int32_t>(coder_.uniform(static_cast<std::uint32_t>(level - first), range));
  }

  Coder& coder_;
  const KnownFaces& faces_;
  std::array<std::uint32_t, 3> largest_;
  VoxelGrid grid_;
  BlendTable blends_;
  ResidualHistory history_;
  ResidualCoder<Coder> residuals_;
  std::vector<std::optional<EdgePlace>> edges_;
  std::array<std::vector<SymbolModel>, 4> ranks_;
  std::array<MixWeights<4>, 4> rank_weights_;
  std::array<std::vector<SymbolModel>, 2> cuts_;
  MixWeights<2> cut_weights_;
  SymbolModel start_{kFreshStart};
  MixWeights<1> start_weights_;
  std::array<NumberModel, 3> nodes_;
};

}  // namespace deltamesh
