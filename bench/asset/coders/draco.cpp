// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/coders/draco.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "asset/coders/draco_values.h"
#include "base/try.h"
#include "support/errors.h"

namespace deltamesh::bench {

std::unique_ptr<draco::Mesh> merged_draco(const Primitive& primitive, std::optional<std::size_t> left_out) {
  auto mesh = to_draco(primitive.mesh, left_out);
  mesh->DeduplicateAttributeValues();
  // Morph targets count on the points.
  if (!primitive.has_targets) mesh->DeduplicatePointIds();
  return mesh;
}

Result<CodedMesh> code_with_draco(const AssetMesh& mesh, const DracoSetting& setting) {
  CodedMesh coded;
  coded.bytes[index_of(Part::kMorph)] = mesh.morph_bytes;
  MeshErrorMeter meter;
  for (const Primitive& primitive : mesh.primitives) {
    DELTAMESH_TRY(auto stream, encode_draco(*merged_draco(primitive), setting, kDracoLevel));
    std::uint64_t rest = stream.size();
    for (std::size_t a = 0; a < primitive.mesh.attributes.size(); ++a) {
      DELTAMESH_TRY(const auto without, encode_draco(*merged_draco(primitive, a), setting, kDracoLevel));
      const std::uint64_t bytes = stream.size() - std::min(stream.size(), without.size());
      const Attribute& attribute = primitive.mesh.attributes[a];
      coded.bytes[index_of(part_of(attribute.kind, attribute.name))] += bytes;
      rest -= std::min(rest, bytes);
    }
    coded.bytes[index_of(Part::kGeometry)] += rest;
    const Mesh values = draco_values(primitive.mesh, setting);
    if (!decodes_to(stream, values)) return failure("Draco's stream is not what its quantisers say");
    std::vector<std::uint32_t> order(values.vertex_count());
    std::iota(order.begin(), order.end(), 0U);
    DELTAMESH_CHECK(meter.add(primitive.mesh, values, order));
    coded.streams.push_back(std::move(stream));
  }
  coded.error = meter.error();
  return coded;
}

}  // namespace deltamesh::bench
