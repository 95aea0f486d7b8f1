// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "field/marching_cubes.h"

#include <algorithm>

#include "field/cube_cases.h"

namespace deltamesh::scenes {
namespace {

constexpr std::uint32_t kNoVertex = 0xffffffffU;

class Marcher {
 public:
  Marcher(const Lattice& lattice, const LayerSource& layer) : lattice_(lattice), layer_(layer) {
    for (auto& ids : along_x_) ids.assign(lattice.layer_size(), kNoVertex);
    for (auto& ids : along_y_) ids.assign(lattice.layer_size(), kNoVertex);
    for (auto& ids : along_z_) ids.assign(lattice.layer_size(), kNoVertex);
  }

  Surface run() {
    load(0, 0);
    for (std::uint32_t i = 0; i + 1 < lattice_.nodes[0]; ++i) {
      load(i + 1, 1);
      march_layer(i);
      advance();
    }
    return std::move(surface_);
  }

 private:
  void load(std::uint32_t i, std::size_t side) {
    const auto values = layer_(i);
    values_[side].assign(values.begin(), values.end());
  }

  void advance() {
    std::swap(values_[0], values_[1]);
    std::swap(along_y_[0], along_y_[1]);
    std::swap(along_z_[0], along_z_[1]);
    for (auto* ids : {&along_x_[0], &along_y_[1], &along_z_[1]})
      std::fill(ids->begin(), ids->end(), kNoVertex);
  }

  std::size_t node(std::uint32_t j, std::uint32_t k) const noexcept {
    return std::size_t{j} * lattice_.nodes[2] + k;
  }

  void march_layer(std::uint32_t i) {
    for (std::uint32_t j = 0; j + 1 < lattice_.nodes[1]; ++j) {
      for (std::uint32_t k = 0; k + 1 < lattice_.nodes[2]; ++k) {
        const unsigned inside = inside_mask(j, k);
        if (inside != 0) add_case(inside, i, j, k);
      }
    }
  }

  /// 0 also where a corner is not observed.
  unsigned inside_mask(std::uint32_t j, std::uint32_t k) const noexcept {
    unsigned mask = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const float value = values_[corner & 1][node(j + (corner >> 1 & 1), k + (corner >> 2))];
      if (value == kUnobserved) return 0;
      if (value < 0) mask |= 1U << corner;
    }
    return mask;
  }

  void add_case(unsigned inside, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    for (const CubeTriangle& triangle : cube_cases()[inside])
      for (const std::uint8_t edge : triangle) surface_.triangles.push_back(vertex_on(edge, i, j, k));
  }

  /// The vertex on an edge of the cube at (i, j, k), made when first asked for.
  std::uint32_t vertex_on(std::uint8_t edge, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const CubeEdge& e = cube_edges()[edge];
    const std::size_t side = e.low & 1;
    const std::uint32_t y = j + (e.low >> 1 & 1);
    const std::uint32_t z = k + (e.low >> 2 & 1);
    auto& ids = e.axis == 0 ? along_x_[0] : e.axis == 1 ? along_y_[side] : along_z_[side];
    std::uint32_t& id = ids[node(y, z)];
    if (id != kNoVertex) return id;
    const double a = values_[side][node(y, z)];
    const double b = values_[e.axis == 0 ? 1 : side][node(y + (e.axis == 1), z + (e.axis == 2))];
    std::array<double, 3> place{i + static_cast<double>(side), static_cast<double>(y),
                                static_cast<double>(z)};
    place[e.axis] += a / (a - b);
    const Point p = lattice_.at(place[0], place[1], place[2]);
    id = static_cast<std::uint32_t>(surface_.positions.size() / 3);
    for (const double x : {p.x, p.y, p.z}) surface_.positions.push_back(static_cast<float>(x));
    return id;
  }

  const Lattice& lattice_;
  const LayerSource& layer_;
  std::array<std::vector<float>, 2> values_;  ///< of the layers i and i + 1
  // The vertices on the lattice edges from each node, along x from layer i, along y and z in layers i and i
  // + 1.
  std::array<std::vector<std::uint32_t>, 1> along_x_;
  std::array<std::vector<std::uint32_t>, 2> along_y_;
  std::array<std::vector<std::uint32_t>, 2> along_z_;
  Surface surface_;
};

}  // namespace

Surface march_cubes(const Lattice& lattice, const LayerSource& layer) {
  return Marcher(lattice, layer).run();
}

}  // namespace deltamesh::scenes
