// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Layout: vertex count, triangle count (u32), lattice origin (3 x f32), cell (f64), n x 3 u16, m x 3 u32;
// all of it one zstd frame.
#include <zstd.h>

#include <cmath>
#include <cstring>

#include "peers/lattice.h"
#include "peers/peer.h"
#include "support/failure.h"

namespace deltamesh::bench {
namespace {

constexpr int kLevel = 19;

struct ZstdHeader {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::array<float, 3> origin{};
  float padding = 0;
  double cell = 0;
};

template <class T>
void append(std::vector<std::byte>& out, std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Fills `values` from the front of `bytes` and drops what it took; false where too few are left.
template <class T>
bool take(std::span<const std::byte>& bytes, std::span<T> values) {
  if (bytes.size() < values.size_bytes()) return false;
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size_bytes());
  bytes = bytes.subspan(values.size_bytes());
  return true;
}

class ZstdPeer final : public Peer {
 public:
  explicit ZstdPeer(int position_bits) : bits_(position_bits) {}

  std::string name() const override { return "zstd -" + std::to_string(kLevel); }
  std::string setting() const override { return "qp " + std::to_string(bits_); }

  Result<void> load(const Mesh& mesh) override {
    mesh_ = &mesh;
    return {};
  }

  Result<std::vector<std::byte>> encode() override {
    const Lattice lattice = make_lattice(*mesh_, bits_);
    const ZstdHeader header{.vertices = static_cast<std::uint32_t>(mesh_->vertex_count()),
                            .triangles = static_cast<std::uint32_t>(mesh_->triangle_count()),
                            .origin = lattice.origin,
                            .cell = lattice.cell};
    std::vector<std::uint16_t> cells(mesh_->positions.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double offset =
          static_cast<double>(mesh_->positions[i]) - static_cast<double>(lattice.origin[i % 3]);
      cells[i] = static_cast<std::uint16_t>(std::lround(offset / lattice.cell));
    }
    std::vector<std::byte> raw;
    append(raw, std::span(&header, 1));
    append(raw, std::span<const std::uint16_t>(cells));
    append(raw, std::span<const std::uint32_t>(mesh_->triangles));
    std::vector<std::byte> bytes(ZSTD_compressBound(raw.size()));
    const std::size_t size = ZSTD_compress(bytes.data(), bytes.size(), raw.data(), raw.size(), kLevel);
    if (ZSTD_isError(size) != 0U) return failure("zstd cannot compress");
    bytes.resize(size);
    return bytes;
  }

  Result<void> decode(std::span<const std::byte> bytes) override {
    std::vector<std::byte> raw(ZSTD_getFrameContentSize(bytes.data(), bytes.size()));
    if (ZSTD_isError(ZSTD_decompress(raw.data(), raw.size(), bytes.data(), bytes.size())) != 0U)
      return failure("zstd cannot decompress what it compressed");
    std::span<const std::byte> rest(raw);
    ZstdHeader header;
    if (!take(rest, std::span(&header, 1))) return failure("zstd lost the header");
    std::vector<std::uint16_t> cells(std::size_t{3} * header.vertices);
    decoded_.positions.resize(cells.size());
    decoded_.triangles.resize(std::size_t{3} * header.triangles);
    if (!take(rest, std::span(cells)) || !take(rest, std::span(decoded_.triangles)))
      return failure("zstd lost bytes");
    for (std::size_t i = 0; i < cells.size(); ++i)
      decoded_.positions[i] =
          static_cast<float>(static_cast<double>(header.origin[i % 3]) + header.cell * cells[i]);
    return {};
  }

  Result<DecodedMesh> decoded() override {
    decoded_.origin = mesh_->origin;
    return DecodedMesh{.mesh = decoded_, .order = {}};
  }

 private:
  int bits_;
  const Mesh* mesh_ = nullptr;
  Mesh decoded_;
};

}  // namespace

std::unique_ptr<Peer> make_zstd_peer(int position_bits) { return std::make_unique<ZstdPeer>(position_bits); }

std::string zstd_version() { return ZSTD_versionString(); }

}  // namespace deltamesh::bench
