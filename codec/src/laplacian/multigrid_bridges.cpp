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

#include "base/prefetch.h"
#include "base/thread_team.h"

namespace deltamesh::multigrid {
namespace {

/// What an edge weighs, in sixteenths, by how many of its ends are seeds. Sums are exact, hence the same from
/// both ends.
constexpr std::array<std::uint32_t, 3> kShares = {6, 9, 18};
constexpr float kUnit = 1.0F / 16;

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
        sums_(aggregates.count(), 0),
        touched_(aggregates.count() + 1),
        higher_sums_(aggregates.count() + 1) {}

  /// That of aggregate `c`, after the others.
  void add(std::uint32_t c, std::span<const std::uint32_t> members, Edges& edges) {
    sums_[c] = 1;  // no bridge leads there
    std::uint32_t count = add_node<true>(members.data(), 0);
    for (const std::uint32_t& member : members.subspan(1)) count = add_node<false>(&member, count);
    sums_[c] = 0;
    edges.make_room(count + 1);
    const Split split = split_bridges(c, count, edges);
    coarse_.middle[c] = edges.count + split.lower;
    edges.count += count;
    coarse_.storage.offsets[c + 1] = edges.count;
    coarse_.degree[c] = to_weight(split.sum);
    coarse_.inverse_degree[c] = split.sum > 0 ? 1 / to_weight(split.sum) : 0;
  }

 private:
  /// Of the aggregates that bridges lead to, how many are lower, and what all weigh.
  struct Split {
    std::uint32_t lower;
    std::uint32_t sum;
  };

  /// Older processors have no instruction for unsigned integers.
  static float to_weight(std::uint32_t sum) noexcept {
    return kUnit * static_cast<float>(static_cast<std::int32_t>(sum));
  }

  /// Their neighbours are wanted so many members later.
  static constexpr std::ptrdiff_t kAhead = 32;

  /// Adds the edges of a member, on top of `count` aggregates touched before; returns how many these are now.
  template <bool kIsSeed>
  std::uint32_t add_node(const std::uint32_t* member, std::uint32_t count) noexcept {
    const std::uint32_t node = *member;
    if (last_ - member > kAhead) prefetch(fine_.neighbors.data() + fine_.offsets[member[kAhead]]);
    constexpr std::uint32_t kToMember = kShares[kIsSeed ? 1 : 0];
    constexpr std::uint32_t kToSeed = kShares[kIsSeed ? 2 : 1];
    std::uint32_t* const sums = sums_.data();
    std::uint32_t* const touched = touched_.data();
    const std::uint32_t* const codes = codes_;
    const std::uint32_t* const end = fine_.neighbors.data() + fine_.offsets[node + 1];
    for (const std::uint32_t* e = fine_.neighbors.data() + fine_.offsets[node]; e != end; ++e) {
      const std::uint32_t code = codes[*e];
      const std::uint32_t other = code & ~Aggregates::kSeed;
      const std::uint32_t sum = sums[other];
      touched[count] = other;
      count += sum == 0 ? 1 : 0;
      sums[other] = sum + (code >= Aggregates::kSeed ? kToSeed : kToMember);
    }
    return count;
  }

  /// Lists the aggregates touched from the end of `edges` on, first those below `c`, and clears the sums.
  Split split_bridges(std::uint32_t c, std::uint32_t count, Edges& edges) noexcept {
    std::uint32_t* const neighbors = edges.neighbors.data() + edges.count;
    float* const weights = edges.weights.data() + edges.count;
    std::uint32_t lower = 0;
    std::uint32_t all = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t other = touched_[k];
      const std::uint32_t sum = std::exchange(sums_[other], 0);
      neighbors[lower] = other;
      weights[lower] = to_weight(sum);
      touched_[k - lower] = other;
      higher_sums_[k - lower] = sum;
      lower += other < c ? 1 : 0;
      all += sum;
    }
    for (std::uint32_t k = lower; k < count; ++k) {
      neighbors[k] = touched_[k - lower];
      weights[k] = to_weight(higher_sums_[k - lower]);
    }
    return {lower, all};
  }

  const Level& fine_;
  const std::uint32_t* codes_;
  const std::uint32_t* last_;  ///< end of all members
  Level& coarse_;
  LargeVector<std::uint32_t> sums_;         ///< by aggregates; 0 but for those touched
  LargeVector<std::uint32_t> touched_;      ///< one after the other, then those that are higher
  LargeVector<std::uint32_t> higher_sums_;  ///< of these
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
      maker.add(c, aggregates.members_of(c), parts[p]);
  });
  join(parts, coarse);
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
  coarse.edge_ends = coarse.neighbors.size();
}

}  // namespace deltamesh::multigrid
