// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/coded_attributes.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "attributes/attribute.h"
#include "base/try.h"
#include "deltamesh/model_states.h"
#include "format/vertex_positions.h"
#include "states/stream_models.h"

namespace deltamesh {
namespace {

constexpr double kLargestAngle = 45;     // degrees
constexpr double kLargestUv = 1.0 / 16;  // texture coordinate units
constexpr double kLargestColor = 64;     // 255ths
constexpr double kLargestColorRms = 32;  // 255ths
constexpr double kLargestWeight = 1.0 / 8;

/// At most `largest`, unless more was asked for.
double scaled_to(double bound, double scale, double largest) noexcept {
  return std::min(bound * scale, std::max(bound, largest));
}

}  // namespace

bool attributes_use_positions(const MeshView& mesh, const EncodeOptions& options) noexcept {
  const auto on_surface = [](const AttributeView& attribute) {
    return attribute.kind == AttributeKind::kNormal || attribute.kind == AttributeKind::kTangent ||
           attribute.kind == AttributeKind::kUv;
  };
  return options.profile == Profile::kSmallest &&
         std::any_of(mesh.attributes.begin(), mesh.attributes.end(), on_surface);
}

Result<ChunkList> code_attributes(const MeshView& mesh, const CodedTopology& topology,
                                  const EncodeOptions& options, const Candidate& geometry, bool about) {
  const std::span<const float> positions = geometry.positions;
  const std::span<const std::uint32_t> copies =
      topology.has_seams ? topology.seams.split.geometric : std::span<const std::uint32_t>();
  const bool is_split = !copies.empty() && !positions.empty();
  const std::vector<float> split = is_split ? copy_rows(positions, copies) : std::vector<float>();
  AttributeSurface surface(topology.triangles(), topology.vertex_count(), copies,
                           is_split ? split : positions);
  if (geometry.grid) surface.set_known(geometry.grid->known);
  const ModelStates* const states = options.starting_states;
  AttributeSettings settings{.quality = options.attributes,
                             .plain = options.profile == Profile::kZstd,
                             .effort = options.effort,
                             .about = about};
  const auto& attributes = mesh.attributes;
  std::vector<CodedAttribute> coded(attributes.size());
  std::vector<Attribute> decoded(attributes.size());
  for (const bool after_others : {false, true}) {
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      if (decoded_after_others(attributes[i].kind) != after_others) continue;
      settings.known = known_attribute(options.known, i, attributes[i].type, attributes[i].components);
      settings.start = states != nullptr ? states->models().of_attribute(i) : nullptr;
      DELTAMESH_TRY(coded[i],
                    write_attribute(attributes[i], topology.vertex_order(), settings, surface, decoded));
      decoded[i] = std::move(coded[i].decoded);
    }
  }
  ChunkList chunks(options.profile, options.effort);
  for (CodedAttribute& attribute : coded) {
    if (!attribute.is_compact) std::swap(attribute.payload, attribute.plain);
    chunks.add_attribute(std::move(attribute.payload), std::move(attribute.plain), attribute.descriptor);
  }
  return chunks;
}

AttributeQuality scaled(const AttributeQuality& quality, double scale) {
  if (quality.is_asked) scale = std::min(scale, 1.0);
  AttributeQuality result = quality;
  result.normal_error = scaled_to(quality.normal_error, scale, kLargestAngle);
  if (quality.tangent_error) result.tangent_error = scaled_to(*quality.tangent_error, scale, kLargestAngle);
  result.uv_error = scaled_to(quality.uv_error, scale, kLargestUv);
  if (quality.color_rms) result.color_rms = scaled_to(*quality.color_rms, scale, kLargestColorRms);
  if (quality.color_error) result.color_error = scaled_to(*quality.color_error, scale, kLargestColor);
  result.weight_error = scaled_to(quality.weight_error, scale, kLargestWeight);
  for (NamedBound& bound : result.named) bound.error *= scale;
  return result;
}

}  // namespace deltamesh
