// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/broken_rule.h"
#include "base/byte_reader.h"
#include "base/checked.h"
#include "base/try.h"
#include "connectivity/faces/border.h"
#include "connectivity/faces/faces.h"
#include "connectivity/faces/gluing.h"
#include "connectivity/faces/op_coder.h"
#include "connectivity/faces/op_models.h"
#include "connectivity/faces/traversal.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Takes every op from the compact coder.
class CompactGuide {
 public:
  CompactGuide(CompactReader& reader, const OpModels* start)
      : reader_(reader), ops_(reader, start != nullptr ? *start : OpModels()) {}

  const OpModels& models() const noexcept { return ops_.models(); }

  void start(const Border& border) { starts_.push_back(border.vertex_count()); }
  std::vector<std::uint32_t> take_starts() noexcept { return std::move(starts_); }

  [[gnu::always_inline]] BorderStep next(const Border& border, const Gate& gate) {
    return ops_.code({}, border, gate);
  }
  [[gnu::always_inline]] auto run(const Gate& gate) { return ops_.run(gate); }
  void begin(const OpCoder<CompactReader>::Run& run) { ops_.begin(run); }
  bool failed() const noexcept { return reader_.failed(); }

 private:
  CompactReader& reader_;
  std::vector<std::uint32_t> starts_;
  OpCoder<CompactReader> ops_;
};

/// Faces and vertices that room is made for at once: untouched memory, so a little for nothing. Where the
/// bytes hold more the room grows.
std::size_t reserved_at_once(std::uint32_t declared, std::size_t bytes) noexcept {
  constexpr std::size_t kPerByte = 32;
  constexpr std::size_t kAnyway = std::size_t{1} << 22;
  return std::min<std::size_t>(declared, std::max(kAnyway, bytes * kPerByte));
}

Result<void> check_face_count(std::uint32_t faces, std::size_t bytes) {
  if (faces <= saturating_mul(bytes, kFacesPerCompactByte)) return {};
  return broken_rule("more faces than the ops can hold", "CONN-2", kTagConnectivity);
}

}  // namespace

Result<Connectivity> read_connectivity(std::span<const std::byte> payload, std::uint32_t vertex_count,
                                       std::uint32_t triangle_count, const Learning<OpModels>& learning) {
  if (triangle_count == 0) {
    DELTAMESH_CHECK(ByteReader(payload, kTagConnectivity).finish());
    return Connectivity{};
  }
  DELTAMESH_CHECK(check_face_count(triangle_count, payload.size()));
  CompactReader reader(payload);
  Border border(triangle_count);
  border.reserve(reserved_at_once(vertex_count, payload.size()),
                 reserved_at_once(triangle_count, payload.size()));
  CompactGuide guide(reader, learning.start);
  if (!traverse(border, guide)) {
    if (reader.failed()) DELTAMESH_CHECK(reader.finish(kTagConnectivity));
    if (border.is_full()) return broken_rule("more faces than declared", "CONN-2", kTagConnectivity);
    return broken_rule("op does not fit the border", "CONN-7", kTagConnectivity);
  }
  DELTAMESH_TRY(const auto vertex, read_gluing(reader, border.faces(), border.vertex_count(), vertex_count));
  DELTAMESH_CHECK(reader.finish(kTagConnectivity));
  if (learning.end != nullptr) *learning.end = guide.models();
  return glued(border, guide.take_starts(), vertex);
}

}  // namespace deltamesh
