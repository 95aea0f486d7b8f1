// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "patch/encode.h"

#include <algorithm>
#include <utility>

#include "base/try.h"
#include "part/fitness.h"
#include "part/measure.h"
#include "patch/coder.h"
#include "patch/container.h"
#include "patch/payload.h"
#include "search/request.h"
#include "support/color_value.h"
#include "support/row_gather.h"

namespace deltamesh {
namespace {

/// The new faces as a part; `rows`: its vertices in the source.
MapPart new_part(const MapPart& source, const PartMatch& match, std::vector<std::uint32_t>& rows) {
  RowGather gather{MeshView(source.mesh)};
  for (const std::uint32_t face : match.new_faces) gather.add_face(face);
  rows = gather.rows();
  MapPart part{source.key, gather.take(), {}};
  std::vector<std::uint32_t> border(source.mesh.vertex_count(), kNotJoined);
  for (std::uint32_t i = 0; i < source.border.size(); ++i) border[source.border[i].vertex] = i;
  for (std::uint32_t v = 0; v < rows.size(); ++v) {
    if (border[rows[v]] == kNotJoined || match.base_of[rows[v]] != kNotJoined) continue;
    part.border.push_back(source.border[border[rows[v]]]);
    part.border.back().vertex = v;
  }
  return part;
}

}  // namespace

Result<std::optional<DecodedPart>> encode_beside(const MapCodec::State& state, const MapPart& source,
                                                 const MapPart& base, std::uint64_t base_hash,
                                                 const PartQuality& quality) {
  DELTAMESH_TRY(DecodedPart part, encode_part(state, source, quality, {.base = &base}));
  if (!part.is_grid) return std::optional<DecodedPart>();
  part.coded.bytes =
      write_body(state.place_of(source.key), base_hash, {{}, without_checksum(part.coded.bytes)});
  return std::optional(std::move(part));
}

Result<std::optional<DecodedPart>> encode_patch(const MapCodec::State& state, const MapPart& source,
                                                const BaseVersion& base, std::uint64_t base_hash,
                                                const PartMatch& match, const PartQuality& quality) {
  std::vector<std::uint32_t> rows;
  DecodedPart inserted;
  if (!match.new_faces.empty()) {
    const MapPart part = new_part(source, match, rows);
    std::vector<std::uint8_t> is_joined;
    is_joined.reserve(rows.size());
    for (const std::uint32_t row : rows) is_joined.push_back(match.base_of[row] != kNotJoined ? 1 : 0);
    DELTAMESH_TRY(inserted, encode_part(state, part, quality, {.is_joined = is_joined}));
  }
  PatchPlan plan{.stays = match.stays, .joins = {}};
  DecodedPart patched;
  patched.order = match.source_of;
  for (const std::uint32_t v : inserted.order) {
    plan.joins.push_back(match.base_of[rows[v]]);
    if (plan.joins.back() == kNotJoined) patched.order.push_back(rows[v]);
  }
  patched.part = put_together(source.key, base.part, inserted.part, plan);
  const PartMeasure measure(source.mesh);
  patched.coded.quality = measure.compare(patched.part.mesh.positions, patched.order);
  const Bounds bounds = bounds_in_model_units(quality.bounds, measure.geometric_count(), measure.diagonal(),
                                              measure.diagonal());
  if (bounds.load(patched.coded.quality) > 1) return std::optional<DecodedPart>();
  for (std::size_t a = 0; a < source.mesh.attributes.size(); ++a) {
    double most = 0;
    for (std::size_t v = 0; v < patched.order.size(); ++v)
      most = std::max(most, color_difference(source.mesh.attributes[a], patched.order[v],
                                             patched.part.mesh.attributes[a], v));
    const auto& bound = quality.attributes.color_error;
    if (bound && most > kMeanTolerance * *bound) return std::optional<DecodedPart>();
    patched.coded.attribute_errors.push_back(most);
  }
  patched.coded.color_rms = color_rms(source.mesh, patched.part.mesh, patched.order);
  const auto& rms = quality.attributes.color_rms;
  if (rms && patched.coded.color_rms > kMeanTolerance * *rms) return std::optional<DecodedPart>();
  const auto coded_plan = write_patch_plan(base.part.mesh, inserted.part.mesh, std::move(plan));
  patched.coded.bytes =
      write_body(state.place_of(source.key), base_hash, {coded_plan, without_checksum(inserted.coded.bytes)});
  return std::optional(std::move(patched));
}

}  // namespace deltamesh
