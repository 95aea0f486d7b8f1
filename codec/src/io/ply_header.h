// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The header of a PLY file: which elements with which properties follow, and how they are written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

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
};

/// Errors: kInvalidFile with the line. Allocates no more than a constant times the header's bytes.
Result<PlyHeader> read_ply_header(std::span<const std::byte> bytes);

}  // namespace deltamesh
