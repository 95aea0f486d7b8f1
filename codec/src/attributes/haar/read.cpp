// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/coder.h"
#include "attributes/haar/fields.h"
#include "attributes/haar/haar.h"
#include "attributes/haar/values.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Readers have nothing to code.
struct NoHaarSource {};

/// `keeps_levels`: else they are freed one by one, as they serve.
template <unsigned kAxes>
LargeVector<HaarRecord> read_haar_axes(CompactReader& reader, std::span<HaarLevel> levels, std::uint32_t step,
                                       const Learning<HaarModels>& learning, bool keeps_levels) {
  const NoHaarSource nothing;
  HaarCoder<CompactReader, kAxes, NoHaarSource> coder(reader, levels, step, nothing, learning.start);
  auto records = coder.run([&](std::size_t l) {
    if (keeps_levels) return;
    LargeVector<HaarNode>().swap(levels[l].nodes);
    levels[l].graph = Adjacency();
  });
  if (learning.end != nullptr) *learning.end = coder.models();
  return records;
}

}  // namespace

Result<std::vector<std::byte>> read_haar_values(std::span<const std::byte> bytes, const Attribute& shape,
                                                const AttributeSurface& surface,
                                                const Learning<HaarModels>& learning) {
  ByteReader in(bytes, kTagAttribute);
  DELTAMESH_TRY(const HaarFields fields, read_haar_fields(in, shape.components));
  HaarValues values(shape.type, shape.components, surface.vertex_count());
  if (surface.vertex_count() == 0) {
    DELTAMESH_CHECK(in.finish());
    return values.take();
  }
  DELTAMESH_TRY(const auto stream, in.read_bytes(in.remaining()));
  auto levels = make_haar_levels(surface);
  CompactReader reader(stream);
  const bool has_alpha = fields.alpha == HaarAlpha::kCoded;
  const auto records = fields.axes == 1
                           ? read_haar_axes<1>(reader, levels, fields.step, learning, has_alpha)
                           : read_haar_axes<kHaarAxes>(reader, levels, fields.step, learning, has_alpha);
  if (shape.components == 1) {
    values.set_numbers(records, fields.scale);
  } else {
    values.set_colors(records, fields.axes);
  }
  if (fields.alpha == HaarAlpha::kConstant) values.set_alpha(fields.alpha_level);
  if (has_alpha) values.set_alpha(read_haar_axes<1>(reader, levels, fields.step, {}, false));
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return values.take();
}

}  // namespace deltamesh
