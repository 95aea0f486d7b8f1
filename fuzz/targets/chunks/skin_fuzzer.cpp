// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Joints and weights from anywhere. The last three bytes are vertices (with a bit for copies), faces, and
// what it is. What is read must be whole; joints must come back when written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/payload.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace deltamesh;
  constexpr std::size_t kShape = 3;
  if (size < kShape) return 0;
  const std::uint8_t* const shape = data + size - kShape;
  const std::uint32_t vertices = shape[0] % 128U;
  const std::uint32_t faces = vertices == 0 ? 0 : shape[1];
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t corner = 0; corner < 3 * faces; ++corner)
    triangles.push_back((corner / 3 + corner % 3 * (1 + faces % 7)) % vertices);
  std::vector<std::uint32_t> geometric;
  for (std::uint32_t v = 0; v < vertices && shape[0] >= 128; ++v) geometric.push_back(v / 2);
  const AttributeSurface surface(triangles, vertices, geometric);

  constexpr ComponentType kTypes[] = {ComponentType::kU8, ComponentType::kU16, ComponentType::kF32};
  const bool is_joints = shape[2] % 2 == 0;
  const AttributeDescriptor descriptor{.kind = is_joints ? AttributeKind::kJoints : AttributeKind::kWeights,
                                       .type = kTypes[shape[2] / 2 % (is_joints ? 2 : 3)],
                                       .components = 4};
  Attribute joints{.kind = AttributeKind::kJoints, .type = ComponentType::kU8, .components = 4};
  for (std::uint32_t i = 0; i < 4 * vertices; ++i)
    joints.values.push_back(static_cast<std::byte>(i / 24 % 5 + i % 4));
  const std::vector<Attribute> others{joints};

  const auto coding = is_joints ? AttributeCoding::kJoints : AttributeCoding::kWeights;
  std::vector<std::byte> bytes{static_cast<std::byte>(coding)};
  for (const std::uint8_t* byte = data; byte != shape; ++byte) bytes.push_back(static_cast<std::byte>(*byte));
  const auto read = read_attribute(Payload::compact(bytes), descriptor, surface, others, 1 << 16);
  if (!read) {
    if (read.error().code == ErrorCode::kInternal) std::abort();
    return 0;
  }
  if (read->values.size() != attribute_bytes(descriptor, vertices)) std::abort();

  std::vector<std::uint32_t> order(vertices);
  std::iota(order.begin(), order.end(), 0U);
  const AttributeView view{read->kind, read->type, 4, false, {}, read->values};
  const AttributeQuality quality{.weight_error = 1.0 / 1024};
  const auto written = write_attribute(view, order, {.quality = quality}, surface, others);
  if (!written || written->compact.empty()) std::abort();
  if (is_joints && written->decoded.values != read->values) std::abort();
  if (written->descriptor.error > 1.0F / 1024) std::abort();
  const auto again =
      read_attribute(Payload::compact(written->compact), written->descriptor, surface, others, 1 << 16);
  if (!again || again->values != written->decoded.values) std::abort();
  return 0;
}
