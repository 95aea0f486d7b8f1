// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/container.h"
#include "format/header_fields.h"
#include "lattice/border_payload.h"
#include "lattice/border_payload_colors.h"
#include "lattice/place_border.h"
#include "lattice/positions.h"

namespace deltamesh {
namespace {

constexpr std::uint8_t kAllLoose = 7;

Error broken_border(const char* message, const char* rule = "MAP-11") noexcept {
  return {.code = ErrorCode::kInvalidStream, .message = message, .rule = rule};
}

/// Positions beyond the lattice have its outermost points.
LatticePoint nearest_point(const float* position, const MapLattice& lattice) noexcept {
  const auto most = static_cast<float>(kMostLatticeSteps * lattice.step());
  std::array<float, 3> within{};
  for (std::size_t k = 0; k < 3; ++k) within[k] = std::clamp(position[k], -most, most);
  return lattice.nearest(within);
}

/// Of a vertex of voxel edges: odd coordinates are between two planes of voxels.
std::uint8_t loose_axes(const float* position, const PositionLattice& lattice) noexcept {
  constexpr double kMostSteps = 0x1p50;
  std::uint8_t loose = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double steps = std::floor((position[axis] - lattice.origin[axis]) / lattice.step[axis] + 0.5);
    const bool is_even = std::abs(steps) < kMostSteps && (static_cast<std::int64_t>(steps) & 1) == 0;
    if (!is_even) loose = static_cast<std::uint8_t>(loose | 1U << axis);
  }
  return loose;
}

/// BorderView::former: unmoved vertices have the bits of a position of the base, of the first vertex there.
std::vector<std::uint32_t> former_of(const Mesh& mesh, const MapPart& base) {
  std::vector<std::uint32_t> in_border(base.mesh.vertex_count(), BorderView::kUnmoved);
  for (std::size_t i = 0; i < base.border.size(); ++i)
    in_border[base.border[i].vertex] = static_cast<std::uint32_t>(i);
  std::unordered_map<PositionBits, std::uint32_t, PositionHash> known;
  const std::vector<float> positions = streamed_positions(base);
  for (std::size_t v = 0; v < in_border.size(); ++v)
    known.try_emplace(position_bits(&positions[3 * v]), in_border[v]);
  std::vector<std::uint32_t> former;
  former.reserve(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto found = known.find(bits_of(mesh, v));
    former.push_back(found != known.end() ? found->second : BorderView::kMoved);
  }
  return former;
}

}  // namespace

Result<BorderView> view_border(std::span<const std::byte> stream, const Mesh& mesh, const MapLattice& lattice,
                               const MapPart* base) {
  DELTAMESH_TRY(const Container container, Container::open(stream));
  const Geometry geometry = geometry_of(container.header());
  BorderView view{.nearest = {}, .loose = {}, .follows = geometry == Geometry::kHighpass};
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const float* const position = mesh.positions.data() + 3 * v;
    view.nearest.push_back(nearest_point(position, lattice));
    view.loose.push_back(geometry == Geometry::kVoxel
                             ? loose_axes(position, container.header().predictive.lattice)
                             : kAllLoose);
  }
  if (base != nullptr) {
    view.former = former_of(mesh, *base);
    view.base_border = base->border;
  }
  return view;
}

Result<std::vector<BorderVertex>> read_border(std::span<const std::byte> bytes, Mesh& mesh,
                                              const BorderView& view,
                                              const Learning<BorderModels>& learning) {
  std::vector<BorderVertex> border;
  if (learning.end != nullptr) *learning.end = *learning.start;
  if (bytes.empty()) return border;
  const OpenEdges edges(mesh.triangles, mesh.vertex_count());
  CompactReader reader(bytes);
  BorderModels models = *learning.start;
  BorderCoder coder(reader, models, view, edges);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count() && !reader.failed(); ++v)
    if (!coder.code(v, border, next) && !reader.failed())
      return broken_border("a border vertex beyond the lattice");
  if (!border.empty() && !code_all_colors(reader, models.colors, mesh, border, {}) && !reader.failed())
    return broken_border("a step of colours above 255", "MAP-24");
  DELTAMESH_CHECK(reader.finish(0));
  if (border.empty()) return broken_border("a coded border without vertices");
  if (learning.end != nullptr) *learning.end = models;
  return border;
}

}  // namespace deltamesh
