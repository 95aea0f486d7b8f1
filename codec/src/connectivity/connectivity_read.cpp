// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/byte_reader.h"
#include "base/checked.h"
#include "base/try.h"
#include "connectivity/border.h"
#include "connectivity/connectivity.h"
#include "connectivity/gluing.h"
#include "connectivity/op_coder.h"
#include "connectivity/op_models.h"
#include "connectivity/op_tokens.h"
#include "connectivity/refusal.h"
#include "connectivity/split_reference.h"
#include "connectivity/traversal.h"
#include "entropy/compact_reader.h"
#include "entropy/planes.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

/// Takes every op from the compact coder.
class CompactGuide {
 public:
  CompactGuide(CompactReader& reader, const OpModels* start)
      : reader_(reader), ops_(reader, start != nullptr ? *start : OpModels()) {}

  const OpModels& models() const noexcept { return ops_.models(); }

  void start(const Border& border) { starts_.push_back(border.vertex_count()); }
  /// As PayloadGuide's.
  std::span<const std::uint32_t> starts() const noexcept { return starts_; }

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
  return Refusal{"more faces than the ops can hold", "CONN-2"}.error();
}

/// The compact form of CONN [CONN-12 to CONN-14]. `triangle_count`: above 0. `learning`: of ops. Errors: as
/// read_connectivity().
Result<Connectivity> read_compact_connectivity(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                               std::uint32_t triangle_count,
                                               const Learning<OpModels>& learning) {
  DELTAMESH_CHECK(check_face_count(triangle_count, bytes.size()));
  CompactReader reader(bytes);
  Border border(triangle_count);
  border.reserve(reserved_at_once(vertex_count, bytes.size()),
                 reserved_at_once(triangle_count, bytes.size()));
  CompactGuide guide(reader, learning.start);
  if (!traverse(border, guide)) {
    if (reader.failed()) DELTAMESH_CHECK(reader.finish(kTagConnectivity));
    return refusal_of(border).error();
  }
  DELTAMESH_TRY(const auto vertex,
                read_compact_gluing(reader, border.faces(), border.vertex_count(), vertex_count));
  DELTAMESH_CHECK(reader.finish(kTagConnectivity));
  if (learning.end != nullptr) *learning.end = guide.models();
  return take_glued(border, guide.starts(), vertex);
}

/// The payload's parts, counts checked against the bytes present.
struct Sections {
  std::array<std::span<const std::byte>, kTokenStreams> tokens;
  std::uint64_t token_count = 0;
  std::span<const std::byte> references;
  std::vector<std::uint32_t> far_targets;
  std::uint64_t glue_count = 0;
};

Result<Sections> read_sections(ByteReader& in) {
  Sections sections;
  std::array<std::uint64_t, kTokenStreams> sizes{};
  for (std::uint64_t& size : sizes) {
    DELTAMESH_TRY(size, in.read_varint());
  }
  DELTAMESH_TRY(const std::uint64_t reference_count, in.read_varint());
  DELTAMESH_TRY(const std::uint64_t far_count, in.read_varint(reference_count));
  DELTAMESH_TRY(sections.glue_count, in.read_varint());
  for (std::size_t i = 0; i < kTokenStreams; ++i) {
    DELTAMESH_TRY(sections.tokens[i], in.read_bytes(sizes[i]));
    sections.token_count += sizes[i];
  }
  DELTAMESH_TRY(sections.references, in.read_bytes(reference_count));
  DELTAMESH_TRY(sections.far_targets, read_planes(in, far_count));
  return sections;
}

/// Takes every op from the payload.
class PayloadGuide {
 public:
  explicit PayloadGuide(const Sections& sections) noexcept
      : tokens_(sections.tokens), references_(sections.references), far_targets_(sections.far_targets) {}

  void start(const Border& border) { starts_.push_back(border.vertex_count()); }
  /// First manifold vertex of every component.
  std::span<const std::uint32_t> starts() const noexcept { return starts_; }
  bool failed() const noexcept { return refusal_.has_value(); }

  BorderStep next(const Border& border, const Gate& gate) {
    BorderStep step{tokens_.get(gate)};
    if (step.op == BorderOp::kNone) return fail({"no such op", "CONN-9"});
    if (step.op == BorderOp::kSplit) {
      const std::optional<std::uint32_t> target = read_target(border, gate.item);
      if (!target) return fail({"split without a target", "CONN-10"});
      step.target = *target;
    }
    return step;
  }

  bool finished() const noexcept { return tokens_.finished() && references_.empty() && far_targets_.empty(); }
  /// Why there was no step; nothing where there was one.
  const std::optional<Refusal>& refusal() const noexcept { return refusal_; }

 private:
  std::optional<std::uint32_t> read_target(const Border& border, std::uint32_t gate) {
    if (references_.empty()) return std::nullopt;
    const auto reference = std::to_integer<std::uint32_t>(references_.front());
    references_ = references_.subspan(1);
    if (reference != kFarReference) return follow_reference(border, gate, reference);
    if (far_targets_.empty()) return std::nullopt;
    const std::uint32_t target = far_targets_.front();
    far_targets_ = far_targets_.subspan(1);
    return target;
  }

  BorderStep fail(const Refusal& refusal) noexcept {
    refusal_ = refusal;
    return {};
  }

  TokenReader tokens_;
  std::span<const std::byte> references_;
  std::span<const std::uint32_t> far_targets_;
  std::vector<std::uint32_t> starts_;
  std::optional<Refusal> refusal_;
};

/// The glued vertices. Errors: kTruncated, kInvalidStream [CONN-11].
Result<GlueList> read_gluing(ByteReader& in, std::uint64_t glue_count, std::uint32_t manifold_count,
                             std::uint32_t vertex_count) {
  DELTAMESH_CHECK(check_glue_count(glue_count, manifold_count, vertex_count));
  GlueList list;
  DELTAMESH_TRY(list.gaps, read_planes(in, glue_count));
  DELTAMESH_TRY(list.targets, read_planes(in, glue_count));
  return list;
}

}  // namespace

Result<Connectivity> read_connectivity(Payload payload, std::uint32_t vertex_count,
                                       std::uint32_t triangle_count, const Learning<OpModels>& learning) {
  ByteReader in(payload.bytes, kTagConnectivity);
  if (triangle_count == 0) {
    DELTAMESH_CHECK(in.finish());
    return Connectivity{};
  }
  if (payload.is_compact)
    return read_compact_connectivity(payload.bytes, vertex_count, triangle_count, learning);
  DELTAMESH_TRY(const Sections sections, read_sections(in));
  if (triangle_count > saturating_mul(sections.token_count, kFacesPerToken))
    return in.error(ErrorCode::kInvalidStream, "more faces than the ops can hold", "CONN-2");

  Border border(triangle_count);
  PayloadGuide guide(sections);
  if (!traverse(border, guide)) {
    const Refusal refusal = guide.refusal().value_or(refusal_of(border));
    return in.error(ErrorCode::kInvalidStream, refusal.message, refusal.rule);
  }
  if (!guide.finished()) return in.error(ErrorCode::kInvalidStream, "ops left over at the end", "CONN-2");

  DELTAMESH_TRY(const GlueList list,
                read_gluing(in, sections.glue_count, border.vertex_count(), vertex_count));
  DELTAMESH_CHECK(in.finish());
  DELTAMESH_TRY(const auto vertex, glue_vertices(list, border.vertex_count(), vertex_count));
  return take_glued(border, guide.starts(), vertex);
}

}  // namespace deltamesh
