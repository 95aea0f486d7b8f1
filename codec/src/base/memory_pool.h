// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Large pages that the arrays of one call pass on to each other, instead of each having its own from the
// system: to have a page mapped and cleared costs more than to fill it.
#pragma once

#include <cstddef>
#include <vector>

namespace deltamesh {

/// As long as one lives, it gives the large arrays [LargeAllocator] of the thread that made it their memory,
/// the last one made before the others. They must be freed by that thread, before it goes.
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

  /// At least `bytes`, not cleared; throws std::bad_alloc. O(blocks).
  void* allocate(std::size_t bytes);

  /// False where the memory is not from here. O(blocks).
  bool free(void* memory) noexcept;

  /// Gives back what nobody uses.
  void release_idle() noexcept;

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

  static thread_local MemoryPool* current_;

  MemoryPool* outer_;
  std::vector<Chunk> chunks_;
};

}  // namespace deltamesh
