// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Triangle soups of every awkward kind, for tests that need faces but no positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace deltamesh::test {

using Indices = std::vector<std::uint32_t>;

/// The same numbers on every platform.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(engine_() % bound); }

 private:
  std::mt19937 engine_;
};

struct Soup {
  std::string name;
  Indices triangles;
  std::uint32_t vertex_count = 0;
};

/// `faces` faces over `vertices` vertices, any three: degenerate, duplicate and crowded edges when few.
inline Soup random_soup(std::uint32_t seed, std::uint32_t vertices, std::uint32_t faces) {
  Random random(seed);
  Soup soup{"random_" + std::to_string(seed), Indices(std::size_t{faces} * 3), vertices};
  for (std::uint32_t& v : soup.triangles) v = random.below(vertices);
  return soup;
}

/// A grid of `width` x `height` cells, wrapped around in either direction on request (both: a torus). About
/// one cell in `hole` is missing (0: none), diagonals follow `seed`.
inline Soup grid(std::uint32_t width, std::uint32_t height, bool wrap_x, bool wrap_y, std::uint32_t hole,
                 std::uint32_t seed) {
  Random random(seed);
  const std::uint32_t columns = wrap_x ? width : width + 1;
  const std::uint32_t rows = wrap_y ? height : height + 1;
  Soup soup{"grid_" + std::to_string(width) + "_" + std::to_string(height) + "_" + std::to_string(hole),
            {},
            columns * rows};
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return (y % rows) * columns + x % columns; };
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      if (hole != 0 && random.below(hole) == 0) continue;
      const std::uint32_t a = at(x, y);
      const std::uint32_t b = at(x + 1, y);
      const std::uint32_t c = at(x + 1, y + 1);
      const std::uint32_t d = at(x, y + 1);
      const Indices cell = random.below(2) == 0 ? Indices{a, b, c, a, c, d} : Indices{a, b, d, b, c, d};
      soup.triangles.insert(soup.triangles.end(), cell.begin(), cell.end());
    }
  }
  return soup;
}

/// `blades` faces around vertex 0; closed into a full turn on request.
inline Soup fan(std::uint32_t blades, bool closed) {
  Soup soup{"fan_" + std::to_string(blades), {}, blades + 2};
  for (std::uint32_t i = 0; i < blades; ++i) {
    const std::uint32_t last = closed && i + 1 == blades ? 1 : i + 2;
    for (const std::uint32_t v : {0U, i + 1, last}) soup.triangles.push_back(v);
  }
  return soup;
}

inline Soup moebius_strip(std::uint32_t length) {
  Soup soup{"moebius", {}, 2 * length};
  for (std::uint32_t i = 0; i < length; ++i) {
    const bool last = i + 1 == length;
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * i + 1;
    const std::uint32_t c = last ? 1 : a + 2;
    const std::uint32_t d = last ? 0 : b + 2;
    for (const std::uint32_t v : {a, b, c, b, d, c}) soup.triangles.push_back(v);
  }
  return soup;
}

/// Every face twice, once per orientation.
inline Soup two_sided(Soup soup) {
  soup.name += "_two_sided";
  for (std::size_t f = 0, m = soup.triangles.size() / 3; f < m; ++f) {
    for (const std::size_t k : {0U, 2U, 1U}) soup.triangles.push_back(soup.triangles[3 * f + k]);
  }
  return soup;
}

/// Faces in another order and rotation, a share of them flipped, vertices renumbered.
inline Soup shuffled(Soup soup, std::uint32_t seed, std::uint32_t flip_one_in) {
  Random random(seed);
  soup.name += "_shuffled";
  Indices number(soup.vertex_count);
  for (std::uint32_t v = 0; v < soup.vertex_count; ++v) number[v] = v;
  for (std::uint32_t v = soup.vertex_count; v > 1; --v) std::swap(number[v - 1], number[random.below(v)]);
  for (std::uint32_t& v : soup.triangles) v = number[v];
  for (std::size_t f = soup.triangles.size() / 3; f > 1; --f) {
    const std::size_t g = random.below(static_cast<std::uint32_t>(f));
    for (std::size_t k = 0; k < 3; ++k)
      std::swap(soup.triangles[3 * (f - 1) + k], soup.triangles[3 * g + (k + f) % 3]);
  }
  for (std::size_t i = 0; i < soup.triangles.size(); i += 3) {
    if (flip_one_in != 0 && random.below(flip_one_in) == 0)
      std::swap(soup.triangles[i], soup.triangles[i + 1]);
  }
  return soup;
}

inline std::vector<Soup> awkward_soups() {
  std::vector<Soup> soups = {
      {"empty", {}, 0},
      {"no_faces", {}, 5},
      {"one_face", {0, 1, 2}, 3},
      {"unreferenced_between", {1, 3, 5}, 7},
      {"degenerate", {0, 0, 0, 1, 1, 2, 2, 1, 2, 1, 2, 3}, 4},
      {"duplicates", {0, 1, 2, 0, 1, 2, 1, 2, 0, 2, 1, 0}, 3},
      {"bubble", {0, 1, 2, 2, 1, 0}, 3},
      {"tetrahedron", {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}, 4},
      {"bow_tie", {0, 1, 2, 0, 3, 4}, 5},
      {"three_at_an_edge", {0, 1, 2, 1, 0, 3, 0, 1, 4}, 5},
      {"same_direction", {0, 1, 2, 0, 1, 3}, 4},
      {"tetrahedra_sharing_a_vertex",
       {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 5, 4, 0, 4, 6, 4, 5, 6, 5, 0, 6},
       7},
      {"tetrahedra_sharing_an_edge",
       {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 4, 1, 0, 1, 5, 1, 4, 5, 4, 0, 5},
       6},
  };
  soups.push_back(fan(1000, false));
  soups.push_back(fan(1000, true));
  soups.push_back(two_sided(fan(40, true)));
  soups.push_back(moebius_strip(3));
  soups.push_back(moebius_strip(20));
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    soups.push_back(grid(12, 9, false, false, 0, seed));
    soups.push_back(grid(20, 20, false, false, 4, seed));
    soups.push_back(grid(30, 30, false, false, 2, seed));
    soups.push_back(grid(9, 5, true, true, 0, seed));
    soups.push_back(grid(2, 2, true, true, 0, seed));
    soups.push_back(grid(16, 16, true, true, 5, seed));
    soups.push_back(two_sided(grid(10, 10, true, false, 6, seed)));
    soups.push_back(shuffled(grid(40, 40, true, true, 9, seed), seed, 0));
    soups.push_back(shuffled(grid(40, 40, true, true, 0, seed), seed, 50));
    soups.push_back(shuffled(moebius_strip(15), seed, 3));
  }
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    soups.push_back(random_soup(seed, 3 + seed % 7, 5 + seed));
    soups.push_back(random_soup(100 + seed, 20 + seed, 40));
    soups.push_back(random_soup(200 + seed, 5 + 3 * seed, 300));
  }
  return soups;
}

}  // namespace deltamesh::test
