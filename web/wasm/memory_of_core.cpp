// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Parts get their memory from core, and so does the C in them.
#include <cstdlib>
#include <cstring>

#include "runtime.h"

namespace deltamesh::web {

extern "C" {
DELTAMESH_IMPORT(allocate) void* allocate_in_core(std::size_t bytes);
DELTAMESH_IMPORT(release) void release_in_core(void* memory);
}

void* allocate(std::size_t bytes) { return allocate_in_core(bytes); }
void release(void* memory) { release_in_core(memory); }

}  // namespace deltamesh::web

extern "C" {
void* malloc(std::size_t bytes) { return deltamesh::web::allocate(bytes); }
void free(void* memory) { deltamesh::web::release(memory); }
void* calloc(std::size_t count, std::size_t bytes) {
  return std::memset(malloc(count * bytes), 0, count * bytes);
}
}
