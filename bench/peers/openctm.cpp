// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OpenCTM sorts vertices and does not tell how. So the mesh is coded a second time, untimed, with the input
// index as an attribute: the order depends on positions alone, hence vertex k is the same in both.
#include <openctm.h>

#include <cmath>
#include <memory>

#include "peers/lattice.h"
#include "peers/peer.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr CTMuint kBestLevel = 9;

struct FreeContext {
  void operator()(void* context) const { ctmFreeContext(context); }
};
using Context = std::unique_ptr<void, FreeContext>;

CTMuint CTMCALL save_bytes(const void* bytes, CTMuint count, void* out) {
  const auto* first = static_cast<const std::byte*>(bytes);
  auto& all = *static_cast<std::vector<std::byte>*>(out);
  all.insert(all.end(), first, first + count);
  return count;
}

CTMuint CTMCALL load_bytes(void* bytes, CTMuint count, void* in) {
  auto& rest = *static_cast<std::span<const std::byte>*>(in);
  count = static_cast<CTMuint>(std::min<std::size_t>(count, rest.size()));
  std::copy_n(rest.begin(), count, static_cast<std::byte*>(bytes));
  rest = rest.subspan(count);
  return count;
}

Result<Context> load_stream(std::span<const std::byte> bytes) {
  Context context(ctmNewContext(CTM_IMPORT));
  ctmLoadCustom(context.get(), load_bytes, &bytes);
  if (ctmGetError(context.get()) != CTM_NONE) return failure("OpenCTM cannot decode what it encoded");
  return context;
}

class OpenctmPeer final : public Peer {
 public:
  explicit OpenctmPeer(int position_bits)
      : Peer("OpenCTM MG2", "qp " + std::to_string(position_bits)), bits_(position_bits) {}

  Result<std::vector<std::byte>> encode() override { return encode({}); }

  Result<void> decode(std::span<const std::byte> bytes) override {
    auto context = load_stream(bytes);
    if (!context) return context.error();
    decoded_ = *std::move(context);
    return {};
  }

  Result<DecodedMesh> decoded() override {
    const std::size_t n = mesh_->vertex_count();
    if (ctmGetInteger(decoded_.get(), CTM_VERTEX_COUNT) != n ||
        ctmGetInteger(decoded_.get(), CTM_TRIANGLE_COUNT) != mesh_->triangle_count())
      return failure("OpenCTM changed the counts");
    auto order = vertex_order();
    if (!order) return order.error();
    const CTMfloat* positions = ctmGetFloatArray(decoded_.get(), CTM_VERTICES);
    const CTMuint* triangles = ctmGetIntegerArray(decoded_.get(), CTM_INDICES);
    DecodedMesh result{.mesh = {}, .order = *std::move(order)};
    result.mesh.origin = mesh_->origin;
    result.mesh.positions.assign(positions, positions + 3 * n);
    result.mesh.triangles.assign(triangles, triangles + mesh_->triangles.size());
    return result;
  }

 private:
  /// `index`: empty, or a number per vertex that becomes an attribute of four components.
  Result<std::vector<std::byte>> encode(const std::vector<float>& index) const {
    const Context context(ctmNewContext(CTM_EXPORT));
    ctmCompressionMethod(context.get(), CTM_METHOD_MG2);
    ctmCompressionLevel(context.get(), kBestLevel);
    ctmDefineMesh(context.get(), mesh_->positions.data(), static_cast<CTMuint>(mesh_->vertex_count()),
                  mesh_->triangles.data(), static_cast<CTMuint>(mesh_->triangle_count()), nullptr);
    ctmVertexPrecision(context.get(), static_cast<CTMfloat>(make_lattice(*mesh_, bits_).cell));
    if (!index.empty()) {
      const CTMenum map = ctmAddAttribMap(context.get(), index.data(), "index");
      ctmAttribPrecision(context.get(), map, 1.0F);
    }
    std::vector<std::byte> bytes;
    ctmSaveCustom(context.get(), save_bytes, &bytes);
    if (ctmGetError(context.get()) != CTM_NONE) return failure("OpenCTM cannot encode the mesh");
    return bytes;
  }

  /// Input vertex of every decoded one.
  Result<std::vector<std::uint32_t>> vertex_order() const {
    const std::size_t n = mesh_->vertex_count();
    std::vector<float> index(4 * n);
    for (std::size_t v = 0; v < n; ++v) {
      index[4 * v] = static_cast<float>(v % kDigit);
      index[4 * v + 1] = static_cast<float>(v / kDigit);
    }
    const auto bytes = encode(index);
    if (!bytes) return bytes.error();
    const auto context = load_stream(*bytes);
    if (!context) return context.error();
    const CTMfloat* coded = ctmGetFloatArray(context->get(), CTM_ATTRIB_MAP_1);
    if (coded == nullptr) return failure("OpenCTM lost an attribute");
    std::vector<std::uint32_t> order(n);
    for (std::size_t v = 0; v < n; ++v)
      order[v] = static_cast<std::uint32_t>(std::lround(coded[4 * v])) +
                 kDigit * static_cast<std::uint32_t>(std::lround(coded[4 * v + 1]));
    return order;
  }

  static constexpr std::uint32_t kDigit = 1U << 12;

  int bits_;
  Context decoded_;
};

}  // namespace

std::unique_ptr<Peer> make_openctm_peer(int position_bits) {
  return std::make_unique<OpenctmPeer>(position_bits);
}

}  // namespace deltamesh::bench
