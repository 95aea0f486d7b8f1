// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The small meshes that inputs of chunk targets choose or describe; seeds are written over the same.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "attributes/surface.h"
#include "attributes/tangents/tangents.h"
#include "support/fuzzed_surface.h"
#include "support/graph_mesh.h"
#include "support/soups.h"

namespace deltamesh::fuzz {

/// Faces all alike over few vertices.
struct SpreadFaces {
  std::uint32_t vertices;
  std::uint32_t faces;
  std::vector<std::uint32_t> triangles{};
  std::vector<std::uint32_t> geometric{};  ///< of vertices in pairs

  SpreadFaces(std::uint8_t vertex_byte, std::uint8_t face_byte)
      : vertices(vertex_byte % 128U), faces(vertices == 0 ? 0 : face_byte) {
    for (std::uint32_t corner = 0; corner < 3 * faces; ++corner)
      triangles.push_back((corner / 3 + corner % 3 * (1 + faces % 7)) % vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) geometric.push_back(v / 2);
  }
  /// `has_copies`: where two vertices are copies of one.
  AttributeSurface surface(bool has_copies) const {
    return {triangles, vertices, has_copies ? std::span(geometric) : std::span<const std::uint32_t>{}};
  }
};

inline test::GraphMesh choose_mesh(unsigned choice) {
  switch (choice % 5) {
    case 0:
      return test::fragments();
    case 1:
      return test::sheet(6, 5);
    case 2:
      return test::fan(40);
    case 3:
      return test::sheet(1, 1);  // one vertex, no faces
    default:
      return test::finish({});
  }
}

inline test::Soup choose_soup(unsigned choice) {
  switch (choice % 4) {
    case 0:
      return test::grid(6, 5, true, false, 4, 1);
    case 1:
      return test::fan(30, true);
    case 2:
      return test::random_soup(2, 8, 20);
    default:
      return {"one_face_and_lone_vertices", {0, 1, 2}, 6};
  }
}

/// A mesh as coders of colours see it.
class ColoredMesh {
 public:
  explicit ColoredMesh(test::GraphMesh mesh) : mesh_(std::move(mesh)) {
    for (const Vec3& p : mesh_.positions)
      for (const double x : {p[0], p[1], p[2]}) positions_.push_back(static_cast<float>(x));
    for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) geometric_.push_back(v % 40);
  }
  AttributeSurface surface(bool with_positions, bool with_copies) const {
    const auto count = static_cast<std::uint32_t>(mesh_.positions.size());
    return {mesh_.triangles, count, with_copies ? std::span(geometric_) : std::span<const std::uint32_t>{},
            with_positions ? std::span(positions_) : std::span<const float>{}};
  }

 private:
  test::GraphMesh mesh_;
  std::vector<float> positions_;
  std::vector<std::uint32_t> geometric_;
};

/// Byte 0: bit 0 whether there are positions, bit 1 whether faces share no vertex of the mesh; byte 1: the
/// number of faces, whose vertex numbers follow.
class FacesOfBytes {
 public:
  explicit FacesOfBytes(std::span<const std::byte> bytes) {
    const auto byte = [&](std::size_t i) {
      return i < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i]) : 0U;
    };
    const std::size_t corners = 3 * std::size_t{byte(1)};
    for (std::size_t i = 0; i < corners; ++i) triangles_.push_back(byte(2 + i));
    rest_ = bytes.subspan(std::min(bytes.size(), 2 + corners));
    count_ = triangles_.empty() ? 1 : *std::max_element(triangles_.begin(), triangles_.end()) + 1;
    if ((byte(0) & 2) != 0) split();
    for (std::uint32_t i = 0; i < 3 * count_ && (byte(0) & 1) != 0; ++i) {
      const std::uint32_t g = geometric_.empty() ? i / 3 : geometric_[i / 3];
      positions_.push_back(static_cast<float>((g * 37 + i % 3 * 11 + g * g % 7) % 64));
    }
  }

  /// Of arrays that this object holds.
  AttributeSurface surface() const { return {triangles_, count_, geometric_, positions_}; }
  std::span<const std::byte> rest() const noexcept { return rest_; }

 private:
  /// A copy for each corner, one at least, by geometric vertex.
  void split() {
    std::vector<std::uint32_t> copies(triangles_.size());
    for (std::uint32_t g = 0; g < count_; ++g) {
      if (std::find(triangles_.begin(), triangles_.end(), g) == triangles_.end()) geometric_.push_back(g);
      for (std::size_t c = 0; c < copies.size(); ++c) {
        if (triangles_[c] != g) continue;
        copies[c] = static_cast<std::uint32_t>(geometric_.size());
        geometric_.push_back(g);
      }
    }
    triangles_ = std::move(copies);
    count_ = static_cast<std::uint32_t>(geometric_.size());
  }

  std::span<const std::byte> rest_;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> geometric_;
  std::vector<float> positions_;
};

/// From a byte, bit 0 for normals, bit 1 for texture coordinates, and their numbers.
inline TangentBasis basis_of(test::FuzzedSurface& fuzzed) {
  TangentBasis basis;
  const unsigned flags = fuzzed.byte();
  for (std::uint32_t i = 0; (flags & 1) != 0 && i < 3 * fuzzed.vertex_count(); ++i)
    basis.normals.push_back(fuzzed.number());
  for (std::uint32_t i = 0; (flags & 2) != 0 && i < 2 * fuzzed.vertex_count(); ++i)
    basis.uvs.push_back(fuzzed.number());
  return basis;
}

/// The joints that weights of a skin are of.
inline Attribute skin_joints(std::uint32_t vertices) {
  Attribute joints{.kind = AttributeKind::kJoints, .type = ComponentType::kU8, .components = 4};
  for (std::uint32_t i = 0; i < 4 * vertices; ++i)
    joints.values.push_back(static_cast<std::byte>(i / 24 % 5 + i % 4));
  return joints;
}

}  // namespace deltamesh::fuzz
