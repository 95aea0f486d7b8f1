// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Seams by the compact coder: a corner mostly uses the copy that the face across one of its edges uses
// [SEAM-6 .. 8].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/small_code.h"
#include "connectivity/seams/corner_copies.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

class SplitVertex {
 public:
  /// An edge at the vertex with a face on one side so far.
  struct Edge {
    std::uint32_t other;       ///< geometric vertex at the other end
    std::uint32_t copy;        ///< that the face uses here
    std::uint32_t other_copy;  ///< and there
  };

  explicit SplitVertex(std::uint32_t copies) noexcept : copies_(copies) {}

  std::uint32_t copies() const noexcept { return copies_; }
  std::uint32_t used() const noexcept { return used_; }
  std::uint32_t present() const noexcept { return present_; }  ///< the copy used last
  /// Edges to split vertices so far, each counted when it opened.
  std::uint32_t split_neighbors() const noexcept { return split_neighbors_; }

  /// Null where the edge is not open, or too many came since.
  const Edge* find(std::uint32_t other) const noexcept {
    const std::size_t place = place_of(other);
    return place == count_ ? nullptr : &edges_[place];
  }

  void use(std::uint32_t copy) noexcept {
    used_ = std::max(used_, copy + 1);
    present_ = copy;
  }

  /// A face uses `edge`: it closes the edge, or opens it.
  void join(const Edge& edge, bool other_is_split) noexcept {
    const std::size_t place = place_of(edge.other);
    if (place < count_) {
      remove(place);
      return;
    }
    split_neighbors_ += other_is_split ? 1 : 0;
    if (count_ == kMostOpen) remove(0);
    edges_[count_++] = edge;
  }

 private:
  static constexpr std::size_t kMostOpen = 6;

  /// Index of the open edge to `other`; count_ if there is none.
  std::size_t place_of(std::uint32_t other) const noexcept {
    std::size_t place = 0;
    while (place < count_ && edges_[place].other != other) ++place;
    return place;
  }

  void remove(std::size_t place) noexcept {
    --count_;
    for (; place < count_; ++place) edges_[place] = edges_[place + 1];
  }

  std::uint32_t copies_;
  std::uint32_t used_ = 0;
  std::uint32_t present_ = 0;
  std::uint32_t split_neighbors_ = 0;
  std::size_t count_ = 0;
  std::array<Edge, kMostOpen> edges_{};  ///< the oldest first
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class SeamCoder {
 public:
  /// `extra_copies`: vertices of the mesh beyond the geometric ones.
  SeamCoder(Coder& coder, std::uint32_t geometric_count, std::uint32_t extra_copies)
      : coder_(coder), extra_left_(extra_copies), slot_(geometric_count, kUnseen) {}

  /// Codes `copies`, which a writer reads and a reader fills in (its counts being 1 before). Returns nothing,
  /// or the rule that a reader's copies break; the reader's own failure comes first. O(corners).
  const char* code(std::span<const std::uint32_t> geometric_triangles, CornerCopies& copies) {
    for (std::size_t f = 0; f < geometric_triangles.size(); f += 3) {
      const Face face{{geometric_triangles[f], geometric_triangles[f + 1], geometric_triangles[f + 2]},
                      &copies.of_corner[f]};
      if (is_unsplit(face)) continue;
      if (const char* const broken = code_face(face, copies.of_vertex); broken != nullptr) return broken;
    }
    if (extra_left_ != 0) return "SEAM-6";
    const bool all_used = std::all_of(split_.begin(), split_.end(),
                                      [](const SplitVertex& v) { return v.used() == v.copies(); });
    return all_used ? nullptr : "SEAM-8";
  }

 private:
  static constexpr std::uint32_t kUnseen = 0xffffffff;
  static constexpr std::uint32_t kUnsplit = 0xfffffffe;
  static constexpr std::uint32_t kNeighborClasses = 5;
  static constexpr std::uint32_t kLast = kSymbols - 1;  ///< stands for itself and more, the rest as a number

  struct Face {
    std::array<std::uint32_t, 3> vertex;
    std::uint32_t* copy;  ///< of its three corners
  };

  /// State of the other end of an edge at a corner [SEAM-7].
  enum Across : std::uint32_t { kNoFace, kUnsplitEnd, kLaterEnd, kSameEnd, kSplitEnd, kAcrossKinds };
  enum Choice : std::uint32_t { kAhead, kBehind, kNew, kNamed };

  DELTAMESH_LOOP_BODY const char* code_face(const Face& face, std::span<std::uint32_t> counts) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = face.vertex[k];
      if (slot_[v] == kUnseen && !code_count(face, k, counts[v])) return "SEAM-6";
      if (!code_corner(face, k)) return "SEAM-8";
    }
    join_edges(face);
    return nullptr;
  }

  /// Whether its corners are known to have one copy each.
  bool is_unsplit(const Face& face) const noexcept {
    return slot_[face.vertex[0]] == kUnsplit && slot_[face.vertex[1]] == kUnsplit &&
           slot_[face.vertex[2]] == kUnsplit;
  }

  SplitVertex* split_at(std::uint32_t vertex) noexcept {
    return slot_[vertex] < kUnsplit ? &split_[slot_[vertex]] : nullptr;
  }

  /// `value` as a symbol, the rest of a large one as a number.
  template <std::size_t kModels>
  std::uint64_t code_value(std::uint32_t value, const Mixture<kModels>& mixture) {
    const unsigned symbol = coder_.symbol(std::min(value, kLast), mixture);
    return symbol < kLast ? symbol : kLast + std::uint64_t{coder_.number(value - kLast, large_)};
  }

  std::uint32_t neighbor_class(std::uint32_t vertex) noexcept {
    if (slot_[vertex] == kUnseen) return 0;
    const SplitVertex* const split = split_at(vertex);
    return split == nullptr ? 1 : 2 + std::min(split->split_neighbors(), 2U);
  }

  bool code_count(const Face& face, std::size_t k, std::uint32_t& count) {
    const std::uint32_t context = neighbor_class(face.vertex[(k + 1) % 3]) * kNeighborClasses +
                                  neighbor_class(face.vertex[(k + 2) % 3]);
    const std::uint64_t extra = code_value(count - 1, Mixture<1>{{&counts_[context]}});
    if (extra > extra_left_) return false;
    extra_left_ -= static_cast<std::uint32_t>(extra);
    count = static_cast<std::uint32_t>(extra) + 1;
    slot_[face.vertex[k]] = extra == 0 ? kUnsplit : static_cast<std::uint32_t>(split_.size());
    if (extra > 0) split_.emplace_back(count);
    return true;
  }

  bool code_corner(const Face& face, std::size_t k) {
    SplitVertex* const split = split_at(face.vertex[k]);
    std::uint32_t& copy = face.copy[k];
    if (split == nullptr || split->used() == 0) {
      copy = 0;
    } else {
      const std::uint64_t coded = code_copy(face, k, *split);
      if (coded > split->used() || coded >= split->copies()) return false;
      copy = static_cast<std::uint32_t>(coded);
    }
    if (split != nullptr) split->use(copy);
    return true;
  }

  Across across(const Face& face, std::size_t k, std::size_t other, const SplitVertex::Edge* edge) const {
    if (edge == nullptr) return kNoFace;
    if (slot_[face.vertex[other]] == kUnsplit) return kUnsplitEnd;
    if (other > k) return kLaterEnd;
    return face.copy[other] == edge->other_copy ? kSameEnd : kSplitEnd;
  }

  std::uint64_t code_copy(const Face& face, std::size_t k, const SplitVertex& split) {
    const SplitVertex::Edge* const ahead = split.find(face.vertex[(k + 1) % 3]);
    const SplitVertex::Edge* const behind = split.find(face.vertex[(k + 2) % 3]);
    const std::uint32_t second = behind != nullptr ? behind->copy : split.present();
    const std::uint32_t first = ahead != nullptr ? ahead->copy : second;
    const std::uint32_t known =
        across(face, k, (k + 1) % 3, ahead) * kAcrossKinds + across(face, k, (k + 2) % 3, behind);
    const std::uint32_t kind = (first != second ? 2U : 0U) + (split.used() < split.copies() ? 1U : 0U);
    const std::uint32_t use = std::min(split.copies() - 2, 3U) * 4 + std::min(split.used() - 1, 3U);
    const std::uint32_t copy = face.copy[k];
    const std::uint64_t choice = code_value(
        copy == first          ? kAhead
        : copy == second       ? kBehind
        : copy == split.used() ? kNew
                               : kNamed + copy,
        Mixture<2>{{&by_edges_[known * 4 + kind], &by_use_[use * 4 + kind]}, &copy_weights_[kind]});
    // From a table, as branches would often go wrong.
    const std::array<std::uint32_t, kNamed> named = {first, second, split.used()};
    return choice < kNamed ? named[static_cast<std::size_t>(choice)] : choice - kNamed;
  }

  void join_edges(const Face& face) {
    for (std::size_t k = 0; k < 3; ++k) {
      SplitVertex* const split = split_at(face.vertex[k]);
      if (split == nullptr) continue;
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3})
        split->join({face.vertex[other], face.copy[k], face.copy[other]},
                    split_at(face.vertex[other]) != nullptr);
    }
  }

  static constexpr SymbolModel kFreshCount{{60, 10, 3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
  static constexpr SymbolModel kFreshChoice{{60, 10, 10, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  Coder& coder_;
  std::uint32_t extra_left_;
  std::vector<std::uint32_t> slot_;  ///< place in split_ of every geometric vertex, kUnseen or kUnsplit
  std::vector<SplitVertex> split_;
  std::vector<SymbolModel> counts_ = std::vector(kNeighborClasses * kNeighborClasses, kFreshCount);
  std::vector<SymbolModel> by_edges_ = std::vector(kAcrossKinds * kAcrossKinds * 4, kFreshChoice);
  std::vector<SymbolModel> by_use_ = std::vector(4 * 4 * 4, kFreshChoice);
  std::array<MixWeights, 4> copy_weights_;
  NumberModel large_;
};

}  // namespace deltamesh
