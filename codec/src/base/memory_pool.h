// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Large pages that the arrays of one call, and of the next ones, pass on to each other, instead of each
// having its own from the system: to have a page mapped and cleared costs more than to fill it.
#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "base/machine.h"

namespace deltamesh {

/// Gives large arrays [LargeAllocator] their memory where a PoolScope says so. They must be freed before it
/// goes.
class MemoryPool {
 public:
  MemoryPool() = default;
  ~MemoryPool();
  MemoryPool(const MemoryPool&) = delete;
  MemoryPool& operator=(const MemoryPool&) = delete;

  /// Of this thread; or null.
  static MemoryPool* current() noexcept { return kHasMemoryPool ? current_ : nullptr; }

  /// This thread, which has none of its own, shares `pool` until it ends; null for none.
  static void share(MemoryPool* pool) noexcept { current_ = pool; }

  /// Before there are arrays, which are thought to take up `bytes` at a time. If it has not as much at once,
  /// it gets it in place of what it has: at once it is more likely to be memory that this process has had
  /// before than in pieces, each of which the system would clear. Throws std::bad_alloc.
  void prepare(std::size_t bytes);

  /// Whether it has no memory.
  bool is_empty() const noexcept { return chunks_.empty(); }

  /// At least `bytes`, not cleared; throws std::bad_alloc. O(blocks).
  void* allocate(std::size_t bytes);

  /// False where the memory is not from here. O(blocks).
  bool free(void* memory) noexcept;

  /// Gives large pages that nobody uses back to the system, up to `bytes` of them beside those that it has
  /// given back since prepare(), those first that are likely to have been in use. They stay the pool's, but
  /// are cleared when they are used again.
  void give_back(std::size_t bytes) noexcept;

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

    std::size_t size() const noexcept { return static_cast<std::size_t>(end - begin); }
    std::size_t size_of(std::size_t block) const noexcept;
    bool is_free() const noexcept { return blocks.size() == 1 && blocks[0].is_free; }
    void release() const noexcept;
  };

  Chunk& add_chunk(std::size_t bytes);
  std::byte* take_block(std::size_t bytes);
  std::byte* take(Chunk& chunk, std::size_t block, std::size_t bytes);
  void release_idle_chunks() noexcept;

  friend class PoolScope;

  static thread_local MemoryPool* current_;

  std::mutex mutex_;  ///< of the chunks
  std::vector<Chunk> chunks_;
  std::size_t given_back_ = 0;  ///< bytes, since prepare()
};

/// As long as one lives, the large arrays of the thread that made it have their memory from `pool`, the scope
/// made last before the others, and those of threads that a ThreadTeam made meanwhile. They must be freed by
/// these threads, before it goes; a team that is older must not be given work meanwhile.
class PoolScope {
 public:
  explicit PoolScope(MemoryPool& pool) noexcept : outer_(std::exchange(MemoryPool::current_, &pool)) {}
  ~PoolScope() { MemoryPool::current_ = outer_; }
  PoolScope(const PoolScope&) = delete;
  PoolScope& operator=(const PoolScope&) = delete;

 private:
  MemoryPool* outer_;
};

}  // namespace deltamesh
