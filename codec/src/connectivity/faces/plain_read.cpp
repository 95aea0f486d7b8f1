// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
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
#include "connectivity/faces/border.h"
#include "connectivity/faces/op_tokens.h"
#include "connectivity/faces/refusal.h"
#include "connectivity/faces/split_reference.h"
#include "connectivity/faces/traversal.h"
#include "connectivity/plain_forms.h"
#include "entropy/planes.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

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
  std::vector<std::uint32_t> take_starts() noexcept { return std::move(starts_); }
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

Result<ManifoldFaces> read_plain_faces(std::span<const std::byte> bytes, std::uint32_t vertex_count,
                                       std::uint32_t triangle_count) {
  ByteReader in(bytes, kTagConnectivity);
  DELTAMESH_TRY(const Sections sections, read_sections(in));
  if (triangle_count > saturating_mul(sections.token_count, kFacesPerToken))
    return in.invalid("more faces than the ops can hold", "CONN-2");

  Border border(triangle_count);
  PayloadGuide guide(sections);
  if (!traverse(border, guide)) {
    const Refusal refusal = guide.refusal().value_or(refusal_of(border));
    return in.invalid(refusal.message, refusal.rule);
  }
  if (!guide.finished()) return in.invalid("ops left over at the end", "CONN-2");

  DELTAMESH_TRY(const GlueList list,
                read_gluing(in, sections.glue_count, border.vertex_count(), vertex_count));
  DELTAMESH_CHECK(in.finish());
  DELTAMESH_TRY(auto vertex, glue_vertices(list, border.vertex_count(), vertex_count));
  return take_faces(border, guide.take_starts(), std::move(vertex));
}

}  // namespace deltamesh
