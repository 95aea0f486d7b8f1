// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Draco reorders vertices and splits non-manifold ones, and does not tell how. So the mesh is coded a second
// time, untimed, with the input index as an extra attribute: connectivity and traversal are the same, hence
// corner k of face f is the same corner in both, and gives the input vertex of every plainly decoded one.
#include <cmath>
#include <numeric>
#include <utility>

#include "peers/draco_mesh.h"
#include "peers/lattice.h"
#include "peers/peer.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

class DracoPeer final : public Peer {
 public:
  DracoPeer(int compression_level, int position_bits)
      : Peer("Draco cl " + std::to_string(compression_level), "qp " + std::to_string(position_bits)),
        level_(compression_level),
        draco_{.position_bits = position_bits} {}

  Result<void> load(const Mesh& mesh) override {
    mesh_ = &mesh;
    plain_ = to_draco(mesh);
    return {};
  }

  Result<std::vector<std::byte>> encode() override { return encode_draco(*plain_, draco_, level_); }

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
  /// The mesh after a round trip with the input index as a second attribute.
  Result<std::unique_ptr<draco::Mesh>> decode_indexed() const {
    std::vector<std::uint32_t> index(mesh_->vertex_count());
    std::iota(index.begin(), index.end(), 0U);
    MeshView mesh(*mesh_);
    mesh.attributes.push_back({.type = ComponentType::kU32, .values = std::as_bytes(std::span(index))});
    const auto bytes = encode_draco(*to_draco(mesh), draco_, level_);
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
    const float tolerance =
        static_cast<float>(0.501 * make_lattice(*mesh_, draco_.position_bits).cell) + 1e-6F * reach();
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
  DracoSetting draco_;
  std::unique_ptr<draco::Mesh> plain_;
  std::unique_ptr<draco::Mesh> decoded_;
};

}  // namespace

std::unique_ptr<Peer> make_draco_peer(int compression_level, int position_bits) {
  return std::make_unique<DracoPeer>(compression_level, position_bits);
}

}  // namespace deltamesh::bench
