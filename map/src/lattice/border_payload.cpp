// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "lattice/border_payload.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "attributes/colors/fields.h"
#include "attributes/values.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "format/container.h"
#include "format/header_fields.h"
#include "support/color_value.h"

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

/// Of one attribute. `wanted`: none for readers.
template <class Coder>
void code_colors(Coder& coder, BorderColorModels& models, std::uint32_t step, Attribute& colors,
                 std::span<const BorderVertex> border, std::span<const std::uint8_t> wanted) {
  BorderColorCoder color_coder(coder, models, step);
  const std::size_t size = component_size(colors.type);
  std::size_t next = 0;
  for (const BorderVertex& vertex : border) {
    color_coder.begin_vertex();
    std::byte* value = colors.values.data() + vertex.vertex * colors.components * size;
    for (std::size_t c = 0; c < colors.components; ++c, value += size, ++next)
      store_component(value, size,
                      color_of_level(colors.type, 8,
                                     color_coder.code(color_level(colors.type, value),
                                                      Coder::kWrites ? wanted[next] : std::uint8_t{0})));
  }
}

/// Of all attributes that are colours. False where a step is too large.
template <class Coder>
bool code_all_colors(Coder& coder, BorderColorModels& models, Mesh& mesh,
                     std::span<const BorderVertex> border, std::span<const BorderColors> wanted) {
  std::size_t next = 0;
  const BorderColors none;
  for (Attribute& attribute : mesh.attributes) {
    if (!is_color(attribute)) continue;
    const BorderColors& colors = next < wanted.size() ? wanted[next] : none;
    ++next;
    const std::uint32_t step = coder.number(colors.step, models.step);
    if (step > kMostBorderStep) return false;
    if (step > 0) code_colors(coder, models, step, attribute, border, colors.levels);
  }
  return true;
}

}  // namespace

Result<BorderView> view_border(std::span<const std::byte> stream, const Mesh& mesh,
                               const MapLattice& lattice) {
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
  return view;
}

std::vector<std::byte> write_border(Mesh& mesh, const BorderView& view, std::vector<BorderVertex> border,
                                    const BorderModels& start, std::span<const BorderColors> colors) {
  if (border.empty()) return {};
  const OpenEdges edges(mesh.triangles, mesh.vertex_count());
  CompactWriter writer;
  BorderModels models = start;
  BorderCoder coder(writer, models, view, edges);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) coder.code(v, border, next);
  code_all_colors(writer, models.colors, mesh, border, colors);
  return writer.finish();
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
