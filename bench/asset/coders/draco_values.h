// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What Draco's quantisers leave of a primitive: its error without a search for corresponding vertices.
#pragma once

#include <draco/attributes/attribute_octahedron_transform.h>
#include <draco/attributes/attribute_quantization_transform.h>

#include <cstddef>
#include <span>

#include "peers/draco_mesh.h"

namespace deltamesh::bench {

/// Quantises float values as Draco does: calls `use(transform, portable)`, the latter with what is coded.
template <class Use>
void with_quantizer(const AttributeView& attribute, std::size_t count, const DracoSetting& setting, Use use) {
  draco::PointAttribute source(layout(draco::GeometryAttribute::GENERIC, attribute));
  source.Reset(count);
  source.SetIdentityMapping();
  set_values(source, attribute, count);
  const auto run = [&](auto& transform) {
    const auto portable = transform.InitTransformedAttribute(source, static_cast<int>(count));
    transform.TransformAttribute(source, {}, portable.get());
    use(transform, *portable);
  };
  if (attribute.kind == AttributeKind::kNormal) {
    draco::AttributeOctahedronTransform transform;
    transform.SetParameters(bits_of(attribute, setting));
    run(transform);
  } else {
    draco::AttributeQuantizationTransform transform;
    transform.ComputeParameters(source, bits_of(attribute, setting));
    run(transform);
  }
}

/// The mesh that a primitive decodes to, vertex by vertex: from Draco's quantisers alone, which no coder
/// behind them changes.
Mesh draco_values(const Mesh& mesh, const DracoSetting& setting);

/// Whether the points of `stream`, decoded, are the vertices of `values`, each combination of values counted
/// once.
bool decodes_to(std::span<const std::byte> stream, const Mesh& values);

}  // namespace deltamesh::bench
