// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What an update takes is in proportion to its blocks, not to the map.
#include <gtest/gtest.h>

#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "support/counted_memory.h"

namespace deltamesh::map_update_cost_test {
namespace {

/// A sender of a plain of `count` x `count` blocks of 18 triangles.
struct Plain {
  explicit Plain(int count) {
    MapDescription description{.cell_steps = 64};
    description.lattice.step_exponent = -6;
    sender.emplace(*MapSender::make(description, {.split = {.most_triangles = 300}}));
    std::vector<Mesh> meshes;
    for (int i = 0; i < count * count; ++i) meshes.push_back(block(i / count, i % count, 0));
    std::vector<MapBlock> blocks;
    for (int i = 0; i < count * count; ++i)
      blocks.push_back({{i / count, i % count, 0}, meshes[static_cast<std::size_t>(i)]});
    EXPECT_TRUE(sender->update(blocks));
  }

  static Mesh block(int x, int y, float height) {
    Mesh mesh;
    for (int i = 0; i < 16; ++i) {
      const bool is_inside = i / 4 % 3 != 0 && i % 4 % 3 != 0;
      for (const float k : {static_cast<float>(x) + static_cast<float>(i / 4) / 3,
                            static_cast<float>(y) + static_cast<float>(i % 4) / 3, is_inside ? height : 0.0F})
        mesh.positions.push_back(k);
    }
    for (std::uint32_t i = 0; i < 9; ++i) {
      const std::uint32_t a = i / 3 * 4 + i % 3;
      for (const std::uint32_t v : {a, a + 4, a + 1, a + 1, a + 4, a + 5}) mesh.triangles.push_back(v);
    }
    return mesh;
  }

  /// The most memory that an update of one block takes for itself.
  std::size_t memory_of_update(int x, int y, float height) {
    const Mesh mesh = block(x, y, height);
    const MapBlock changed{{x, y, 0}, mesh};
    test::most_memory_from_now();
    const std::size_t before = test::memory_taken();
    EXPECT_TRUE(sender->update(std::span(&changed, 1)));
    return test::most_memory() - before;
  }

  std::optional<MapSender> sender;
};

TEST(MapUpdateCost, AnUpdateTakesMemoryForItsBlocksNotForTheMap) {
  Plain small(10);
  Plain large(60);
  const std::size_t most = small.memory_of_update(5, 5, 0.25F);
  EXPECT_LT(large.memory_of_update(5, 5, 0.25F), 2 * most + 10'000);
  EXPECT_LT(large.memory_of_update(50, 31, 0.25F), 2 * most + 10'000);
}

TEST(MapUpdateCost, ManyUpdatesTakeNoMoreMemoryThanFew) {
  Plain plain(12);
  std::size_t before = 0;
  for (int i = 0; i < 600; ++i) {
    (void)plain.memory_of_update(i % 12, i / 5 % 12, static_cast<float>(i % 7) / 8);
    if (i == 300) before = test::memory_taken();
  }
  EXPECT_LT(test::memory_taken(), before + before / 50);
}

}  // namespace
}  // namespace deltamesh::map_update_cost_test
