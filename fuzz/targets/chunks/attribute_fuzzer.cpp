// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ATTR payloads from anywhere, of any shape. The last four bytes are vertex count, kind, type and components.
// What is read must be whole, and must come back unchanged when written exactly.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "attributes/attribute.h"
#include "goal.h"
#include "support/attribute_coding.h"

namespace {

using namespace deltamesh;

fuzz::Goal plain_values("plain values");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kShape = 4;
  if (size < kShape) return 0;
  const std::uint8_t* const shape = data + size - kShape;
  const AttributeSurface surface({}, shape[0]);
  const AttributeDescriptor descriptor{
      .kind = static_cast<AttributeKind>(shape[1] % kAttributeKinds),
      .type = static_cast<ComponentType>(shape[2] % 8),
      .components = static_cast<std::uint8_t>(1 + shape[3] % kMaxComponents)};
  const std::vector<std::byte> bytes(reinterpret_cast<const std::byte*>(data),
                                     reinterpret_cast<const std::byte*>(shape));
  const auto read = read_attribute(bytes, descriptor, surface, {}, 1 << 16);
  if (!fuzz::check(read)) return 0;
  if (read->values.size() != attribute_bytes(descriptor, surface.vertex_count())) std::abort();

  const auto order = test::identity(surface.vertex_count());
  const AttributeView exact{AttributeKind::kGeneric, read->type, read->components,
                            read->normalized,        {},         read->values};
  const AttributeQuality quality;
  const auto written = write_attribute(exact, order, {.quality = quality, .plain = true}, surface, {});
  if (!written) std::abort();
  const auto again = read_attribute(written->payload, written->descriptor, surface, {}, 1 << 16);
  if (!again || again->values != read->values) std::abort();
  plain_values.reach();
  return 0;
}
