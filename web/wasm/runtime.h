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

extern "C" {
/// Throws in JavaScript.
[[noreturn]] DELTAMESH_IMPORT(out_of_memory) void out_of_memory();

/// For what JavaScript hands over.
DELTAMESH_EXPORT(allocate) void* allocate(std::size_t bytes);
DELTAMESH_EXPORT(release) void release(void* memory);
}
