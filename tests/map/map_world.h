// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A tiny map that changes: a sheet of unit squares, each a block, whose corners have heights.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "deltamesh/map/sender.h"

namespace deltamesh::test {

using Square = std::array<std::int32_t, 3>;

class World {
 public:
  World(int edge, std::uint32_t seed) : edge_(edge), random_(seed) {
    for (int x = 0; x <= edge; ++x)
      for (int y = 0; y <= edge; ++y) heights_[{x, y}] = height();
    for (int x = 0; x < edge; ++x)
      for (int y = 0; y < edge; ++y)
        if (random_() % 3 != 0) present_.insert({x, y, 0});
  }

  static MapDescription description() {
    MapDescription description{.id = 9, .epoch = 1, .frame = "map", .cell_steps = 64};
    description.lattice.step_exponent = -6;
    return description;
  }

  /// Moves some corners, by little or by much, and makes some squares come or go. The blocks that changed.
  std::set<Square> change() {
    std::set<Square> touched;
    for (int i = below(4); i > 0; --i) {
      const int x = below(edge_ + 1);
      const int y = below(edge_ + 1);
      float& h = heights_[{x, y}];
      h = random_() % 2 == 0 ? height() : h + 0.01F * static_cast<float>(below(5) - 2);
      for (int dx = -1; dx <= 0; ++dx)
        for (int dy = -1; dy <= 0; ++dy)
          if (present_.contains({x + dx, y + dy, 0})) touched.insert({x + dx, y + dy, 0});
    }
    for (int i = below(3); i > 0; --i) {
      const Square square{below(edge_), below(edge_), 0};
      if (present_.erase(square) != 0) {
        removed_.insert(square);
      } else {
        present_.insert(square);
      }
      touched.insert(square);
    }
    return touched;
  }

  const std::set<Square>& present() const { return present_; }
  const std::set<Square>& ever_removed() const { return removed_; }
  int edge() const { return edge_; }

  /// Heights of its corners, x first, or nothing.
  std::optional<std::array<float, 4>> heights_of(const Square& square) const {
    if (!present_.contains(square)) return std::nullopt;
    std::array<float, 4> heights{};
    for (int i = 0; i < 4; ++i)
      heights[static_cast<std::size_t>(i)] = heights_.at({square[0] + i % 2, square[1] + i / 2});
    return heights;
  }

  /// Gives the sender these blocks as they are now.
  Result<void> tell(MapSender& sender, const std::set<Square>& squares) const {
    std::vector<Mesh> meshes;
    for (const Square& square : squares)
      meshes.push_back(present_.contains(square) ? mesh_of(square) : Mesh());
    std::vector<MapBlock> blocks;
    auto mesh = meshes.begin();
    for (const Square& square : squares) blocks.push_back({square, *mesh++});
    return sender.update(blocks);
  }

 private:
  float height() { return 0.125F + 0.7F * static_cast<float>(random_() % 1000) / 1000; }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  Mesh mesh_of(const Square& square) const {
    Mesh mesh;
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
      for (const float coordinate : {static_cast<float>(square[0] + dx), static_cast<float>(square[1] + dy),
                                     heights_.at({square[0] + dx, square[1] + dy})})
        mesh.positions.push_back(coordinate);
    mesh.triangles = {0, 1, 2, 1, 3, 2};
    return mesh;
  }

  int edge_;
  std::mt19937 random_;
  std::map<std::pair<int, int>, float> heights_;
  std::set<Square> present_;
  std::set<Square> removed_;
};

}  // namespace deltamesh::test
