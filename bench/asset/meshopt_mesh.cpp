// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/meshopt_mesh.h"

#include <draco/attributes/attribute_octahedron_transform.h>
#include <draco/attributes/attribute_quantization_transform.h>
#include <meshoptimizer.h>
#include <zstd.h>

#include <cstddef>
#include <cstring>
#include <vector>

#include "support/failure.h"

namespace deltamesh::bench {
namespace {

constexpr int kZstdLevel = 19;

/// Rows of bytes, one for each vertex; the codec asks for multiples of four.
struct Rows {
  std::size_t size = 0;
  std::vector<std::byte> bytes;
};

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// Integers as they are.
Rows plain_rows(const AttributeView& attribute, std::size_t count) {
  const std::size_t size = attribute.values.size() / count;
  Rows rows{.size = padded(size), .bytes = std::vector<std::byte>(padded(size) * count)};
  for (std::size_t v = 0; v < count; ++v)
    std::memcpy(rows.bytes.data() + v * rows.size, attribute.values.data() + v * size, size);
  return rows;
}

/// Symbols of one of Draco's quantisers, 16 bits each.
template <class Transform>
Rows lattice_rows(Transform& transform, const draco::PointAttribute& source, std::size_t count) {
  const auto portable = transform.InitTransformedAttribute(source, static_cast<int>(count));
  transform.TransformAttribute(source, {}, portable.get());
  const std::size_t components = portable->num_components();
  const std::size_t size = padded(components * sizeof(std::uint16_t));
  Rows rows{.size = size, .bytes = std::vector<std::byte>(size * count)};
  std::vector<std::uint32_t> symbols(components);
  for (std::uint32_t v = 0; v < count; ++v) {
    portable->GetValue(draco::AttributeValueIndex(v), symbols.data());
    for (std::size_t k = 0; k < components; ++k) {
      const auto symbol = static_cast<std::uint16_t>(symbols[k]);
      std::memcpy(rows.bytes.data() + v * size + k * sizeof symbol, &symbol, sizeof symbol);
    }
  }
  return rows;
}

Rows rows_of(const AttributeView& attribute, std::size_t count, const DracoSetting& setting) {
  if (attribute.type != ComponentType::kF32) return plain_rows(attribute, count);
  draco::PointAttribute source(layout(draco::GeometryAttribute::GENERIC, attribute));
  source.Reset(count);
  source.SetIdentityMapping();
  set_values(source, attribute, count);
  const Part part = part_of(attribute.kind, attribute.name);
  if (part == Part::kNormals) {
    draco::AttributeOctahedronTransform transform;
    transform.SetParameters(setting.normal_bits);
    return lattice_rows(transform, source, count);
  }
  const int bits = attribute.name == "POSITION" ? setting.position_bits
                   : part == Part::kUvs         ? setting.uv_bits
                   : part == Part::kColors      ? kColorBits
                                                : kGenericBits;
  draco::AttributeQuantizationTransform transform;
  transform.ComputeParameters(source, bits);
  return lattice_rows(transform, source, count);
}

/// Appends the vertex stream of `rows` in the order `place`.
void append_vertices(std::vector<unsigned char>& raw, const Rows& rows,
                     const std::vector<std::uint32_t>& place) {
  const std::size_t n = place.size();
  std::vector<std::byte> ordered(rows.bytes.size());
  meshopt_remapVertexBuffer(ordered.data(), rows.bytes.data(), n, rows.size, place.data());
  std::vector<unsigned char> stream(meshopt_encodeVertexBufferBound(n, rows.size));
  stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), ordered.data(), n, rows.size));
  raw.insert(raw.end(), stream.begin(), stream.end());
}

void append_primitive(std::vector<unsigned char>& raw, const Mesh& mesh, const DracoSetting& setting) {
  const std::size_t n = mesh.vertex_count();
  std::vector<std::uint32_t> indices(mesh.triangles.size());
  meshopt_optimizeVertexCacheStrip(indices.data(), mesh.triangles.data(), indices.size(), n);
  std::vector<std::uint32_t> place(n);
  meshopt_optimizeVertexFetchRemap(place.data(), indices.data(), indices.size(), n);
  for (std::uint32_t& index : indices) index = place[index];

  append_vertices(raw, rows_of(position_view(mesh), n, setting), place);
  for (const AttributeView& attribute : MeshView(mesh).attributes)
    append_vertices(raw, rows_of(attribute, n, setting), place);
  std::vector<unsigned char> faces(meshopt_encodeIndexBufferBound(indices.size(), n));
  faces.resize(meshopt_encodeIndexBuffer(faces.data(), faces.size(), indices.data(), indices.size()));
  raw.insert(raw.end(), faces.begin(), faces.end());
}

}  // namespace

Result<std::uint64_t> meshopt_bytes(const AssetMesh& mesh, const DracoSetting& setting) {
  std::vector<unsigned char> raw;
  for (const Primitive& primitive : mesh.primitives) append_primitive(raw, primitive.mesh, setting);
  std::vector<std::byte> bytes(ZSTD_compressBound(raw.size()));
  const std::size_t size = ZSTD_compress(bytes.data(), bytes.size(), raw.data(), raw.size(), kZstdLevel);
  if (ZSTD_isError(size) != 0U) return failure("zstd cannot compress");
  return std::uint64_t{size};
}

}  // namespace deltamesh::bench
