// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/normals/normals.h"
#include "attributes/normals/traversal.h"
#include "base/byte_reader.h"
#include "base/small_code.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Readers need no source.
struct NoSource {
  static constexpr bool same(std::uint32_t, std::uint32_t) noexcept { return false; }
  static constexpr bool is_zero(std::uint32_t) noexcept { return false; }
};

Result<NormalParameters> read_parameters(ByteReader& in, const AttributeSurface& surface) {
  NormalParameters parameters;
  DELTAMESH_TRY(const auto form, in.read<std::uint8_t>());
  DELTAMESH_TRY(parameters.radius, in.read<float>());
  const int rule = form & kRuleMask;
  if (rule > static_cast<int>(NormalRule::kEdges)) return in.invalid("unknown rule of normals", "ATTR-20");
  parameters.rule = static_cast<NormalRule>(rule);
  if (parameters.rule != NormalRule::kNone && !surface.has_positions())
    return in.invalid("normals by a rule without positions", "ATTR-20");
  if ((form & ~(kRuleMask | kSharesFlag | kZerosFlag | kBlendsFlag)) != 0)
    return in.invalid("reserved attribute flag set", "ATTR-20");
  parameters.shares = (form & kSharesFlag) != 0;
  parameters.has_zeros = (form & kZerosFlag) != 0;
  parameters.blends = (form & kBlendsFlag) != 0;
  if (!(parameters.radius >= kLeastRadius && parameters.radius <= 1))
    return in.invalid("a parameter of the attribute is out of range", "ATTR-20");
  return parameters;
}

}  // namespace

DELTAMESH_APART Result<std::vector<float>> read_surface_normals(std::span<const std::byte> bytes,
                                                                const AttributeSurface& surface) {
  ByteReader in(bytes, kTagAttribute);
  DELTAMESH_TRY(const NormalParameters parameters, read_parameters(in, surface));
  DELTAMESH_TRY(const auto rest, in.read_bytes(in.remaining()));
  CompactReader reader(rest);
  NoSource source;
  NormalTraversal traversal(reader, source, surface, parameters);
  const bool is_valid = traversal.run();
  if (!is_valid && !reader.failed()) return in.invalid("a normal off the sphere", "ATTR-24");
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return traversal.values();
}

}  // namespace deltamesh
