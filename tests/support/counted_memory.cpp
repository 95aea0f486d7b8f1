// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // both are replaced, as a pair
#endif
#include "support/counted_memory.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> taken{0};
std::atomic<std::size_t> most{0};

void* take(std::size_t size) noexcept {
  void* const memory = std::malloc(size);
  const std::size_t now = taken += malloc_usable_size(memory);
  if (now > most) most = now;
  return memory;
}

void* take_or_throw(std::size_t size) {
  if (void* const memory = take(size)) return memory;
  throw std::bad_alloc();
}

void write_back(void* memory) noexcept {
  taken -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return take_or_throw(size); }
void* operator new[](std::size_t size) { return take_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return take(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return take(size); }
void operator delete(void* memory) noexcept { write_back(memory); }
void operator delete[](void* memory) noexcept { write_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { write_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { write_back(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { write_back(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { write_back(memory); }

namespace deltamesh::test {

std::size_t memory_taken() { return taken; }
std::size_t most_memory() { return most; }
void most_memory_from_now() { most = taken.load(); }

}  // namespace deltamesh::test
