// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/uvs/coder.h"
#include "attributes/uvs/uvs.h"
#include "base/byte_reader.h"
#include "base/small_code.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Readers choose nothing.
struct NoUvChoice {};

}  // namespace

DELTAMESH_APART Result<std::vector<float>> read_surface_uvs(std::span<const std::byte> bytes,
                                                            const AttributeSurface& surface) {
  ByteReader in(bytes, kTagAttribute);
  DELTAMESH_TRY(const auto step, in.read<float>());
  if (!(step >= kLeastUvStep && step <= kMostUvStep))
    return in.invalid("a parameter of the attribute is out of range", "ATTR-31");
  DELTAMESH_TRY(const auto stream, in.read_bytes(in.remaining()));
  CompactReader reader(stream);
  UvCoder coder(reader, surface, static_cast<double>(step), NoUvChoice{});
  for (std::size_t i = 0; i < coder.count(); ++i) {
    const bool is_valid = coder.code(i);
    if (reader.failed()) break;
    if (!is_valid) return in.invalid("texture coordinates too far from their prediction", "ATTR-37");
  }
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return std::move(coder.values());
}

}  // namespace deltamesh
