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
        vertices_(faces.vertex_count()),
        corner_models_(kCornerContexts, kFreshEdge) {
    edge_models_.reserve(kEdgeContexts);
    for (std::size_t i = 0; i < kEdgeContexts; ++i)
      edge_models_.push_back(fresh_edges(i / kEdgeSlots / kMostLikely % voxel::kEdges, i % kEdgeSlots));
    while ((levels - 1) >> low_bits_ >= kSymbols) ++low_bits_;
    std::array<std::uint8_t, kSymbols> weights{};
    for (std::uint32_t i = 0; i <= (levels - 1) >> low_bits_; ++i) weights[i] = 1;
    for (std::size_t i = 0; i < cuts_.size(); ++i) cuts_[i].assign(kCutContexts[i], SymbolModel(weights));
  }

  /// Codes cells[vertex]; those before it are coded. A reader fills it in. The rule that a stream breaks
  /// here, or null.
  const char* code_vertex(std::uint32_t vertex, std::span<Cell> cells) {
    const Surroundings around = faces_.around(vertex);
    std::optional<VoxelGrid::Cut> cut;
    if constexpr (Coder::kWrites) cut = grid_.cut_of(cells[vertex]);
    VoxelVertex own;
    VoxelView view;
    if (view.find(around, vertices_)) {
      if (view.is_open()) view.choose(coder_.bit(cut && view.higher_has(cut->vertex), higher_));
      view.look(around, vertices_, blends_);
      const unsigned number = code_edge(around, view, cut ? view.number_of(cut->vertex) : voxel::kNoEdge);
      if (number < voxel::kEdges) {
        const std::size_t axis = view.edge_of(number, own);
        const std::int32_t level = code_level(cut ? cut->level : 0, view.mean_along(axis),
                                              view.plane_along(axis, own), view.neighbors());
        cells[vertex] = grid_.cut(own, axis, level);
        vertices_[vertex] = own;
        return within(cells[vertex]) ? nullptr : "POSN-7";
      }
      if (number != voxel::kNoEdge) return "VOX-4";
    }
    return code_elsewhere(around, vertex, cells, cut);
  }

 private:
  static constexpr std::size_t kMostLikely = 4;
  static constexpr std::size_t kMostFaces = 9;
  static constexpr std::size_t kEdgeSlots = voxel::kEdges + 1;  ///< with none
  static constexpr std::size_t kEdgeContexts = voxel::kPairKinds * voxel::kEdges * kMostLikely * kEdgeSlots;
  static constexpr std::size_t kCornerContexts = voxel::kPairKinds * kEdgeSlots * (kMostFaces + 1);
  static constexpr std::size_t kCutBins = 20;
  static constexpr std::array<std::size_t, 2> kCutContexts = {kCutBins * kCutBins, 2 * kCutBins * 6};
  static constexpr unsigned kFree = 3;
  static constexpr SymbolModel kFreshEdge{{8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 1, 0, 0, 0}};
  static constexpr SymbolModel kFreshStart{{8, 8, 8, 8, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  bool within(const Cell& cell) const noexcept {
    bool is_within = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      is_within &= static_cast<std::uint32_t>(cell[axis]) <= largest_[axis];
    return is_within;
  }

  static SymbolModel fresh_edges(std::size_t nearest, std::size_t next) {
    std::array<std::uint8_t, kSymbols> weights = {2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 1};
    weights[nearest] = 100;
    if (next != voxel::kNoEdge) weights[next] = 20;
    return SymbolModel(weights);
  }

  unsigned code_edge(const Surroundings& around, const VoxelView& view, unsigned number) {
    const std::size_t likely = std::min<std::size_t>(view.likely(), kMostLikely) - 1;
    const std::size_t degree = std::min<std::size_t>(around.faces, kMostFaces);
    const std::size_t edge =
        ((view.kind() * voxel::kEdges + view.nearest()) * kMostLikely + likely) * kEdgeSlots + view.next();
    const std::size_t corner = (view.kind() * kEdgeSlots + view.opposite()) * (kMostFaces + 1) + degree;
    return coder_.symbol(number, Mixture<2>{{&edge_models_[edge], &corner_models_[corner]},
                                            &edge_weights_[std::min(around.known_count, 3U) - 1]});
  }

  /// An edge by its axis and its lower node, from the node below what is expected; or a vertex on none.
  /// Kept out of the way of the vertices on a cube's edges, which are most.
  [[gnu::noinline]] const char* code_elsewhere(const Surroundings& around, std::uint32_t vertex,
                                               std::span<Cell> cells,
                                               const std::optional<VoxelGrid::Cut>& cut) {
    const Expectation expected = expect_place(around, vertex, cells, blends_);
    const std::array<std::int64_t, 3> place = expected.place();
    const unsigned start = coder_.symbol(cut ? static_cast<unsigned>(cut->vertex.axis()) : kFree,
                                         Mixture<1>{{&start_}, &start_weights_});
    if (start > kFree) return "VOX-1";
    if (start == kFree) return code_free(around, expected, vertex, cells[vertex]);
    VoxelVertex& own = vertices_[vertex];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t nodes = largest_[a] / static_cast<std::uint32_t>(grid_.voxel());
      const std::int64_t below = std::clamp<std::int64_t>((place[a] >> 4) / grid_.voxel(), 0, nodes);
      const std::uint32_t code =
          cut ? zigzag(static_cast<std::int32_t>(cut->vertex.place[a] / 2 - below)) : 0;
      const std::int64_t node = below + unzigzag(coder_.number(code, nodes_[a]));
      if (node < 0 || node > nodes) return "VOX-5";
      own.place[a] = static_cast<std::int32_t>(2 * node + (a == start ? 1 : 0));
    }
    cells[vertex] = grid_.cut(own, start, code_level(cut ? cut->level : 0, kMiddle, kMiddle, 0));
    return within(cells[vertex]) ? nullptr : "POSN-7";
  }

  /// What is remembered is of such vertices only.
  const char* code_free(Surroundings around, const Expectation& expected, std::uint32_t vertex, Cell& cell) {
    const unsigned count = around.known_count;
    around.known_count = 0;
    for (unsigned i = 0; i < count; ++i) {
      const KnownFace face = around.known[i];
      const bool has_a = !vertices_[face.a].on_edge();
      const bool has_b = !vertices_[face.b].on_edge();
      if (!has_a && !has_b) continue;
      around.known[around.known_count++] = {has_a ? face.a : face.b, has_b ? face.b : face.a, face.opposite};
    }
    history_.begin(around, expected);
    if (!code_free<0>(cell) || !code_free<1>(cell) || !code_free<2>(cell)) return "POSN-7";
    history_.end(vertex, cell);
    return nullptr;
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

  static constexpr std::int32_t kMiddle = 64;  ///< of an edge, 64ths of half a voxel

  /// Which of the levels along its edge a vertex is at. `mean` and `plane`: where it is expected, 64ths of
  /// half a voxel.
  std::int32_t code_level(std::int32_t level, std::int32_t mean, std::int32_t plane, unsigned neighbors) {
    if (grid_.levels() == 1) return 0;
    const auto bin = [](std::int32_t along, int shift, std::size_t bins) {
      return static_cast<std::size_t>(
          std::clamp((along + 16) >> shift, 0, static_cast<std::int32_t>(bins) - 1));
    };
    const std::size_t both = bin(mean, 3, kCutBins) * kCutBins + bin(plane, 3, kCutBins);
    const std::size_t fine = bin(mean, 2, 2 * kCutBins) * 6 + std::min(neighbors, 5U);
    const auto high = static_cast<std::int32_t>(
        coder_.symbol(static_cast<unsigned>(level) >> low_bits_,
                      Mixture<2>{{&cuts_[0][both], &cuts_[1][fine]}, &cut_weights_}));
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
  std::vector<VoxelVertex> vertices_;
  unsigned low_bits_ = 0;  ///< of a level, outside its symbol
  BitModel higher_;
  std::vector<SymbolModel> edge_models_;
  std::vector<SymbolModel> corner_models_;
  std::array<MixWeights<2>, 3> edge_weights_;
  std::array<std::vector<SymbolModel>, 2> cuts_;
  MixWeights<2> cut_weights_;
  SymbolModel start_{kFreshStart};
  MixWeights<1> start_weights_;
  std::array<NumberModel, 3> nodes_;
};

}  // namespace deltamesh
