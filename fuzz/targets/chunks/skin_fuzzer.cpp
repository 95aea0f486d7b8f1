// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Joints and weights from anywhere. The last three bytes are vertices (with a bit for copies), faces, and
// what it is. What is read must be whole; joints must come back when written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/payload.h"
#include "goal.h"
#include "meshes.h"
#include "support/attribute_coding.h"

namespace {

using namespace deltamesh;

fuzz::Goal joints_read("joints");
fuzz::Goal weights_read("weights");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kShape = 3;
  if (size < kShape) return 0;
  const std::uint8_t* const shape = data + size - kShape;
  const fuzz::SpreadFaces spread(shape[0], shape[1]);
  const AttributeSurface surface = spread.surface(shape[0] >= 128);
  const std::uint32_t vertices = spread.vertices;

  constexpr ComponentType kTypes[] = {ComponentType::kU8, ComponentType::kU16, ComponentType::kF32};
  const bool is_joints = shape[2] % 2 == 0;
  const AttributeDescriptor descriptor{.kind = is_joints ? AttributeKind::kJoints : AttributeKind::kWeights,
                                       .type = kTypes[shape[2] / 2 % (is_joints ? 2 : 3)],
                                       .components = 4};
  const std::vector<Attribute> others{fuzz::skin_joints(vertices)};

  const auto coding = is_joints ? AttributeCoding::kJoints : AttributeCoding::kWeights;
  std::vector<std::byte> bytes{static_cast<std::byte>(coding)};
  for (const std::uint8_t* byte = data; byte != shape; ++byte) bytes.push_back(static_cast<std::byte>(*byte));
  const auto read = read_attribute(Payload::compact(bytes), descriptor, surface, others, 1 << 16);
  if (!fuzz::check(read)) return 0;
  if (read->values.size() != attribute_bytes(descriptor, vertices)) std::abort();

  const auto order = test::identity(vertices);
  const AttributeView view{read->kind, read->type, 4, false, {}, read->values};
  const AttributeQuality quality{.weight_error = 1.0 / 1024};
  const auto written = write_attribute(view, order, {.quality = quality}, surface, others);
  if (!written || !written->is_compact) std::abort();
  if (is_joints && written->decoded.values != read->values) std::abort();
  if (written->descriptor.error > 1.0F / 1024) std::abort();
  const auto again =
      read_attribute(Payload::compact(written->payload), written->descriptor, surface, others, 1 << 16);
  if (!again || again->values != written->decoded.values) std::abort();
  (is_joints ? joints_read : weights_read).reach();
  return 0;
}
