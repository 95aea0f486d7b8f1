// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A geometric vertex with several copies, on the way through the corners in coded order: what the compact
// form of SEAM knows there [SEAM-7].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

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

  /// Of an edge; count_ where it is not open.
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

}  // namespace deltamesh
