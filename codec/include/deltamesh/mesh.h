// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The mesh as users hand it in and get it back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace deltamesh {

enum class AttributeKind : std::uint8_t {
  kNormal = 0,   ///< unit vector, 3 x f32
  kColor = 1,    ///< 3 or 4 components, u8 or u16 over the full range, or f32 in [0, 1]
  kUv = 2,       ///< texture coordinates, 2 x f32
  kGeneric = 3,  ///< anything else; exact unless its name is given a bound
  kTangent = 4,  ///< 4 x f32: unit vector, and a sign of 1 or -1
  kJoints = 5,   ///< indices of a skin's joints, u8 or u16; exact
  kWeights = 6,  ///< of those joints, f32, or u8 or u16 over the full range
};

enum class ComponentType : std::uint8_t { kI8 = 0, kU8, kI16, kU16, kI32, kU32, kF32, kF64 };

/// Bytes of one component: 1, 2, 4 or 8.
constexpr std::size_t component_size(ComponentType type) noexcept {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

inline constexpr std::uint8_t kAttributeKinds = 7;

/// One value per vertex: `components` numbers of `type`, native byte order, tightly packed.
struct Attribute {
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;  ///< 1 to 16
  bool normalized = false;      ///< integers stand for [0, 1] or [-1, 1], as in glTF
  std::string name{};  ///< the source's name ("nx", "TEXCOORD_0", "confidence"); UTF-8, at most 255 bytes
  std::vector<std::byte> values{};  ///< vertices x components x component_size(type) bytes
  /// Colours only: linear light, as in glTF; else what a screen shows (sRGB), as in PLY, OBJ, OFF and STL.
  bool linear = false;
};

/// What files call a group of faces; UTF-8, at most 255 bytes each, empty where they say nothing.
struct GroupName {
  std::string object{};    ///< OBJ: o; glTF: the mesh; STL: the solid
  std::string group{};     ///< OBJ: g
  std::string material{};  ///< OBJ: usemtl; glTF: the material

  bool operator==(const GroupName&) const = default;
  bool operator<(const GroupName& other) const noexcept {
    return std::tie(object, group, material) < std::tie(other.object, other.group, other.material);
  }
};

inline constexpr std::uint32_t kMostGroups = 1U << 16;  ///< of a mesh's faces

/// An owned triangle mesh. World position of vertex i = origin + positions[3i .. 3i+2].
struct Mesh {
  std::array<double, 3> origin{};        ///< model units; keeps georeferenced maps precise
  std::vector<float> positions;          ///< n x 3, model units, relative to `origin`
  std::vector<std::uint32_t> triangles;  ///< m x 3 vertex indices, each below n
  std::vector<Attribute> attributes;
  /// m: number of the group (material, primitive) of every triangle, below kMostGroups; or empty: one group.
  std::vector<std::uint32_t> face_groups;
  /// By the group's number; or fewer, or none. At most kMostGroups.
  std::vector<GroupName> group_names{};

  std::size_t vertex_count() const noexcept { return positions.size() / 3; }
  std::size_t triangle_count() const noexcept { return triangles.size() / 3; }
};

/// As Attribute, without ownership.
struct AttributeView {
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;
  bool normalized = false;
  std::string_view name{};
  std::span<const std::byte> values{};
  bool linear = false;
};

/// As Mesh, without ownership of the arrays; they must outlive the view.
struct MeshView {
  MeshView() = default;
  MeshView(const Mesh& mesh);  // NOLINT(google-explicit-constructor): a Mesh is a MeshView

  std::array<double, 3> origin{};
  std::span<const float> positions;
  std::span<const std::uint32_t> triangles;
  std::vector<AttributeView> attributes;
  std::span<const std::uint32_t> face_groups;
  std::span<const GroupName> group_names;

  std::size_t vertex_count() const noexcept { return positions.size() / 3; }
  std::size_t triangle_count() const noexcept { return triangles.size() / 3; }
};

}  // namespace deltamesh
