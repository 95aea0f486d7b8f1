// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How a compact ATTR payload codes its values [ATTR-2], and the shapes that each coding is for.
#pragma once

#include <cstdint>

#include "format/chunk/attribute_descriptor.h"

namespace deltamesh {

/// How the values became symbols [ATTR-2].
enum class AttributeCoding : std::uint8_t {
  kSurfaceNormals = 4,   ///< normals, predicted from the surface [ATTR-20]
  kSurfaceUvs = 5,       ///< texture coordinates, predicted from the surface [ATTR-31]
  kSurfaceTangents = 6,  ///< tangents, predicted from the surface [ATTR-38]
  kSurfaceColors = 7,    ///< colours from those around, exact or within a bound [ATTR-45]
  kLattice = 8,          ///< numbers on lattices, predicted from the surface [ATTR-55]
  kWeights = 9,          ///< of joints, which add up to 1 [ATTR-62]
  kJoints = 10,          ///< from those of the vertices around [ATTR-60]
  kMean = 11,            ///< colours or numbers at a mean error, by a transform [HAAR-6]
};

/// Types of colours, weights and what sensors measure.
constexpr bool is_measure(ComponentType type) noexcept {
  return type == ComponentType::kU8 || type == ComponentType::kU16 || type == ComponentType::kF32;
}

/// True where values of this shape may be coded so [ATTR-2].
constexpr bool coding_fits(AttributeCoding coding, AttributeKind kind, ComponentType type,
                           unsigned components) noexcept {
  switch (coding) {
    case AttributeCoding::kLattice:
      return true;
    case AttributeCoding::kSurfaceNormals:
      return kind == AttributeKind::kNormal && type == ComponentType::kF32 && components == 3;
    case AttributeCoding::kWeights:
      return kind == AttributeKind::kWeights && components == 4 && is_measure(type);
    case AttributeCoding::kJoints:
      return kind == AttributeKind::kJoints && components == 4 &&
             (type == ComponentType::kU8 || type == ComponentType::kU16);
    case AttributeCoding::kSurfaceColors:
      return kind == AttributeKind::kColor && (components == 3 || components == 4) && is_measure(type);
    case AttributeCoding::kMean:
      return ((kind == AttributeKind::kColor && (components == 3 || components == 4)) ||
              (kind == AttributeKind::kGeneric && components == 1)) &&
             is_measure(type);
    case AttributeCoding::kSurfaceUvs:
      return kind == AttributeKind::kUv && type == ComponentType::kF32 && components == 2;
    case AttributeCoding::kSurfaceTangents:
      return kind == AttributeKind::kTangent && type == ComponentType::kF32 && components == 4;
  }
  return false;
}

}  // namespace deltamesh
