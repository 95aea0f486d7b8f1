// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/corners.h"

#include <algorithm>
#include <utility>

namespace deltamesh::gltf {
namespace {

/// Whether two vertices are at one place and nothing that may move them tells them apart.
bool stay_together(const AccessorStore& store, const PrimitiveSource& source, std::uint32_t a,
                   std::uint32_t b) {
  if (a == b) return true;
  const AccessorRows& positions = store.rows(source.position);
  return vector_at(positions, a) == vector_at(positions, b) &&
         std::ranges::all_of(source.attributes, [&](const SourceAttribute& attribute) {
           if (is_look(attribute.semantic)) return true;
           const AccessorRows& rows = store.rows(attribute.accessor);
           return std::ranges::equal(rows.row(a), rows.row(b));
         });
}

}  // namespace

Result<std::vector<std::uint32_t>> read_corners(const AccessorStore& store, const PrimitiveSource& source) {
  return triangle_corners(source, store.rows(source.position).shape().count,
                          source.indices ? &store.rows(*source.indices) : nullptr);
}

std::size_t drop_degenerate(const AccessorStore& store, const PrimitiveSource& source,
                            std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::uint32_t* c = &corners[i];
    if (stay_together(store, source, c[0], c[1]) || stay_together(store, source, c[1], c[2]) ||
        stay_together(store, source, c[2], c[0]))
      continue;
    kept.insert(kept.end(), c, c + 3);
  }
  if (kept.empty()) return 0;
  const std::size_t dropped = (corners.size() - kept.size()) / 3;
  corners = std::move(kept);
  return dropped;
}

}  // namespace deltamesh::gltf
