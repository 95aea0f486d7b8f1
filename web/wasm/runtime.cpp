// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "runtime.h"

#include <new>

using deltamesh::web::allocate;
using deltamesh::web::release;

/// There is one way to get memory, which is aligned for all elements that vectors have.
void* operator new(std::size_t bytes) { return allocate(bytes); }
void* operator new(std::size_t bytes, std::align_val_t) { return allocate(bytes); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

/// The same of all modules that work together.
DELTAMESH_EXPORT(release_of) std::uint32_t release_of() { return DELTAMESH_RELEASE; }

// What emscripten would otherwise import from JavaScript.
extern "C" {
void emscripten_notify_memory_growth(std::size_t) {}
void __wasi_proc_exit(int) { __builtin_trap(); }  // NOLINT(bugprone-reserved-identifier)
}
