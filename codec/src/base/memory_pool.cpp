// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/memory_pool.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/large_pages.h"
#include "base/poison.h"

namespace deltamesh {

namespace {

/// Whole large pages, but for an end of less than half a one.
constexpr std::size_t chunk_size(std::size_t bytes) noexcept {
  const std::size_t whole = (bytes + kLargePage / 2) / kLargePage * kLargePage;
  return std::max({bytes, whole, kLargePage});
}

}  // namespace

thread_local MemoryPool* MemoryPool::current_ = nullptr;

MemoryPool::~MemoryPool() {
  for (const Chunk& chunk : chunks_) chunk.release();
}

void MemoryPool::Chunk::release() const noexcept {
  allow_memory(begin, size());
  free_pages(begin);
}

void MemoryPool::prepare(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  given_back_ = 0;
  const auto is_large = [&](const Chunk& chunk) { return chunk.size() >= bytes; };
  if (std::any_of(chunks_.begin(), chunks_.end(), is_large)) return;
  release_idle_chunks();
  add_chunk(bytes);
}

std::size_t MemoryPool::Chunk::size_of(std::size_t block) const noexcept {
  const std::byte* const after = block + 1 < blocks.size() ? blocks[block + 1].begin : end;
  return static_cast<std::size_t>(after - blocks[block].begin);
}

void* MemoryPool::allocate(std::size_t bytes) {
  constexpr std::size_t kUnit = 64;  // a line of the cache
  const std::lock_guard lock(mutex_);
  std::byte* const begin = take_block((bytes + kUnit - 1) / kUnit * kUnit);
  allow_memory(begin, bytes);
  return begin;
}

/// The smallest free block that is large enough, but the end of a chunk, which may be untouched, only where
/// there is no other; or new pages, once those that nobody uses are given back, so that no more memory is
/// taken than without a pool.
std::byte* MemoryPool::take_block(std::size_t bytes) {
  Chunk* best = nullptr;
  std::size_t best_block = 0;
  std::pair<bool, std::size_t> least{true, std::numeric_limits<std::size_t>::max()};
  for (Chunk& chunk : chunks_) {
    for (std::size_t i = 0; i < chunk.blocks.size(); ++i) {
      const std::pair cost(i + 1 == chunk.blocks.size(), chunk.size_of(i));
      if (!chunk.blocks[i].is_free || cost.second < bytes || least <= cost) continue;
      best = &chunk;
      best_block = i;
      least = cost;
    }
  }
  if (best != nullptr) return take(*best, best_block, bytes);
  release_idle_chunks();
  return take(add_chunk(bytes), 0, bytes);
}

MemoryPool::Chunk& MemoryPool::add_chunk(std::size_t bytes) {
  const std::size_t size = chunk_size(bytes);
  chunks_.reserve(chunks_.size() + 1);
  Chunk chunk{.begin = nullptr, .end = nullptr, .blocks = {}};
  chunk.blocks.reserve(8);
  chunk.begin = static_cast<std::byte*>(allocate_pages(size));
  chunk.end = chunk.begin + size;
  forbid_memory(chunk.begin, size);
  chunk.blocks.push_back({chunk.begin, true});
  chunks_.push_back(std::move(chunk));
  return chunks_.back();
}

std::byte* MemoryPool::take(Chunk& chunk, std::size_t block, std::size_t bytes) {
  std::byte* const begin = chunk.blocks[block].begin;
  if (chunk.size_of(block) > bytes)
    chunk.blocks.insert(chunk.blocks.begin() + static_cast<std::ptrdiff_t>(block) + 1, {begin + bytes, true});
  chunk.blocks[block].is_free = false;
  return begin;
}

bool MemoryPool::free(void* memory) noexcept {
  const std::lock_guard lock(mutex_);
  for (Chunk& chunk : chunks_) {
    auto& blocks = chunk.blocks;
    const auto block =
        std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) { return b.begin == memory; });
    if (block == blocks.end()) continue;
    forbid_memory(memory, chunk.size_of(static_cast<std::size_t>(block - blocks.begin())));
    block->is_free = true;
    if (block + 1 != blocks.end() && (block + 1)->is_free) blocks.erase(block + 1);
    if (block != blocks.begin() && (block - 1)->is_free) blocks.erase(block);
    return true;
  }
  return false;
}

/// Blocks are taken from the begin of what is free, which so is likely to have been in use.
void MemoryPool::give_back(std::size_t bytes) noexcept {
  const std::lock_guard lock(mutex_);
  given_back_ += bytes;
  std::size_t pages = (given_back_ + kLargePage / 2) / kLargePage;
  for (const Chunk& chunk : chunks_) {
    for (std::size_t i = 0; i < chunk.blocks.size() && pages > 0; ++i) {
      if (chunk.blocks[i].is_free) pages -= forget_pages(chunk.blocks[i].begin, chunk.size_of(i), pages);
    }
  }
}

void MemoryPool::release_idle_chunks() noexcept {
  std::erase_if(chunks_, [](const Chunk& chunk) {
    if (chunk.is_free()) chunk.release();
    return chunk.is_free();
  });
}

}  // namespace deltamesh
