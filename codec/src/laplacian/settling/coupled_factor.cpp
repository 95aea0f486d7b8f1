// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/coupled_factor.h"

#include <utility>

#include "laplacian/settling/dissection.h"

namespace deltamesh::settling {
namespace {

using multigrid::narrow;
using multigrid::widen;

/// Row 2 v is that of s at v, row 2 v + 1 that of x.
SymmetricMatrix assemble(const Adjacency& graph, std::span<const std::uint32_t> anchors) {
  SymmetricMatrix matrix;
  matrix.offsets.push_back(0);
  const auto add = [&](std::uint32_t column, double value) {
    matrix.columns.push_back(column);
    matrix.values.push_back(value);
  };
  for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
    const double degree = graph.degree(v);
    for (const std::uint32_t other : {1U, 0U}) {  // x in the row of s, s in that of x
      bool is_own_due = true;
      const auto add_own = [&] {
        if (std::exchange(is_own_due, false)) add(2 * v + other, degree);
      };
      for (const std::uint32_t neighbor : graph.of(v)) {
        if (neighbor > v) add_own();
        add(2 * neighbor + other, -1);
      }
      add_own();
      matrix.offsets.push_back(static_cast<std::uint32_t>(matrix.columns.size()));
    }
    matrix.diagonal.push_back(degree * degree);
    matrix.diagonal.push_back(0);
  }
  for (const std::uint32_t anchor : anchors) matrix.diagonal[2 * anchor + 1] = -1;
  return matrix;
}

std::vector<std::uint32_t> places(const Adjacency& graph) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t place : dissect(graph)) {
    result.push_back(2 * place);
    result.push_back(2 * place + 1);
  }
  return result;
}

}  // namespace

std::optional<CoupledFactor> CoupledFactor::make(const Adjacency& graph,
                                                 std::span<const std::uint32_t> anchors,
                                                 std::uint64_t& work_left) {
  auto factor = SparseFactor::make(assemble(graph, anchors), places(graph), work_left);
  if (!factor) return std::nullopt;
  CoupledFactor result;
  result.anchors_.assign(anchors.begin(), anchors.end());
  result.factor_ = *std::move(factor);
  result.values_.resize(2 * graph.vertex_count());
  result.vectors_.b.resize(graph.vertex_count());
  result.vectors_.u.resize(graph.vertex_count());
  result.vectors_.gaps.resize(anchors.size());
  result.vectors_.forces.resize(anchors.size());
  return result;
}

void CoupledFactor::solve() {
  for (std::size_t v = 0; v < vectors_.b.size(); ++v) {
    values_[2 * v] = widen(vectors_.b[v].x);
    values_[2 * v + 1] = widen(vectors_.b[v].s);
  }
  for (std::size_t a = 0; a < anchors_.size(); ++a)
    values_[2 * std::size_t{anchors_[a]} + 1] -= widen(vectors_.gaps[a]);
  factor_.solve(values_);
  for (std::size_t v = 0; v < vectors_.u.size(); ++v)
    vectors_.u[v] = {narrow(values_[2 * v + 1]), narrow(values_[2 * v])};
  for (std::size_t a = 0; a < anchors_.size(); ++a)
    vectors_.forces[a] = vectors_.u[anchors_[a]].x - vectors_.gaps[a];
}

}  // namespace deltamesh::settling
