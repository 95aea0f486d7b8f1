// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the programs here share: files, and hashes of what they hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh::test {

inline std::vector<char> read_file(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// FNV-1a.
class Hash {
 public:
  void add(std::span<const std::byte> bytes) noexcept {
    for (const std::byte byte : bytes) value_ = (value_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
  }
  std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Of faces, positions and attributes.
inline std::uint64_t hash_of(const Mesh& mesh) noexcept {
  Hash hash;
  hash.add(std::as_bytes(std::span(mesh.triangles)));
  hash.add(std::as_bytes(std::span(mesh.positions)));
  for (const Attribute& attribute : mesh.attributes) hash.add(attribute.values);
  return hash.value();
}

}  // namespace deltamesh::test
