// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Large pages that the arrays of one call pass on to each other, instead of each having its own from the
// system: to have a page mapped and cleared costs more than to fill it.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace deltamesh {

/// As long as one lives, it gives the large arrays [LargeAllocator] of the thread that made it their memory,
/// the last one made before the others, and those of threads that a ThreadTeam made meanwhile. They must be
/// freed by these threads, before it goes; a team that is older must not be given work meanwhile.
class MemoryPool {
 public:
  /// `bytes`: what the arrays are thought to take up at a time. At once it is more likely to be memory that
  /// this process has had before than in pieces, each of which the system would clear.
  explicit MemoryPool(std::size_t bytes = 0);
  ~MemoryPool();
  MemoryPool(const MemoryPool&) = delete;
  MemoryPool& operator=(const MemoryPool&) = delete;

  /// Of this thread; or null.
  static MemoryPool* current() noexcept { return current_; }

  /// This thread, which has none of its own, shares `pool` until it ends; null for none.
  static void share(MemoryPool* pool) noexcept { current_ = pool; }

  /// At least `bytes`, not cleared; throws std::bad_alloc. O(blocks).
  void* allocate(std::size_t bytes);

  /// False where the memory is not from here. O(blocks).
  bool free(void* memory) noexcept;

  /// Gives back what came from the system at once and nobody uses.
  void release_idle() noexcept;

  /// The same for every large page that nobody uses: the pool is to grow no more.
  void release_pages() noexcept;

 private:
  /// Part of a chunk, up to the next block.
  struct Block {
    std::byte* begin;
    bool is_free;
  };
  /// What came from the system at once. No two free blocks follow each other.
  struct Chunk {
    std::byte* begin;
    std::byte* end;
    std::vector<Block> blocks;

    std::size_t size_of(std::size_t block) const noexcept;
    bool is_free() const noexcept { return blocks.size() == 1 && blocks[0].is_free; }
  };

  Chunk& add_chunk(std::size_t bytes);
  void* take(Chunk& chunk, std::size_t block, std::size_t bytes);
  void release_idle_chunks() noexcept;

  static thread_local MemoryPool* current_;

  MemoryPool* outer_;
  std::mutex mutex_;  ///< of the chunks
  std::vector<Chunk> chunks_;
};

}  // namespace deltamesh
