// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes on lattices from anywhere. The last four bytes are vertices (with a bit for copies), faces, type
// (with a bit for exceptions) and components. What is read must be whole, and must come back unchanged when
// written exactly.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/exceptions/exceptions.h"
#include "attributes/payload.h"
#include "goal.h"
#include "meshes.h"
#include "support/attribute_coding.h"

namespace {

using namespace deltamesh;

fuzz::Goal values_read("values");
fuzz::Goal exceptions_read("values with exceptions");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kShape = 4;
  if (size < kShape) return 0;
  const std::uint8_t* const shape = data + size - kShape;
  const fuzz::SpreadFaces spread(shape[0], shape[1]);
  const AttributeSurface surface = spread.surface(shape[0] >= 128);
  const std::uint32_t vertices = spread.vertices;
  const AttributeDescriptor descriptor{
      .type = static_cast<ComponentType>(shape[2] % 8),
      .components = static_cast<std::uint8_t>(1 + shape[3] % kMaxComponents)};

  const auto exceptions = static_cast<std::byte>(shape[2] & kExceptionsFlag);
  std::vector<std::byte> bytes{static_cast<std::byte>(AttributeCoding::kLattice) | exceptions};
  for (const std::uint8_t* byte = data; byte != shape; ++byte) bytes.push_back(static_cast<std::byte>(*byte));
  const auto read = read_attribute(Payload::compact(bytes), descriptor, surface, {}, 1 << 16);
  if (!fuzz::check(read)) return 0;
  if (read->values.size() != attribute_bytes(descriptor, vertices)) std::abort();

  const auto order = test::identity(vertices);
  const AttributeView exact{AttributeKind::kGeneric, read->type, read->components,
                            read->normalized,        {},         read->values};
  const AttributeQuality quality;
  const auto written = write_attribute(exact, order, {.quality = quality}, surface, {});
  if (!written || written->decoded.values != read->values) std::abort();
  const Payload payload =
      written->is_compact ? Payload::compact(written->payload) : Payload(written->payload);
  const auto again = read_attribute(payload, written->descriptor, surface, {}, 1 << 16);
  if (!again || again->values != read->values) std::abort();
  (exceptions == std::byte{0} ? values_read : exceptions_read).reach();
  return 0;
}
