// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/large_vector.h"

#include <new>

#include "base/large_pages.h"

namespace deltamesh {
namespace {

/// Of what has no pages of its own: a line of the cache, and what elements of vectors ask for.
constexpr std::align_val_t kAlignment{64};

/// Smaller arrays are like any others.
constexpr bool has_own_pages(std::size_t bytes) noexcept { return bytes >= kLargePage / 2; }

}  // namespace

void* allocate_large(std::size_t bytes) {
  return has_own_pages(bytes) ? allocate_pages(bytes) : ::operator new(bytes, kAlignment);
}

void free_large(void* memory, std::size_t bytes) noexcept {
  if (has_own_pages(bytes)) {
    free_pages(memory, bytes);
  } else {
    ::operator delete(memory, kAlignment);
  }
}

}  // namespace deltamesh
