// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// read_many FORMAT: reads files from standard input, each behind its size as 4 bytes, low byte first, and
// prints a line for each: "refused MESSAGE", or its numbers of vertices and triangles, the coordinates and
// the indices. At the end, on standard error, the most memory it had (VmHWM of Linux).
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "deltamesh/io.h"

int main(int argc, char** argv) {
  const auto format = deltamesh::format_of_path(std::string(".") + (argc > 1 ? argv[1] : ""));
  if (!format) return 2;
  const std::string input(std::istreambuf_iterator<char>(std::cin), {});
  for (std::size_t at = 0; at + 4 <= input.size();) {
    std::size_t size = 0;
    for (unsigned i = 0; i < 4; ++i) size |= std::size_t{static_cast<std::uint8_t>(input[at + i])} << (8 * i);
    const std::string file = input.substr(at + 4, size);
    at += 4 + size;
    const auto imported = deltamesh::read_mesh(std::as_bytes(std::span(file)), *format);
    if (!imported) {
      std::printf("refused %s\n", describe(imported.error()).c_str());
      continue;
    }
    const deltamesh::Mesh& mesh = imported->mesh;
    std::printf("%zu %zu", mesh.vertex_count(), mesh.triangle_count());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      std::printf(" %.9g", mesh.origin[i % 3] + static_cast<double>(mesh.positions[i]));
    for (const std::uint32_t index : mesh.triangles) std::printf(" %u", index);
    std::printf("\n");
  }
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) std::fprintf(stderr, "%s\n", line.c_str());
  return 0;
}
