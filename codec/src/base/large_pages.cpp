// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/large_pages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace deltamesh {

#if defined(__linux__) && defined(MADV_HUGEPAGE)

/// Not by an aligning allocator: such ones are known to give back to the system at once what they would have
/// kept for the next call. What is to be freed stands before the pages.
void* allocate_pages(std::size_t bytes) {
  const std::size_t large = (bytes + kLargePage / 2) / kLargePage * kLargePage;
  std::byte* const memory = static_cast<std::byte*>(::operator new(std::max(bytes, large) + kLargePage));
  const std::size_t before = kLargePage - reinterpret_cast<std::uintptr_t>(memory) % kLargePage;
  std::byte* const begin = memory + before;
  std::memcpy(begin - sizeof(memory), &memory, sizeof(memory));
  if (large > 0) madvise(begin, large, MADV_HUGEPAGE);
  return begin;
}

void free_pages(void* begin) noexcept {
  std::byte* memory = nullptr;
  std::memcpy(&memory, static_cast<const std::byte*>(begin) - sizeof(memory), sizeof(memory));
  ::operator delete(memory);
}

namespace {

/// For the first large pages that `memory` fills, `most` at most. Returns how many.
std::size_t advise(void* memory, std::size_t bytes, std::size_t most, int advice) noexcept {
  const std::size_t before = (~reinterpret_cast<std::uintptr_t>(memory) + 1) % kLargePage;
  if (bytes < before + kLargePage) return 0;
  const std::size_t pages = std::min((bytes - before) / kLargePage, most);
  if (pages > 0) madvise(static_cast<std::byte*>(memory) + before, pages * kLargePage, advice);
  return pages;
}

}  // namespace

std::size_t forget_pages(void* memory, std::size_t bytes, std::size_t most) noexcept {
  return advise(memory, bytes, most, MADV_DONTNEED);
}

void want_large_pages(void* memory, std::size_t bytes) noexcept {
  advise(memory, bytes, bytes, MADV_HUGEPAGE);
}

#else

void* allocate_pages(std::size_t bytes) { return ::operator new (bytes, std::align_val_t{64}); }
void free_pages(void* memory) noexcept { ::operator delete (memory, std::align_val_t{64}); }
std::size_t forget_pages(void*, std::size_t, std::size_t) noexcept { return 0; }
void want_large_pages(void*, std::size_t) noexcept {}

#endif

}  // namespace deltamesh
