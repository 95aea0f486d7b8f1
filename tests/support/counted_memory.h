// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How much memory code takes with `new`. A program that links counted_memory.cpp has its operators replaced.
#pragma once

#include <cstddef>

namespace deltamesh::test {

/// Bytes that are taken now.
std::size_t memory_taken();
/// The most bytes that were taken at once since most_memory_from_now().
std::size_t most_memory();
void most_memory_from_now();

}  // namespace deltamesh::test
