// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cstring>

#include "attributes/tangents/coder.h"
#include "attributes/tangents/tangents.h"
#include "base/byte_reader.h"
#include "base/small_code.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Readers choose nothing.
struct NoTangentChoice {};

/// Of the first attribute of this kind, if it has floats, `components` for each vertex.
std::vector<float> first_floats(std::span<const Attribute> decoded, AttributeKind kind,
                                std::uint8_t components, std::uint32_t vertex_count) {
  for (const Attribute& a : decoded) {
    if (a.kind != kind || a.type != ComponentType::kF32 || a.components != components) continue;
    std::vector<float> values(std::size_t{components} * vertex_count);
    if (a.values.size() != values.size() * sizeof(float)) continue;
    if (!values.empty()) std::memcpy(values.data(), a.values.data(), a.values.size());
    return values;
  }
  return {};
}

}  // namespace

TangentBasis tangent_basis(std::span<const Attribute> decoded, std::uint32_t vertex_count) {
  return {.normals = first_floats(decoded, AttributeKind::kNormal, 3, vertex_count),
          .uvs = first_floats(decoded, AttributeKind::kUv, 2, vertex_count)};
}

DELTAMESH_APART Result<std::vector<float>> read_surface_tangents(std::span<const std::byte> bytes,
                                                                 const AttributeSurface& surface,
                                                                 const TangentBasis& basis) {
  ByteReader in(bytes, kTagAttribute);
  DELTAMESH_TRY(const auto step, in.read<float>());
  if (!(step >= kLeastTangentStep && step <= kMostTangentStep))
    return in.invalid("a parameter of the attribute is out of range", "ATTR-38");
  DELTAMESH_TRY(const auto stream, in.read_bytes(in.remaining()));
  CompactReader reader(stream);
  TangentCoder coder(reader, surface, basis.normals, basis.uvs, step, NoTangentChoice{});
  for (std::size_t i = 0; i < coder.count(); ++i) {
    const bool is_valid = coder.code(i);
    if (reader.failed()) break;
    if (!is_valid) return in.invalid("a tangent beyond all directions", "ATTR-24");
  }
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return std::move(coder.values());
}

}  // namespace deltamesh
