// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/coarsest/envelope_factor.h"

#include <algorithm>

namespace deltamesh::multigrid {
namespace {

/// Appends all that can be reached from `first`, nearest first. `is_seen`: n.
void append_reached(const Level& level, std::uint32_t first, std::vector<bool>& is_seen,
                    std::vector<std::uint32_t>& nodes) {
  std::size_t next = nodes.size();
  nodes.push_back(first);
  is_seen[first] = true;
  for (; next < nodes.size(); ++next) {
    const std::uint32_t node = nodes[next];
    for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e) {
      const std::uint32_t neighbor = level.neighbors[e];
      if (is_seen[neighbor]) continue;
      is_seen[neighbor] = true;
      nodes.push_back(neighbor);
    }
  }
}

/// In four sums, none of which waits for another.
double product(const double* a, const double* b, std::size_t count) noexcept {
  TwoDoubles even{};
  TwoDoubles odd{};
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    even += TwoDoubles{a[k], a[k + 1]} * TwoDoubles{b[k], b[k + 1]};
    odd += TwoDoubles{a[k + 2], a[k + 3]} * TwoDoubles{b[k + 2], b[k + 3]};
  }
  double rest = 0;
  for (; k < count; ++k) rest += a[k] * b[k];
  even += odd;
  return even[0] + even[1] + rest;
}

}  // namespace

void order_narrowly(const Level& level, std::vector<std::uint32_t>& nodes) {
  nodes.clear();
  std::vector<bool> is_seen(level.node_count());
  for (std::uint32_t node = 0; node < level.node_count(); ++node) {
    if (is_seen[node]) continue;
    // What a walk from anywhere reaches last is at an end.
    const auto begin = static_cast<std::ptrdiff_t>(nodes.size());
    append_reached(level, node, is_seen, nodes);
    const std::uint32_t end = nodes.back();
    for (auto reached = nodes.begin() + begin; reached != nodes.end(); ++reached) is_seen[*reached] = false;
    nodes.resize(static_cast<std::size_t>(begin));
    append_reached(level, end, is_seen, nodes);
  }
  std::reverse(nodes.begin(), nodes.end());
}

void EnvelopeFactor::factor(const Level& level) {
  size_ = level.node_count();
  copy_k(level);
  make_rows();
  assemble(level.anchors);
  factor();
}

void EnvelopeFactor::copy_k(const Level& level) {
  const bool is_finest = level.weights.empty();
  order_narrowly(level, nodes_);
  numbers_.resize(size_);
  for (std::uint32_t r = 0; r < size_; ++r) numbers_[nodes_[r]] = r;
  first_entry_.assign(1, 0);
  entries_.clear();
  inverse_mass_.clear();
  for (const std::uint32_t node : nodes_) {
    const double degree = is_finest ? unit_degree(level, node) : level.degree[node];
    inverse_mass_.push_back(1 / (is_finest ? degree * degree : level.mass[node]));
    entries_.push_back({numbers_[node], degree});
    for (std::uint32_t e = level.offsets[node]; e < level.offsets[node + 1]; ++e)
      entries_.push_back({numbers_[level.neighbors[e]], is_finest ? -1.0 : -level.weights[e]});
    first_entry_.push_back(static_cast<std::uint32_t>(entries_.size()));
  }
}

std::span<const EnvelopeFactor::Entry> EnvelopeFactor::row_of_k(std::size_t i) const noexcept {
  return {entries_.data() + first_entry_[i], entries_.data() + first_entry_[i + 1]};
}

void EnvelopeFactor::make_rows() {
  first_column_.resize(size_);
  for (std::size_t i = 0; i < size_; ++i) first_column_[i] = i;
  for (std::size_t r = 0; r < size_; ++r) {
    std::size_t lowest = r;
    for (const Entry& entry : row_of_k(r)) lowest = std::min<std::size_t>(lowest, entry.column);
    for (const Entry& entry : row_of_k(r))
      first_column_[entry.column] = std::min(first_column_[entry.column], lowest);
  }
  begin_.clear();
  std::size_t size = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    begin_.push_back(size);
    size += i + 1 - first_column_[i];
  }
  lower_.assign(size, 0.0);
}

/// Adds row r of K, times 1 / M and itself, for every r.
void EnvelopeFactor::assemble(std::span<const std::uint32_t> anchors) {
  for (std::size_t r = 0; r < size_; ++r) {
    for (const Entry& a : row_of_k(r)) {
      const std::size_t first = first_column_[a.column];
      for (const Entry& b : row_of_k(r)) {
        if (b.column <= a.column) row(a.column)[b.column - first] += a.value * b.value * inverse_mass_[r];
      }
    }
  }
  for (const std::uint32_t anchor : anchors) {
    const std::uint32_t i = numbers_[anchor];
    row(i)[i - first_column_[i]] += 1;
  }
}

void EnvelopeFactor::factor() {
  scaled_.resize(size_);
  inverse_diagonal_.resize(size_);
  for (std::size_t i = 0; i < size_; ++i) {
    const std::size_t first = first_column_[i];
    double* const own = row(i);
    for (std::size_t j = first; j < i; ++j) {
      const std::size_t both = std::max(first, first_column_[j]);
      scaled_[j] = own[j - first] - product(&scaled_[both], row(j) + (both - first_column_[j]), j - both);
    }
    double pivot = own[i - first];
    for (std::size_t j = first; j < i; ++j) {
      own[j - first] = scaled_[j] * inverse_diagonal_[j];
      pivot -= scaled_[j] * own[j - first];
    }
    inverse_diagonal_[i] = pivot > 0 ? 1 / pivot : 0;
  }
}

void EnvelopeFactor::solve(std::span<Double4> b) {
  solution_.clear();
  for (std::size_t i = 0; i < size_; ++i) {
    const double* const own = row(i);
    const std::size_t first = first_column_[i];
    Double4 sum = b[nodes_[i]];
    for (std::size_t j = first; j < i; ++j) sum -= own[j - first] * solution_[j];
    solution_.push_back(sum);
  }
  for (std::size_t i = 0; i < size_; ++i) solution_[i] = inverse_diagonal_[i] * solution_[i];
  for (std::size_t i = size_; i-- > 0;) {
    const double* const own = row(i);
    const std::size_t first = first_column_[i];
    for (std::size_t j = first; j < i; ++j) solution_[j] -= own[j - first] * solution_[i];
    b[nodes_[i]] = solution_[i];
  }
}

}  // namespace deltamesh::multigrid
