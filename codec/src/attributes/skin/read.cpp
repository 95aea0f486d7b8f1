// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/skin/rows.h"
#include "attributes/skin/skin.h"
#include "base/broken_rule.h"
#include "base/byte_reader.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// What went wrong where rows could not be read.
Result<void> fault(const CompactReader& reader, const char* message, const char* rule) {
  if (reader.failed()) DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return broken_rule(message, rule, kTagAttribute);
}

}  // namespace

Result<std::vector<std::byte>> read_joints(std::span<const std::byte> bytes, const Attribute& shape,
                                           const AttributeSurface& surface) {
  CompactReader reader(bytes);
  const FieldFaces over(surface, reader.bits(0, 1) != 0);
  std::vector<JointRow> joints(surface.vertex_count(), JointRow{});
  if (!code_joints(reader, over, top_of(shape.type), joints))
    DELTAMESH_CHECK(fault(reader, "a joint beyond its type", "ATTR-60"));
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return joint_values(joints, shape.type);
}

Result<std::vector<std::byte>> read_weights(std::span<const std::byte> bytes, const Attribute& shape,
                                            const AttributeSurface& surface,
                                            std::span<const JointRow> joints) {
  ByteReader in(bytes, kTagAttribute);
  DELTAMESH_TRY(const auto coded_sum, in.read_varint(kMostWeightSum));
  const auto sum = static_cast<std::uint32_t>(coded_sum);
  if (sum == 0 || (shape.type != ComponentType::kF32 && top_of(shape.type) % sum != 0))
    return in.invalid("weights that cannot add up to one", "ATTR-63");
  DELTAMESH_TRY(const auto coded, in.read_bytes(in.remaining()));
  CompactReader reader(coded);
  const FieldFaces over(surface, reader.bits(0, 1) != 0);
  const std::uint32_t blend = reader.bits(0, 2);
  std::vector<WeightRow> weights(surface.vertex_count(), WeightRow{});
  if (const char* const broken = code_weights(reader, over, joints, sum, blend, weights))
    DELTAMESH_CHECK(fault(reader, "a weight beyond what the others leave", broken));
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return weight_values(weights, sum, shape.type);
}

}  // namespace deltamesh
