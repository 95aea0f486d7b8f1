// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/faces/gluing.h"

#include <numeric>

#include "base/broken_rule.h"
#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "connectivity/faces/glue_coder.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

Error broken_gluing(const char* message) noexcept {
  return broken_rule(message, "CONN-11", kTagConnectivity);
}

/// Runs of connected vertices. `starts`: first manifold vertex of every component, and the end of the last.
VertexRuns connected_runs(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> vertex) {
  VertexRuns runs;
  if (vertex.empty()) {
    for (const std::uint32_t start : starts.first(starts.size() - 1)) runs.begin(start);
    runs.end(starts.back());
    return runs;
  }
  std::uint32_t fresh = 0;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    runs.begin(fresh);
    for (std::uint32_t m = starts[i]; m < starts[i + 1]; ++m) {
      if (vertex[m] == fresh) {
        ++fresh;
      } else {
        runs.join(vertex[m]);
      }
    }
  }
  runs.end(fresh);
  return runs;
}

/// Before anything of the list's size is allocated. Errors: kInvalidStream [CONN-11].
Result<void> check_glue_count(std::uint64_t count, std::uint32_t manifold_count, std::uint32_t vertex_count) {
  if (count > manifold_count) return broken_gluing("more glued vertices than vertices");
  if (manifold_count - count > vertex_count) return broken_gluing("more vertices than declared");
  return {};
}

}  // namespace

Result<LargeVector<std::uint32_t>> glue_vertices(const GlueList& list, std::uint32_t manifold_count,
                                                 std::uint32_t vertex_count) {
  DELTAMESH_CHECK(check_glue_count(list.gaps.size(), manifold_count, vertex_count));
  LargeVector<std::uint32_t> vertex;
  if (list.gaps.empty()) return vertex;
  vertex.resize(manifold_count);
  std::uint32_t next = 0;  // manifold vertex
  std::uint32_t fresh = 0;
  const auto take_fresh = [&](std::uint32_t count) {
    std::iota(vertex.begin() + next, vertex.begin() + next + count, fresh);
    next += count;
    fresh += count;
  };
  std::uint32_t target = 0;
  for (std::size_t i = 0; i < list.gaps.size(); ++i) {
    if (list.gaps[i] >= manifold_count - next) return broken_gluing("glued vertex beyond the last");
    take_fresh(list.gaps[i]);
    target += static_cast<std::uint32_t>(unzigzag(list.targets[i]));
    if (target >= fresh) return broken_gluing("glued to a vertex yet to come");
    vertex[next++] = target;
  }
  take_fresh(manifold_count - next);
  return vertex;
}

void renumber(std::span<std::uint32_t> manifold, std::span<const std::uint32_t> vertex) {
  if (vertex.empty()) return;
  for (std::uint32_t& m : manifold) m = vertex[m];
}

Connectivity glued(Border& border, std::vector<std::uint32_t> starts, std::span<const std::uint32_t> vertex) {
  starts.push_back(border.vertex_count());
  Connectivity connectivity{.triangles = border.take_faces(),
                            .open_edges = border.take_open_edges(),
                            .runs = connected_runs(starts, vertex)};
  renumber(connectivity.triangles, vertex);
  for (DirectedEdge& edge : connectivity.open_edges) renumber(edge, vertex);
  return connectivity;
}

Result<LargeVector<std::uint32_t>> read_gluing(CompactReader& reader, std::span<const std::uint32_t> faces,
                                               std::uint32_t manifold_count, std::uint32_t vertex_count) {
  NumberModel counts;
  const std::uint32_t count = reader.number(0, counts);
  DELTAMESH_CHECK(check_glue_count(count, manifold_count, vertex_count));
  if (is_dense(count, manifold_count)) {
    LargeVector<std::uint32_t> vertex(manifold_count, 0);
    GlueCoder glue(reader, faces, manifold_count);
    const auto fault = [](const char* message) { return broken_rule(message, "CONN-14", kTagConnectivity); };
    if (!glue.code(vertex, [&] { return reader.failed(); }) && !reader.failed())
      return fault("glued to a vertex yet to come");
    if (glue.glued_count() != count && !reader.failed()) return fault("another number of glued vertices");
    return vertex;
  }
  GlueList list;
  NumberModel gaps;
  NumberModel targets;
  for (std::uint32_t i = 0; i < count && !reader.failed(); ++i) {
    list.gaps.push_back(reader.number(0, gaps));
    list.targets.push_back(reader.number(0, targets));
  }
  if (reader.failed()) return LargeVector<std::uint32_t>{};
  return glue_vertices(list, manifold_count, vertex_count);
}

}  // namespace deltamesh
