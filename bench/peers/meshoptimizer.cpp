// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// meshoptimizer's vertex and index codecs on the lattice that the other quantisers get, both streams in one
// zstd frame. Layout: FrameHeader, vertex stream, index stream.
#include <meshoptimizer.h>

#include <array>

#include "peers/meshopt_streams.h"
#include "peers/peer.h"
#include "peers/zstd_frame.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

using Cell = std::array<std::uint16_t, 4>;  ///< the codec asks for a multiple of four bytes

class MeshoptimizerPeer final : public Peer {
 public:
  explicit MeshoptimizerPeer(int position_bits)
      : Peer("meshoptimizer, zstd -" + std::to_string(kZstdLevel), "qp " + std::to_string(position_bits)),
        bits_(position_bits) {}

  Result<std::vector<std::byte>> encode() override {
    order_ = meshopt_order(mesh_->triangles, mesh_->vertex_count());
    const Lattice lattice = make_lattice(*mesh_, bits_);
    FrameHeader header(*mesh_, lattice);
    std::vector<Cell> cells(header.vertices);
    for (std::size_t i = 0; i < mesh_->positions.size(); ++i)
      cells[i / 3][i % 3] = lattice.symbol(mesh_->positions[i], i % 3);
    std::vector<std::byte> streams;
    header.vertex_bytes = static_cast<std::uint32_t>(
        append_vertices(streams, std::as_bytes(std::span(cells)), sizeof(Cell), order_));
    append_indices(streams, order_);
    std::vector<std::byte> raw;
    append(raw, std::span<const FrameHeader>(&header, 1));
    append(raw, std::span<const std::byte>(streams));
    return zstd_frame(raw);
  }

  Result<void> decode(std::span<const std::byte> bytes) override {
    const auto raw = open_zstd_frame(bytes);
    if (!raw) return raw.error();
    std::span<const std::byte> rest(*raw);
    FrameHeader header;
    if (!take(rest, std::span(&header, 1))) return failure("zstd lost the header");
    std::vector<Cell> cells(header.vertices);
    decoded_.triangles.resize(std::size_t{3} * header.triangles);
    const auto* streams = reinterpret_cast<const unsigned char*>(rest.data());
    if (meshopt_decodeVertexBuffer(cells.data(), cells.size(), sizeof(Cell), streams, header.vertex_bytes) !=
            0 ||
        meshopt_decodeIndexBuffer(decoded_.triangles.data(), decoded_.triangles.size(), sizeof(std::uint32_t),
                                  streams + header.vertex_bytes, rest.size() - header.vertex_bytes) != 0)
      return failure("meshoptimizer cannot decode what it encoded");
    decoded_.positions.resize(3 * cells.size());
    for (std::size_t i = 0; i < decoded_.positions.size(); ++i)
      decoded_.positions[i] = header.lattice().value(cells[i / 3][i % 3], i % 3);
    return {};
  }

  Result<DecodedMesh> decoded() override {
    decoded_.origin = mesh_->origin;
    DecodedMesh result{.mesh = decoded_, .order = std::vector<std::uint32_t>(order_.place.size())};
    for (std::uint32_t v = 0; v < order_.place.size(); ++v) result.order[order_.place[v]] = v;
    return result;
  }

 private:
  int bits_;
  MeshoptOrder order_;
  Mesh decoded_;
};

}  // namespace

std::unique_ptr<Peer> make_meshoptimizer_peer(int position_bits) {
  return std::make_unique<MeshoptimizerPeer>(position_bits);
}

}  // namespace deltamesh::bench
