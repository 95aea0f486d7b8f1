// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_bridges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/thread_team.h"
#include "laplacian/multigrid_upper_half.h"

namespace deltamesh::multigrid {
namespace {

/// Of an edge, by how many of its ends are seeds. Sums are exact, hence the same from both ends.
constexpr std::array<float, 3> kShares = {6.0F / 16, 9.0F / 16, 18.0F / 16};

/// Some rows of a graph.
struct GraphRows {
  LargeVector<std::uint32_t> offsets;    ///< where each begins, and the end
  LargeVector<std::uint32_t> middle;     ///< where its edges to higher nodes begin
  LargeVector<std::uint32_t> neighbors;  ///< first the lower ones
  LargeVector<float> weights;
};

/// Sums over columns met in any order.
struct Sums {
  explicit Sums(std::uint32_t columns) : values(columns, 0.0F), touched(columns + 1) {}

  LargeVector<float> values;           ///< 0 but for those touched
  LargeVector<std::uint32_t> touched;  ///< one after the other
};

/// Adds up what leads to each aggregate from one, itself among them, and returns how many these are. No
/// branch: it could not be predicted.
std::uint32_t sum_bridges(const Level& fine, const Aggregates& aggregates,
                          std::span<const std::uint32_t> members, Sums& sums) noexcept {
  float* const values = sums.values.data();
  std::uint32_t* const touched = sums.touched.data();
  std::uint32_t count = 0;
  std::size_t seeds = 1;  // the first member is one
  for (const std::uint32_t node : members) {
    const std::uint32_t end = fine.offsets[node + 1];
    for (std::uint32_t e = fine.offsets[node]; e < end; ++e) {
      const std::uint32_t code = aggregates.codes[fine.neighbors[e]];
      const std::uint32_t other = code & ~Aggregates::kSeed;
      touched[count] = other;
      count += values[other] == 0 ? 1 : 0;
      values[other] += kShares[seeds + (code >> 31)];
    }
    seeds = 0;
  }
  return count;
}

/// Appends the row of aggregate `c` and clears the sums.
void finish_row(std::uint32_t c, std::uint32_t count, Sums& sums, GraphRows& rows) {
  std::size_t lower = rows.neighbors.size();
  std::size_t higher = lower;
  for (std::uint32_t k = 0; k < count; ++k) higher += sums.touched[k] < c ? 1 : 0;
  rows.middle.push_back(static_cast<std::uint32_t>(higher));
  rows.neighbors.resize(lower + count + 1);
  rows.weights.resize(lower + count + 1);
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t other = sums.touched[k];
    const std::size_t place = other < c ? lower : higher;
    rows.neighbors[place] = other;
    rows.weights[place] = std::exchange(sums.values[other], 0.0F);
    lower += other < c ? 1 : 0;
    higher += other > c ? 1 : 0;
  }
  rows.neighbors.resize(higher);
  rows.weights.resize(higher);
  rows.offsets.push_back(static_cast<std::uint32_t>(higher));
}

GraphRows make_rows(const Level& fine, const Aggregates& aggregates, std::uint32_t begin, std::uint32_t end) {
  GraphRows rows;
  Sums sums(aggregates.count());
  const std::size_t edges = fine.neighbors.size() / aggregates.count() * (end - begin) / 2;
  rows.neighbors.reserve(edges);
  rows.weights.reserve(edges);
  rows.middle.reserve(end - begin);
  rows.offsets.reserve(end - begin + 1);
  rows.offsets.push_back(0);
  for (std::uint32_t c = begin; c < end; ++c)
    finish_row(c, sum_bridges(fine, aggregates, aggregates.members_of(c), sums), sums, rows);
  return rows;
}

/// The parts' rows one after the other.
GraphRows join(std::span<const GraphRows> parts) {
  GraphRows whole;
  std::vector<std::uint32_t> first_row(1, 0), first_edge(1, 0);
  for (const GraphRows& part : parts) {
    first_row.push_back(first_row.back() + static_cast<std::uint32_t>(part.middle.size()));
    first_edge.push_back(first_edge.back() + static_cast<std::uint32_t>(part.neighbors.size()));
  }
  whole.neighbors.resize(first_edge.back());
  whole.weights.resize(first_edge.back());
  whole.middle.resize(first_row.back());
  whole.offsets.resize(first_row.back() + 1);
  share_work(static_cast<std::uint32_t>(parts.size()), [&](std::uint32_t p) {
    const GraphRows& part = parts[p];
    std::copy(part.neighbors.begin(), part.neighbors.end(), whole.neighbors.data() + first_edge[p]);
    std::copy(part.weights.begin(), part.weights.end(), whole.weights.data() + first_edge[p]);
    for (std::size_t row = 0; row < part.middle.size(); ++row) {
      whole.offsets[first_row[p] + row] = first_edge[p] + part.offsets[row];
      whole.middle[first_row[p] + row] = first_edge[p] + part.middle[row];
    }
  });
  whole.offsets.back() = first_edge.back();
  return whole;
}

}  // namespace

void make_bridge_graph(const Level& fine, const Aggregates& aggregates, Level& coarse) {
  const std::uint32_t nodes = aggregates.count();
  const std::uint32_t pieces = piece_count(nodes);
  std::vector<GraphRows> parts(pieces);
  share_work(pieces, [&](std::uint32_t p) {
    parts[p] = make_rows(fine, aggregates, piece_begin(nodes, pieces, p), piece_begin(nodes, pieces, p + 1));
  });
  GraphRows rows = pieces == 1 ? std::move(parts.front()) : join(parts);
  parts.clear();
  coarse.storage = {.offsets = std::move(rows.offsets), .neighbors = std::move(rows.neighbors)};
  coarse.weights = std::move(rows.weights);
  coarse.middle = std::move(rows.middle);
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
  coarse.edge_ends = coarse.neighbors.size();
  set_degrees(coarse);
}

}  // namespace deltamesh::multigrid
