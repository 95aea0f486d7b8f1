// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One codec at one setting, as the benchmark sees it: every peer of the comparison is an adapter of this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

/// What came out of a peer, in the form deltamesh::compare() takes.
struct DecodedMesh {
  Mesh mesh;
  std::vector<std::uint32_t> order;  ///< input vertex of every vertex of `mesh`; empty: same index
};

/// Bytes of a stream by what they are spent on.
struct ByteShares {
  std::uint64_t connectivity = 0;
  std::uint64_t geometry = 0;
  std::uint64_t anchors = 0;
  std::uint64_t attributes = 0;
  std::uint64_t container = 0;
};

/// Calls come in the order of declaration, each at least once; encode() and decode() may come several times
/// and are what is timed, so they do nothing that a user of the peer would not have to do.
class Peer {
 public:
  /// Peers of one `name` form one curve: "Draco cl 10"; `setting`: the place on the curve: "qp 11".
  Peer(std::string name, std::string setting) : name_(std::move(name)), setting_(std::move(setting)) {}
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  const std::string& name() const noexcept { return name_; }
  const std::string& setting() const noexcept { return setting_; }

  /// Takes `mesh` over in the peer's own form. It has no attributes, no two vertices at one place, no
  /// degenerate face and no unused vertex, and outlives the peer. Errors: kInternal, kOutOfMemory.
  virtual Result<void> load(const Mesh& mesh) {
    mesh_ = &mesh;
    return {};
  }
  /// Errors: kInternal where the peer refuses the mesh.
  virtual Result<std::vector<std::byte>> encode() = 0;
  /// Decodes into the peer's own form. Errors: kInternal.
  virtual Result<void> decode(std::span<const std::byte> bytes) = 0;
  /// What the last decode() gave. Errors: kInternal where it does not belong to the loaded mesh.
  virtual Result<DecodedMesh> decoded() = 0;

  /// Where the bytes of an encoded mesh go; nothing where the peer does not say.
  virtual std::optional<ByteShares> shares(std::span<const std::byte>) const { return std::nullopt; }

 protected:
  const Mesh* mesh_ = nullptr;

 private:
  std::string name_;
  std::string setting_;
};

/// Draco, positions quantised to `position_bits` over the longest side; speed = 10 - `compression_level`.
std::unique_ptr<Peer> make_draco_peer(int compression_level, int position_bits);

/// Ours: `bits` of the delta quantiser, anchors as a share of the vertices.
std::unique_ptr<Peer> make_deltamesh_peer(int bits, double anchor_share);

/// Ours, asked for a quality. `label`: the place on the curve.
std::unique_ptr<Peer> make_deltamesh_peer(const QualityRequest& quality, std::string label);

/// meshoptimizer's vertex and index codecs on the lattice of `position_bits`, then zstd level 19.
std::unique_ptr<Peer> make_meshoptimizer_peer(int position_bits);

/// OpenCTM, method MG2 at its best level, precision one cell of the lattice of `position_bits`.
std::unique_ptr<Peer> make_openctm_peer(int position_bits);

std::string draco_version();
std::string zstd_version();

}  // namespace deltamesh::bench
