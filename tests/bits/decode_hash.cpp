// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// decode_hash STREAM...: prints a hash of the bits of every stream's decoded positions (scripts/check-bits).
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

#include "deltamesh/decode.h"

namespace {

/// FNV-1a over 32-bit words.
std::uint64_t hash_of(std::span<const float> values) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const float value : values) hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3;
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
    std::printf("%016" PRIx64 " %s\n", hash_of(mesh->positions), argv[i]);
  }
}
