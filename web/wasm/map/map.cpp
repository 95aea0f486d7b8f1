// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Exports for maps on disk: what the manifest says, and parts one by one. Outcomes live until the next call.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "deltamesh/map/folder.h"
#include "deltamesh/map/map_codec.h"
#include "map_outcome.h"
#include "mesh_outcome.h"
#include "runtime.h"

namespace deltamesh::web {
namespace {

struct OpenMap {
  MapCodec codec;
  std::vector<PartEntry> entries;
  std::vector<PartOutcome> parts;
};
std::optional<OpenMap> map;
MapOutcome map_outcome;

struct KeptPart {
  MapPart part;
  MeshOutcome mesh;
};
std::optional<KeptPart> kept;

std::uint32_t low_of(std::uint64_t value) noexcept { return static_cast<std::uint32_t>(value); }
std::uint32_t high_of(std::uint64_t value) noexcept { return static_cast<std::uint32_t>(value >> 32); }

PartOutcome outcome_of(const PartEntry& entry, bool is_finest) {
  PartOutcome part{.quality = {entry.quality.vde_rms, entry.quality.lfe_rms, entry.quality.max_error},
                   .level = entry.key.level,
                   .cell = {entry.key.x, entry.key.y, entry.key.z},
                   .revision = {low_of(entry.revision), high_of(entry.revision)},
                   .hash = {low_of(entry.hash), high_of(entry.hash)},
                   .bytes = entry.bytes,
                   .vertices = entry.vertices,
                   .triangles = entry.triangles,
                   .is_finest = is_finest ? 1U : 0U};
  std::copy_n(entry.box_min.data(), 3, part.box);
  std::copy_n(entry.box_max.data(), 3, part.box + 3);
  return part;
}

std::vector<PartOutcome> outcomes_of(const std::vector<PartEntry>& entries) {
  std::vector<PartKey> keys;
  for (const PartEntry& entry : entries) keys.push_back(entry.key);
  const std::vector<PartKey> finest = keys_on_level(keys, 0);
  std::vector<PartOutcome> parts;
  for (const PartEntry& entry : entries)
    parts.push_back(outcome_of(entry, std::binary_search(finest.begin(), finest.end(), entry.key)));
  return parts;
}

}  // namespace

extern "C" {

/// Of the manifest's `bytes` at `manifest`.
DELTAMESH_EXPORT(openMap) MapOutcome* open_map(const std::byte* manifest, std::size_t bytes) {
  map.reset();
  map_outcome = {};
  auto read = read_manifest({manifest, bytes});
  if (!read) {
    map_outcome.error = outcome_of(read.error());
    return &map_outcome;
  }
  std::copy_n(read->description.lattice.origin.data(), 3, map_outcome.origin);
  std::erase_if(read->entries, [](const PartEntry& entry) { return entry.bytes == 0; });
  auto codec = MapCodec::open(std::move(read->description));
  if (!codec) {
    map_outcome.error = outcome_of(codec.error());
    return &map_outcome;
  }
  map.emplace(OpenMap{*std::move(codec), std::move(read->entries), {}});
  map->parts = outcomes_of(map->entries);
  map_outcome.part_count = low_of(map->parts.size());
  map_outcome.parts = map->parts.data();
  return &map_outcome;
}

/// Of the `bytes` at `octets`, which are those of the map's part `number`.
DELTAMESH_EXPORT(decodePart)
StreamOutcome* decode_part(std::uint32_t number, const std::byte* octets, std::size_t bytes) {
  kept.emplace();
  auto part = map->codec.decode(map->entries[number].key, {octets, bytes});
  if (!part) {
    kept->mesh.outcome.error = outcome_of(part.error());
    return &kept->mesh.outcome;
  }
  kept->part = *std::move(part);
  kept->mesh.describe(kept->part.mesh);
  return &kept->mesh.outcome;
}

/// Frees the last part.
DELTAMESH_EXPORT(forget) void forget() { kept.reset(); }

}  // extern "C"
}  // namespace deltamesh::web
