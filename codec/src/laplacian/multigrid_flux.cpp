// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_flux.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "laplacian/multigrid_row_sums.h"
#include "laplacian/multigrid_upper_half.h"

namespace deltamesh::multigrid {
namespace {

/// The nodes of every aggregate, in order.
struct Members {
  explicit Members(const Aggregates& aggregates)
      : start(aggregates.seeds.size() + 1, 0), nodes(aggregates.codes.size()) {
    const auto count = static_cast<std::uint32_t>(nodes.size());
    for (std::uint32_t i = 0; i < count; ++i) ++start[aggregates.of(i)];
    for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
    for (std::uint32_t i = count; i-- > 0;) nodes[--start[aggregates.of(i)]] = i;
  }
  std::span<const std::uint32_t> of(std::uint32_t aggregate) const noexcept {
    return std::span(nodes).subspan(start[aggregate], start[aggregate + 1] - start[aggregate]);
  }

  LargeVector<std::uint32_t> start;
  LargeVector<std::uint32_t> nodes;
};

/// Of an edge inside of an aggregate, and of one that leads out.
constexpr std::array<float, 2> kShare = {0, 1};

void add_interpolated(const Interpolation& p, float factor, RowSums& row) noexcept {
  for (std::size_t k = 0; k < 3; ++k) row.add(p.node[k], factor * p.weight[k]);
}

/// Edges inside of an aggregate cancel out. A branch could not be predicted.
RowSums sum_flux(const Level& fine, const Aggregates& aggregates, std::span<const std::uint32_t> members,
                 std::uint32_t aggregate, RowSums row) {
  for (const std::uint32_t i : members) {
    float outward = 0;
    for (std::uint32_t e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e) {
      const std::uint32_t j = fine.neighbors[e];
      const float weight = kShare[aggregates.of(j) == aggregate ? 0 : 1] * fine.weight(e);
      outward += weight;
      add_interpolated(fine.interpolation[j], weight, row);
    }
    add_interpolated(fine.interpolation[i], -outward, row);
  }
  return row;
}

/// Rows of A, above 0 and beside the diagonal only, halved.
SparseRows make_flux_rows(const Level& fine, const Aggregates& aggregates) {
  const auto nodes = static_cast<std::uint32_t>(aggregates.seeds.size());
  const Members members(aggregates);
  return make_rows(nodes, fine.neighbors.size() / 2,
                   [&](std::uint32_t begin, std::uint32_t end, SparseRows& rows) {
                     SumTable table(nodes);
                     for (std::uint32_t c = begin; c < end; ++c) {
                       RowSums row = sum_flux(fine, aggregates, members.of(c), c, table.row());
                       row.finish([&](std::uint32_t other, float sum) {
                         if (other != c && sum > 0) rows.entries.push_back({other, 0.5F * sum});
                       });
                       rows.end_row();
                     }
                   });
}

/// Entries left of the diagonal as the rows that they would be in above it.
SparseRows transpose_lower(const SparseRows& rows) {
  const std::uint32_t nodes = rows.row_count();
  SparseRows result{.start = LargeVector<std::uint32_t>(nodes + 1, 0), .entries = {}};
  const auto each_lower = [&](const auto& take) {
    for (std::uint32_t c = 0; c < nodes; ++c) {
      for (const Entry& entry : rows.of(c)) {
        if (entry.node < c) take(c, entry);
      }
    }
  };
  each_lower([&](std::uint32_t, const Entry& entry) { ++result.start[entry.node + 1]; });
  for (std::size_t c = 0; c < nodes; ++c) result.start[c + 1] += result.start[c];
  result.entries.resize(result.start[nodes]);
  LargeVector<std::uint32_t> next(result.start.begin(), result.start.end() - 1);
  each_lower([&](std::uint32_t c, const Entry& entry) {
    result.entries[next[entry.node]++] = {c, entry.weight};
  });
  return result;
}

/// The sum of `rows` and its transpose, above the diagonal.
UpperHalf symmetrize(const SparseRows& rows) {
  const std::uint32_t nodes = rows.row_count();
  const SparseRows others = transpose_lower(rows);
  UpperHalf upper;
  upper.rows =
      make_rows(nodes, rows.entries.size(), [&](std::uint32_t begin, std::uint32_t end, SparseRows& sums) {
        SumTable table(nodes);
        for (std::uint32_t c = begin; c < end; ++c) {
          RowSums row = table.row();
          for (const Entry& entry : rows.of(c)) {
            if (entry.node > c) row.add(entry.node, entry.weight);
          }
          for (const Entry& entry : others.of(c)) row.add(entry.node, entry.weight);
          row.finish([&](std::uint32_t other, float sum) { sums.entries.push_back({other, sum}); });
          sums.end_row();
        }
      });
  upper.largest.assign(nodes, 0.0F);
  for (std::uint32_t c = 0; c < nodes; ++c) {
    float largest = upper.largest[c];
    for (const Entry& entry : upper.rows.of(c)) {
      largest = std::max(largest, entry.weight);
      upper.largest[entry.node] = std::max(upper.largest[entry.node], entry.weight);
    }
    upper.largest[c] = largest;
  }
  return upper;
}

}  // namespace

bool make_flux_graph(const Level& fine, const Aggregates& aggregates, float smallest, Level& coarse) {
  UpperHalf upper = symmetrize(make_flux_rows(fine, aggregates));
  if (upper.rows.entries.size() > fine.neighbors.size() / 2) return false;
  make_graph(std::move(upper), smallest, coarse);
  return true;
}

}  // namespace deltamesh::multigrid
