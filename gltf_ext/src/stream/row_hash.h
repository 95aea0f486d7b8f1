// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A hash of bytes for tables in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace deltamesh::gltf {

/// Goes on from `hash`, eight bytes at a time.
inline std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash = 0) noexcept {
  constexpr std::uint64_t kPrime = 0x9e3779b97f4a7c15;
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t size = bytes.size() < sizeof word ? bytes.size() : sizeof word;
    std::memcpy(&word, bytes.data(), size);
    hash = (hash ^ word ^ (hash >> 32)) * kPrime;
    bytes = bytes.subspan(size);
  }
  return hash ^ (hash >> 29);
}

}  // namespace deltamesh::gltf
