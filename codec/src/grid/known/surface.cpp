// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "grid/known/surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "grid/bounds.h"
#include "grid/cube/cube.h"
#include "grid/window.h"

namespace deltamesh::grid {
namespace {

constexpr unsigned kNoAxis = 3;

Bricks::Place brick_of(const Node& node) noexcept { return {node[0] >> 4, node[1] >> 4, node[2] >> 4}; }
Spot spot_in_brick(const Node& node) noexcept { return {node[0] & 15, node[1] & 15, node[2] & 15}; }

}  // namespace

/// Of a vertex: the edge that it is on.
struct KnownSurface::Home {
  Node node{};
  unsigned axis = kNoAxis;
  std::uint32_t level = 0;

  static Home of(const float* position, const PredictiveParameters& parameters) noexcept {
    const PositionLattice& lattice = parameters.lattice;
    const double voxel = 2.0 * parameters.levels;
    Home home;
    std::array<double, 3> at{};
    std::array<double, 3> off{};  // from the nearest plane of nodes
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] =
          (double{position[k]} - lattice.origin[k]) / lattice.step[k] - static_cast<double>(lattice.first[k]);
      if (!(at[k] >= -0.5 && at[k] <= lattice.cells[k] + 0.5)) return {};
      const double nearest = std::floor(at[k] / voxel + 0.5);
      off[k] = std::abs(at[k] - voxel * nearest);
      home.node[k] = static_cast<std::int32_t>(nearest);
    }
    const auto axis = static_cast<unsigned>(std::max_element(off.begin(), off.end()) - off.begin());
    for (unsigned k = 0; k < 3; ++k)
      if (k != axis && off[k] > voxel / 8) return {};
    const double first = std::floor(std::max(at[axis], 0.0) / voxel);
    home.node[axis] = static_cast<std::int32_t>(first);
    home.axis = axis;
    home.level = static_cast<std::uint32_t>(
        std::clamp(std::floor((at[axis] - voxel * first) / 2), 0.0, voxel / 2 - 1));
    return home;
  }
};

/// With its three corners on different edges of one cube.
struct KnownSurface::Face {
  Node lowest{};
  Triangle edges{};

  static std::optional<Face> of(const std::array<const Home*, 3>& corners) noexcept {
    Face face;
    face.lowest.fill(std::numeric_limits<std::int32_t>::min());
    for (const Home* const home : corners) {
      if (home->axis == kNoAxis) return std::nullopt;
      for (unsigned k = 0; k < 3; ++k)
        face.lowest[k] = std::max(face.lowest[k], home->node[k] - (k != home->axis ? 1 : 0));
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const Home& home = *corners[c];
      for (std::size_t k = 0; k < 3; ++k)
        if (home.node[k] < face.lowest[k]) return std::nullopt;
      const auto step = [&](unsigned axis) {
        return static_cast<unsigned>(home.node[axis % 3] - face.lowest[axis % 3]);
      };
      face.edges[c] =
          static_cast<std::uint8_t>(4 * home.axis + step(home.axis + 1) + 2 * step(home.axis + 2));
    }
    const auto& [a, b, c] = face.edges;
    return a == b || b == c || c == a ? std::nullopt : std::optional(face);
  }
};

std::optional<KnownSurface> KnownSurface::make(const KnownMesh& mesh,
                                               const PredictiveParameters& parameters) {
  std::optional<KnownSurface> surface(std::in_place);
  const std::uint32_t most = most_bricks(mesh.positions.size() / 3);
  std::vector<Home> homes;
  if (!surface->add_vertices(mesh, parameters, homes)) return std::nullopt;
  for (std::size_t f = 0; f < mesh.triangles.size() / 3; ++f) {
    const auto corner = [&](std::size_t c) { return &homes[mesh.triangles[3 * f + c]]; };
    if (const auto face = Face::of({corner(0), corner(1), corner(2)})) surface->add_face(*face);
    if (surface->bricks_.count() > most) return std::nullopt;
  }
  for (const Cube& cube : surface->cubes_) {
    surface->add_bricks_around(cube);
    if (surface->bricks_.count() > most) return std::nullopt;
  }
  for (const Cube& cube : surface->cubes_) surface->settle(cube);
  for (auto& [cube, pattern] : surface->patterns_) pattern.sort();
  return surface;
}

/// False where there are too many bricks.
bool KnownSurface::add_vertices(const KnownMesh& mesh, const PredictiveParameters& parameters,
                                std::vector<Home>& homes) {
  const std::size_t count = mesh.positions.size() / 3;
  edges_.resize(count);
  homes.reserve(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const Home& home = homes.emplace_back(Home::of(&mesh.positions[3 * std::size_t{v}], parameters));
    if (home.axis == kNoAxis) continue;
    edges_[v].level = home.level;
    edges_[v].cut = static_cast<std::int8_t>(
        static_cast<int>(32 * (2 * std::uint64_t{home.level} + 1) / parameters.levels) - 32);
    Brick& brick = brick_at(brick_of(home.node));
    const Spot spot = spot_in_brick(home.node);
    std::uint32_t& vertex = bricks_.vertex(
        brick, kSlots[0][static_cast<std::size_t>(spot[0])] + row_slot(spot[1], spot[2]), home.axis);
    if (vertex == kNoVertex) vertex = v;
    brick.cut[static_cast<std::size_t>(spot[1] + kSide * spot[2])] |=
        Brick::cut_bit(static_cast<unsigned>(spot[0]), home.axis);
    if (bricks_.count() > most_bricks(count)) return false;
  }
  return true;
}

std::vector<std::uint32_t> KnownSurface::vertices_at(std::span<const float> positions,
                                                     const PredictiveParameters& parameters) const {
  std::vector<std::uint32_t> vertices(positions.size() / 3, kNoKnownVertex);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Home home = Home::of(&positions[3 * v], parameters);
    if (home.axis == kNoAxis) continue;
    const Brick* const brick = bricks_.find(brick_of(home.node));
    const auto spot = spot_in_brick(home.node);
    const auto x = static_cast<unsigned>(spot[0]);
    if (brick == nullptr ||
        (brick->cut[static_cast<std::size_t>(spot[1] + kSide * spot[2])] & Brick::cut_bit(x, home.axis)) == 0)
      continue;
    vertices[v] = bricks_.vertex(*brick, kSlots[0][x] + row_slot(spot[1], spot[2]), home.axis);
  }
  return vertices;
}

Brick& KnownSurface::brick_at(const Bricks::Place& at) {
  if (last_ == nullptr || last_->at != at) last_ = &bricks_.get(at);
  return *last_;
}

void KnownSurface::add_face(const Face& face) {
  Brick& brick = brick_at(brick_of(face.lowest));
  const unsigned place = place_of(spot_in_brick(face.lowest));
  const bool is_first = brick.cubes[place] == 0;
  if (is_first) cubes_.push_back({&brick, place});
  brick.cubes[place] = 1;
  Pattern& pattern = patterns_[number_of(brick, place)];
  if (pattern.triangles().size() < Pattern::kMostTriangles) pattern.add(face.edges);
  const Corners known(brick, place);
  Signs outside = known.outside;
  Signs inside = known.inside;
  const Node normal = normal_of(face.edges);
  for (const unsigned edge : face.edges) {
    const int way = normal[edge / 4];
    if (way == 0) continue;
    unsigned in = 1U << first_corner(edge);
    unsigned out = 1U << last_corner(edge);
    if (way < 0) std::swap(in, out);
    inside |= in & ~outside;
    outside |= out & ~inside;
  }
  if (is_first || outside != known.outside || inside != known.inside)
    bricks_.set_corners(brick, place, outside, inside);
}

/// Makes the bricks of the 26 cubes around. Cubes away from low sides have them already, by their corners.
void KnownSurface::add_bricks_around(const Cube& cube) {
  const Spot spot = spot_of(cube.place);
  if (spot[0] > 0 && spot[1] > 0 && spot[2] > 0) return;
  for (int i = 0; i < 27; ++i) {
    Spot other = {spot[0] + i % 3 - 1, spot[1] + i / 3 % 3 - 1, spot[2] + i / 9 - 1};
    bricks_.home(*cube.brick, other);
  }
}

/// Corners that no face tells of are on the side of those along edges that are not cut.
void KnownSurface::settle(const Cube& cube) {
  Brick& brick = *cube.brick;
  const unsigned over = beyond(cube.place);
  const Spot spot = spot_of(cube.place);
  Corners known(brick, cube.place);
  if (known.known() == 255) return;
  const auto is_cut = [&](unsigned edge) {
    const unsigned corner = first_corner(edge);
    const auto at = [&](unsigned axis) {
      return (static_cast<unsigned>(spot[axis]) + (corner >> axis & 1)) & 15;
    };
    return (Bricks::brick_of(brick, over, corner).cut[at(1) + kSide * at(2)] &
            Brick::cut_bit(at(0), edge / 4)) != 0;
  };
  std::array<Signs, 3> uncut{};  // of each axis, the first corners of edges
  for (unsigned edge = 0; edge < kEdges; ++edge)
    if (!is_cut(edge)) uncut[edge / 4] |= 1U << first_corner(edge);
  for (Signs before = 0; before != known.known();) {
    before = known.known();
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned step = 1U << axis;
      const Signs all = known.known();
      const Signs up = uncut[axis] & all & ~(all >> step);
      const Signs down = uncut[axis] & ~all & all >> step;
      for (Signs* const side : {&known.outside, &known.inside})
        *side |= (*side & up) << step | (*side >> step & down);
    }
  }
  bricks_.set_corners(brick, cube.place, known.outside, known.inside);
}

}  // namespace deltamesh::grid
