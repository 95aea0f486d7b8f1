// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A building as a robot has mapped it: truncated signed distances with noise, where it has looked.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/building.h"
#include "field/marching_cubes.h"

namespace deltamesh::scenes {

/// Values of the lattice's layers, upwards, from blocks of voxels: only blocks near a surface are evaluated.
class Scan {
 public:
  Scan(const Building& building, const Lattice& lattice, std::uint64_t seed);

  /// Layer i of the lattice, as LayerSource asks for it; `i` runs upwards.
  std::span<const float> layer(std::uint32_t i);

 private:
  void fill_slab(std::uint32_t first);
  void fill_block(std::uint32_t first, std::uint32_t j, std::uint32_t k);
  float value_at(std::uint32_t i, std::uint32_t j, std::uint32_t k, const Room& room,
                 std::span<const Item* const> items);
  double visibility_at(std::uint32_t i, std::uint32_t j, std::uint32_t k);
  double visibility_node(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  double trace_visibility(const Point& p) const;

  const Building& building_;
  const Lattice& lattice_;
  std::uint64_t seed_;
  double truncation_;
  std::uint32_t slab_first_ = 0;
  std::vector<float> slab_;              ///< kBlock layers
  std::vector<float> visibility_;        ///< coarse nodes of the slab; negative: not yet known
  std::vector<const Item*> near_items_;  ///< of the block in hand
};

}  // namespace deltamesh::scenes
