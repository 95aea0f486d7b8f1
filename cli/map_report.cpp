// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map_report.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "console.h"
#include "deltamesh/map/description.h"

namespace deltamesh::cli {
namespace {

struct Totals {
  std::uint64_t bytes = 0;
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t most = 0;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  double max_error = 0;
};

Totals totals_of(const MapManifest& manifest) {
  Totals totals;
  for (const PartEntry& entry : manifest.entries) {
    totals.bytes += entry.bytes;
    totals.least = std::min(totals.least, entry.bytes);
    totals.most = std::max(totals.most, entry.bytes);
    totals.vertices += entry.vertices;
    totals.triangles += entry.triangles;
    totals.max_error = std::max(totals.max_error, entry.quality.max_error);
  }
  if (manifest.entries.empty()) totals.least = 0;
  return totals;
}

std::uint64_t primer_bytes(const MapDescription& description) noexcept {
  std::uint64_t bytes = 0;
  for (const MapPrimer& primer : description.primers) bytes += primer.stream.size() + primer.border.size();
  return bytes;
}

}  // namespace

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

void print_map(const std::string& headline, const MapManifest& manifest) {
  const MapDescription& description = manifest.description;
  const Totals totals = totals_of(manifest);
  Summary summary(headline);
  summary.add("map", std::to_string(description.id) + " in frame " + description.frame + ", epoch " +
                         std::to_string(description.epoch) + ", revision " +
                         std::to_string(manifest.revision));
  summary.add("lattice", "2^" + std::to_string(description.lattice.step_exponent) + " = " +
                             brief(description.lattice.step()));
  summary.add("smallest cell", brief(description.cell_steps * description.lattice.step()));
  std::string parts = grouped(manifest.entries.size());
  if (!manifest.entries.empty())
    parts += " of " + grouped(totals.least) + " to " + counted(totals.most, "byte", "bytes") + ", mean " +
             grouped(totals.bytes / manifest.entries.size());
  summary.add("parts", parts);
  summary.add("vertices", grouped(totals.vertices) + ", those of borders in each of their parts");
  summary.add("triangles", grouped(totals.triangles));
  summary.add("bytes", grouped(totals.bytes + primer_bytes(description)) + ", of which " +
                           grouped(primer_bytes(description)) + " are primers");
  summary.add("max error", brief(totals.max_error));
  summary.print();
}

nlohmann::ordered_json map_object(const MapManifest& manifest) {
  const MapDescription& description = manifest.description;
  const Totals totals = totals_of(manifest);
  nlohmann::ordered_json object;
  object["map_id"] = description.id;
  object["frame"] = description.frame;
  object["epoch"] = description.epoch;
  object["revision"] = manifest.revision;
  object["origin"] = description.lattice.origin;
  object["lattice_step"] = description.lattice.step();
  object["cell_edge"] = description.cell_steps * description.lattice.step();
  object["parts"] = manifest.entries.size();
  object["part_bytes"] = totals.bytes;
  object["primer_bytes"] = primer_bytes(description);
  object["vertices"] = totals.vertices;
  object["triangles"] = totals.triangles;
  object["max_error"] = totals.max_error;
  return object;
}

}  // namespace deltamesh::cli
