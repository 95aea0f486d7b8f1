// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The encoder's exports. An outcome lives until the next call.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "deltamesh/compare.h"
#include "deltamesh/encode.h"
#include "deltamesh/gltf.h"
#include "encoder_call.h"
#include "runtime.h"

extern "C" {
/// Tells JavaScript the share of the work that is done.
DELTAMESH_IMPORT(progress) void progress(double share);
}

namespace deltamesh::web {
namespace {

struct Kept {
  Encoded encoded;
  Comparison comparison;
  GltfOutput packed;
  EncodeOutcome encode;
  CompareOutcome compare;
  PackOutcome pack;
  std::vector<PackedAttributeOutcome> attributes;
};
std::optional<Kept> kept;

std::optional<double> given(double number) {
  return std::isnan(number) ? std::nullopt : std::optional(number);
}
template <class T>
std::optional<T> given_as(double number) {
  return std::isnan(number) ? std::nullopt : std::optional(static_cast<T>(number));
}

std::optional<QualityBound> bound_of(const BoundCall& bound) {
  if (std::isnan(bound.value)) return std::nullopt;
  return QualityBound{.value = bound.value, .unit = static_cast<QualityUnit>(bound.unit)};
}

MeshView view_of(const MeshCall& mesh) {
  MeshView view;
  view.origin = {mesh.origin[0], mesh.origin[1], mesh.origin[2]};
  view.positions = {mesh.positions, std::size_t{3} * mesh.vertices};
  view.triangles = {mesh.indices, std::size_t{3} * mesh.triangles};
  if (mesh.groups != nullptr) view.face_groups = {mesh.groups, mesh.triangles};
  for (std::uint32_t i = 0; i < mesh.attribute_count; ++i) {
    const AttributeCall& a = mesh.attributes[i];
    view.attributes.push_back({.kind = static_cast<AttributeKind>(a.kind),
                               .type = static_cast<ComponentType>(a.type),
                               .components = static_cast<std::uint8_t>(a.components),
                               .normalized = (a.flags & 1U) != 0,
                               .name = {a.name, a.name_bytes},
                               .values = {a.values, a.value_bytes},
                               .linear = (a.flags & 2U) != 0});
  }
  return view;
}

EncodeOptions options_of(const OptionsCall& call) {
  EncodeOptions options;
  options.quality = {.vde = bound_of(call.vde),
                     .lfe = bound_of(call.lfe),
                     .max_error = bound_of(call.max_error),
                     .target_bytes = given_as<std::uint64_t>(call.target_bytes)};
  options.geometry = static_cast<GeometryCoder>(call.geometry);
  options.lossless = call.lossless != 0;
  options.effort = static_cast<int>(call.effort);
  options.bits = given_as<int>(call.bits);
  options.step = given(call.step);
  options.anchors = given_as<std::uint32_t>(call.anchors);
  options.anchor_density = given_as<std::uint32_t>(call.anchor_density);
  options.anchor_bits = static_cast<int>(call.anchor_bits);
  const AttributeQuality usual;
  const auto is_given = [](double x) { return given(x).has_value(); };
  options.attributes = {.normal_error = given(call.normal_error).value_or(usual.normal_error),
                        .tangent_error = given(call.tangent_error),
                        .uv_error = given(call.uv_error).value_or(usual.uv_error),
                        .color_error = given(call.color_error),
                        .color_rms = given(call.color_rms),
                        .weight_error = given(call.weight_error).value_or(usual.weight_error),
                        .is_asked = call.named_count > 0 || is_given(call.normal_error) ||
                                    is_given(call.tangent_error) || is_given(call.uv_error) ||
                                    is_given(call.color_error) || is_given(call.color_rms) ||
                                    is_given(call.weight_error)};
  for (std::uint32_t i = 0; i < call.named_count; ++i) {
    const NamedCall& named = call.named[i];
    options.attributes.named.push_back(
        {.name = {named.name, named.name_bytes}, .error = named.error, .is_mean = named.is_mean != 0});
  }
  options.profile = static_cast<Profile>(call.profile);
  options.keep_order = call.keep_order != 0;
  options.keep_unreferenced = call.keep_unreferenced != 0;
  options.progress = progress;
  return options;
}

void tell(const GltfReport& report, PackOutcome& outcome) {
  const std::uint64_t counts[] = {report.primitives,
                                  report.converted,
                                  report.streams,
                                  report.not_triangles,
                                  report.not_float_positions,
                                  report.otherwise_compressed,
                                  report.not_smaller,
                                  report.vertices,
                                  report.triangles,
                                  report.unreferenced_vertices,
                                  report.degenerate_triangles,
                                  report.dropped_lengths,
                                  report.welded_vertices,
                                  report.stream_bytes,
                                  report.input_bytes,
                                  report.output_bytes,
                                  report.animation_bytes,
                                  report.image_bytes};
  std::copy(std::begin(counts), std::end(counts), outcome.counts);
  outcome.max_error = report.max_error;
  outcome.max_error_percent = report.max_error_percent;
  for (const GltfAttributeReport& attribute : report.attributes)
    kept->attributes.push_back({.bytes = static_cast<double>(attribute.bytes),
                                .error = attribute.error,
                                .semantic = attribute.semantic.data(),
                                .semantic_bytes = static_cast<std::uint32_t>(attribute.semantic.size()),
                                .kind = static_cast<std::uint32_t>(attribute.kind),
                                .morph = attribute.morph ? 1U : 0U});
  outcome.attributes = kept->attributes.data();
  outcome.attribute_count = static_cast<std::uint32_t>(kept->attributes.size());
}

}  // namespace

extern "C" {

DELTAMESH_EXPORT(encode) EncodeOutcome* encode_mesh(const MeshCall* mesh, const OptionsCall* options) {
  kept.emplace();
  auto encoded = encode(view_of(*mesh), options_of(*options));
  if (!encoded) {
    const Error& error = encoded.error();
    kept->encode = {.error = outcome_of(error),
                    .best_value = error.best_value,
                    .best_bytes = static_cast<double>(error.best_bytes)};
    return &kept->encode;
  }
  kept->encoded = *std::move(encoded);
  kept->encode.bytes = kept->encoded.bytes.data();
  kept->encode.byte_count = static_cast<std::uint32_t>(kept->encoded.bytes.size());
  kept->encode.order = kept->encoded.order.data();
  kept->encode.order_count = static_cast<std::uint32_t>(kept->encoded.order.size());
  return &kept->encode;
}

/// `asset`: a GLB, or JSON with its buffers in it; packed, it is a GLB.
DELTAMESH_EXPORT(pack)
PackOutcome* pack_asset(const std::byte* asset, std::size_t bytes, const OptionsCall* options,
                        std::uint32_t fallback) {
  kept.emplace();
  auto packed = pack_gltf({asset, bytes}, {.encode = options_of(*options), .fallback = fallback != 0});
  PackOutcome& outcome = kept->pack;
  if (!packed) {
    outcome.error = outcome_of(packed.error());
    return &outcome;
  }
  kept->packed = *std::move(packed);
  tell(kept->packed.report, outcome);
  outcome.bytes = kept->packed.asset.data();
  outcome.byte_count = static_cast<std::uint32_t>(kept->packed.asset.size());
  return &outcome;
}

/// `order`: vertex of `a` for every vertex of `b`, or none.
DELTAMESH_EXPORT(compare)
CompareOutcome* compare_meshes(const MeshCall* a, const MeshCall* b, const std::uint32_t* order,
                               std::size_t order_count) {
  kept.emplace();
  auto comparison = compare(view_of(*a), view_of(*b), {order, order_count});
  CompareOutcome& outcome = kept->compare;
  if (!comparison) {
    outcome.error = outcome_of(comparison.error());
    return &outcome;
  }
  kept->comparison = *std::move(comparison);
  const Comparison& c = kept->comparison;
  outcome.corresponding = c.corresponding;
  outcome.quality[0] = c.quality.vde_rms;
  outcome.quality[1] = c.quality.lfe_rms;
  outcome.quality[2] = c.quality.max_error;
  outcome.surface_rms = c.surface_rms;
  outcome.surface_max = c.surface_max;
  outcome.normal_angle_mean = c.normal_angle_mean;
  outcome.normal_angle_p95 = c.normal_angle_p95;
  outcome.diagonal = c.diagonal;
  outcome.signed_error = c.signed_error.data();
  outcome.signed_error_count = static_cast<std::uint32_t>(c.signed_error.size());
  return &outcome;
}

/// Frees what the last call made.
DELTAMESH_EXPORT(forget) void forget() { kept.reset(); }

}  // extern "C"
}  // namespace deltamesh::web
