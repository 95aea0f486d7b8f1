// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Draco reorders vertices and splits non-manifold ones, and does not tell how. So the mesh is coded a second
// time, untimed, with the input index as an extra attribute: connectivity and traversal are the same, hence
// corner k of face f is the same corner in both, and gives the input vertex of every plainly decoded one.
#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/core/draco_version.h>
#include <draco/mesh/mesh.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "peers/lattice.h"
#include "peers/peer.h"
#include "support/failure.h"

namespace deltamesh::bench {
namespace {

/// Adds one value per point. `values`: num_points() equally long ones.
void add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, std::int8_t components,
                   draco::DataType data_type, std::span<const std::byte> values) {
  const std::size_t size = values.size() / mesh.num_points();
  draco::GeometryAttribute layout;
  layout.Init(type, nullptr, components, data_type, false, static_cast<std::int64_t>(size), 0);
  draco::PointAttribute& attribute = *mesh.attribute(mesh.AddAttribute(layout, true, mesh.num_points()));
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i)
    attribute.SetAttributeValue(draco::AttributeValueIndex(i), values.data() + i * size);
}

std::unique_ptr<draco::Mesh> to_draco(const Mesh& mesh) {
  auto result = std::make_unique<draco::Mesh>();
  result->set_num_points(static_cast<std::uint32_t>(mesh.vertex_count()));
  result->SetNumFaces(mesh.triangle_count());
  for (std::uint32_t f = 0; f < mesh.triangle_count(); ++f) {
    const std::uint32_t* corners = mesh.triangles.data() + std::size_t{3} * f;
    result->SetFace(draco::FaceIndex(f), {draco::PointIndex(corners[0]), draco::PointIndex(corners[1]),
                                          draco::PointIndex(corners[2])});
  }
  add_attribute(*result, draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32,
                std::as_bytes(std::span(mesh.positions)));
  return result;
}

Result<std::unique_ptr<draco::Mesh>> decode_draco(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) return failure("Draco cannot decode what it encoded");
  return std::move(mesh).value();
}

class DracoPeer final : public Peer {
 public:
  DracoPeer(int compression_level, int position_bits) : level_(compression_level), bits_(position_bits) {}

  std::string name() const override { return "Draco cl " + std::to_string(level_); }
  std::string setting() const override { return "qp " + std::to_string(bits_); }

  Result<void> load(const Mesh& mesh) override {
    mesh_ = &mesh;
    plain_ = to_draco(mesh);
    return {};
  }

  Result<std::vector<std::byte>> encode() override { return encode(*plain_); }

  Result<void> decode(std::span<const std::byte> bytes) override {
    auto mesh = decode_draco(bytes);
    if (!mesh) return mesh.error();
    decoded_ = *std::move(mesh);
    return {};
  }

  Result<DecodedMesh> decoded() override {
    auto indexed = decode_indexed();
    if (!indexed) return indexed.error();
    return map_back(**indexed);
  }

 private:
  Result<std::vector<std::byte>> encode(const draco::Mesh& mesh) const {
    draco::Encoder encoder;
    encoder.SetSpeedOptions(10 - level_, 10 - level_);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits_);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(mesh, &buffer).ok()) return failure("Draco cannot encode the mesh");
    const auto bytes = std::as_bytes(std::span(buffer.data(), buffer.size()));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  }

  /// The mesh after a round trip with the input index as a second attribute.
  Result<std::unique_ptr<draco::Mesh>> decode_indexed() const {
    const auto mesh = to_draco(*mesh_);
    std::vector<std::uint32_t> index(mesh_->vertex_count());
    std::iota(index.begin(), index.end(), 0U);
    add_attribute(*mesh, draco::GeometryAttribute::GENERIC, 1, draco::DT_UINT32,
                  std::as_bytes(std::span(index)));
    const auto bytes = encode(*mesh);
    if (!bytes) return bytes.error();
    return decode_draco(*bytes);
  }

  /// The input's triangles over the decoded positions. Errors: where a decoded corner is further from its
  /// original than the quantiser allows, or a vertex did not come back: then the two streams differ in order.
  Result<DecodedMesh> map_back(const draco::Mesh& indexed) const {
    if (indexed.num_faces() != decoded_->num_faces())
      return failure("Draco coded other faces beside an attribute");
    const auto& positions = *decoded_->GetNamedAttribute(draco::GeometryAttribute::POSITION);
    const auto& indices = *indexed.GetNamedAttribute(draco::GeometryAttribute::GENERIC);
    const float tolerance = static_cast<float>(0.501 * make_lattice(*mesh_, bits_).cell) + 1e-6F * reach();
    DecodedMesh result{.mesh = *mesh_, .order = {}};
    std::vector<bool> seen(mesh_->vertex_count());
    std::size_t missing = seen.size();
    for (draco::FaceIndex f(0); f < decoded_->num_faces(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t vertex = 0;
        indices.GetMappedValue(indexed.face(f)[k], &vertex);
        if (vertex >= seen.size()) return failure("Draco changed an integer attribute");
        std::array<float, 3> position{};
        positions.GetMappedValue(decoded_->face(f)[k], position.data());
        for (std::size_t axis = 0; axis < 3; ++axis) {
          float& coordinate = result.mesh.positions[std::size_t{3} * vertex + axis];
          const float original = mesh_->positions[std::size_t{3} * vertex + axis];
          if (!(std::fabs(position[axis] - original) <= tolerance))
            return failure("Draco's vertices could not be matched with the input's");
          coordinate = position[axis];
        }
        if (!seen[vertex]) --missing;
        seen[vertex] = true;
      }
    }
    if (missing != 0) return failure("Draco lost a vertex that a face uses");
    return result;
  }

  /// Largest coordinate: what float32 rounding is relative to.
  float reach() const {
    float largest = 0;
    for (const float x : mesh_->positions) largest = std::fmax(largest, std::fabs(x));
    return largest;
  }

  int level_;
  int bits_;
  const Mesh* mesh_ = nullptr;
  std::unique_ptr<draco::Mesh> plain_;
  std::unique_ptr<draco::Mesh> decoded_;
};

}  // namespace

std::unique_ptr<Peer> make_draco_peer(int compression_level, int position_bits) {
  return std::make_unique<DracoPeer>(compression_level, position_bits);
}

std::string draco_version() { return draco::kDracoVersion; }

}  // namespace deltamesh::bench
