// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstdint>
#include <new>

#include "base/memory/large_vector.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

// AddressSanitizer watches the heap alone.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define DELTAMESH_WATCHES_HEAP
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define DELTAMESH_WATCHES_HEAP
#endif

namespace deltamesh {
namespace {

/// Of what has no pages of its own: a line of the cache, and what elements of vectors ask for.
constexpr std::align_val_t kAlignment{64};

}  // namespace

#if defined(__linux__) && defined(MADV_HUGEPAGE) && !defined(DELTAMESH_WATCHES_HEAP)

namespace {

/// Smaller arrays are like any others.
constexpr bool has_own_pages(std::size_t bytes) noexcept { return bytes >= kLargePage / 2; }

/// From `address` to the next large page, 0 where one begins there.
std::size_t bytes_before_page(const void* address) noexcept {
  return (~reinterpret_cast<std::uintptr_t>(address) + 1) % kLargePage;
}

/// Whole large pages, but for an end of less than half a one, which is of pages as large as any system's
/// small ones.
std::size_t mapped_size(std::size_t bytes) noexcept {
  constexpr std::size_t kSmallPage = std::size_t{1} << 16;
  const std::size_t whole = (bytes + kLargePage / 2) / kLargePage * kLargePage;
  return std::max(whole, (bytes + kSmallPage - 1) / kSmallPage * kSmallPage);
}

}  // namespace

/// Not from the heap, which would keep much of what is freed: a decoder's peak would be a seventh higher. Nor
/// kept for the next array of its size: a process that decodes again and again would save a twentieth of its
/// time, and a decode's peak would be up to a quarter higher.
void* allocate_large(std::size_t bytes) {
  if (!has_own_pages(bytes)) return ::operator new(bytes, kAlignment);
  const std::size_t size = mapped_size(bytes);
  void* const mapped =
      mmap(nullptr, size + kLargePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  const std::size_t before = bytes_before_page(mapped);
  std::byte* const begin = static_cast<std::byte*>(mapped) + before;
  if (before > 0) munmap(mapped, before);
  munmap(begin + size, kLargePage - before);
  madvise(begin, size / kLargePage * kLargePage, MADV_HUGEPAGE);
  return begin;
}

void free_large(void* memory, std::size_t bytes) noexcept {
  if (has_own_pages(bytes)) {
    munmap(memory, mapped_size(bytes));
  } else {
    ::operator delete(memory, kAlignment);
  }
}

void want_large_pages(void* memory, std::size_t bytes) noexcept {
  const std::size_t before = bytes_before_page(memory);
  if (bytes < before + kLargePage) return;
  madvise(static_cast<std::byte*>(memory) + before, (bytes - before) / kLargePage * kLargePage,
          MADV_HUGEPAGE);
}

#else

void* allocate_large(std::size_t bytes) { return ::operator new(bytes, kAlignment); }
void free_large(void* memory, std::size_t) noexcept { ::operator delete(memory, kAlignment); }
void want_large_pages(void*, std::size_t) noexcept {}

#endif

}  // namespace deltamesh
