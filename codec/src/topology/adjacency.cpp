// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/adjacency.h"

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "base/small_code.h"
#include "base/threads/thread_team.h"
#include "base/union_find.h"

namespace deltamesh {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// The three directed edges of a face, and open edges turned round.
template <class Visit>
[[gnu::always_inline]] inline void for_each_half_edge(std::span<const std::uint32_t> triangles,
                                                      std::span<const DirectedEdge> open_edges,
                                                      const Visit& visit) {
  for (std::size_t f = 0; f + 2 < triangles.size(); f += 3) {
    const std::uint32_t a = triangles[f];
    const std::uint32_t b = triangles[f + 1];
    const std::uint32_t c = triangles[f + 2];
    visit(a, b);
    visit(b, c);
    visit(c, a);
  }
  for (const auto& [a, b] : open_edges) visit(b, a);
}

/// The six directed edges of a face, without those from a vertex to itself.
template <class Visit>
void for_each_directed_edge(std::span<const std::uint32_t> triangles, Visit&& visit) {
  for (std::size_t f = 0; f + 2 < triangles.size(); f += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[f + k];
      const std::uint32_t b = triangles[f + (k + 1) % 3];
      if (a == b) continue;
      visit(a, b);
      visit(b, a);
    }
  }
}

/// Counts in places 1 .. n become the offsets of rows 0 .. n.
void sum_up(LargeVector<std::uint32_t>& offsets) {
  for (std::size_t v = 1; v < offsets.size(); ++v) offsets[v] += offsets[v - 1];
}

/// The same symmetric graph with ascending rows, each neighbour once: row w receives every v in ascending
/// order of v, so that what is repeated comes in a row.
Adjacency tidy(const Adjacency& graph) {
  const auto vertex_count = static_cast<std::uint32_t>(graph.vertex_count());
  Adjacency sorted;
  sorted.offsets.assign(graph.offsets.size(), 0);
  LargeVector<std::uint32_t> last(vertex_count, kNone);
  in_turns(vertex_count, [&, counts = sorted.offsets.data() + 1, last = last.data()](std::uint32_t begin,
                                                                                     std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v) {
      for (const std::uint32_t w : graph.of(v)) {
        counts[w] += last[w] != v ? 1 : 0;
        last[w] = v;
      }
    }
  });
  sum_up(sorted.offsets);
  sorted.neighbors.resize(sorted.offsets.back());
  LargeVector<std::uint32_t> ends(sorted.offsets.begin(), sorted.offsets.end() - 1);
  last.assign(vertex_count, kNone);
  in_turns(vertex_count, [&, rows = sorted.neighbors.data(), ends = ends.data(), last = last.data()](
                             std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v) {
      for (const std::uint32_t w : graph.of(v)) {
        ends[w] += last[w] != v ? 1 : 0;
        rows[ends[w] - 1] = v;  // once more where it was there
        last[w] = v;
      }
    }
  });
  return sorted;
}

/// Ascending, for rows that are not long and hardly out of order, as those of coded meshes are.
void sort_short(std::span<std::uint32_t> row) noexcept {
  for (std::size_t i = 1; i < row.size(); ++i) {
    const std::uint32_t moved = row[i];
    std::size_t place = i;
    for (; place > 0 && row[place - 1] > moved; --place) row[place] = row[place - 1];
    row[place] = moved;
  }
}

/// Makes rows ascend, but for long ones. Returns whether there is one, or one that has a neighbour twice.
bool sort_rows(Adjacency& graph, ThreadTeam* team) {
  constexpr std::ptrdiff_t kLong = 128;
  std::atomic<bool> are_left = false;
  share_rows(team, graph.vertex_count(),
             [&, offsets = graph.offsets.data(), neighbors = graph.neighbors.data()](std::uint32_t begin,
                                                                                     std::uint32_t end) {
               bool has_own = false;
               for (std::uint32_t v = begin; v < end; ++v) {
                 std::uint32_t* const row = neighbors + offsets[v];
                 std::uint32_t* const row_end = neighbors + offsets[v + 1];
                 if (row_end - row <= kLong) {
                   sort_short({row, row_end});
                 } else {
                   has_own = true;
                 }
                 for (std::ptrdiff_t k = 1; k < row_end - row; ++k) has_own |= row[k - 1] == row[k];
               }
               if (has_own) are_left = true;
             });
  return are_left;
}

}  // namespace

Adjacency build_adjacency(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  Adjacency graph;
  graph.offsets.assign(std::size_t{vertex_count} + 1, 0);
  for_each_directed_edge(triangles, [&](std::uint32_t a, std::uint32_t) { ++graph.offsets[a + 1]; });
  sum_up(graph.offsets);

  graph.neighbors.resize(graph.offsets.back());
  LargeVector<std::uint32_t> cursor(graph.offsets.begin(), graph.offsets.end() - 1);
  for_each_directed_edge(triangles,
                         [&](std::uint32_t a, std::uint32_t b) { graph.neighbors[cursor[a]++] = b; });
  return tidy(graph);
}

/// Two threads fill rows from both ends: so neither has to know how far the other comes.
Adjacency build_adjacency(std::span<const std::uint32_t> triangles, std::span<const DirectedEdge> open_edges,
                          std::uint32_t vertex_count, ThreadTeam* team) {
  const std::uint32_t halves = std::min(piece_count(team, vertex_count), 2U);
  const auto first_half = triangles.first(triangles.size() / 3 / halves * 3);
  const auto visit_half = [&](std::uint32_t half, const auto& visit) {
    if (half == 0) {
      for_each_half_edge(first_half, open_edges, visit);
    } else {
      for_each_half_edge(triangles.subspan(first_half.size()), {}, visit);
    }
  };
  Adjacency graph;
  LargeVector<std::uint32_t>& offsets = graph.offsets;
  offsets.assign(std::size_t{vertex_count} + 1, 0);
  LargeVector<std::uint32_t> ends;
  share_work(team, halves, [&](std::uint32_t half) {
    if (half == 1) ends.assign(vertex_count, 0);
    visit_half(half,
               [counts = half == 0 ? offsets.data() + 1 : ends.data()](std::uint32_t a, std::uint32_t b) {
                 if (a != b) ++counts[a];
               });
  });
  for (std::size_t v = 0; v < ends.size(); ++v) offsets[v + 1] += ends[v];
  sum_up(offsets);

  graph.neighbors.resize(offsets.back());
  share_work(team, halves, [&, rows = graph.neighbors.data()](std::uint32_t half) {
    if (half == 0) {
      LargeVector<std::uint32_t> begins(offsets.begin(), offsets.end() - 1);
      visit_half(half, [rows, next = begins.data()](std::uint32_t a, std::uint32_t b) {
        if (a == b) return;
        std::uint32_t& place = next[a];
        rows[place] = b;  // not with ++ here: that takes two instructions more
        ++place;
      });
    } else {
      ends.assign(offsets.begin() + 1, offsets.end());
      visit_half(half, [rows, last = ends.data()](std::uint32_t a, std::uint32_t b) {
        if (a != b) rows[--last[a]] = b;
      });
    }
  });
  if (sort_rows(graph, team)) return tidy(graph);
  return graph;
}

Components find_components(const Adjacency& graph) {
  const std::size_t n = graph.vertex_count();
  Components components;
  components.label.assign(n, kNone);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t seed = 0; seed < n; ++seed) {
    if (components.label[seed] != kNone) continue;
    const std::uint32_t label = components.count++;
    components.label[seed] = label;
    queue.assign(1, seed);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      for (const std::uint32_t w : graph.of(queue[next])) {
        if (components.label[w] != kNone) continue;
        components.label[w] = label;
        queue.push_back(w);
      }
    }
    components.size.push_back(static_cast<std::uint32_t>(queue.size()));
  }
  return components;
}

std::uint32_t count_components(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  UnionFind sets(vertex_count);
  std::uint32_t count = vertex_count;
  for (std::size_t corner = 0; corner < triangles.size(); ++corner)
    count -= sets.unite(triangles[corner - corner % 3], triangles[corner]) ? 1U : 0U;
  return count;
}

}  // namespace deltamesh
