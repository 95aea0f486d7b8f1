// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/encode_map.h"

#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "encoder/check_mesh.h"
#include "encoder/default_quality.h"
#include "link_table.h"
#include "map_limits.h"
#include "part_fitness.h"

namespace deltamesh {
namespace {

constexpr std::uint8_t kLevelsOfParts = 3;  ///< from the smallest to the largest

Box box_of(std::span<const float> positions) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (positions.empty()) return {};
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    box.min[i % 3] = std::min(box.min[i % 3], double{positions[i]});
    box.max[i % 3] = std::max(box.max[i % 3], double{positions[i]});
  }
  return box;
}

/// Bounds in model units, or those that encode() has for the whole mesh.
QualityRequest request_of(const MeshView& mesh, const QualityRequest& asked) {
  const Box box = box_of(mesh.positions);
  if (asked.empty()) {
    std::vector<Vec3> positions;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
      positions.push_back({mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]});
    return default_quality(mesh.triangles, positions, box);
  }
  QualityRequest request = asked;
  for (auto* bound : {&request.vde, &request.lfe, &request.max_error})
    if (*bound && (*bound)->unit == QualityUnit::kDiagonal)
      *bound = QualityBound{(*bound)->value / 100 * box.diagonal()};
  return request;
}

/// The least of the bounds: a lattice that keeps it for border vertices leaves room for all.
double least_bound(const QualityRequest& request) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& bound : {request.vde, request.lfe, request.max_error})
    if (bound) least = std::min(least, bound->value);
  return least;
}

Result<MapDescription> describe_map(const MeshView& mesh, const MapSettings& settings,
                                    const QualityRequest& request) {
  MapDescription description{.id = settings.id, .frame = settings.frame};
  description.lattice = {.origin = mesh.origin, .step_exponent = step_exponent_for(least_bound(request))};
  const double steps =
      std::round(std::ldexp(settings.part_edge, -kLevelsOfParts) / description.lattice.step());
  if (!(steps <= kMostCellSteps))
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "parts of more than 2^27 steps of the lattice; ask for smaller ones",
                 .rule = "MAP-3"};
  description.cell_steps = static_cast<std::uint32_t>(std::max(steps, 1.0));
  // Floors and walls are often at 0: a third of a cell, on every level, from where cells meet.
  const std::int64_t third = (std::int64_t{description.cell_steps} << kLevelsOfParts) / 3;
  description.cell_origin.fill(-static_cast<std::int32_t>(std::min<std::int64_t>(third, kMostLatticeSteps)));
  for (const AttributeView& a : mesh.attributes)
    description.attributes.push_back({a.kind, a.type, a.components, a.normalized, std::string(a.name)});
  return description;
}

/// Whether parts of the one are parts of the other, whatever the primers.
bool share_lattice(MapDescription a, const MapDescription& b) {
  a.epoch = b.epoch;
  a.primers = b.primers;
  return a == b;
}

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

std::vector<PartKey> keys_of(std::span<const MapPart> parts) {
  std::vector<PartKey> keys;
  for (const MapPart& part : parts) keys.push_back(part.key);
  return keys;
}

/// The parts that are not coarser copies.
std::vector<MapPart> finest_of(std::span<const MapPart> parts) {
  const auto keys = keys_on_level(keys_of(parts), 0);
  std::vector<MapPart> finest;
  for (const MapPart& part : parts)
    if (std::ranges::binary_search(keys, part.key)) finest.push_back(part);
  return finest;
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

/// Entries without revision, group and links.
Result<MapState> code_parts(const MapCodec& codec, std::span<const MapPart> parts,
                            std::span<const MapPart> finest, const PartQuality& quality) {
  MapState state;
  state.manifest.description = codec.description();
  for (const MapPart& part : parts) {
    DELTAMESH_TRY(CodedPart coded, codec.encode(part, quality));
    DELTAMESH_TRY(const MapPart decoded, codec.decode(part.key, coded.bytes));
    state.manifest.entries.push_back(entry_of(part, coded, decoded));
    if (!std::ranges::binary_search(finest, part.key, {}, &MapPart::key))
      state.manifest.entries.back().quality.max_error =
          errors_between(surface_in(part.key, finest), surface_in(part.key, std::span(&decoded, 1)))
              .max_error;
    state.octets.push_back(std::move(coded.bytes));
  }
  return state;
}

const PartEntry* find_entry(const MapManifest& manifest, const PartKey& key) noexcept {
  const auto found = std::ranges::lower_bound(manifest.entries, key, {}, &PartEntry::key);
  return found != manifest.entries.end() && found->key == key ? &*found : nullptr;
}

std::uint32_t border_with(const PartEntry& entry, const PartKey& key) noexcept {
  const auto found = std::ranges::find(entry.links, key, &PartLink::key);
  return found == entry.links.end() ? 0 : found->border;
}

/// Links, and what a version has from the state before. All that changes is one group.
void number_versions(std::span<const MapPart> parts, const MapState* before, MapState& state) {
  MapManifest& manifest = state.manifest;
  manifest.revision = before != nullptr ? before->manifest.revision + 1 : 1;
  const std::uint64_t group = before != nullptr ? before->manifest.next_group : 0;
  manifest.next_group = group + 1;
  const bool is_same_epoch = before != nullptr && before->manifest.description == manifest.description;
  LinkTable links;
  for (const MapPart& part : parts) links.put(part);
  for (PartEntry& entry : manifest.entries) {
    entry.links = links.links_of(entry.key);
    const PartEntry* old = is_same_epoch ? find_entry(before->manifest, entry.key) : nullptr;
    if (old != nullptr && version_hash(old->hash, old->links) == version_hash(entry.hash, entry.links)) {
      entry.revision = old->revision;
      entry.group = old->group;
      entry.links = old->links;
      continue;
    }
    entry.revision = manifest.revision;
    entry.group = group;
    for (PartLink& link : entry.links)
      link.together = is_same_epoch &&
                      (old != nullptr || find_entry(before->manifest, link.key) != nullptr) &&
                      (old == nullptr || border_with(*old, link.key) != link.border);
  }
}

Result<MapState> encode_as(const MeshView& mesh, MapDescription description,
                           const SplitOptions& split_options, const PartQuality& quality,
                           const MapState* before) {
  DELTAMESH_TRY(const auto parts, split(mesh, description, split_options));
  const std::vector<MapPart> finest = finest_of(parts);
  if (before != nullptr && share_lattice(description, before->manifest.description)) {
    description = before->manifest.description;
  } else {
    description.epoch = before != nullptr ? before->manifest.description.epoch + 1 : 0;
    DELTAMESH_TRY(description, with_primers(std::move(description), finest, quality));
  }
  DELTAMESH_TRY(const MapCodec codec, MapCodec::open(std::move(description)));
  DELTAMESH_TRY(MapState state, code_parts(codec, parts, finest, quality));
  number_versions(parts, before, state);
  return state;
}

}  // namespace

Result<void> validate(const MapSettings& settings) noexcept {
  const auto invalid = [](const char* message) {
    return Error{.code = ErrorCode::kInvalidArgument, .message = message};
  };
  if (!std::isfinite(settings.part_edge) || !(settings.part_edge > 0))
    return invalid("the edge of parts is not above 0");
  if (settings.most_triangles == 0) return invalid("parts of no triangles");
  if (settings.levels > kMostPartLevel - kLevelsOfParts) return invalid("more than 21 coarser levels");
  if (settings.frame.size() > kMostNameBytes) return invalid("the name of the frame has more than 255 bytes");
  if (settings.quality.bounds.target_bytes) return invalid("a map cannot be asked for a number of bytes");
  return {};
}

Result<MapState> encode_map(const MeshView& mesh, const MapSettings& settings,
                            const MapState* before) noexcept {
  return guarded([&]() -> Result<MapState> {
    DELTAMESH_CHECK(validate(settings));
    DELTAMESH_CHECK(check_mesh(mesh));
    PartQuality quality = settings.quality;
    quality.bounds = request_of(mesh, settings.quality.bounds);
    DELTAMESH_TRY(const MapDescription description, describe_map(mesh, settings, quality.bounds));
    SplitOptions options{.most_triangles = settings.most_triangles, .most_level = kLevelsOfParts};
    if (settings.levels > 0) options.copy_level = static_cast<std::uint8_t>(kLevelsOfParts + settings.levels);
    for (;; options.most_triangles /= 2) {
      auto state = encode_as(mesh, description, options, quality, before);
      const bool is_too_large = !state && state.error().code == ErrorCode::kLimitExceeded;
      if (!is_too_large || options.most_triangles == 1) return state;
    }
  });
}

Result<Mesh> decode_map(const MapState& state, const DecodeOptions& options, std::uint8_t level) noexcept {
  return guarded([&]() -> Result<Mesh> {
    const auto& entries = state.manifest.entries;
    if (entries.size() != state.octets.size())
      return Error{.code = ErrorCode::kInvalidArgument, .message = "not as many octets as entries"};
    DELTAMESH_TRY(const MapCodec codec, MapCodec::open(state.manifest.description, options.limits));
    std::vector<PartKey> keys;
    for (const PartEntry& entry : entries) keys.push_back(entry.key);
    keys = keys_on_level(keys, level);
    std::vector<MapPart> parts;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (!std::ranges::binary_search(keys, entries[i].key)) continue;
      DELTAMESH_TRY(MapPart part, codec.decode(entries[i].key, state.octets[i], options));
      parts.push_back(std::move(part));
    }
    return join(parts);
  });
}

}  // namespace deltamesh
