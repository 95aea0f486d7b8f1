// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "connectivity/check_mesh.h"
#include "deltamesh/color_content.h"
#include "deltamesh/find_grid.h"
#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "lattice/borders_of_links.h"
#include "part/link_table.h"
#include "whole/coded_parts.h"
#include "whole/describe.h"

namespace deltamesh {
namespace {

/// Whether parts of the one are parts of the other, whatever the primers.
bool share_lattice(MapDescription a, const MapDescription& b) {
  a.epoch = b.epoch;
  a.primers = b.primers;
  return a == b;
}

/// A part with hardly a vertex within keeps bounds on means only with border vertices that are near.
constexpr int kMostFiner = 6;  // times half the step that suits the bounds

/// How much finer the lattice of a state is than would suit it; 0: not, or by more than is ever chosen.
int steps_finer(const MapDescription& state, const MapDescription& suited) noexcept {
  const int finer = suited.lattice.step_exponent - state.lattice.step_exponent;
  return finer > 0 && finer <= kMostFiner ? finer : 0;
}

/// The map's, unless the mesh is on another one.
std::optional<VoxelGrid> grid_of(const MeshView& mesh, const MapState* before) {
  std::optional<VoxelGrid> known;
  if (before != nullptr && before->manifest.description.lattice.origin == mesh.origin)
    known = before->manifest.description.grid;
  if (known && is_on_grid(*known, mesh)) return known;
  const auto found = find_grid(mesh);
  return found ? found : known;
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

const PartEntry* find_entry(const MapManifest& manifest, const PartKey& key) noexcept {
  const auto found = std::ranges::lower_bound(manifest.entries, key, {}, &PartEntry::key);
  return found != manifest.entries.end() && found->key == key ? &*found : nullptr;
}

/// Links, and what a version has from the state before. All that changes is one group; where nothing does,
/// there is no update.
void number_versions(std::span<const MapPart> parts, const MapState* before, MapState& state) {
  MapManifest& manifest = state.manifest;
  manifest.revision = before != nullptr ? before->manifest.revision + 1 : 1;
  const std::uint64_t group = before != nullptr ? before->manifest.next_group : 0;
  manifest.next_group = group + 1;
  const bool is_same_epoch = before != nullptr && before->manifest.description == manifest.description;
  LinkTable links;
  for (const MapPart& part : parts) links.put(part);
  std::size_t kept = 0;
  for (PartEntry& entry : manifest.entries) {
    entry.links = links.links_of(entry.key);
    const PartEntry* old = is_same_epoch ? find_entry(before->manifest, entry.key) : nullptr;
    if (old != nullptr && version_hash(old->hash, old->links) == version_hash(entry.hash, entry.links)) {
      entry.revision = old->revision;
      entry.group = old->group;
      entry.links = old->links;
      ++kept;
      continue;
    }
    entry.revision = manifest.revision;
    entry.group = group;
    for (PartLink& link : entry.links)
      link.together = is_same_epoch &&
                      (old != nullptr || find_entry(before->manifest, link.key) != nullptr) &&
                      (old == nullptr || border_in(old->links, link.key) != link.border);
  }
  if (!is_same_epoch || kept != manifest.entries.size() || kept != before->manifest.entries.size()) return;
  manifest.revision = before->manifest.revision;
  manifest.next_group = group;
}

bool are_same(const QualityRequest& a, const QualityRequest& b) noexcept {
  const auto is_same = [](const std::optional<QualityBound>& x, const std::optional<QualityBound>& y) {
    return x.has_value() == y.has_value() && (!x || (x->value == y->value && x->unit == y->unit));
  };
  return is_same(a.vde, b.vde) && is_same(a.lfe, b.lfe) && is_same(a.max_error, b.max_error);
}

/// The positions of `mesh` relative to `origin`; none where they are already, or where that would round more
/// of them than readers do: an origin as near to the mesh's as the mesh is large.
Mesh moved_to(const std::array<double, 3>& origin, const MeshView& mesh) {
  Mesh moved;
  if (origin == mesh.origin) return moved;
  const Box box = box_of(mesh.positions);
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::fabs(mesh.origin[k] - origin[k]) <= 16 * box.longest_side())) return moved;
  moved.origin = origin;
  moved.positions.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    moved.positions.push_back(
        static_cast<float>(mesh.origin[i % 3] + double{mesh.positions[i]} - origin[i % 3]));
  return moved;
}

MeshView with_positions_of(const Mesh& moved, MeshView mesh) {
  mesh.origin = moved.origin;
  mesh.positions = moved.positions;
  return mesh;
}

Result<MapState> encode_as(std::span<const MapPart> parts, MapDescription description,
                           const PartQuality& quality, const MapState* before) {
  const std::vector<MapPart> finest = finest_of(parts);
  if (before != nullptr && share_lattice(description, before->manifest.description)) {
    description = before->manifest.description;
  } else {
    description.epoch = before != nullptr ? before->manifest.description.epoch + 1 : 0;
    if (finest.size() > 1) {
      DELTAMESH_TRY(description, with_primers(std::move(description), finest, quality));
    }
  }
  DELTAMESH_TRY(const MapCodec codec, MapCodec::open(std::move(description)));
  DELTAMESH_TRY(MapState state, code_parts(codec, parts, finest, quality));
  number_versions(parts, before, state);
  return state;
}

}  // namespace

Result<MapState> encode_map(const MeshView& mesh, const MapSettings& settings,
                            const MapState* before) noexcept {
  return guarded([&]() -> Result<MapState> {
    DELTAMESH_CHECK(validate(settings));
    DELTAMESH_CHECK(check_mesh(mesh));
    PartQuality quality = settings.quality;
    const QualityRequest asked = before != nullptr && quality.bounds.empty() ? before->asked : quality.bounds;
    const bool keeps = before != nullptr && !before->bounds.empty() && are_same(asked, before->asked);
    quality.bounds = keeps ? before->bounds
                     : mesh.triangles.empty()
                         ? QualityRequest{.max_error = QualityBound{settings.part_edge / 1024}}
                         : request_of(mesh, asked);
    ColorContent content;
    DELTAMESH_CHECK(content.add(mesh));
    quality.attributes = content.complete(std::move(quality.attributes));
    const Mesh moved =
        before != nullptr ? moved_to(before->manifest.description.lattice.origin, mesh) : Mesh();
    const MeshView placed = moved.positions.empty() ? mesh : with_positions_of(moved, mesh);
    const std::optional<VoxelGrid> grid = grid_of(placed, before);
    const auto describe = [&](int finer) {
      return describe_map(placed, grid, settings, quality.bounds, finer);
    };
    DELTAMESH_TRY(MapDescription description, describe(0));
    int finer = before != nullptr ? steps_finer(before->manifest.description, description) : 0;
    if (finer > 0) {
      DELTAMESH_TRY(description, describe(finer));
    }
    SplitOptions options{.most_triangles = settings.most_triangles, .most_level = kLevelsOfParts};
    if (settings.levels > 0) options.copy_level = static_cast<std::uint8_t>(kLevelsOfParts + settings.levels);
    for (;;) {
      DELTAMESH_TRY(const auto parts, split(placed, description, options));
      auto state = encode_as(parts, description, quality, before);
      if (state && (keeps || !mesh.triangles.empty())) state->bounds = quality.bounds;
      if (state) state->asked = asked;
      if (state) state->attributes = quality.attributes;
      if (!state && state.error().code == ErrorCode::kLimitExceeded && options.most_triangles > 1) {
        options.most_triangles /= 2;
      } else if (!state && state.error().code == ErrorCode::kUnmetRequest && finer < kMostFiner) {
        auto described = describe(++finer);
        if (!described) return state;
        description = *std::move(described);
      } else {
        return state;
      }
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
    keys.reserve(entries.size());
    for (const PartEntry& entry : entries) keys.push_back(entry.key);
    if (level > top_level(keys))
      return Error{.code = ErrorCode::kInvalidArgument,
                   .message = "the map has no parts that show all of it on this level"};
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
