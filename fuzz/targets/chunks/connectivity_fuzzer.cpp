// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// CONN payloads from anywhere, and any triangle soup through writer and reader. The last three bytes are the
// vertex count and the face count; the lowest bit of the face count chooses which of the two it is.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "connectivity/faces/faces.h"
#include "connectivity/plain/topology.h"
#include "goal.h"

namespace {

using namespace deltamesh;

fuzz::Goal faces_read("a payload");
fuzz::Goal faces_written("any faces");

/// What comes with the faces says the same as they do.
void check_graph(const Connectivity& read, std::uint32_t vertex_count) {
  const Adjacency graph = build_adjacency(read.triangles, vertex_count);
  const Adjacency quick = build_adjacency(read.triangles, read.open_edges, vertex_count);
  if (quick.offsets != graph.offsets || quick.neighbors != graph.neighbors) std::abort();
  const Components components = find_components(graph);
  const Components by_runs = read.runs.components(vertex_count);
  if (read.runs.count(vertex_count) != components.count || by_runs.label != components.label) std::abort();
  if (by_runs.count != components.count || by_runs.size != components.size) std::abort();
}

/// Whatever the faces are, they come back.
void check_round_trip(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  const CodedConnectivity coded = write_connectivity(triangles, vertex_count);
  const auto face_count = static_cast<std::uint32_t>(triangles.size() / 3);
  if (coded.vertex_order.size() != vertex_count || coded.face_order.size() != face_count) std::abort();
  for (std::size_t f = 0; f < face_count; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t original =
          triangles[std::size_t{3} * coded.face_order[f] + (k + coded.face_rotation[f]) % 3];
      if (coded.vertex_order[coded.triangles[3 * f + k]] != original) std::abort();
    }
  }
  const auto read = read_connectivity(coded.payload, vertex_count, face_count);
  if (!read || read->triangles != coded.triangles) std::abort();
  check_graph(*read, vertex_count);
  const auto plain = read_plain_faces(write_plain_faces(triangles), face_count, vertex_count);
  if (!plain || !std::ranges::equal(*plain, triangles)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const std::uint32_t vertex_count = data[size - 3];
  const std::uint32_t face_choice = data[size - 2] + 256U * data[size - 1];
  size -= 3;
  if (face_choice % 2 == 0) {
    const auto read = read_connectivity(std::as_bytes(std::span(data, size)), vertex_count, face_choice / 2);
    if (!fuzz::check(read)) return 0;
    if (read->triangles.size() != std::size_t{face_choice / 2} * 3) std::abort();
    for (const std::uint32_t v : read->triangles) {
      if (v >= vertex_count) std::abort();
    }
    check_graph(*read, vertex_count);
    check_round_trip(read->triangles, vertex_count);
    faces_read.reach();
  } else if (vertex_count != 0) {
    std::vector<std::uint32_t> triangles(size - size % 3);
    for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = data[i] % vertex_count;
    check_round_trip(triangles, vertex_count);
    faces_written.reach();
  }
  return 0;
}
