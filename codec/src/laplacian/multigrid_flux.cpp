// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_flux.h"

#include <algorithm>
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

/// Rows of A, above 0 and beside the diagonal only, halved.
struct Rows {
  LargeVector<std::uint32_t> start;
  LargeVector<Entry> entries;
};

void add_interpolated(const Interpolation& p, float factor, RowSums& row) noexcept {
  for (std::size_t k = 0; k < 3; ++k) row.add(p.node[k], factor * p.weight[k]);
}

/// Edges inside of an aggregate cancel out.
RowSums sum_flux(const Level& fine, const Aggregates& aggregates, std::span<const std::uint32_t> members,
                 std::uint32_t aggregate, RowSums row) {
  for (const std::uint32_t i : members) {
    float outward = 0;
    for (std::uint32_t e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e) {
      const std::uint32_t j = fine.neighbors[e];
      if (aggregates.of(j) == aggregate) continue;
      const float weight = fine.weight(e);
      outward += weight;
      add_interpolated(fine.interpolation[j], weight, row);
    }
    add_interpolated(fine.interpolation[i], -outward, row);
  }
  return row;
}

Rows make_rows(const Level& fine, const Aggregates& aggregates) {
  const auto nodes = static_cast<std::uint32_t>(aggregates.seeds.size());
  const Members members(aggregates);
  SumTable table(nodes);
  Rows rows{.start = LargeVector<std::uint32_t>(nodes + 1), .entries = {}};
  LargeVector<Entry>& entries = rows.entries;
  rows.start[0] = 0;
  entries.reserve(fine.neighbors.size() / 2);
  for (std::uint32_t c = 0; c < nodes; ++c) {
    RowSums row = sum_flux(fine, aggregates, members.of(c), c, table.row());
    row.finish([&](std::uint32_t other, float sum) {
      if (other != c && sum > 0) entries.push_back({other, 0.5F * sum});
    });
    rows.start[c + 1] = static_cast<std::uint32_t>(entries.size());
  }
  return rows;
}

/// Entries left of the diagonal as the rows that they would be in above it.
Rows transpose_lower(const Rows& rows) {
  const std::size_t nodes = rows.start.size() - 1;
  Rows result{.start = LargeVector<std::uint32_t>(nodes + 1, 0), .entries = {}};
  const auto each_lower = [&](const auto& take) {
    for (std::uint32_t c = 0; c < nodes; ++c) {
      for (std::uint32_t e = rows.start[c]; e < rows.start[c + 1]; ++e) {
        if (rows.entries[e].node < c) take(c, rows.entries[e]);
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
UpperHalf symmetrize(const Rows& rows) {
  const auto nodes = static_cast<std::uint32_t>(rows.start.size() - 1);
  const Rows others = transpose_lower(rows);
  SumTable table(nodes);
  UpperHalf upper;
  upper.start.assign(1, 0);
  upper.start.reserve(nodes + 1);
  upper.largest.assign(nodes, 0.0F);
  upper.entries.reserve(rows.entries.size());
  for (std::uint32_t c = 0; c < nodes; ++c) {
    RowSums row = table.row();
    for (std::uint32_t e = rows.start[c]; e < rows.start[c + 1]; ++e) {
      if (rows.entries[e].node > c) row.add(rows.entries[e].node, rows.entries[e].weight);
    }
    for (std::uint32_t e = others.start[c]; e < others.start[c + 1]; ++e)
      row.add(others.entries[e].node, others.entries[e].weight);
    float largest = upper.largest[c];
    row.finish([&](std::uint32_t other, float sum) {
      largest = std::max(largest, sum);
      upper.largest[other] = std::max(upper.largest[other], sum);
      upper.entries.push_back({other, sum});
    });
    upper.largest[c] = largest;
    upper.start.push_back(static_cast<std::uint32_t>(upper.entries.size()));
  }
  return upper;
}

}  // namespace

bool make_flux_graph(const Level& fine, const Aggregates& aggregates, float smallest, Level& coarse) {
  UpperHalf upper = symmetrize(make_rows(fine, aggregates));
  if (upper.entries.size() > fine.neighbors.size() / 2) return false;
  make_graph(std::move(upper), smallest, coarse);
  return true;
}

}  // namespace deltamesh::multigrid
