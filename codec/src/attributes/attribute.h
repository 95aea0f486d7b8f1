// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// ATTR: one attribute of the vertices, within a bound of its kind's error or to the last bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/surface.h"
#include "deltamesh/attribute_quality.h"
#include "deltamesh/known_mesh.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "entropy/coder/learning.h"
#include "entropy/payload.h"
#include "format/chunk/attribute_descriptor.h"

namespace deltamesh {

struct AttributeModels;

struct AttributeSettings {
  const AttributeQuality& quality;
  bool plain = false;                      ///< the plain form
  int effort = 1;                          ///< 0 to 2
  bool about = false;                      ///< mean errors may be off by kAbout (haar/haar.h)
  const AttributeModels* start = nullptr;  ///< null for fresh models
  const Attribute* known = nullptr;        ///< of colours; what readers have of known vertices, or null
};

/// A coded attribute and what a decoder gets.
struct CodedAttribute {
  std::vector<std::byte> payload;
  bool is_compact = false;
  /// Of compact values that may repeat as zstd alone finds out: the same in the plain form; else empty.
  std::vector<std::byte> plain;
  AttributeDescriptor descriptor;
  Attribute decoded;
};

/// `order`: the row of `attribute` for every coded vertex. `others`: the decoded attributes that decoders
/// know before this one, see decoded_after_others(). An attribute of a known kind whose shape does not fit
/// the kind (a colour of doubles, say), or that is not finite, is exact. What no compact coding suits
/// (doubles that are on no lattice, numbers that are not finite) is in the plain form, whatever is asked for.
/// Errors: kInvalidMesh (sizes that disagree).
Result<CodedAttribute> write_attribute(const AttributeView& attribute, std::span<const std::uint32_t> order,
                                       const AttributeSettings& settings, const AttributeSurface& surface,
                                       std::span<const Attribute> others);

/// The attribute number `index` of `known`, if it is there in this shape; else null. `known`: may be null.
inline const Attribute* known_attribute(const KnownMesh* known, std::size_t index, ComponentType type,
                                        std::size_t components) noexcept {
  if (known == nullptr || index >= known->attributes.size()) return nullptr;
  const Attribute& found = known->attributes[index];
  const std::size_t bytes = known->positions.size() / 3 * components * component_size(type);
  const bool fits = found.type == type && found.components == components && found.values.size() == bytes;
  return fits ? &found : nullptr;
}

/// Whether attributes of this kind are decoded after all other kinds and predicted from these [ATTR-11].
constexpr bool decoded_after_others(AttributeKind kind) noexcept {
  return kind == AttributeKind::kTangent || kind == AttributeKind::kWeights;
}

/// Without values.
Attribute shape_of(const AttributeDescriptor& descriptor);

/// Bytes of all values of `rows` vertices.
std::uint64_t attribute_bytes(const AttributeDescriptor& descriptor, std::uint32_t rows) noexcept;

/// `others`: see write_attribute(). Errors: kTruncated, kInvalidStream [ATTR-*], kLimitExceeded where the
/// values would take more than `max_bytes`. `known`: as AttributeSettings::known.
Result<Attribute> read_attribute(Payload payload, const AttributeDescriptor& descriptor,
                                 const AttributeSurface& surface, std::span<const Attribute> others,
                                 std::uint64_t max_bytes, const Learning<AttributeModels>& learning = {},
                                 const Attribute* known = nullptr);

}  // namespace deltamesh
