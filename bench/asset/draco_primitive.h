// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A primitive as KHR_draco_mesh_compression has it: a Draco buffer of its own. Bytes are those of
// glTF-Transform 4.5.1, apart from primitives that share vertices (there the quantisers' ranges are those of
// all) and those with morph targets (which that program codes sequentially).
#pragma once

#include <draco/mesh/mesh.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "asset/asset_source.h"
#include "asset/part.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

/// Bits of the quantisers. Tangents, weights and other floats have 12, float colours 8; integers are exact.
struct DracoSetting {
  int position_bits = 0;
  int normal_bits = 0;
  int uv_bits = 0;
};
inline constexpr int kGenericBits = 12;
inline constexpr int kColorBits = 8;

/// The primitive in Draco's form, equal values and points merged as its own tools do. Without the attribute
/// `left_out`, counted as in the primitive.
std::unique_ptr<draco::Mesh> to_draco(const Primitive& primitive,
                                      std::optional<std::size_t> left_out = std::nullopt);

/// `level`: 10 - speed. Errors: kInternal.
Result<std::vector<std::byte>> encode_draco(const draco::Mesh& mesh, const DracoSetting& setting, int level);
Result<std::unique_ptr<draco::Mesh>> decode_draco(std::span<const std::byte> bytes);

/// Positions as an attribute like the others.
AttributeView position_view(const Mesh& mesh);

/// An attribute's form without its values.
draco::GeometryAttribute layout(draco::GeometryAttribute::Type type, const AttributeView& attribute);

/// `count` rows, one for each value of `attribute`.
void set_values(draco::PointAttribute& attribute, const AttributeView& view, std::size_t count);

}  // namespace deltamesh::bench
