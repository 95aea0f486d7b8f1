// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "map/splits.h"

#include "deltamesh/map/encode_map.h"
#include "map/peers.h"
#include "report/table.h"
#include "report/text.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

std::uint64_t primer_bytes(const MapDescription& description) {
  std::uint64_t bytes = 0;
  for (const MapPrimer& primer : description.primers) bytes += primer.stream.size() + primer.border.size();
  return bytes;
}

}  // namespace

void print_splits(const std::string& name, Mesh mesh, const Bounds& bounds,
                  const std::vector<double>& part_edges, std::uint32_t most_triangles) {
  std::erase_if(mesh.attributes, [](const Attribute& a) { return a.kind != AttributeKind::kColor; });
  const auto whole = static_cast<double>(plain_block(mesh, bounds).bytes);
  MapSettings settings;
  settings.most_triangles = most_triangles;
  settings.quality.bounds.max_error = QualityBound{bounds.max_error};
  settings.quality.attributes = quality_of(bounds);
  settings.quality.effort = bounds.effort;
  for (const double edge : part_edges) {
    settings.part_edge = edge;
    const MapState state = value_or_exit(encode_map(mesh, settings));
    const std::uint64_t primers = primer_bytes(state.manifest.description);
    std::uint64_t parts = 0;
    for (const PartEntry& entry : state.manifest.entries) parts += entry.bytes;
    const auto count = static_cast<double>(state.manifest.entries.size());
    const auto bytes = static_cast<double>(parts + primers);
    print(table_row({name, fixed(whole, 0), significant(edge, 6), fixed(count, 0), fixed(bytes / count, 0),
                     number(primers), fixed(bytes / whole, 3)}));
  }
}

}  // namespace deltamesh::bench
