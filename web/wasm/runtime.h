// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What every module here shares with the JavaScript around it. There are no exceptions: where memory ends
// JavaScript throws and makes another instance, so that nothing of the one that failed is used again.
#pragma once

#include <cstddef>
#include <cstdint>

#define DELTAMESH_IMPORT(name) __attribute__((import_module("env"), import_name(#name)))
#define DELTAMESH_EXPORT(name) __attribute__((export_name(#name)))

namespace deltamesh::web {

/// Memory of the module's own (own_memory.cpp), or of core's (memory_of_core.cpp).
void* allocate(std::size_t bytes);
void release(void* memory);

}  // namespace deltamesh::web
