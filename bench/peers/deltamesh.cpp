// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Ours, through the public interface only.
#include <algorithm>
#include <cmath>
#include <utility>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/peer.h"
#include "report/text.h"

namespace deltamesh::bench {
namespace {

class DeltameshPeer final : public Peer {
 public:
  DeltameshPeer(int bits, double anchor_share)
      : Peer("deltamesh", join({"p ", number(bits), ", ", significant(100 * anchor_share, 3), " %"})),
        anchor_share_(anchor_share) {
    options_.bits = bits;
  }
  DeltameshPeer(const QualityRequest& quality, std::string label) : Peer("deltamesh", std::move(label)) {
    options_.quality = quality;
  }

  Result<void> load(const Mesh& mesh) override {
    mesh_ = &mesh;
    if (!anchor_share_) return {};
    const double anchors = std::round(*anchor_share_ * static_cast<double>(mesh.vertex_count()));
    options_.anchors = static_cast<std::uint32_t>(std::max(1.0, anchors));
    return {};
  }

  Result<std::vector<std::byte>> encode() override {
    auto encoded = deltamesh::encode(*mesh_, options_);
    if (!encoded) return encoded.error();
    order_ = std::move(encoded->order);
    return std::move(encoded->bytes);
  }

  Result<void> decode(std::span<const std::byte> bytes) override {
    auto mesh = deltamesh::decode(bytes);
    if (!mesh) return mesh.error();
    decoded_ = *std::move(mesh);
    return {};
  }

  Result<DecodedMesh> decoded() override { return DecodedMesh{.mesh = decoded_, .order = order_}; }

  std::optional<ByteShares> shares(std::span<const std::byte> bytes) const override {
    const auto info = inspect(bytes);
    if (!info) return std::nullopt;
    return ByteShares{.connectivity = info->connectivity_bytes,
                      .geometry = info->geometry_bytes,
                      .anchors = info->anchor_bytes,
                      .attributes = info->attribute_bytes,
                      .container = info->container_bytes};
  }

 private:
  std::optional<double> anchor_share_{};
  EncodeOptions options_;
  std::vector<std::uint32_t> order_;
  Mesh decoded_;
};

}  // namespace

std::unique_ptr<Peer> make_deltamesh_peer(int bits, double anchor_share) {
  return std::make_unique<DeltameshPeer>(bits, anchor_share);
}

std::unique_ptr<Peer> make_deltamesh_peer(const QualityRequest& quality, std::string label) {
  return std::make_unique<DeltameshPeer>(quality, std::move(label));
}

}  // namespace deltamesh::bench
