// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_galerkin.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace deltamesh::multigrid {
namespace {

struct Entry {
  std::uint32_t node;
  float weight;
};

/// Rows of P^T: the nodes interpolated from c are entries[start[c] .. start[c + 1]), ascending.
struct Transpose {
  Transpose(const Level& fine, std::uint32_t nodes) : start(nodes + 1, 0) {
    for (const Interpolation& p : fine.interpolation) {
      for (std::size_t k = 0; k < 3; ++k) start[p.node[k] + 1] += p.weight[k] > 0 ? 1 : 0;
    }
    for (std::size_t c = 0; c < nodes; ++c) start[c + 1] += start[c];
    entries.resize(start[nodes]);
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < fine.interpolation.size(); ++i) {
      const Interpolation& p = fine.interpolation[i];
      for (std::size_t k = 0; k < 3; ++k) {
        if (p.weight[k] > 0) entries[next[p.node[k]]++] = {i, p.weight[k]};
      }
    }
  }
  std::vector<std::uint32_t> start;
  std::vector<Entry> entries;
};

struct Sum {
  float value = 0;
  std::uint32_t is_touched = 0;
};

/// One row of a sparse matrix, sums over columns met in any order, in memory of a SumTable. To be held by
/// value: its count then stays in a register.
class RowSums {
 public:
  RowSums(Sum* sums, std::uint32_t* touched) : sums_(sums), touched_(touched) {}

  void add(std::uint32_t column, float value) noexcept {
    Sum& sum = sums_[column];
    touched_[count_] = column;
    count_ += 1 - sum.is_touched;  // no branch: it could not be predicted
    sum.is_touched = 1;
    sum.value += value;
  }

  /// The same where columns met for the first time are rare.
  void add_known(std::uint32_t column, float value) noexcept {
    if (sums_[column].is_touched == 0) [[unlikely]] {
      sums_[column].is_touched = 1;
      touched_[count_++] = column;
    }
    sums_[column].value += value;
  }

  /// Calls take(column, sum) for every column in the order of first mention, and clears the row.
  template <class Take>
  void finish(const Take& take) {
    for (std::uint32_t k = 0; k < count_; ++k) take(touched_[k], std::exchange(sums_[touched_[k]], {}).value);
    count_ = 0;
  }

 private:
  Sum* sums_;
  std::uint32_t* touched_;
  std::uint32_t count_ = 0;
};

struct SumTable {
  explicit SumTable(std::uint32_t columns) : sums(columns), touched(columns + 1) {}
  RowSums row() noexcept { return {sums.data(), touched.data()}; }

  std::vector<Sum> sums;
  std::vector<std::uint32_t> touched;
};

/// Row c of -P^T K, over fine nodes.
template <bool kUnitWeights>
RowSums sum_neighborhoods(const Level& fine, std::span<const Entry> members, RowSums row) {
  const std::uint32_t* const neighbors = fine.neighbors.data();
  const float* const weights = fine.weights.data();
  for (const Entry& member : members) {
    const std::uint32_t end = fine.offsets[member.node + 1];
    row.add(member.node, -member.weight * fine.degree[member.node]);
    for (std::uint32_t e = fine.offsets[member.node]; e < end; ++e)
      row.add(neighbors[e], kUnitWeights ? member.weight : member.weight * weights[e]);
  }
  return row;
}

/// Row c of -P^T K P from that of -P^T K.
RowSums interpolate_row(const Level& fine, RowSums near, RowSums row) {
  near.finish([&](std::uint32_t i, float factor) {
    const Interpolation& p = fine.interpolation[i];
    for (std::size_t k = 0; k < 3; ++k) row.add_known(p.node[k], factor * p.weight[k]);
  });
  return row;
}

/// Positive entries right of the diagonal, row by row, and the largest of every whole row.
struct UpperHalf {
  std::vector<std::uint32_t> start;
  std::vector<Entry> entries;
  std::vector<float> largest;
};

bool make_upper_half(const Level& fine, std::uint32_t nodes, UpperHalf& upper) {
  const Transpose transpose(fine, nodes);
  SumTable near_table(fine.node_count());
  SumTable table(nodes);
  upper.start.reserve(nodes + 1);
  upper.start.push_back(0);
  upper.largest.reserve(nodes);
  upper.entries.reserve(fine.neighbors.size() / 2 + nodes);
  for (std::uint32_t c = 0; c < nodes; ++c) {
    const auto members =
        std::span(transpose.entries).subspan(transpose.start[c], transpose.start[c + 1] - transpose.start[c]);
    const RowSums near = fine.has_unit_weights() ? sum_neighborhoods<true>(fine, members, near_table.row())
                                                 : sum_neighborhoods<false>(fine, members, near_table.row());
    RowSums row = interpolate_row(fine, near, table.row());
    float largest = 0;
    row.finish([&](std::uint32_t other, float sum) {
      if (other == c) return;
      largest = std::max(largest, sum);
      if (other > c && sum > 0) upper.entries.push_back({other, sum});
    });
    if (upper.entries.size() > fine.neighbors.size() / 2) return false;
    upper.start.push_back(static_cast<std::uint32_t>(upper.entries.size()));
    upper.largest.push_back(largest);
  }
  return true;
}

/// Keeps the entries that are not small.
void drop_small(UpperHalf& upper, float smallest) {
  std::uint32_t kept = 0;
  std::uint32_t first = 0;
  for (std::uint32_t c = 0; c < upper.largest.size(); ++c) {
    const std::uint32_t end = upper.start[c + 1];
    for (std::uint32_t e = first; e < end; ++e) {
      const Entry entry = upper.entries[e];
      if (entry.weight >= smallest * std::min(upper.largest[c], upper.largest[entry.node]))
        upper.entries[kept++] = entry;
    }
    first = end;
    upper.start[c + 1] = kept;
  }
  upper.entries.resize(kept);
}

/// Both halves, in every row first the edges to lower nodes.
void mirror(const UpperHalf& upper, Level& coarse) {
  const auto nodes = static_cast<std::uint32_t>(upper.largest.size());
  auto& offsets = coarse.storage.offsets;
  offsets.assign(nodes + 1, 0);
  for (std::uint32_t c = 0; c < nodes; ++c) offsets[c + 1] = upper.start[c + 1] - upper.start[c];
  for (const Entry& entry : upper.entries) ++offsets[entry.node + 1];
  for (std::uint32_t c = 0; c < nodes; ++c) offsets[c + 1] += offsets[c];
  coarse.storage.neighbors.resize(offsets[nodes]);
  coarse.weights.resize(offsets[nodes]);
  coarse.middle.resize(nodes);
  std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
  const auto put = [&](std::uint32_t from, std::uint32_t to, float weight) {
    coarse.storage.neighbors[next[from]] = to;
    coarse.weights[next[from]++] = weight;
  };
  for (std::uint32_t c = 0; c < nodes; ++c) {
    coarse.middle[c] = next[c];
    for (std::uint32_t e = upper.start[c]; e < upper.start[c + 1]; ++e) {
      put(c, upper.entries[e].node, upper.entries[e].weight);
      put(upper.entries[e].node, c, upper.entries[e].weight);
    }
  }
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
}

}  // namespace

bool make_galerkin_graph(const Level& fine, std::uint32_t nodes, float smallest, Level& coarse) {
  UpperHalf upper;
  if (!make_upper_half(fine, nodes, upper)) return false;
  drop_small(upper, smallest);
  mirror(upper, coarse);
  coarse.degree.resize(nodes);
  coarse.inverse_degree.resize(nodes);
  for (std::uint32_t c = 0; c < nodes; ++c) {
    float degree = 0;
    for (std::uint32_t e = coarse.offsets[c]; e < coarse.offsets[c + 1]; ++e) degree += coarse.weights[e];
    coarse.degree[c] = degree;
    coarse.inverse_degree[c] = degree > 0 ? 1 / degree : 0;
  }
  return true;
}

}  // namespace deltamesh::multigrid
