// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// decode_hash THREADS STREAM...: prints a hash of every stream's decoded mesh (scripts/check-platforms).
// Fails where that many threads decode another one than a single thread.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "bits/hash.h"
#include "deltamesh/decode.h"

int main(int argc, char** argv) {
  using namespace deltamesh;
  for (int i = 2; i < argc; ++i) {
    const std::vector<char> file = test::read_file(argv[i]);
    const auto stream = std::as_bytes(std::span(file));
    const auto mesh = decode(stream);
    const auto shared = decode(stream, {.threads = static_cast<unsigned>(std::atoi(argv[1]))});
    if (!mesh || !shared) {
      std::fprintf(stderr, "%s: %s\n", argv[i], describe((mesh ? shared : mesh).error()).c_str());
      return 1;
    }
    const std::uint64_t hash = test::hash_of(*mesh);
    if (test::hash_of(*shared) != hash) {
      std::fprintf(stderr, "%s: several threads decode another mesh than one\n", argv[i]);
      return 1;
    }
    std::printf("%016" PRIx64 " %s\n", hash, argv[i]);
  }
}
