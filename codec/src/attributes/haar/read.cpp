// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/coder.h"
#include "attributes/haar/haar.h"
#include "attributes/haar/values.h"
#include "base/byte_reader.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Readers have nothing to code.
struct NoHaarSource {};

template <unsigned kAxes>
Result<std::vector<std::byte>> read_haar_axes(std::span<const std::byte> stream, std::uint32_t step,
                                              const AttributeSurface& surface) {
  const auto levels = make_haar_levels(surface);
  CompactReader reader(stream);
  const NoHaarSource nothing;
  HaarCoder<CompactReader, kAxes, NoHaarSource> coder(reader, levels, step, nothing);
  const auto records = coder.run();
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return haar_colors(records, kAxes);
}

}  // namespace

Result<std::vector<std::byte>> read_haar_colors(std::span<const std::byte> bytes,
                                                const AttributeSurface& surface) {
  ByteReader in(bytes, kTagAttribute);
  DELTAMESH_TRY(const auto axes, in.read<std::uint8_t>());
  if (axes != 1 && axes != kHaarAxes)
    return in.invalid("number of axes of colours is neither 1 nor 3", "HAAR-6");
  DELTAMESH_TRY(const auto step, in.read<std::uint16_t>());
  if (step == 0) return in.invalid("step of colours is 0", "HAAR-6");
  if (surface.vertex_count() == 0) {
    DELTAMESH_CHECK(in.finish());
    return std::vector<std::byte>{};
  }
  DELTAMESH_TRY(const auto stream, in.read_bytes(in.remaining()));
  return axes == 1 ? read_haar_axes<1>(stream, step, surface) : read_haar_axes<3>(stream, step, surface);
}

}  // namespace deltamesh
