// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The faces over which an attribute's field is coded: those of the mesh's vertices or of the geometric
// vertices [ATTR-58].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "attributes/surface.h"
#include "positions/surroundings.h"

namespace deltamesh {

class FieldFaces {
 public:
  /// `joined`: copies of a geometric vertex are one. `surface` must outlive it.
  FieldFaces(const AttributeSurface& surface, bool joined)
      : geometric_(joined ? surface.geometric() : std::span<const std::uint32_t>()),
        faces_(geometric_.empty() ? surface.faces() : surface.joined_faces()) {}

  std::uint32_t vertex_count() const noexcept { return faces_.vertex_count(); }
  /// The geometric vertex of every vertex of the mesh; empty if the field is over the mesh's vertices.
  std::span<const std::uint32_t> geometric() const noexcept { return geometric_; }
  const KnownFaces& faces() const noexcept { return faces_; }

  /// The row of the first copy of every vertex.
  template <class Row>
  std::vector<Row> first_copies(std::span<const Row> rows) const {
    if (geometric_.empty()) return {rows.begin(), rows.end()};
    std::vector<Row> shared(vertex_count(), Row{});
    for (std::size_t v = rows.size(); v-- > 0;) shared[geometric_[v]] = rows[v];
    return shared;
  }

 private:
  std::span<const std::uint32_t> geometric_;
  const KnownFaces& faces_;
};

/// Whether most copies of a geometric vertex have the row of the copy before.
template <class Row>
bool copies_agree(std::span<const std::uint32_t> geometric, std::span<const Row> rows) noexcept {
  std::size_t copies = 0;
  std::size_t same = 0;
  for (std::size_t v = 1; v < geometric.size(); ++v) {
    if (geometric[v] != geometric[v - 1]) continue;
    ++copies;
    same += rows[v] == rows[v - 1] ? 1 : 0;
  }
  return 2 * same > copies;
}

}  // namespace deltamesh
