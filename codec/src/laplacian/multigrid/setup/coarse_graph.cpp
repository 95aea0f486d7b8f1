// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid/setup/coarse_graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/prefetch.h"
#include "base/thread_team.h"

namespace deltamesh::multigrid {
namespace {

/// What an edge counts, by how many of its ends are seeds, and what a count of 1 weighs.
constexpr float kShares[] = {2, 3, 6};
constexpr float kUnit = 0.2F;

/// The edges of some rows.
struct Edges {
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

/// Makes rows of the coarse graph, whose offsets count from the first of these. Without branches that could
/// not be predicted.
class RowMaker {
 public:
  RowMaker(const Level& fine, const Aggregates& aggregates, Level& coarse)
      : fine_(fine),
        codes_(aggregates.codes.data()),
        last_(aggregates.members.data() + aggregates.members.size()),
        coarse_(coarse),
        sums_(aggregates.count(), 0.0F),
        touched_(aggregates.count() + 1) {}

  /// That of aggregate `c`, after the others.
  void add(std::uint32_t c, std::span<const std::uint32_t> members, Edges& edges) {
    std::size_t count = 0;
    sums_[c] = 1;  // no edge leads there
    for (const std::uint32_t& member : members)
      count = fine_.weights.empty() ? add_node<true>(&member, count) : add_node<false>(&member, count);
    sums_[c] = 0;
    edges.make_room(count);
    const Taken taken = take_sums(c, count, edges);
    coarse_.middle[c] = edges.count + taken.lower;
    edges.count += static_cast<std::uint32_t>(count);
    coarse_.storage.offsets[c + 1] = edges.count;
    coarse_.degree[c] = taken.sum;
    coarse_.inverse_degree[c] = taken.sum > 0 ? 1 / taken.sum : 0;
  }

 private:
  /// Of the aggregates that edges lead to, how many are lower, and what all weigh.
  struct Taken {
    std::uint32_t lower;
    float sum;
  };

  /// Their neighbours are wanted so many members later.
  static constexpr std::ptrdiff_t kAhead = 32;

  /// Adds the edges of a member, on top of `count` aggregates touched before; returns how many these are now.
  template <bool kHasUnitWeights>
  std::size_t add_node(const std::uint32_t* member, std::size_t count) noexcept {
    const std::uint32_t* const offsets = fine_.offsets.data();
    const std::uint32_t* const neighbors = fine_.neighbors.data();
    if (last_ - member > kAhead) prefetch(neighbors + offsets[member[kAhead]]);
    const std::uint32_t own = codes_[*member] / Aggregates::kSeed;
    const float shares[] = {kShares[own], kShares[own + 1]};
    const std::size_t end = offsets[*member + 1];
    for (std::size_t e = offsets[*member]; e < end; ++e) {
      const std::uint32_t code = codes_[neighbors[e]];
      const std::size_t other = code % Aggregates::kSeed;
      touched_[count] = static_cast<std::uint32_t>(other);
      count += sums_[other] == 0 ? 1 : 0;
      const float share = shares[code / Aggregates::kSeed];
      sums_[other] += kHasUnitWeights ? share : share * fine_.weights[e];
    }
    return count;
  }

  /// Clears the sums of the aggregates touched and makes them edges from the end of `edges` on, first those
  /// to the aggregates below `c`, at the end the others, backwards.
  Taken take_sums(std::uint32_t c, std::size_t count, Edges& edges) noexcept {
    std::uint32_t* const neighbors = edges.neighbors.data() + edges.count;
    float* const weights = edges.weights.data() + edges.count;
    std::size_t low = 0;
    std::size_t high = count;
    float all = 0;
    for (const std::uint32_t other : std::span(touched_.data(), count)) {
      const float weight = kUnit * std::exchange(sums_[other], 0.0F);
      --high;  // at both ends: one of the places will be overwritten
      neighbors[low] = neighbors[high] = other;
      weights[low] = weights[high] = weight;
      low += other < c ? 1 : 0;
      high += other < c ? 1 : 0;
      all += weight;
    }
    return {static_cast<std::uint32_t>(low), all};
  }

  const Level& fine_;
  const std::uint32_t* codes_;
  const std::uint32_t* last_;  ///< end of all members
  Level& coarse_;
  LargeVector<float> sums_;             ///< by aggregates; 0 but for those touched
  LargeVector<std::uint32_t> touched_;  ///< one after the other
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

void make_coarse_graph(const Level& fine, const Aggregates& aggregates, Level& coarse) {
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
    const std::uint32_t end = piece_begin(nodes, pieces, p + 1);
    for (std::uint32_t c = piece_begin(nodes, pieces, p); c < end; ++c)
      maker.add(c, aggregates.members_of(c), parts[p]);
  });
  join(parts, coarse);
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
}

}  // namespace deltamesh::multigrid
