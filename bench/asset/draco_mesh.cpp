// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/draco_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "asset/draco_values.h"
#include "base/try.h"

namespace deltamesh::bench {

Result<CodedMesh> code_with_draco(const AssetMesh& mesh, const DracoSetting& setting) {
  CodedMesh coded;
  coded.bytes[index_of(Part::kMorph)] = mesh.morph_bytes;
  coded.is_verified = true;
  MeshErrorMeter meter;
  for (const Primitive& primitive : mesh.primitives) {
    DELTAMESH_TRY(auto stream, encode_draco(*to_draco(primitive), setting, kDracoLevel));
    std::uint64_t rest = stream.size();
    for (std::size_t a = 0; a < primitive.mesh.attributes.size(); ++a) {
      DELTAMESH_TRY(const auto without, encode_draco(*to_draco(primitive, a), setting, kDracoLevel));
      const std::uint64_t bytes = stream.size() - std::min(stream.size(), without.size());
      const Attribute& attribute = primitive.mesh.attributes[a];
      coded.bytes[index_of(part_of(attribute.kind, attribute.name))] += bytes;
      rest -= std::min(rest, bytes);
    }
    coded.bytes[index_of(Part::kGeometry)] += rest;
    const Mesh values = draco_values(primitive, setting);
    coded.is_verified &= decodes_to(stream, values);
    std::vector<std::uint32_t> order(values.vertex_count());
    std::iota(order.begin(), order.end(), 0U);
    meter.add(primitive.mesh, values, order);
    coded.streams.push_back(std::move(stream));
  }
  coded.error = meter.error();
  return coded;
}

}  // namespace deltamesh::bench
