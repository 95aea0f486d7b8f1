// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/coders/meshopt.h"

#include <cstddef>
#include <cstring>
#include <vector>

#include "asset/coders/draco_values.h"
#include "peers/meshopt_streams.h"
#include "peers/zstd_frame.h"

namespace deltamesh::bench {
namespace {

/// StreamRows of bytes, one for each vertex; the codec asks for multiples of four.
struct StreamRows {
  std::size_t size = 0;
  std::vector<std::byte> bytes;
};

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// Integers as they are.
StreamRows plain_rows(const AttributeView& attribute, std::size_t count) {
  const std::size_t size = attribute.values.size() / count;
  StreamRows rows{.size = padded(size), .bytes = std::vector<std::byte>(padded(size) * count)};
  for (std::size_t v = 0; v < count; ++v)
    std::memcpy(rows.bytes.data() + v * rows.size, attribute.values.data() + v * size, size);
  return rows;
}

/// Symbols of Draco's quantisers, 16 bits each.
StreamRows lattice_rows(const AttributeView& attribute, std::size_t count, const DracoSetting& setting) {
  StreamRows rows;
  with_quantizer(
      attribute, count, setting, [&](const auto& /*transform*/, const draco::PointAttribute& portable) {
        const std::size_t components = portable.num_components();
        rows.size = padded(components * sizeof(std::uint16_t));
        rows.bytes.resize(rows.size * count);
        std::vector<std::uint32_t> symbols(components);
        for (std::uint32_t v = 0; v < count; ++v) {
          portable.GetValue(draco::AttributeValueIndex(v), symbols.data());
          for (std::size_t k = 0; k < components; ++k) {
            const auto symbol = static_cast<std::uint16_t>(symbols[k]);
            std::memcpy(rows.bytes.data() + v * rows.size + k * sizeof symbol, &symbol, sizeof symbol);
          }
        }
      });
  return rows;
}

void append_primitive(std::vector<std::byte>& raw, const Mesh& mesh, const DracoSetting& setting) {
  const std::size_t n = mesh.vertex_count();
  const MeshoptOrder order = meshopt_order(mesh.triangles, n);
  MeshView view(mesh);
  view.attributes.insert(view.attributes.begin(), position_view(mesh));
  for (const AttributeView& attribute : view.attributes) {
    const StreamRows rows = attribute.type == ComponentType::kF32 ? lattice_rows(attribute, n, setting)
                                                                  : plain_rows(attribute, n);
    append_vertices(raw, rows.bytes, rows.size, order);
  }
  append_indices(raw, order);
}

}  // namespace

Result<std::uint64_t> meshopt_bytes(const AssetMesh& mesh, const DracoSetting& setting) {
  std::vector<std::byte> raw;
  for (const Primitive& primitive : mesh.primitives) append_primitive(raw, primitive.mesh, setting);
  const auto frame = zstd_frame(raw);
  if (!frame) return frame.error();
  return std::uint64_t{frame->size()};
}

}  // namespace deltamesh::bench
