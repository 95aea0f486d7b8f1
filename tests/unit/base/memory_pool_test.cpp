// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/memory_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  MemoryPool pool;
  EXPECT_TRUE(pool.is_empty());
  pool.prepare(std::size_t{3} << 20);
  EXPECT_FALSE(pool.is_empty());
  auto* const first = static_cast<std::byte*>(pool.allocate(std::size_t{1} << 20));
  auto* const second = static_cast<std::byte*>(pool.allocate(std::size_t{2} << 20));
  EXPECT_EQ(second - first, std::ptrdiff_t{1} << 20);
  EXPECT_TRUE(pool.free(first));
  EXPECT_TRUE(pool.free(second));
  EXPECT_EQ(pool.allocate(std::size_t{3} << 20), first);
}

TEST(MemoryPool, KeepsItsMemoryUntilMoreIsNeeded) {
  constexpr std::size_t kSize = std::size_t{6} << 20;
  MemoryPool pool;
  pool.prepare(kSize);
  void* const first = pool.allocate(kSize);
  EXPECT_TRUE(pool.free(first));
  for (const std::size_t size : {kSize, kSize / 8, kSize}) {
    pool.prepare(size);
    EXPECT_EQ(pool.allocate(size), first);
    EXPECT_TRUE(pool.free(first));
  }
  pool.prepare(4 * kSize);
  auto* const larger = static_cast<std::byte*>(pool.allocate(3 * kSize));
  auto* const after = static_cast<std::byte*>(pool.allocate(kSize));
  EXPECT_EQ(after - larger, std::ptrdiff_t{3 * kSize});
}

#if defined(__linux__)
/// Pages that the system had back are cleared.
TEST(MemoryPool, GivesBackAsMuchAsIsAskedFor) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  constexpr std::size_t kSize = 8 * kPage;
  MemoryPool pool;
  pool.prepare(kSize);
  void* const memory = pool.allocate(kSize);
  std::memset(memory, 1, kSize);
  pool.give_back(2 * kPage);  // but all is in use
  const auto* const begin = static_cast<const unsigned char*>(memory);
  EXPECT_EQ(std::count(begin, begin + kSize, 1), kSize);
  pool.prepare(kSize);
  for (const std::size_t pages : {2, 5}) {
    EXPECT_TRUE(pool.free(memory));
    pool.give_back(pages == 2 ? 2 * kPage : 3 * kPage);
    ASSERT_EQ(pool.allocate(kSize), memory);
    EXPECT_EQ(std::count(begin, begin + kSize, 0), pages * kPage);
  }
}
#endif

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
    const PoolScope outer_scope(outer);
    LargeVector<std::uint32_t> kept(1000000, 6);
    {
      MemoryPool inner;
      const PoolScope inner_scope(inner);
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
