// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// encode_hash STREAM...: decodes every stream, encodes the mesh in several ways and prints hashes of the new
// streams (scripts/check-platforms).
#include <cinttypes>
#include <cstdio>

#include "bits/hash.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"

int main(int argc, char** argv) {
  using namespace deltamesh;
  const QualityBound per_mille{.value = 0.1, .unit = QualityUnit::kDiagonal};
  const EncodeOptions ways[] = {
      {.quality = {.vde = per_mille}},
      {.quality = {.max_error = per_mille}},
      {.lossless = true, .keep_order = true},
      {.geometry = GeometryCoder::kHighpass, .bits = 6, .profile = Profile::kZstd},
      {.geometry = GeometryCoder::kPredictive, .effort = 2},
  };
  for (int i = 1; i < argc; ++i) {
    const std::vector<char> file = test::read_file(argv[i]);
    const auto mesh = decode(std::as_bytes(std::span(file)));
    if (!mesh) return std::fprintf(stderr, "%s: %s\n", argv[i], describe(mesh.error()).c_str()), 1;
    for (const EncodeOptions& way : ways) {
      const auto encoded = encode(*mesh, way);
      if (!encoded) return std::fprintf(stderr, "%s: %s\n", argv[i], describe(encoded.error()).c_str()), 1;
      test::Hash hash;
      hash.add(encoded->bytes);
      std::printf("%016" PRIx64 " %s, way %d\n", hash.value(), argv[i], static_cast<int>(&way - ways));
    }
  }
}
