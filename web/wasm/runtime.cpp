// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "runtime.h"

#include <cstdlib>
#include <new>

namespace {

void* allocate_or_leave(std::size_t bytes, std::size_t alignment) {
  void* const memory = alignment > 0 ? std::aligned_alloc(alignment, (bytes + alignment - 1) & -alignment)
                                     : std::malloc(bytes > 0 ? bytes : 1);
  if (memory == nullptr) out_of_memory();
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) { return allocate_or_leave(bytes, 0); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocate_or_leave(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

void* allocate(std::size_t bytes) { return operator new(bytes); }
void release(void* memory) { operator delete(memory); }
