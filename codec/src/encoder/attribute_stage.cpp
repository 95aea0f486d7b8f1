// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/attribute_stage.h"

#include <algorithm>
#include <utility>

#include "attributes/attribute.h"
#include "base/try.h"
#include "format/tags.h"
#include "geometry/vertex_positions.h"

namespace deltamesh {

std::uint64_t CodedAttributes::bytes() const noexcept {
  std::uint64_t sum = 0;
  for (const CodedChunk& chunk : chunks.chunks()) sum += chunk.bytes.size();
  return sum;
}

bool AttributeStage::uses_positions() const noexcept {
  const auto on_surface = [](const AttributeView& attribute) {
    return attribute.kind == AttributeKind::kNormal || attribute.kind == AttributeKind::kTangent ||
           attribute.kind == AttributeKind::kUv;
  };
  return options_.profile == Profile::kSmallest &&
         std::any_of(mesh_.attributes.begin(), mesh_.attributes.end(), on_surface);
}

Result<CodedAttributes> AttributeStage::code(const AttributeQuality& quality,
                                             std::span<const float> positions) const {
  const std::span<const std::uint32_t> copies =
      topology_.has_seams ? topology_.seams.split.geometric : std::span<const std::uint32_t>();
  const bool is_split = !copies.empty() && !positions.empty();
  const std::vector<float> split = is_split ? copy_rows(positions, copies) : std::vector<float>();
  const AttributeSurface surface(topology_.triangles(), topology_.vertex_count(), copies,
                                 is_split ? split : positions);
  const AttributeSettings settings{
      .quality = quality, .plain = options_.profile == Profile::kZstd, .effort = options_.effort};
  const auto& attributes = mesh_.attributes;
  std::vector<CodedAttribute> coded(attributes.size());
  std::vector<Attribute> decoded(attributes.size());
  for (const bool after_others : {false, true}) {
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      if (decoded_after_others(attributes[i].kind) != after_others) continue;
      DELTAMESH_TRY(coded[i],
                    write_attribute(attributes[i], topology_.vertex_order(), settings, surface, decoded));
      decoded[i] = std::move(coded[i].decoded);
    }
  }
  CodedAttributes all{.chunks = ChunkList(options_.profile, options_.effort)};
  for (CodedAttribute& attribute : coded) {
    all.descriptors.push_back(std::move(attribute.descriptor));
    if (attribute.plain.empty()) {
      all.chunks.add_compact(kTagAttribute, std::move(attribute.compact));
    } else {
      DELTAMESH_CHECK(
          all.chunks.add(kTagAttribute, std::move(attribute.plain), std::move(attribute.compact)));
    }
  }
  return all;
}

}  // namespace deltamesh
