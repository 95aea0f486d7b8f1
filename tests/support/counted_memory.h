// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Counts the memory that `new` allocates. Linking counted_memory.cpp replaces the program's global operators.
#pragma once

#include <cstddef>

namespace deltamesh::test {

/// Bytes allocated and not yet freed.
std::size_t memory_taken();
/// The largest memory_taken() since the last call of most_memory_from_now().
std::size_t most_memory();
void most_memory_from_now();

}  // namespace deltamesh::test
