// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/small_components.h"

#include <algorithm>
#include <array>

#include "laplacian/settling/dense_component.h"

namespace deltamesh::settling {
namespace {

static_assert(SmallComponents::kLargest <= DenseComponent::kLargest);

/// Items sorted by the small component they belong to, in order within each. `place_of` gives an item's
/// component, or `count` for none; the items of component c are items[first[c] .. first[c + 1]).
template <class PlaceOf>
void sort_by_component(std::uint32_t item_count, std::uint32_t count, const PlaceOf& place_of,
                       std::vector<std::uint32_t>& items, std::vector<std::uint32_t>& first) {
  first.assign(std::size_t{count} + 1, 0);
  for (std::uint32_t i = 0; i < item_count; ++i) {
    const std::uint32_t c = place_of(i);
    if (c < count) ++first[c + 1];
  }
  for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
  items.resize(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < item_count; ++i) {
    const std::uint32_t c = place_of(i);
    if (c < count) items[next[c]++] = i;
  }
}

/// Vertices of a component to numbers from 0, in the same order. Mostly the vertices follow each other.
class LocalNumbers {
 public:
  explicit LocalNumbers(std::span<const std::uint32_t> vertices) noexcept
      : vertices_(vertices), is_run_(vertices.back() - vertices.front() + 1 == vertices.size()) {}

  std::uint32_t of(std::uint32_t vertex) const noexcept {
    if (is_run_) return vertex - vertices_.front();
    return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) -
                                      vertices_.begin());
  }

 private:
  std::span<const std::uint32_t> vertices_;
  bool is_run_;
};

/// `columns`: room for a component. Returns how many are used: the vertex and its neighbours, ascending.
std::size_t collect_columns(const Adjacency& graph, const LocalNumbers& numbers, std::uint32_t vertex,
                            std::span<std::uint32_t> columns) noexcept {
  std::size_t used = 0;
  bool own_is_in = false;
  for (const std::uint32_t neighbor : graph.of(vertex)) {
    if (!own_is_in && neighbor > vertex) {
      columns[used++] = numbers.of(vertex);
      own_is_in = true;
    }
    columns[used++] = numbers.of(neighbor);
  }
  if (!own_is_in) columns[used++] = numbers.of(vertex);
  return used;
}

}  // namespace

SmallComponents::SmallComponents(const Adjacency& graph, const Components& components,
                                 std::span<const std::uint32_t> anchors)
    : graph_(graph), anchor_vertex_(anchors.begin(), anchors.end()) {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> place(components.count);
  for (std::uint32_t c = 0; c < components.count; ++c)
    place[c] = components.size[c] <= kLargest ? count++ : components.count;
  first_vertex_.assign(1, 0);
  if (count == 0) return;
  sort_by_component(
      static_cast<std::uint32_t>(graph.vertex_count()), count,
      [&](std::uint32_t v) { return place[components.label[v]]; }, vertices_, first_vertex_);
  sort_by_component(
      static_cast<std::uint32_t>(anchors.size()), count,
      [&](std::uint32_t a) { return place[components.label[anchors[a]]]; }, anchors_, first_anchor_);
}

bool SmallComponents::solve_range(std::uint32_t begin, std::uint32_t end, const DeltaView& deltas,
                                  std::span<const Vec3> anchor_positions, std::span<Vec3> x) const {
  DenseComponent component;
  std::array<std::uint32_t, kLargest> columns;
  for (std::uint32_t c = begin; c < end; ++c) {
    const auto vertices = vertices_of(c);
    const LocalNumbers numbers(vertices);
    component.begin(static_cast<std::uint32_t>(vertices.size()));
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
      if (graph_.degree(vertices[i]) == 0) continue;
      const std::size_t used = collect_columns(graph_, numbers, vertices[i], columns);
      component.add_row(i, std::span(columns).first(used), deltas[vertices[i]]);
    }
    for (const std::uint32_t a : anchors_of(c))
      component.add_anchor(numbers.of(anchor_vertex_[a]), anchor_positions[a]);
    if (!component.solve()) return false;
    for (std::uint32_t i = 0; i < vertices.size(); ++i) x[vertices[i]] = component.solution(i);
  }
  return true;
}

Result<void> SmallComponents::solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                    std::span<Vec3> x) const {
  const auto count = static_cast<std::uint32_t>(first_vertex_.size() - 1);
  if (solve_range(0, count, deltas, anchor_positions, x)) return {};
  return Error{
      .code = ErrorCode::kInvalidStream, .message = "the least-squares system is singular", .rule = "DELT-4"};
}

}  // namespace deltamesh::settling
