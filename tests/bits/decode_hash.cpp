// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// decode_hash STREAM...: prints a hash of the bits of every stream's decoded positions and
// attributes (scripts/check-bits).
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

#include "deltamesh/decode.h"

namespace {

/// FNV-1a over the bytes of positions and attributes.
std::uint64_t hash_of(const deltamesh::Mesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&hash](std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
  };
  add(std::as_bytes(std::span(mesh.positions)));
  for (const deltamesh::Attribute& attribute : mesh.attributes) add(attribute.values);
  return hash;
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    const auto mesh = deltamesh::decode(std::as_bytes(std::span(bytes)));
    if (!mesh) {
      std::fprintf(stderr, "%s: %s\n", argv[i], deltamesh::describe(mesh.error()).c_str());
      return 1;
    }
    std::printf("%016" PRIx64 " %s\n", hash_of(*mesh), argv[i]);
  }
}
