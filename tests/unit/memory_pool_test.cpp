// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/memory_pool.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include "base/large_vector.h"

namespace deltamesh {
namespace {

TEST(MemoryPool, GivesWhatWasFreedBefore) {
  MemoryPool pool;
  void* const first = pool.allocate(3000000);
  void* const second = pool.allocate(100000);
  EXPECT_TRUE(pool.free(first));
  EXPECT_FALSE(pool.free(nullptr));
  EXPECT_EQ(pool.allocate(2000000), first);
  EXPECT_TRUE(pool.free(second));
}

TEST(MemoryPool, GivesPartsOfWhatItBeganWith) {
  MemoryPool pool(std::size_t{3} << 20);
  auto* const first = static_cast<std::byte*>(pool.allocate(std::size_t{1} << 20));
  auto* const second = static_cast<std::byte*>(pool.allocate(std::size_t{2} << 20));
  EXPECT_EQ(second - first, std::ptrdiff_t{1} << 20);
  EXPECT_TRUE(pool.free(first));
  EXPECT_TRUE(pool.free(second));
  EXPECT_EQ(pool.allocate(std::size_t{3} << 20), first);
}

TEST(MemoryPool, BlocksDoNotOverlap) {
  struct Held {
    unsigned char* begin;
    std::size_t size;
    unsigned char mark;
  };
  MemoryPool pool;
  std::mt19937 random(7);
  std::vector<Held> held;
  const auto is_whole = [](const Held& block) {
    return block.begin[0] == block.mark && block.begin[block.size / 2] == block.mark &&
           block.begin[block.size - 1] == block.mark;
  };
  for (int step = 0; step < 3000; ++step) {
    if (random() % 5 < 2 && !held.empty()) {
      const std::size_t i = random() % held.size();
      ASSERT_TRUE(is_whole(held[i])) << step;
      ASSERT_TRUE(pool.free(held[i].begin));
      held.erase(held.begin() + static_cast<std::ptrdiff_t>(i));
    } else if (held.size() < 40) {
      const std::size_t size = 1 + random() % (random() % 4 == 0 ? 5000000 : 200000);
      auto* const begin = static_cast<unsigned char*>(pool.allocate(size));
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(begin) % 64, 0U);
      held.push_back({begin, size, static_cast<unsigned char>(step)});
      std::memset(begin, held.back().mark, size);
    }
  }
  for (const Held& block : held) EXPECT_TRUE(is_whole(block));
}

TEST(MemoryPool, VectorsTakeTheInnermost) {
  EXPECT_EQ(MemoryPool::current(), nullptr);
  const LargeVector<std::uint32_t> before(1000000, 5);
  {
    MemoryPool outer;
    LargeVector<std::uint32_t> kept(1000000, 6);
    {
      const MemoryPool inner;
      EXPECT_EQ(MemoryPool::current(), &inner);
      const LargeVector<std::uint32_t> copy = kept;
      kept.assign(500000, 7);  // in the room it has
      EXPECT_EQ(copy[999999], 6U);
    }
    EXPECT_EQ(MemoryPool::current(), &outer);
    EXPECT_EQ(kept[499999], 7U);
  }
  EXPECT_EQ(MemoryPool::current(), nullptr);
  EXPECT_EQ(before[999999], 5U);
}

}  // namespace
}  // namespace deltamesh
