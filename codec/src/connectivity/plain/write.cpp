// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_writer.h"
#include "connectivity/faces/cut.h"
#include "connectivity/plain/topology.h"
#include "entropy/arrays.h"

namespace deltamesh {

std::vector<std::uint32_t> walk_faces(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  const HalfEdges edges = match_half_edges(triangles, vertex_count);
  std::vector<std::uint32_t> corners;
  corners.reserve(triangles.size() / 3);
  std::vector<std::uint8_t> done(triangles.size() / 3, 0);
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t first = 0; first < triangles.size(); first += 3) {
    waiting.push_back(first);
    while (!waiting.empty()) {
      const std::uint32_t corner = waiting.back();
      waiting.pop_back();
      if (done[corner / 3] != 0) continue;
      done[corner / 3] = 1;
      corners.push_back(corner);
      for (const std::uint32_t edge : {previous_in_face(corner), next_in_face(corner)}) {
        const std::uint32_t across = edges.opposite[edge];
        if (across != kNoIndex && done[across / 3] == 0) waiting.push_back(across);
      }
    }
  }
  return corners;
}

std::vector<std::byte> write_plain_faces(std::span<const std::uint32_t> triangles) {
  ByteWriter out;
  write_indices(out, triangles);
  return out.take();
}

std::vector<std::byte> write_plain_seams(std::span<const std::uint32_t> geometric) {
  ByteWriter out;
  write_indices(out, geometric);
  return out.take();
}

std::vector<std::byte> write_plain_groups(std::span<const std::uint32_t> groups) {
  ByteWriter out;
  write_array(out, groups);
  return out.take();
}

}  // namespace deltamesh
