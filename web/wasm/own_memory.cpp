// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <malloc.h>

#include <cstdlib>

#include "runtime.h"

namespace deltamesh::web {

/// Throws in JavaScript.
extern "C" [[noreturn]] DELTAMESH_IMPORT(out_of_memory) void out_of_memory();

DELTAMESH_EXPORT(allocate) void* allocate(std::size_t bytes) {
  void* const memory = memalign(32, bytes);
  if (memory == nullptr) out_of_memory();
  return memory;
}

DELTAMESH_EXPORT(release) void release(void* memory) { std::free(memory); }

}  // namespace deltamesh::web
