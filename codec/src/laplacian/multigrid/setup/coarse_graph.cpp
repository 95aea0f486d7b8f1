// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/setup/coarse_graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/threads/thread_team.h"
#include "laplacian/multigrid/level/interpolation.h"
#include "laplacian/multigrid/setup/row_sums.h"

namespace deltamesh::multigrid {
namespace {

/// What an edge counts, by how many of its ends are seeds, and what a count of 1 weighs.
constexpr float kShares[] = {2, 3, 6};
constexpr float kUnitOfSecond = 0.2F;
constexpr float kUnitOfThird = 0.185F;  ///< measured: what leaves the energy of smooth fields as it is

/// The edges of some rows.
struct PathEdges {
  LargeVector<std::uint32_t> neighbors;
  LargeVector<float> weights;
  std::uint32_t count = 0;  ///< of those above; then there is room

  void make_room(std::size_t more) {
    if (count + more <= neighbors.size()) return;
    const std::size_t room = 2 * std::size_t{count} + more;
    neighbors.resize(room);
    weights.resize(room);
  }
};

/// Edges as the paths from seed to seed.
template <bool kHasUnitWeights>
class PathRows {
 public:
  PathRows(const Level& fine, const Aggregates& aggregates)
      : fine_(fine),
        aggregates_(aggregates),
        codes_(aggregates.codes.data()),
        last_(aggregates.members.data() + aggregates.members.size()) {}

  void add(std::uint32_t c, RowSums& sums) const noexcept {
    for (const std::uint32_t& member : aggregates_.members_of(c)) add_node(&member, sums);
  }

 private:
  /// Their neighbours are wanted so many members later.
  static constexpr std::ptrdiff_t kAhead = 32;

  void add_node(const std::uint32_t* member, RowSums& sums) const noexcept {
    const std::uint32_t* const offsets = fine_.offsets.data();
    const std::uint32_t* const neighbors = fine_.neighbors.data();
    if (last_ - member > kAhead) __builtin_prefetch(neighbors + offsets[member[kAhead]]);
    const std::uint32_t own = codes_[*member] / Aggregates::kSeed;
    const float shares[] = {kShares[own], kShares[own + 1]};
    const std::size_t end = offsets[*member + 1];
    for (std::size_t e = offsets[*member]; e < end; ++e) {
      const std::uint32_t code = codes_[neighbors[e]];
      const float share = shares[code / Aggregates::kSeed];
      sums.add(code % Aggregates::kSeed, kHasUnitWeights ? share : share * fine_.weights[e]);
    }
  }

  const Level& fine_;
  const Aggregates& aggregates_;
  const std::uint32_t* codes_;
  const std::uint32_t* last_;  ///< end of all members
};

/// Rows of P^T: the nodes that are interpolated from each coarse one, ascending.
struct Transposed {
  Transposed(std::span<const Interpolation> rows, std::uint32_t nodes) : start(nodes + 1, 0) {
    const auto visit = [&](const auto& each) {
      for (std::uint32_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (rows[i].counts(k)) each(i, k);
        }
      }
    };
    visit([&](std::uint32_t i, std::size_t k) { ++start[rows[i].node(k) + 1]; });
    for (std::uint32_t c = 0; c < nodes; ++c) start[c + 1] += start[c];
    entries.resize(start[nodes]);
    LargeVector<std::uint32_t> next(start.begin(), start.end() - 1);
    visit([&](std::uint32_t i, std::size_t k) { entries[next[rows[i].node(k)]++] = {i, rows[i].weight(k)}; });
  }

  struct Entry {
    std::uint32_t node;
    float weight;
  };
  std::span<const Entry> of(std::uint32_t c) const noexcept {
    return std::span(entries).subspan(start[c], start[c + 1] - start[c]);
  }

  LargeVector<std::uint32_t> start;  ///< nodes + 1
  LargeVector<Entry> entries;
};

/// Rows of -P^T K P.
class ProductRows {
 public:
  ProductRows(const Level& fine, const Transposed& transposed)
      : fine_(fine), transposed_(transposed), near_(fine.node_count()) {}

  void add(std::uint32_t c, RowSums& sums) noexcept {
    near_.begin();
    for (const auto& [node, share] : transposed_.of(c)) {
      near_.add(node, -share * fine_.degree[node]);
      for (std::uint32_t e = fine_.offsets[node]; e < fine_.offsets[node + 1]; ++e)
        near_.add(fine_.neighbors[e], share * fine_.weights[e]);
    }
    for (const std::uint32_t node : near_.columns()) {
      const Interpolation& p = fine_.interpolation[node];
      const float value = near_.of(node);
      sums.add(p.node(0), value * p.weight(0));
      sums.add(p.node(1), value * p.weight(1));  // the first once more where that weighs nothing
      sums.add(p.node(2), value * p.weight(2));
    }
  }

 private:
  const Level& fine_;
  const Transposed& transposed_;
  RowSums near_;  ///< of -P^T K
};

/// Puts the row of `c` after the others of `coarse`, whose offsets count from the first of these: first the
/// edges to the nodes below `c`, at the end the others, backwards.
void append(std::uint32_t c, const RowSums& sums, float unit, PathEdges& edges, Level& coarse) {
  const auto columns = sums.columns();
  edges.make_room(columns.size());
  std::uint32_t* const neighbors = edges.neighbors.data() + edges.count;
  float* const weights = edges.weights.data() + edges.count;
  std::size_t low = 0;
  std::size_t high = columns.size() - 1;  // without c itself
  float degree = 0;
  for (const std::uint32_t other : columns) {
    if (other == c) continue;
    const float weight = unit * sums.of(other);
    --high;  // at both ends: one of the places will be overwritten
    neighbors[low] = neighbors[high] = other;
    weights[low] = weights[high] = weight;
    low += other < c ? 1 : 0;
    high += other < c ? 1 : 0;
    degree += weight;
  }
  coarse.middle[c] = edges.count + static_cast<std::uint32_t>(low);
  edges.count += static_cast<std::uint32_t>(columns.size()) - 1;
  coarse.storage.offsets[c + 1] = edges.count;
  coarse.degree[c] = degree;
  coarse.inverse_degree[c] = degree > 0 ? 1 / degree : 0;
}

/// Numbers the edges of the rows from `begin` to `end` from `first` on, and puts them there.
void place(const PathEdges& edges, std::uint32_t begin, std::uint32_t end, std::uint32_t first,
           Level& coarse) {
  for (std::uint32_t c = begin; c < end; ++c) {
    coarse.middle[c] += first;
    coarse.storage.offsets[c + 1] += first;
  }
  std::copy_n(edges.neighbors.begin(), edges.count, coarse.storage.neighbors.data() + first);
  std::copy_n(edges.weights.begin(), edges.count, coarse.weights.data() + first);
}

/// One part after the other.
void join(std::span<PathEdges> parts, Level& coarse, ThreadTeam* team) {
  const auto pieces = static_cast<std::uint32_t>(parts.size());
  const std::size_t nodes = coarse.middle.size();
  std::vector<std::uint32_t> first(1, 0);
  for (const PathEdges& part : parts) first.push_back(first.back() + part.count);
  if (pieces == 1) {
    coarse.storage.neighbors = std::move(parts.front().neighbors);
    coarse.weights = std::move(parts.front().weights);
  }
  coarse.storage.neighbors.resize(first.back());
  coarse.weights.resize(first.back());
  if (pieces == 1) return;
  share_work(team, pieces, [&](std::uint32_t p) {
    place(parts[p], piece_begin(nodes, pieces, p), piece_begin(nodes, pieces, p + 1), first[p], coarse);
  });
}

}  // namespace

void make_coarse_graph(const Level& fine, const Aggregates& aggregates, bool by_paths, Level& coarse,
                       ThreadTeam* team) {
  const std::uint32_t nodes = aggregates.count();
  coarse.storage.offsets.resize(nodes + 1);
  coarse.storage.offsets[0] = 0;
  coarse.middle.resize(nodes);
  coarse.degree.resize(nodes);
  coarse.inverse_degree.resize(nodes);
  const std::uint32_t pieces = piece_count(team, nodes);
  std::vector<PathEdges> parts(pieces);
  const auto make_rows = [&](float unit, const auto& make) {
    share_work(team, pieces, [&](std::uint32_t p) {
      auto rows = make();
      RowSums sums(nodes);
      parts[p].make_room(fine.neighbors.size() / pieces / 2);
      const std::uint32_t end = piece_begin(nodes, pieces, p + 1);
      for (std::uint32_t c = piece_begin(nodes, pieces, p); c < end; ++c) {
        sums.begin();
        sums.add(c, 0);
        rows.add(c, sums);
        append(c, sums, unit, parts[p], coarse);
      }
    });
  };
  if (fine.weights.empty()) {
    make_rows(kUnitOfSecond, [&] { return PathRows<true>(fine, aggregates); });
  } else if (by_paths) {
    make_rows(kUnitOfThird, [&] { return PathRows<false>(fine, aggregates); });
  } else {
    const Transposed transposed(fine.interpolation, nodes);
    make_rows(1, [&] { return ProductRows(fine, transposed); });
  }
  join(parts, coarse, team);
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
}

}  // namespace deltamesh::multigrid
