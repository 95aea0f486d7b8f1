// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "deltamesh/map/description.h"
#include "report/attributes.h"
#include "report/console.h"

namespace deltamesh::cli {
namespace {

struct Totals {
  std::size_t parts = 0;
  std::uint64_t bytes = 0;
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t most = 0;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  double max_error = 0;
};

/// Of the parts that show the map on a level.
Totals totals_on(const MapManifest& manifest, std::uint8_t level) {
  const auto keys = keys_on_level(keys_of(manifest), level);
  Totals totals;
  for (const PartEntry& entry : manifest.entries) {
    if (!std::ranges::binary_search(keys, entry.key)) continue;
    ++totals.parts;
    totals.bytes += entry.bytes;
    totals.least = std::min(totals.least, entry.bytes);
    totals.most = std::max(totals.most, entry.bytes);
    totals.vertices += entry.vertices;
    totals.triangles += entry.triangles;
    totals.max_error = std::max(totals.max_error, entry.quality.max_error);
  }
  if (totals.parts == 0) totals.least = 0;
  return totals;
}

bool is_color(const MapAttribute& attribute) noexcept { return attribute.kind == AttributeKind::kColor; }

/// The largest error of colours, 255ths; empty where there are none.
std::optional<double> color_error_of(const MapManifest& manifest) {
  const auto& attributes = manifest.description.attributes;
  if (std::ranges::none_of(attributes, is_color)) return std::nullopt;
  double most = 0;
  for (const PartEntry& entry : manifest.entries)
    for (std::size_t i = 0; i < attributes.size(); ++i)
      if (is_color(attributes[i])) most = std::max(most, double{entry.attribute_errors.at(i)});
  return most;
}

struct Copies {
  std::size_t parts = 0;
  std::uint64_t bytes = 0;
};

/// `finest`: what shows the map on level 0.
Copies copies_in(const MapManifest& manifest, const Totals& finest) noexcept {
  Copies copies{.parts = manifest.entries.size() - finest.parts};
  for (const PartEntry& entry : manifest.entries) copies.bytes += entry.bytes;
  copies.bytes -= finest.bytes;
  return copies;
}

/// One line for levels that the same parts show.
void add_levels(Summary& summary, const MapManifest& manifest) {
  const auto keys = keys_of(manifest);
  const int top = top_level(keys);
  for (int first = 0; first <= top;) {
    const auto parts = keys_on_level(keys, static_cast<std::uint8_t>(first));
    int last = first;
    while (last < top && keys_on_level(keys, static_cast<std::uint8_t>(last + 1)) == parts) ++last;
    const Totals shown = totals_on(manifest, static_cast<std::uint8_t>(first));
    summary.add(first == last ? "seen on level " + std::to_string(first)
                              : "seen on levels " + std::to_string(first) + " to " + std::to_string(last),
                counted(shown.parts, "part", "parts") + ", " + counted(shown.bytes, "byte", "bytes") + ", " +
                    counted(shown.triangles, "triangle", "triangles") + ", max error " +
                    brief(shown.max_error));
    first = last + 1;
  }
}

std::uint64_t primer_bytes(const MapDescription& description) noexcept {
  std::uint64_t bytes = 0;
  for (const MapPrimer& primer : description.primers) bytes += primer.stream.size() + primer.border.size();
  return bytes;
}

}  // namespace

std::vector<PartKey> keys_of(const MapManifest& manifest) {
  std::vector<PartKey> keys;
  for (const PartEntry& entry : manifest.entries) keys.push_back(entry.key);
  return keys;
}

std::string key_text(const PartKey& key) {
  return "level " + std::to_string(key.level) + ", " + std::to_string(key.x) + ' ' + std::to_string(key.y) +
         ' ' + std::to_string(key.z);
}

nlohmann::ordered_json key_object(const PartKey& key) {
  nlohmann::ordered_json object;
  object["level"] = key.level;
  object["cell"] = {key.x, key.y, key.z};
  return object;
}

void print_map(const std::string& headline, const MapManifest& manifest,
               const std::optional<MapUpdate>& update) {
  const MapDescription& description = manifest.description;
  const Totals totals = totals_on(manifest, 0);
  Summary summary(headline);
  summary.add("map", std::to_string(description.id) + " in frame " + description.frame + ", epoch " +
                         std::to_string(description.epoch) + ", revision " +
                         std::to_string(manifest.revision));
  summary.add("lattice", "2^" + std::to_string(description.lattice.step_exponent) + " = " +
                             brief(description.lattice.step()));
  if (description.grid) summary.add("grid", "voxels of " + brief_list(description.grid->edge, " x "));
  summary.add("smallest cell", brief(description.cell_steps * description.lattice.step()));
  std::string parts = grouped(totals.parts);
  if (totals.parts != 0)
    parts += " of " + grouped(totals.least) + " to " + counted(totals.most, "byte", "bytes") + ", mean " +
             grouped(totals.bytes / totals.parts);
  const Copies copies = copies_in(manifest, totals);
  if (copies.parts != 0) parts += "; and " + counted(copies.parts, "coarser copy", "coarser copies");
  summary.add("parts", parts);
  if (update)
    summary.add("new or changed", counted(update->new_parts, "part", "parts") +
                                      (copies.parts != 0 ? ", coarser copies too" : ""));
  if (update && update->mended_parts != 0)
    summary.add("mended", counted(update->mended_parts, "part", "parts"));
  summary.add("vertices", grouped(totals.vertices) + ", those of borders in each of their parts");
  summary.add("triangles", grouped(totals.triangles));
  summary.add("bytes", grouped(totals.bytes + copies.bytes + primer_bytes(description)) + ", of which " +
                           grouped(primer_bytes(description)) + " are primers" +
                           (copies.parts != 0 ? " and " + grouped(copies.bytes) + " coarser copies" : ""));
  if (update) summary.add(update->keeps_bounds ? "bounds kept" : "bounds", update->bounds);
  if (update && !update->attribute_bounds.empty())
    summary.add(update->keeps_attribute_bounds ? "attribute bounds kept" : "attribute bounds",
                update->attribute_bounds);
  summary.add("max error", brief(totals.max_error));
  if (const auto error = color_error_of(manifest))
    summary.add("colours", kept_text(AttributeKind::kColor, *error, update ? update->color_rms : 0));
  if (copies.parts != 0) add_levels(summary, manifest);
  summary.print();
}

double rounding_in_map(const Mesh& mesh, const MapDescription& description) {
  double most = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    std::array<double, 3> off{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double place = mesh.positions[3 * v + k] + (mesh.origin[k] - description.lattice.origin[k]);
      off[k] = place - double{static_cast<float>(place)};
    }
    most = std::max(most, std::hypot(off[0], off[1], off[2]));
  }
  return most;
}

nlohmann::ordered_json map_object(const MapManifest& manifest) {
  const MapDescription& description = manifest.description;
  const Totals totals = totals_on(manifest, 0);
  nlohmann::ordered_json object;
  object["map_id"] = description.id;
  object["frame"] = description.frame;
  object["epoch"] = description.epoch;
  object["revision"] = manifest.revision;
  object["origin"] = description.lattice.origin;
  object["lattice_step"] = description.lattice.step();
  if (description.grid) object["voxel"] = description.grid->edge;
  object["cell_edge"] = description.cell_steps * description.lattice.step();
  object["parts"] = totals.parts;
  object["part_bytes"] = totals.bytes;
  object["primer_bytes"] = primer_bytes(description);
  object["vertices"] = totals.vertices;
  object["triangles"] = totals.triangles;
  object["max_error"] = totals.max_error;
  if (const auto error = color_error_of(manifest)) object["color_error"] = *error;
  const Copies copies = copies_in(manifest, totals);
  if (copies.parts == 0) return object;
  object["copies"] = copies.parts;
  object["copy_bytes"] = copies.bytes;
  for (int level = 1; level <= top_level(keys_of(manifest)); ++level) {
    const Totals shown = totals_on(manifest, static_cast<std::uint8_t>(level));
    object["levels"].push_back({{"level", level},
                                {"parts", shown.parts},
                                {"part_bytes", shown.bytes},
                                {"triangles", shown.triangles},
                                {"max_error", shown.max_error}});
  }
  return object;
}

std::vector<MapDifference> map_differences(const MapManifest& before, const MapManifest& after) {
  std::vector<MapDifference> list;
  auto old = before.entries.begin();
  for (const PartEntry& entry : after.entries) {
    for (; old != before.entries.end() && old->key < entry.key; ++old) list.push_back({"removed", &*old});
    const bool is_known = old != before.entries.end() && old->key == entry.key;
    if (!is_known) list.push_back({"new", &entry});
    if (is_known && old->hash != entry.hash) list.push_back({"changed", &entry});
    if (is_known) ++old;
  }
  for (; old != before.entries.end(); ++old) list.push_back({"removed", &*old});
  return list;
}

}  // namespace deltamesh::cli
