// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes in Draco's form, and its calls.
#pragma once

#include <draco/mesh/mesh.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

/// Bits of the quantisers. Tangents, weights and other floats have 12, float colours 8; integers are exact.
struct DracoSetting {
  int position_bits = 0;
  int normal_bits = 8;
  int uv_bits = 10;
};
inline constexpr int kGenericBits = 12;
inline constexpr int kColorBits = 8;

/// Bits of the quantiser of a float attribute; normals' are those of their octahedron.
int bits_of(const AttributeView& attribute, const DracoSetting& setting);

/// Without the attribute `left_out`.
std::unique_ptr<draco::Mesh> to_draco(const MeshView& mesh,
                                      std::optional<std::size_t> left_out = std::nullopt);

/// `level`: 10 - speed. Errors: kInternal.
Result<std::vector<std::byte>> encode_draco(const draco::Mesh& mesh, const DracoSetting& setting, int level);
Result<std::unique_ptr<draco::Mesh>> decode_draco(std::span<const std::byte> bytes);

/// Positions as an attribute like the others.
AttributeView position_view(const MeshView& mesh);

/// An attribute's form without its values.
draco::GeometryAttribute layout(draco::GeometryAttribute::Type type, const AttributeView& attribute);

/// `count` rows, one for each value of `attribute`.
void set_values(draco::PointAttribute& attribute, const AttributeView& view, std::size_t count);

}  // namespace deltamesh::bench
