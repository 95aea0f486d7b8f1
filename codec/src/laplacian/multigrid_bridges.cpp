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
      : offsets_(fine.offsets.data()),
        neighbors_(fine.neighbors.data()),
        codes_(aggregates.codes.data()),
        last_(aggregates.members.data() + aggregates.members.size()),
        coarse_offsets_(coarse.storage.offsets.data()),
        middle_(coarse.middle.data()),
        degree_(coarse.degree.data()),
        inverse_degree_(coarse.inverse_degree.data()),
        sums_(aggregates.count(), 0),
        touched_(aggregates.count() + 1) {}

  /// That of aggregate `c`, after the others.
  void add(std::uint32_t c, std::span<const std::uint32_t> members, Edges& edges) {
    sums_[c] = 1;  // no bridge leads there
    std::size_t count = add_node<true>(members.data(), 0);
    for (const std::uint32_t& member : members.subspan(1)) count = add_node<false>(&member, count);
    sums_[c] = 0;
    edges.make_room(count);
    const Taken taken = take_sums(c, count, edges);
    middle_[c] = edges.count + taken.lower;
    edges.count += static_cast<std::uint32_t>(count);
    coarse_offsets_[c + 1] = edges.count;
    const float degree = to_weight(taken.sum);
    degree_[c] = degree;
    inverse_degree_[c] = degree > 0 ? 1 / degree : 0;
  }

 private:
  /// Of the aggregates that bridges lead to, how many are lower, and what all weigh.
  struct Taken {
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
  std::size_t add_node(const std::uint32_t* member, std::size_t count) noexcept {
    constexpr std::uint32_t kToMember = kShares[kIsSeed ? 1 : 0];
    constexpr std::uint32_t kMoreToSeed = kShares[kIsSeed ? 2 : 1] - kToMember;
    if (last_ - member > kAhead) prefetch(neighbors_ + offsets_[member[kAhead]]);
    std::uint32_t* const sums = sums_.data();
    std::uint32_t* const touched = touched_.data();
    const std::uint32_t* const codes = codes_;
    const std::uint32_t* const offset = offsets_ + *member;
    const std::uint32_t* const end = neighbors_ + offset[1];
    for (const std::uint32_t* e = neighbors_ + offset[0]; e != end; ++e) {
      const std::size_t code = codes[*e];
      const std::size_t other = code % Aggregates::kSeed;
      touched[count] = static_cast<std::uint32_t>(other);
      count += sums[other] == 0 ? 1 : 0;
      sums[other] += kToMember + static_cast<std::uint32_t>(code / Aggregates::kSeed) * kMoreToSeed;
    }
    return count;
  }

  /// Clears the sums of the aggregates touched and makes them edges from the end of `edges` on, first those
  /// to the aggregates below `c`, at the end the others, backwards.
  Taken take_sums(std::uint32_t c, std::size_t count, Edges& edges) noexcept {
    std::uint32_t* const sums = sums_.data();
    std::uint32_t* const neighbors = edges.neighbors.data() + edges.count;
    float* const weights = edges.weights.data() + edges.count;
    std::size_t low = 0;
    std::size_t high = count;
    std::uint32_t all = 0;
    for (const std::uint32_t other : std::span(touched_.data(), count)) {
      const std::uint32_t sum = std::exchange(sums[other], 0);
      --high;  // at both ends: one of the places will be overwritten
      neighbors[low] = neighbors[high] = other;
      weights[low] = weights[high] = to_weight(sum);
      low += other < c ? 1 : 0;
      high += other < c ? 1 : 0;
      all += sum;
    }
    return {static_cast<std::uint32_t>(low), all};
  }

  const std::uint32_t* offsets_;
  const std::uint32_t* neighbors_;
  const std::uint32_t* codes_;
  const std::uint32_t* last_;  ///< end of all members
  std::uint32_t* coarse_offsets_;
  std::uint32_t* middle_;
  float* degree_;
  float* inverse_degree_;
  LargeVector<std::uint32_t> sums_;     ///< by aggregates; 0 but for those touched
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
    const std::uint32_t end = piece_begin(nodes, pieces, p + 1);
    for (std::uint32_t c = piece_begin(nodes, pieces, p); c < end; ++c)
      maker.add(c, aggregates.members_of(c), parts[p]);
  });
  join(parts, coarse);
  coarse.offsets = coarse.storage.offsets;
  coarse.neighbors = coarse.storage.neighbors;
  coarse.edge_ends = coarse.neighbors.size();
}

}  // namespace deltamesh::multigrid
