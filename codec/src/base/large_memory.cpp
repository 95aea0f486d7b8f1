// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstdint>

#include "base/large_vector.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace deltamesh {

#if defined(__linux__) && defined(MADV_HUGEPAGE)

namespace {

/// Smaller than some systems' large pages, which then are not used.
constexpr std::size_t kPage = std::size_t{1} << 21;

/// How much of `bytes` is on large pages: the last one where half of it is needed.
constexpr std::size_t on_large_pages(std::size_t bytes) noexcept {
  return (bytes + kPage / 2) / kPage * kPage;
}

}  // namespace

void* allocate_large(std::size_t bytes) {
  const std::size_t large = on_large_pages(bytes);
  void* const memory = ::operator new (std::max(bytes, large), std::align_val_t{kPage});
  if (large > 0) madvise(memory, large, MADV_HUGEPAGE);
  return memory;
}

void free_large(void* memory) noexcept { ::operator delete (memory, std::align_val_t{kPage}); }

void want_large_pages(void* memory, std::size_t bytes) noexcept {
  const std::size_t before = (~reinterpret_cast<std::uintptr_t>(memory) + 1) % kPage;
  if (bytes < before + kPage) return;
  madvise(static_cast<std::byte*>(memory) + before, (bytes - before) / kPage * kPage, MADV_HUGEPAGE);
}

#else

void* allocate_large(std::size_t bytes) { return ::operator new(bytes); }
void free_large(void* memory) noexcept { ::operator delete(memory); }
void want_large_pages(void*, std::size_t) noexcept {}

#endif

}  // namespace deltamesh
