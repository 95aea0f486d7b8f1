// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "corners.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "positions.h"

namespace deltamesh::gltf {
namespace {

/// Whether two vertices are at one place and nothing that may move them tells them apart.
bool stay_together(const AccessorStore& store, const PrimitiveSource& source, std::uint32_t a,
                   std::uint32_t b) {
  if (a == b) return true;
  const AccessorRows& positions = store.rows(source.position);
  return position_of(positions, a) == position_of(positions, b) &&
         std::ranges::all_of(source.attributes, [&](const SourceAttribute& attribute) {
           if (is_look(attribute.semantic)) return true;
           const AccessorRows& rows = store.rows(attribute.accessor);
           return std::ranges::equal(rows.row(a), rows.row(b));
         });
}

/// A strip or a fan as a list, each triangle turned as glTF says.
std::vector<std::uint32_t> as_list(const std::vector<std::uint32_t>& path, TriangleMode mode) {
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i + 2 < path.size(); ++i) {
    if (mode == TriangleMode::kFan)
      corners.insert(corners.end(), {path[i + 1], path[i + 2], path[0]});
    else
      corners.insert(corners.end(), {path[i], path[i + 1 + i % 2], path[i + 2 - i % 2]});
  }
  return corners;
}

}  // namespace

Result<std::vector<std::uint32_t>> read_corners(const AccessorStore& store, const PrimitiveSource& source) {
  const std::uint64_t vertices = store.rows(source.position).shape().count;
  if (vertices > ~std::uint32_t{0})
    return Error{.code = ErrorCode::kLimitExceeded,
                 .message = "a primitive with more vertices than an index can number",
                 .where_kind = WhereKind::kElement,
                 .where = source.number};
  const bool is_list = source.mode == TriangleMode::kList;
  const auto whole = [&](std::uint64_t count) {
    return static_cast<std::size_t>(is_list ? count / 3 * 3 : count);
  };
  std::vector<std::uint32_t> corners;
  if (source.indices) {
    const AccessorRows& rows = store.rows(*source.indices);
    corners.resize(whole(rows.shape().count));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] = read_index(rows.row(i));
      if (corners[i] >= vertices)
        return element_error("a vertex index beyond the primitive's vertices", source.number);
    }
  } else {
    corners.resize(whole(vertices));
    std::iota(corners.begin(), corners.end(), 0U);
  }
  return is_list ? corners : as_list(corners, source.mode);
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
