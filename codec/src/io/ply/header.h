// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The header of a PLY file: which elements with which properties follow, and how they are written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Names of the types of properties, by ComponentType.
inline constexpr std::array<std::string_view, 8> kPlyTypes{"char", "uchar", "short", "ushort",
                                                           "int",  "uint",  "float", "double"};

enum class PlyEncoding : std::uint8_t { kAscii, kLittleEndian, kBigEndian };

struct PlyProperty {
  std::string name;
  ComponentType type = ComponentType::kF32;       ///< of the value, or of the list's entries
  bool is_list = false;                           ///
  ComponentType count_type = ComponentType::kU8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::size_t data_offset = 0;  ///< first byte after the header
  std::uint64_t data_line = 1;  ///< its line
  std::uint64_t textures = 0;   ///< comments that name an image
};

/// Errors: kInvalidFile with the line. Allocates no more than a constant times the header's bytes.
Result<PlyHeader> read_ply_header(std::span<const std::byte> bytes);

struct PlyTarget {
  enum class Kind : std::uint8_t { kSkip, kPosition, kAttribute };
  Kind kind = Kind::kSkip;
  std::size_t attribute = 0;   ///< index into PlyLayout::attributes
  std::uint8_t component = 0;  ///< of the position or attribute
};

struct PlyLayout {
  bool has_position = false;
  std::vector<PlyTarget> targets;     ///< one per property
  std::vector<Attribute> attributes;  ///< without values
};

/// Finds x y z, normals (nx ny nz), colours (red green blue [alpha], also r g b [a] and diffuse_red ...;
/// uchar, ushort, float or double), texture coordinates (s t, u v, texture_u texture_v, texture_s texture_t);
/// every other scalar property becomes a generic attribute of its own type. Lists, and properties whose name
/// repeats an earlier one or is no attribute name (over 255 bytes, not UTF-8), are skipped.
PlyLayout layout_ply_element(const PlyElement& element);

}  // namespace deltamesh
