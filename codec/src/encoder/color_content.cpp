// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/color_content.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <span>

#include "attributes/colors/fields.h"
#include "attributes/values.h"
#include "base/guard.h"
#include "base/try.h"
#include "connectivity/check_mesh.h"

namespace deltamesh {
namespace {

constexpr std::uint64_t kFewestEdges = 3000;  // of 1000 faces

using ColorRow = std::array<std::uint8_t, kColorAxes>;

bool are_colors(const AttributeView& attribute) noexcept {
  return attribute.kind == AttributeKind::kColor && attribute.components > 0 &&
         attribute.components <= kColorAxes && color_bits_fit(attribute.type, 8);
}

/// Of 8 bits; empty where a float has none.
std::optional<std::vector<ColorRow>> levels_of(const AttributeView& colors, std::size_t vertices) {
  const std::size_t size = component_size(colors.type);
  std::vector<ColorRow> levels(vertices);
  const std::byte* from = colors.values.data();
  for (ColorRow& row : levels) {
    for (std::size_t c = 0; c < colors.components; ++c, from += size) {
      const auto bits = static_cast<std::uint32_t>(load_component(from, size));
      const auto level = nearest_color_level(colors.type, 8, bits);
      if (!level) return std::nullopt;
      row[c] = static_cast<std::uint8_t>(*level);
    }
  }
  return levels;
}

void count_edge(const ColorRow& a, const ColorRow& b, ColorEdges& edges) noexcept {
  constexpr int kNear = 8;
  constexpr int kFar = 32;
  int difference = 0;
  for (std::size_t c = 0; c < kColorAxes; ++c) difference = std::max(difference, std::abs(a[c] - b[c]));
  ++edges.all;
  edges.equal += difference == 0 ? 1 : 0;
  edges.near += difference > 0 && difference <= kNear ? 1 : 0;
  edges.far += difference > kFar ? 1 : 0;
}

ColorEdges count_edges(std::span<const ColorRow> levels, std::span<const std::uint32_t> triangles) {
  ColorEdges edges;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    count_edge(levels[triangles[i]], levels[triangles[i + 1]], edges);
    count_edge(levels[triangles[i + 1]], levels[triangles[i + 2]], edges);
    count_edge(levels[triangles[i + 2]], levels[triangles[i]], edges);
  }
  return edges;
}

bool are_known(const ColorEdges& edges) noexcept { return edges.all >= kFewestEdges; }

bool are_photographic(const ColorEdges& edges) noexcept {
  return are_known(edges) && 4 * edges.near >= 2 * edges.equal + 3 * edges.far;
}

}  // namespace

ColorEdges& ColorEdges::operator+=(const ColorEdges& other) noexcept {
  equal += other.equal;
  near += other.near;
  far += other.far;
  all += other.all;
  return *this;
}

Result<void> ColorContent::add(const MeshView& mesh) noexcept {
  return guarded([&]() -> Result<void> {
    DELTAMESH_CHECK(check_mesh(mesh));
    std::vector<ColorEdges> added;
    for (const AttributeView& attribute : mesh.attributes) {
      if (!are_colors(attribute)) continue;
      const std::size_t row = attribute.components * component_size(attribute.type);
      if (attribute.values.size() < row * mesh.vertex_count())
        return Error{.code = ErrorCode::kInvalidMesh,
                     .message = "an attribute has fewer values than the mesh has vertices"};
      const auto levels = levels_of(attribute, mesh.vertex_count());
      added.push_back(levels ? count_edges(*levels, mesh.triangles) : ColorEdges());
    }
    edges_.resize(std::max(edges_.size(), added.size()));
    for (std::size_t i = 0; i < added.size(); ++i) edges_[i] += added[i];
    return {};
  });
}

bool ColorContent::is_photographic() const noexcept {
  return !edges_.empty() && std::all_of(edges_.begin(), edges_.end(), are_photographic);
}

bool ColorContent::has_labels() const noexcept {
  return std::any_of(edges_.begin(), edges_.end(),
                     [](const ColorEdges& edges) { return are_known(edges) && !are_photographic(edges); });
}

AttributeQuality ColorContent::complete(AttributeQuality quality) const {
  if (quality.color_error || quality.color_rms) return quality;
  if (is_photographic())
    quality.color_rms = kPhotographicRms;
  else
    quality.color_error = 0;
  return quality;
}

}  // namespace deltamesh
