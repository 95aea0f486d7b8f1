// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/large_pages.h"

#include <algorithm>
#include <cstdint>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace deltamesh {

#if defined(__linux__) && defined(MADV_HUGEPAGE)

void* allocate_pages(std::size_t bytes) {
  const std::size_t large = (bytes + kLargePage / 2) / kLargePage * kLargePage;
  void* const memory = ::operator new (std::max(bytes, large), std::align_val_t{kLargePage});
  if (large > 0) madvise(memory, large, MADV_HUGEPAGE);
  return memory;
}

void free_pages(void* memory) noexcept { ::operator delete (memory, std::align_val_t{kLargePage}); }

void want_large_pages(void* memory, std::size_t bytes) noexcept {
  const std::size_t before = (~reinterpret_cast<std::uintptr_t>(memory) + 1) % kLargePage;
  if (bytes < before + kLargePage) return;
  madvise(static_cast<std::byte*>(memory) + before, (bytes - before) / kLargePage * kLargePage,
          MADV_HUGEPAGE);
}

#else

void* allocate_pages(std::size_t bytes) { return ::operator new(bytes, std::align_val_t{64}); }
void free_pages(void* memory) noexcept { ::operator delete(memory, std::align_val_t{64}); }
void want_large_pages(void*, std::size_t) noexcept {}

#endif

}  // namespace deltamesh
