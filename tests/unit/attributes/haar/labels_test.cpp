// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of labels are told from those of photographs.
#include "attributes/colors/labels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "haar/meshes.h"

namespace deltamesh::haar_test {
namespace {

using Levels = std::vector<std::uint8_t>;

bool labels(const Levels& colors, const Adjacency& graph) {
  return are_labels(count_color_edges(colors, 3, graph));
}

/// A surface and the label of every vertex: the nearest of some seeds.
struct Labelled {
  Labelled(std::uint64_t seed, std::uint32_t count) : mesh(rooms(6000, seed)), graph(mesh.surface().graph()) {
    test::RandomBits random(static_cast<std::uint32_t>(seed));
    std::vector<std::uint32_t> seeds(count);
    for (std::uint32_t& s : seeds) s = random() % mesh.count;
    for (std::uint32_t v = 0; v < mesh.count; ++v) {
      std::uint32_t best = 0;
      double least = 1e300;
      for (std::uint32_t k = 0; k < count; ++k) {
        double distance = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double way = mesh.positions[3 * v + axis] - mesh.positions[3 * seeds[k] + axis];
          distance += way * way;
        }
        if (distance >= least) continue;
        least = distance;
        best = k;
      }
      label.push_back(best);
    }
  }

  Levels painted(const Levels& palette) const {
    Levels colors;
    for (const std::uint32_t k : label)
      colors.insert(colors.end(), palette.begin() + 3 * k, palette.begin() + 3 * k + 3);
    return colors;
  }
  /// Each colour is the mean of those around and itself.
  Levels blended(const Levels& colors) const {
    Levels result;
    for (std::uint32_t v = 0; v < mesh.count; ++v) {
      for (std::size_t c = 0; c < 3; ++c) {
        std::uint32_t sum = colors[3 * v + c];
        for (const std::uint32_t u : graph.of(v)) sum += colors[3 * u + c];
        result.push_back(static_cast<std::uint8_t>(sum / (1 + graph.degree(v))));
      }
    }
    return result;
  }

  Colored mesh;
  Adjacency graph;
  std::vector<std::uint32_t> label;
};

Levels random_palette(std::uint32_t count, std::uint32_t seed) {
  test::RandomBits random(seed);
  Levels palette(std::size_t{3} * count);
  for (std::uint8_t& x : palette) x = static_cast<std::uint8_t>(random());
  return palette;
}

TEST(ColorLabels, CountsEdgesByTheirDifference) {
  const test::GraphMesh mesh = test::sheet(2, 2);  // 5 edges
  const Levels colors = {10, 10, 10, 10, 10, 10, 10, 18, 10, 10, 10, 60};
  const ColorEdges edges = count_color_edges(colors, 3, mesh.graph);
  EXPECT_EQ(edges.equal, 1U);
  EXPECT_EQ(edges.near, 2U);
  EXPECT_EQ(edges.far, 2U);
}

TEST(ColorLabels, SharesOfEqualAndNearEdgesDecide) {
  EXPECT_TRUE(are_labels({.equal = 0, .near = 0, .far = 0}));
  EXPECT_TRUE(are_labels({.equal = 61, .near = 30, .far = 0}));
  EXPECT_FALSE(are_labels({.equal = 60, .near = 30, .far = 0}));
  EXPECT_TRUE(are_labels({.equal = 0, .near = 15, .far = 21}));
  EXPECT_FALSE(are_labels({.equal = 0, .near = 15, .far = 20}));
}

TEST(ColorLabels, LabelMapsStayExact) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const std::uint32_t count : {10U, 100U, 600U}) {
      const Labelled map(seed, count);
      const std::string name = std::to_string(seed) + " " + std::to_string(count);
      const Levels plain = map.painted(random_palette(count, 5));
      EXPECT_TRUE(labels(plain, map.graph)) << name;
      Levels ids;
      for (std::uint32_t k = 0; k < count; ++k)
        for (const std::uint32_t part : {k % 256, k / 256, 0U})
          ids.push_back(static_cast<std::uint8_t>(part));
      EXPECT_TRUE(labels(map.painted(ids), map.graph)) << name;
      EXPECT_TRUE(labels(map.blended(plain), map.graph)) << name;
      EXPECT_TRUE(labels(map.blended(map.blended(plain)), map.graph)) << name;
      Levels noisy = plain;
      test::RandomBits random(9);
      for (std::uint32_t v = 0; v < map.mesh.count; v += 1 + random() % 99) noisy[3 * v] ^= 0x55;
      EXPECT_TRUE(labels(noisy, map.graph)) << name;
    }
  }
}

TEST(ColorLabels, TexturesAreNoLabels) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Colored mesh = rooms(6000, seed);
    const Adjacency graph = mesh.surface().graph();
    for (const double grain : {1.0, 5.0, 10.0}) {
      for (const double wave : {0.5, 1.0, 2.0}) {
        test::RandomBits random(11);
        Levels colors;
        for (std::uint32_t v = 0; v < mesh.count; ++v) {
          const float* p = &mesh.positions[3 * v];
          for (std::size_t c = 0; c < 3; ++c) {
            const double smooth =
                std::sin(wave * static_cast<double>(p[0]) + static_cast<double>(c)) +
                std::sin(wave * static_cast<double>(p[1])) * std::cos(static_cast<double>(p[2]));
            const double noise = grain * ((random() % 1024) / 512.0 - 1);
            colors.push_back(static_cast<std::uint8_t>(128 + 40 * smooth + noise));
          }
        }
        EXPECT_FALSE(labels(colors, graph)) << seed << " " << grain << " " << wave;
      }
    }
  }
}

}  // namespace
}  // namespace deltamesh::haar_test
