// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the bytes of an asset's mesh are spent on, and how far each part is from the source.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "deltamesh/mesh.h"

namespace deltamesh::bench {

enum class Part : std::uint8_t {
  kGeometry,  ///< faces, positions, and everything that belongs to no attribute
  kSeams,     ///< of ours: where attributes differ around a position; Draco's are within its attributes
  kNormals,
  kTangents,
  kUvs,
  kColors,
  kJoints,
  kWeights,
  kOther,
  kMorph,  ///< all displacements of morph targets
};
inline constexpr std::size_t kParts = 10;
inline constexpr std::array<const char*, kParts> kPartNames = {
    "geometry", "seams",  "normals", "tangents", "uvs",
    "colours",  "joints", "weights", "other",    "morph targets"};

constexpr std::size_t index_of(Part part) noexcept { return static_cast<std::size_t>(part); }

/// Of an attribute of a stream, or of a primitive where the name is the glTF semantic. Displacements of morph
/// targets are generic attributes whose names are their semantics after a "d".
constexpr Part part_of(AttributeKind kind, std::string_view name) noexcept {
  switch (kind) {
    case AttributeKind::kNormal:
      return Part::kNormals;
    case AttributeKind::kTangent:
      return Part::kTangents;
    case AttributeKind::kUv:
      return Part::kUvs;
    case AttributeKind::kColor:
      return Part::kColors;
    case AttributeKind::kJoints:
      return Part::kJoints;
    case AttributeKind::kWeights:
      return Part::kWeights;
    case AttributeKind::kGeneric:
      break;
  }
  return name.starts_with('d') ? Part::kMorph : Part::kOther;
}

/// The kind of a vertex attribute of glTF.
constexpr AttributeKind kind_of(std::string_view semantic) noexcept {
  if (semantic == "NORMAL") return AttributeKind::kNormal;
  if (semantic == "TANGENT") return AttributeKind::kTangent;
  if (semantic.starts_with("TEXCOORD_")) return AttributeKind::kUv;
  if (semantic.starts_with("COLOR_")) return AttributeKind::kColor;
  if (semantic.starts_with("JOINTS_")) return AttributeKind::kJoints;
  if (semantic.starts_with("WEIGHTS_")) return AttributeKind::kWeights;
  return AttributeKind::kGeneric;
}

using PartBytes = std::array<std::uint64_t, kParts>;

constexpr std::uint64_t sum(const PartBytes& bytes) noexcept {
  std::uint64_t total = 0;
  for (const std::uint64_t part : bytes) total += part;
  return total;
}

}  // namespace deltamesh::bench
