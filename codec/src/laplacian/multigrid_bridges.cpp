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

namespace deltamesh::multigrid {
namespace {

/// What an edge weighs, in sixteenths, by how many of its ends are seeds. Sums are exact, hence the same from
/// both ends.
constexpr std::array<std::uint32_t, 3> kShares = {6, 9, 18};
constexpr float kUnit = 1.0F / 16;

/// Sums over columns met in any order.
struct Sums {
  explicit Sums(std::uint32_t columns) : values(columns, 0), touched(columns + 1) {}

  LargeVector<std::uint32_t> values;   ///< 0 but for those touched
  LargeVector<std::uint32_t> touched;  ///< one after the other
};

/// Adds up what leads to each aggregate from a member of one, on top of `count` aggregates touched before,
/// and returns how many these are now. No branch: it could not be predicted.
std::uint32_t add_bridges(const Level& fine, const std::uint32_t* codes, std::uint32_t node, bool is_seed,
                          std::uint32_t count, Sums& sums) noexcept {
  std::uint32_t* const values = sums.values.data();
  std::uint32_t* const touched = sums.touched.data();
  const std::uint32_t to_member = kShares[is_seed ? 1 : 0];
  const std::uint32_t more_to_seed = kShares[is_seed ? 2 : 1] - to_member;
  const std::uint32_t* const end = fine.neighbors.data() + fine.offsets[node + 1];
  for (const std::uint32_t* e = fine.neighbors.data() + fine.offsets[node]; e != end; ++e) {
    const std::uint32_t code = codes[*e];
    const std::uint32_t other = code & ~Aggregates::kSeed;
    const std::uint32_t value = values[other];
    touched[count] = other;
    count += value == 0 ? 1 : 0;
    values[other] = value + to_member + more_to_seed * (code >> 31);
  }
  return count;
}

/// The edges of some rows.
struct Edges {
  LargeVector<std::uint32_t> neighbors;
  LargeVector<float> weights;
  std::uint32_t count = 0;  ///< of those above; then there is room

  void make_room(std::size_t more) {
    if (count + more <= neighbors.size()) return;
    neighbors.resize(2 * count + more);
    weights.resize(2 * count + more);
  }
};

/// Makes rows of the coarse graph, whose offsets count from the first of these.
class RowMaker {
 public:
  RowMaker(const Level& fine, const Aggregates& aggregates, Level& coarse)
      : fine_(fine), aggregates_(aggregates), coarse_(coarse), sums_(aggregates.count()) {}

  /// That of aggregate `c`, after the others.
  void add(std::uint32_t c, Edges& edges) {
    std::uint32_t count = 0;
    for (const std::uint32_t node : aggregates_.members_of(c))
      count = add_bridges(fine_, aggregates_.codes.data(), node, aggregates_.is_seed(node), count, sums_);
    const std::span<const std::uint32_t> touched(sums_.touched.data(), count);
    sums_.values[c] = 0;
    edges.make_room(count + 1);
    append(touched, edges, [c](std::uint32_t other) { return other < c; });
    coarse_.middle[c] = edges.count;
    append(touched, edges, [c](std::uint32_t other) { return other > c; });
    coarse_.storage.offsets[c + 1] = edges.count;
    coarse_.degree[c] = kUnit * to_float(clear(touched));
    coarse_.inverse_degree[c] = coarse_.degree[c] > 0 ? 1 / coarse_.degree[c] : 0;
  }

 private:
  /// Those wanted. No branch: it could not be predicted.
  template <class IsWanted>
  void append(std::span<const std::uint32_t> touched, Edges& edges,
              const IsWanted& is_wanted) const noexcept {
    std::uint32_t* neighbor = edges.neighbors.data() + edges.count;
    float* weight = edges.weights.data() + edges.count;
    for (const std::uint32_t other : touched) {
      *neighbor = other;
      *weight = kUnit * to_float(sums_.values[other]);
      const std::ptrdiff_t step = is_wanted(other) ? 1 : 0;
      neighbor += step;
      weight += step;
    }
    edges.count = static_cast<std::uint32_t>(neighbor - edges.neighbors.data());
  }

  /// Returns what it was in all.
  std::uint32_t clear(std::span<const std::uint32_t> touched) noexcept {
    std::uint32_t sum = 0;
    for (const std::uint32_t other : touched) sum += std::exchange(sums_.values[other], 0);
    return sum;
  }

  /// Older processors have no instruction for unsigned integers.
  static float to_float(std::uint32_t sum) noexcept {
    return static_cast<float>(static_cast<std::int32_t>(sum));
  }

  const Level& fine_;
  const Aggregates& aggregates_;
  Level& coarse_;
  Sums sums_;
};

/// Numbers the edges of the rows from `begin` to `end` from `first` on, and puts them there.
void place(const Edges& edges, std::uint32_t begin, std::uint32_t end, std::uint32_t first, Level& coarse) {
  for (std::uint32_t c = begin; c < end; ++c) {
    coarse.middle[c] += first;
    coarse.storage.offsets[c + 1] += first;
  }
  std::copy_n(edges.neighbors.begin(), edges.count, coarse.storage.neighbors.data() + first);
  std::copy_n(edges.weights.begin(), edges.count, coarse.weights.data() + first);
}

/// One part after the other.
void join(std::span<Edges> parts, Level& coarse) {
  const auto pieces = static_cast<std::uint32_t>(parts.size());
  const std::size_t nodes = coarse.middle.size();
  std::vector<std::uint32_t> first(1, 0);
  for (const Edges& part : parts) first.push_back(first.back() + part.count);
  if (pieces == 1) {
    coarse.storage.neighbors = std::move(parts.front().neighbors);
    coarse.weights = std::move(parts.front().weights);
  }
  coarse.storage.neighbors.resize(first.back());
  coarse.weights.resize(first.back());
  if (pieces == 1) return;
  share_work(pieces, [&](std::uint32_t p) {
    place(parts[p], piece_begin(nodes, pieces, p), piece_begin(nodes, pieces, p + 1), first[p], coarse);
  });
}

}  // namespace

void make_bridge_graph(const Level& fine, const Aggregates& aggregates, Level& coarse) {
  const std::uint32_t nodes = aggregates.count();
  coarse.storage.offsets.resize(nodes + 1);
  coarse.storage.offsets[0] = 0;
  coarse.middle.resize(nodes);
  coarse.degree.resize(nodes);
  coarse.inverse_degree.resize(nodes);
  const std::uint32_t pieces = piece_count(nodes);
  std::vector<Edges> parts(pieces);
  share_work(pieces, [&](std::uint32_t p) {
    RowMaker maker(fine, aggregates, coarse);
    parts[p].make_room(fine.neighbors.size() / pieces / 2);
    for (std::uint32_t c = piece_begin(nodes, pieces, p); c < piece_begin(nodes, pieces, p + 1); ++c)
      maker.add(c, parts[p]);
  });
  join(parts, coarse);
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
  coarse.edge_ends = coarse.neighbors.size();
}

}  // namespace deltamesh::multigrid
