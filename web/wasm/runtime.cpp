// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "runtime.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

/// There is one way to get memory, which is aligned for all elements that vectors have.
void* operator new(std::size_t bytes) {
  void* const memory = memalign(32, bytes);
  if (memory == nullptr) out_of_memory();
  return memory;
}
void* operator new(std::size_t bytes, std::align_val_t) { return operator new(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

void* allocate(std::size_t bytes) { return operator new(bytes); }
void release(void* memory) { operator delete(memory); }

// What emscripten would otherwise import from JavaScript.
extern "C" {
void emscripten_notify_memory_growth(std::size_t) {}
void __wasi_proc_exit(int) { __builtin_trap(); }  // NOLINT(bugprone-reserved-identifier)
}
