// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Parts that show a whole map, of one level or of several.
#pragma once

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "deltamesh/map/part.h"
#include "map/map_meshes.h"

namespace deltamesh::test {

/// How many edges have an odd number of faces.
inline std::size_t odd_edges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  const Mesh whole = welded(mesh);
  for (std::size_t i = 0; i < whole.triangles.size(); ++i)
    ++edges[std::minmax(whole.triangles[i], whole.triangles[i % 3 == 2 ? i - 2 : i + 1])];
  return static_cast<std::size_t>(
      std::ranges::count_if(edges, [](const auto& edge) { return edge.second % 2 == 1; }));
}

inline std::vector<PartKey> keys_of(const std::vector<MapPart>& parts) {
  std::vector<PartKey> keys;
  for (const MapPart& part : parts) keys.push_back(part.key);
  return keys;
}

inline std::vector<MapPart> chosen(const std::vector<MapPart>& parts, const std::vector<PartKey>& keys) {
  std::vector<MapPart> some;
  for (const MapPart& part : parts)
    if (std::ranges::binary_search(keys, part.key)) some.push_back(part);
  return some;
}

/// Parts that show the whole map, each of any level.
inline std::vector<PartKey> random_cover(const std::vector<MapPart>& parts, std::mt19937& random) {
  std::vector<PartKey> cover;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    const bool is_finest = std::ranges::none_of(parts, [&](const MapPart& other) {
      return other.key.level < part->key.level && overlap(other.key, part->key);
    });
    const bool is_covered =
        std::ranges::any_of(cover, [&](const PartKey& key) { return overlap(key, part->key); });
    if (!is_covered && (is_finest || random() % 3 == 0)) cover.push_back(part->key);
  }
  std::ranges::sort(cover);
  return cover;
}

}  // namespace deltamesh::test
