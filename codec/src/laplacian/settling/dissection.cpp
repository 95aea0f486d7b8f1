// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/dissection.h"

#include <cstddef>
#include <span>
#include <utility>

namespace deltamesh::settling {
namespace {

/// Rows that are not taken apart any more.
constexpr std::size_t kSmall = 12;

/// Of rows that are no hubs, through which everything would be near everything.
constexpr std::uint32_t kMostNeighbors = 64;

class Dissection {
 public:
  explicit Dissection(const Adjacency& graph)
      : graph_(graph),
        part_(graph.vertex_count(), 0),
        place_(part_.size()),
        last_(static_cast<std::uint32_t>(part_.size())) {}

  std::vector<std::uint32_t> run() {
    std::vector<std::uint32_t> all;
    for (std::uint32_t row = 0; row < part_.size(); ++row) {
      if (graph_.degree(row) > kMostNeighbors) {
        part_[row] = kPlaced;
        place_[row] = --last_;
      } else {
        all.push_back(row);
      }
    }
    push_components(all, 0);
    while (!components_.empty()) {
      const std::vector<std::uint32_t> rows = std::move(components_.back());
      components_.pop_back();
      take_apart(rows);
    }
    return std::move(place_);
  }

 private:
  /// Rows by their distance from the first one, and where each distance begins, and the end.
  struct Search {
    std::vector<std::uint32_t> rows;
    std::vector<std::size_t> levels;
  };

  /// Of rows of one part, which become part `next`.
  Search search_from(std::uint32_t first, std::uint32_t next) {
    const std::uint32_t part = part_[first];
    Search search{.rows = {first}, .levels = {0}};
    part_[first] = next;
    for (std::size_t begin = 0; begin < search.rows.size();) {
      const std::size_t end = search.rows.size();
      for (std::size_t k = begin; k < end; ++k) visit_neighbors(search.rows[k], part, next, search.rows);
      search.levels.push_back(end);
      begin = end;
    }
    return search;
  }

  void visit_neighbors(std::uint32_t row, std::uint32_t part, std::uint32_t next,
                       std::vector<std::uint32_t>& rows) {
    for (const std::uint32_t other : graph_.of(row)) {
      if (part_[other] != part) continue;
      part_[other] = next;
      rows.push_back(other);
    }
  }

  /// `rows`: all of a part.
  void push_components(std::span<const std::uint32_t> rows, std::uint32_t part) {
    for (const std::uint32_t row : rows) {
      if (part_[row] == part) components_.push_back(search_from(row, ++parts_).rows);
    }
  }

  /// A component of a part. Starts from a row that is far from others, so that levels are many and small.
  void take_apart(std::span<const std::uint32_t> rows) {
    const std::uint32_t far = search_from(rows.front(), ++parts_).rows.back();
    const Search search = search_from(far, ++parts_);
    std::size_t middle = 0;
    while (2 * search.levels[middle + 1] < rows.size()) ++middle;
    const bool is_small = rows.size() <= kSmall || search.levels.size() < 4;
    const std::size_t begin = is_small ? 0 : search.levels[middle];
    const std::size_t end = is_small ? rows.size() : search.levels[middle + 1];
    for (std::size_t k = end; k-- > begin;) {
      part_[search.rows[k]] = kPlaced;
      place_[search.rows[k]] = --last_;
    }
    const std::uint32_t part = parts_;
    push_components(std::span(search.rows).first(begin), part);
    push_components(std::span(search.rows).subspan(end), part);
  }

  static constexpr std::uint32_t kPlaced = ~std::uint32_t{0};

  const Adjacency& graph_;
  std::vector<std::uint32_t> part_;  ///< of each row; kPlaced once it has its place
  std::vector<std::uint32_t> place_;
  std::uint32_t last_;                                  ///< lowest place taken
  std::uint32_t parts_ = 0;                             ///< numbered so far
  std::vector<std::vector<std::uint32_t>> components_;  ///< to be taken apart
};

}  // namespace

std::vector<std::uint32_t> dissect(const Adjacency& graph) { return Dissection(graph).run(); }

}  // namespace deltamesh::settling
