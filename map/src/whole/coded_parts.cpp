// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "whole/coded_parts.h"

#include <xxhash.h>

#include <algorithm>
#include <utility>

#include "base/try.h"
#include "part/fitness.h"
#include "split/copies.h"
#include "whole/describe.h"

namespace deltamesh {
namespace {

PartEntry entry_of(const MapPart& part, const CodedPart& coded, const MapPart& decoded) {
  PartEntry entry{.key = part.key};
  entry.bytes = static_cast<std::uint32_t>(coded.bytes.size());
  entry.hash = XXH3_64bits(coded.bytes.data(), coded.bytes.size());
  entry.vertices = static_cast<std::uint32_t>(decoded.mesh.vertex_count());
  entry.triangles = static_cast<std::uint32_t>(decoded.mesh.triangle_count());
  const Box box = box_of(decoded.mesh.positions);
  for (std::size_t k = 0; k < 3; ++k) {
    entry.box_min[k] = static_cast<float>(box.min[k]);
    entry.box_max[k] = static_cast<float>(box.max[k]);
  }
  entry.quality = coded.quality;
  for (const double error : coded.attribute_errors)
    entry.attribute_errors.push_back(static_cast<float>(error));
  return entry;
}

/// The faces of parts in a cell, without attributes.
Mesh surface_in(const PartKey& cell, std::span<const MapPart> parts) {
  Mesh mesh;
  for (const MapPart& part : parts) {
    if (!overlap(part.key, cell)) continue;
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    mesh.origin = part.mesh.origin;
    mesh.positions.insert(mesh.positions.end(), part.mesh.positions.begin(), part.mesh.positions.end());
    for (const std::uint32_t v : part.mesh.triangles) mesh.triangles.push_back(first + v);
  }
  return mesh;
}

/// A copy is off by its simplification already: positions within a part of that cost bytes that nobody sees.
constexpr double kCodingOfSimplification = 1.0 / 2;

PartQuality quality_of_copy(const PartKey& key, const MapDescription& description, PartQuality quality) {
  const double least = kCodingOfSimplification * simplification_error(key, description);
  for (auto* bound : {&quality.bounds.vde, &quality.bounds.lfe, &quality.bounds.max_error})
    if (*bound) (*bound)->value = std::max((*bound)->value, least);
  return quality;
}

}  // namespace

Result<MapState> code_parts(const MapCodec& codec, std::span<const MapPart> parts,
                            std::span<const MapPart> finest, const PartQuality& quality) {
  MapState state;
  state.manifest.description = codec.description();
  for (const MapPart& part : parts) {
    const bool is_copy = !std::ranges::binary_search(finest, part.key, {}, &MapPart::key);
    DELTAMESH_TRY(
        CodedPart coded,
        codec.encode(part, is_copy ? quality_of_copy(part.key, codec.description(), quality) : quality));
    DELTAMESH_TRY(const MapPart decoded, codec.decode(part.key, coded.bytes));
    state.manifest.entries.push_back(entry_of(part, coded, decoded));
    if (is_copy)
      state.manifest.entries.back().quality.max_error =
          errors_between(surface_in(part.key, finest), surface_in(part.key, std::span(&decoded, 1)))
              .max_error;
    state.octets.push_back(std::move(coded.bytes));
  }
  return state;
}

}  // namespace deltamesh
