// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/galerkin.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/prefetch.h"
#include "laplacian/settling/row_sums.h"
#include "laplacian/settling/upper_half.h"

namespace deltamesh::settling {
namespace {

/// Rows of P^T: of each, the nodes interpolated from it, ascending but that those on the rim come last.
/// Without branches on weights, which could not be predicted.
SparseRows transpose(const Level& fine, std::uint32_t nodes) {
  SparseRows rows{.start = LargeVector<std::uint32_t>(nodes + 1, 0), .entries = {}};
  std::uint32_t* const start = rows.start.data();
  const Interpolation* const interpolation = fine.interpolation.data();
  fine.chunks.visit([=](std::uint32_t i) {
    for (std::size_t k = 0; k < 3; ++k)
      start[interpolation[i].node(k) + 1] += interpolation[i].counts(k) ? 1 : 0;
  });
  for (std::size_t c = 0; c < nodes; ++c) start[c + 1] += start[c];
  rows.entries.resize(start[nodes]);
  LargeVector<std::uint32_t> next(rows.start.begin(), rows.start.end() - 1);
  fine.chunks.visit([entries = rows.entries.data(), places = next.data(), interpolation](std::uint32_t i) {
    for (std::size_t k = 3; k-- > 0;) {  // the first one overwrites those without weight, whose node it has
      std::uint32_t& place = places[interpolation[i].node(k)];
      entries[place] = {i, interpolation[i].weight(k)};
      place += interpolation[i].counts(k) ? 1 : 0;
    }
  });
  return rows;
}

/// Has the rows of `members` fetched; returns how many nodes and edges these are.
std::size_t fetch_rows(const Level& fine, std::span<const Entry> members) noexcept {
  std::size_t count = members.size();
  for (const Entry& member : members) {
    const std::size_t node = member.node;
    const std::size_t begin = fine.offsets[node];
    count += fine.offsets[node + 1] - begin;
    prefetch(fine.neighbors.data() + begin);
    if (!fine.has_unit_weights()) prefetch(fine.weights.data() + begin);
  }
  return count;
}

template <bool kUnitWeights>
RowSums add_neighborhoods(const Level& fine, std::span<const Entry> members, SumTable& table) {
  RowSums row = table.row(fetch_rows(fine, members));
  const std::uint32_t* const offsets = fine.offsets.data();
  const std::uint32_t* const neighbors = fine.neighbors.data();
  const float* const weights = fine.weights.data();
  const float* const degree = fine.degree.data();
  for (const Entry& member : members) {
    const std::size_t node = member.node;
    const float share = member.weight;
    const std::size_t end = offsets[node + 1];
    row.add(node, -share * degree[node]);
    for (std::size_t e = offsets[node]; e < end; ++e)
      row.add(neighbors[e], kUnitWeights ? share : share * weights[e]);
  }
  return row;
}

/// Row c of -P^T K, over fine nodes.
RowSums sum_neighborhoods(const Level& fine, std::span<const Entry> members, SumTable& table) {
  return fine.has_unit_weights() ? add_neighborhoods<true>(fine, members, table)
                                 : add_neighborhoods<false>(fine, members, table);
}

/// Row c of -P^T K P from that of -P^T K.
RowSums interpolate_row(const Level& fine, RowSums near, SumTable& table) {
  RowSums row = table.row(3 * near.columns().size());
  const Interpolation* const interpolation = fine.interpolation.data();
  for (const std::uint32_t i : near.columns()) {
    const Interpolation p = interpolation[i];
    const float factor = near.take(i);
    row.add(p.node(0), factor * p.weight(0));
    if (!p.counts(1)) continue;  // seeds, mostly; then the third one does not count either
    row.add(p.node(1), factor * p.weight(1));
    row.add(p.node(2), factor * p.weight(2));
  }
  return row;
}

/// Makes rows of the upper half, and finds what is largest in the whole ones.
class RowMaker {
 public:
  RowMaker(const Level& fine, const SparseRows& members, std::uint32_t nodes, float* largest)
      : fine_(fine), members_(members), near_table_(fine.node_count()), table_(nodes), largest_(largest) {}

  /// That of node `c`, after the others.
  void add(std::uint32_t c, SparseRows& rows) {
    RowSums row = interpolate_row(fine_, sum_neighborhoods(fine_, members_.of(c), near_table_), table_);
    row.take(c);
    const std::size_t before = rows.entries.size();
    rows.entries.resize(before + row.columns().size());
    Entry* place = rows.entries.data() + before;
    float largest = 0;
    for (const std::uint32_t other : row.columns()) {
      const float sum = row.take(other);
      largest = std::max(largest, sum);
      *place = {other, sum};  // no branch: it could not be predicted
      place += (other > c ? 1 : 0) & (sum > 0 ? 1 : 0);
    }
    largest_[c] = largest;
    rows.entries.resize(static_cast<std::size_t>(place - rows.entries.data()));
    rows.end_row();
  }

 private:
  const Level& fine_;
  const SparseRows& members_;  ///< of P^T
  SumTable near_table_;
  SumTable table_;
  float* largest_;
};

/// Up to the row with which there are more than `most` entries.
UpperHalf make_upper_half(const Level& fine, std::uint32_t nodes, std::size_t most) {
  const SparseRows members = transpose(fine, nodes);
  UpperHalf upper;
  upper.largest.resize(nodes);
  upper.rows.begin(nodes, most + nodes);
  RowMaker maker(fine, members, nodes, upper.largest.data());
  for (std::uint32_t c = 0; c < nodes && upper.rows.entries.size() <= most; ++c) maker.add(c, upper.rows);
  return upper;
}

}  // namespace

bool make_galerkin_graph(const Level& fine, std::uint32_t nodes, float smallest, Level& coarse) {
  const std::size_t most = fine.neighbors.size() / 2;
  UpperHalf upper = make_upper_half(fine, nodes, most);
  if (upper.rows.entries.size() > most) return false;
  make_graph(std::move(upper), smallest, coarse);
  return true;
}

}  // namespace deltamesh::settling
