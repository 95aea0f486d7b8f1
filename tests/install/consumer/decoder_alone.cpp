// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// decoder_alone STREAM: decodes it with the decoder's library alone, all of which is linked: nothing in it
// may need what only writers have.
#include <deltamesh/decode.h>
#include <deltamesh/stream_info.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <span>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  std::ifstream file(argv[1], std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  const auto stream = std::as_bytes(std::span(bytes));
  const auto info = deltamesh::inspect(stream);
  const auto mesh = deltamesh::decode(stream);
  return info && mesh && mesh->triangles.size() == 3 * info->triangles ? 0 : 2;
}
