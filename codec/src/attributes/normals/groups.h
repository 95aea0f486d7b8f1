// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which copies of a geometric vertex share a normal [ATTR-21].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/normals/prediction.h"
#include "entropy/coder/model.h"

namespace deltamesh {

/// One side of an edge at the vertex in work.
struct NormalEdge {
  std::uint32_t copy;       ///< of the vertex, counted from its first
  std::uint32_t geometric;  ///< vertex at the other end
  std::uint32_t leader;     ///< of the copy at the other end, if that is coded
  bool is_coded;
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class NormalGroupCoder {
 public:
  explicit NormalGroupCoder(Coder& coder) : coder_(coder) {}

  /// Puts each copy into a group: `group[i]` is 0 or above, groups being numbered as they come. `edges`: in
  /// the order of the copies. `same(i, j)`: whether copy i belongs to the group of which copy j is the first;
  /// asked by writers only. Returns how many groups there are.
  template <class Same>
  std::uint32_t code(const std::vector<NormalEvidence>& copies, const std::vector<NormalEdge>& edges,
                     std::vector<std::uint32_t>& group, Same same) {
    leaders_.clear();
    sums_.clear();
    group.assign(copies.size(), 0);
    const std::span<const NormalEdge> asked =
        edges.size() > kMostEdges ? std::span<const NormalEdge>{} : edges;
    std::size_t begin = 0;
    for (std::uint32_t i = 0; i < copies.size(); ++i) {
      const std::uint32_t none = static_cast<std::uint32_t>(leaders_.size());
      std::uint32_t found = none;
      std::size_t end = begin;
      while (end < asked.size() && asked[end].copy == i) ++end;
      const std::size_t count = rank_groups(
          copies[i].rule, {.own = asked.subspan(begin, end - begin), .before = asked.first(begin)}, group);
      begin = end;
      for (std::size_t rank = 0; rank < count && found == none; ++rank) {
        const Candidate& candidate = ranked_[rank];
        BitModel& model = models_[(rank * 4 + candidate.tie) * kLikeness + candidate.likeness];
        if (coder_.bit(Coder::kWrites && same(i, leaders_[candidate.group]), model)) found = candidate.group;
      }
      group[i] = found;
      if (found == none) {
        leaders_.push_back(i);
        sums_.push_back(copies[i].rule);
      } else {
        sums_[found] += copies[i].rule;
      }
    }
    return static_cast<std::uint32_t>(leaders_.size());
  }

 private:
  static constexpr std::size_t kMostAsked = 3;
  static constexpr std::uint32_t kMostGroups = 16;  ///< of which the last ones are looked at
  static constexpr std::size_t kMostEdges = 128;
  static constexpr std::size_t kLikeness = 8;

  /// The relation of a copy to a group by an edge that they share.
  enum Tie : std::uint32_t { kApart = 0, kOpen = 1, kSplit = 2, kJoined = 3 };

  struct Candidate {
    std::uint32_t group = 0;
    std::uint32_t tie = kApart;
    std::uint32_t likeness = 0;
    float score = 0;
  };

  /// The edges of a copy, and those of the copies before it.
  struct Edges {
    std::span<const NormalEdge> own;
    std::span<const NormalEdge> before;
  };

  /// The most likely groups of a copy come first in ranked_; returns how many are to be asked about.
  std::size_t rank_groups(FourFloats own, const Edges& edges, const std::vector<std::uint32_t>& group) {
    const auto groups = static_cast<std::uint32_t>(leaders_.size());
    const std::uint32_t first = groups > kMostGroups ? groups - kMostGroups : 0;
    find_ties(edges, group, first);
    const float own_size = std::sqrt(dot3(own, own));
    std::size_t count = 0;
    for (std::uint32_t g = first; g < groups; ++g) {
      Candidate c{.group = g, .tie = ties_[g - first], .likeness = 0, .score = 0};
      const float sizes = own_size * std::sqrt(dot3(sums_[g], sums_[g]));
      const float cosine = sizes > 0 ? dot3(own, sums_[g]) / sizes : 0;
      for (const float limit : kCosines) c.likeness += cosine > limit ? 1 : 0;
      c.score = cosine + (c.tie == kJoined ? 2.0F : 0.0F) - (c.tie == kSplit ? 2.0F : 0.0F);
      std::size_t place = count++;
      for (; place > 0 && c.score > ranked_[place - 1].score; --place) ranked_[place] = ranked_[place - 1];
      ranked_[place] = c;
    }
    return std::min(count, kMostAsked);
  }

  /// Fills ties_ with what the edges say that a copy shares with the groups from `first` on.
  void find_ties(const Edges& edges, const std::vector<std::uint32_t>& group, std::uint32_t first) {
    ties_.fill(kApart);
    for (const NormalEdge& a : edges.own) {
      for (const NormalEdge& b : edges.before) {
        if (b.geometric != a.geometric || group[b.copy] < first) continue;
        std::uint32_t& tie = ties_[group[b.copy] - first];
        tie = std::max<std::uint32_t>(tie, !a.is_coded ? kOpen : (a.leader == b.leader ? kJoined : kSplit));
      }
    }
  }

  static constexpr std::array<float, kLikeness - 1> kCosines = {0,     0.5F,   0.85F,  0.95F,
                                                                0.99F, 0.999F, 0.9999F};

  Coder& coder_;
  std::array<BitModel, kMostAsked * 4 * kLikeness> models_;
  std::array<Candidate, kMostGroups> ranked_;
  std::vector<std::uint32_t> leaders_;
  std::array<std::uint32_t, kMostGroups> ties_{};  ///< of the last groups
  std::vector<RuleSum> sums_;
};

}  // namespace deltamesh
