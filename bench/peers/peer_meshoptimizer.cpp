// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// meshoptimizer's vertex and index codecs on the lattice that the other quantisers get, both streams in one
// zstd frame. Layout: vertex count, triangle count, bytes of the vertex stream (u32), lattice origin (3 x
// f32), cell (f64), vertex stream, index stream.
#include <meshoptimizer.h>
#include <zstd.h>

#include <array>
#include <cmath>
#include <cstring>

#include "peers/lattice.h"
#include "peers/peer.h"
#include "support/failure.h"

namespace deltamesh::bench {
namespace {

constexpr int kZstdLevel = 19;

using Cell = std::array<std::uint16_t, 4>;  ///< the codec asks for a multiple of four bytes

struct MeshoptimizerHeader {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t vertex_bytes = 0;
  std::array<float, 3> origin{};
  double cell = 0;
};

class MeshoptimizerPeer final : public Peer {
 public:
  explicit MeshoptimizerPeer(int position_bits) : bits_(position_bits) {}

  std::string name() const override { return "meshoptimizer, zstd -" + std::to_string(kZstdLevel); }
  std::string setting() const override { return "qp " + std::to_string(bits_); }

  Result<void> load(const Mesh& mesh) override {
    mesh_ = &mesh;
    return {};
  }

  Result<std::vector<std::byte>> encode() override {
    const std::size_t n = mesh_->vertex_count();
    std::vector<std::uint32_t> indices(mesh_->triangles.size());
    meshopt_optimizeVertexCacheStrip(indices.data(), mesh_->triangles.data(), indices.size(), n);
    std::vector<std::uint32_t> place(n);
    meshopt_optimizeVertexFetchRemap(place.data(), indices.data(), indices.size(), n);
    for (std::uint32_t& index : indices) index = place[index];
    order_.resize(n);
    for (std::uint32_t v = 0; v < n; ++v) order_[place[v]] = v;

    const Lattice lattice = make_lattice(*mesh_, bits_);
    const std::vector<Cell> cells = cells_of(lattice);
    std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(n, sizeof(Cell)));
    vertices.resize(
        meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), cells.data(), n, sizeof(Cell)));
    std::vector<unsigned char> faces(meshopt_encodeIndexBufferBound(indices.size(), n));
    faces.resize(meshopt_encodeIndexBuffer(faces.data(), faces.size(), indices.data(), indices.size()));

    const MeshoptimizerHeader header{.vertices = static_cast<std::uint32_t>(n),
                                     .triangles = static_cast<std::uint32_t>(mesh_->triangle_count()),
                                     .vertex_bytes = static_cast<std::uint32_t>(vertices.size()),
                                     .origin = lattice.origin,
                                     .cell = lattice.cell};
    std::vector<unsigned char> raw(sizeof header);
    std::memcpy(raw.data(), &header, sizeof header);
    raw.insert(raw.end(), vertices.begin(), vertices.end());
    raw.insert(raw.end(), faces.begin(), faces.end());
    std::vector<std::byte> bytes(ZSTD_compressBound(raw.size()));
    const std::size_t size = ZSTD_compress(bytes.data(), bytes.size(), raw.data(), raw.size(), kZstdLevel);
    if (ZSTD_isError(size) != 0U) return failure("zstd cannot compress");
    bytes.resize(size);
    return bytes;
  }

  Result<void> decode(std::span<const std::byte> bytes) override {
    std::vector<unsigned char> raw(ZSTD_getFrameContentSize(bytes.data(), bytes.size()));
    if (ZSTD_isError(ZSTD_decompress(raw.data(), raw.size(), bytes.data(), bytes.size())) != 0U ||
        raw.size() < sizeof(MeshoptimizerHeader))
      return failure("zstd cannot decompress what it compressed");
    MeshoptimizerHeader header;
    std::memcpy(&header, raw.data(), sizeof header);
    std::vector<Cell> cells(header.vertices);
    decoded_.triangles.resize(std::size_t{3} * header.triangles);
    const unsigned char* streams = raw.data() + sizeof header;
    const std::size_t face_bytes = raw.size() - sizeof header - header.vertex_bytes;
    if (meshopt_decodeVertexBuffer(cells.data(), cells.size(), sizeof(Cell), streams, header.vertex_bytes) !=
            0 ||
        meshopt_decodeIndexBuffer(decoded_.triangles.data(), decoded_.triangles.size(), sizeof(std::uint32_t),
                                  streams + header.vertex_bytes, face_bytes) != 0)
      return failure("meshoptimizer cannot decode what it encoded");
    decoded_.positions.resize(3 * cells.size());
    for (std::size_t i = 0; i < decoded_.positions.size(); ++i)
      decoded_.positions[i] =
          static_cast<float>(static_cast<double>(header.origin[i % 3]) + header.cell * cells[i / 3][i % 3]);
    return {};
  }

  Result<DecodedMesh> decoded() override {
    decoded_.origin = mesh_->origin;
    return DecodedMesh{.mesh = decoded_, .order = order_};
  }

 private:
  std::vector<Cell> cells_of(const Lattice& lattice) const {
    std::vector<Cell> cells(order_.size());
    for (std::size_t v = 0; v < cells.size(); ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double offset = static_cast<double>(mesh_->positions[std::size_t{3} * order_[v] + axis]) -
                              static_cast<double>(lattice.origin[axis]);
        cells[v][axis] = static_cast<std::uint16_t>(std::lround(offset / lattice.cell));
      }
    }
    return cells;
  }

  int bits_;
  const Mesh* mesh_ = nullptr;
  std::vector<std::uint32_t> order_;  ///< input vertex of every coded one
  Mesh decoded_;
};

}  // namespace

std::unique_ptr<Peer> make_meshoptimizer_peer(int position_bits) {
  return std::make_unique<MeshoptimizerPeer>(position_bits);
}

}  // namespace deltamesh::bench
