// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The known faces of a vertex, whose other corners were coded before it [POSN-3].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "base/simd/four_ints.h"
#include "base/simd/pick_lanes.h"

namespace deltamesh {

/// Faces over vertices. A view.
struct FaceList {
  std::span<const std::uint32_t> triangles;  ///< m x 3 indices below `vertex_count`
  std::uint32_t vertex_count = 0;
};

/// No vertex from there on has a face. O(m), mostly far less.
std::uint32_t count_with_faces(const FaceList& list) noexcept;

inline constexpr std::uint32_t kNoVertex = 0xffffffff;

/// A face rotated so that the corner with the highest number comes first: when vertices are coded by number,
/// a face is known at that corner.
struct RotatedFace {
  std::uint32_t last;  ///< the corner with the highest number
  std::uint32_t a;     ///< the one after it
  std::uint32_t b;     ///< the one before it

  /// Its corners are three vertices.
  bool is_whole() const noexcept { return a != b && a != last && b != last; }
};

/// is_so ? then : otherwise, without a branch.
constexpr std::uint32_t choose(bool is_so, std::uint32_t then, std::uint32_t otherwise) noexcept {
  return otherwise ^ ((then ^ otherwise) & (0U - static_cast<std::uint32_t>(is_so)));
}

/// The face x, y, z, rotated. No branches, as they would often be mispredicted; a table takes twice the time.
constexpr RotatedFace rotated_face(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept {
  const bool is_y = y > x;
  const std::uint32_t later = choose(is_y, y, x);
  const bool is_z = z > later;
  const std::uint32_t last = choose(is_z, z, later);
  const std::uint32_t a = choose(is_z, x, choose(is_y, z, y));
  return {last, a, x ^ y ^ z ^ last ^ a};
}

/// A face whose two other corners come before a vertex, and what is across the edge between these.
struct KnownFace {
  std::uint32_t a;         ///< the corner after the vertex
  std::uint32_t b;         ///< the corner before it
  std::uint32_t opposite;  ///< of the parallelogram, or kNoVertex
};

struct Surroundings {
  static constexpr unsigned kMostKnown = 4;

  std::array<KnownFace, kMostKnown> known;
  FourInts repeated{};               ///< -1 where the corner a of a known face is the corner b of another
  unsigned known_count = 0;          ///< 0: nothing around is known
  unsigned parallelogram_count = 0;  ///< known faces with an opposite corner
  unsigned neighbor_count = 0;       ///< corners of known faces, the repeated ones once
  std::uint32_t faces = 0;           ///< at the vertex, whatever their other corners
};

/// The usual case: one or two known faces, each with a parallelogram.
struct FacePair {
  KnownFace first;
  KnownFace second;      ///< the first where there is no other
  unsigned known_count;  ///< 1 or 2
  std::uint32_t faces;   ///< as in Surroundings
};

/// The corners a and b of the first known faces, two at most.
struct NearCorners {
  std::array<std::uint32_t, 2> a;
  std::array<std::uint32_t, 2> b;
  unsigned known_count;  ///< 0 to 2
};

/// The first known faces of every vertex.
class KnownFaces {
 public:
  /// Vertices in the order of their numbers. O(n + m); memory for those up to the last one with a face.
  explicit KnownFaces(const FaceList& list);

  /// For begin() and add(), by which vertices are numbered in their order. The first `with_faces` have to
  /// come; none after them has a face.
  KnownFaces(std::uint32_t vertex_count, std::uint32_t with_faces)
      : stars_(with_faces), vertex_count_(vertex_count) {}
  /// A vertex, of which nothing is known so far. `faces`: at it, whatever their other corners.
  void begin(std::uint32_t vertex, std::uint32_t faces) noexcept {
    if (vertex < stars_.size()) stars_[vertex] = Star{.faces = faces};
  }
  /// A face of the vertex that began last, after those that come before it in the list.
  void add(const RotatedFace& face) noexcept {
    if (face.is_whole()) stars_[face.last].add(face.a, face.b);
  }

  std::uint32_t vertex_count() const noexcept { return vertex_count_; }
  Surroundings around(std::uint32_t vertex) const noexcept;
  NearCorners near(std::uint32_t vertex) const noexcept {
    if (vertex >= stars_.size()) return {};
    const Star& star = stars_[vertex];
    return {{star.a[0], star.a[1]}, {star.b[0], star.b[1]}, std::min(star.known, 2U)};
  }
  /// False where it is something else that is around `vertex`.
  bool pair_around(std::uint32_t vertex, FacePair& pair) const noexcept;
  /// Whether the prediction of `vertex`, which is above 0, depends on the vertex before it.
  bool needs_previous(std::uint32_t vertex) const noexcept {
    if (vertex >= stars_.size()) return true;
    const Star& star = stars_[vertex];
    const auto previous = static_cast<std::int32_t>(vertex - 1);
    return star.known == 0 ||
           set_lanes((four_ints(star.a) == previous) | (four_ints(star.b) == previous)) != 0;
  }

 private:
  static constexpr std::array<std::uint32_t, Surroundings::kMostKnown> kNone = {kNoVertex, kNoVertex,
                                                                                kNoVertex, kNoVertex};
  struct Star {
    std::array<std::uint32_t, Surroundings::kMostKnown> a = kNone;
    std::array<std::uint32_t, Surroundings::kMostKnown> b = kNone;
    std::uint32_t known = 0;
    std::uint32_t faces = 0;

    void add(std::uint32_t corner_after, std::uint32_t corner_before) noexcept {
      const std::uint32_t i = known;
      if (i == Surroundings::kMostKnown) return;
      a[i] = corner_after;
      b[i] = corner_before;
      known = i + 1;
    }
  };

  std::uint32_t across(std::uint32_t a, std::uint32_t b) const noexcept;

  LargeVector<Star> stars_;  ///< of vertices up to the last one with a face
  std::uint32_t vertex_count_;
};

/// The third corner of the first known face of the later one of `a` and `b` that has both.
inline std::uint32_t KnownFaces::across(std::uint32_t a, std::uint32_t b) const noexcept {
  const std::uint32_t earlier = std::min(a, b);
  const std::uint32_t later = std::max(a, b);
  const Star& star = stars_[later];
  const auto same = static_cast<std::int32_t>(earlier);
  const unsigned found = set_lanes((four_ints(star.a) == same) | (four_ints(star.b) == same));
  if (found == 0) return kNoVertex;
  const auto first = static_cast<std::size_t>(std::countr_zero(found));
  return star.a[first] ^ star.b[first] ^ earlier;
}

[[gnu::always_inline]] inline Surroundings KnownFaces::around(std::uint32_t vertex) const noexcept {
  Surroundings around;
  if (vertex >= stars_.size()) [[unlikely]]
    return around;
  const Star& star = stars_[vertex];
  around.known_count = star.known;
  around.faces = star.faces;
  const FourInts a = four_ints(star.a);
  const FourInts b = four_ints(star.b);
  around.repeated =
      (a == pick_lanes<1, 2, 3, 0>(b)) | (a == pick_lanes<2, 3, 0, 1>(b)) | (a == pick_lanes<3, 0, 1, 2>(b));
  constexpr std::array<std::uint8_t, 16> kCount = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  around.neighbor_count = 2 * star.known - kCount[set_lanes(around.repeated) & ((1U << star.known) - 1)];
  for (unsigned i = 0; i < star.known; ++i) {
    const std::uint32_t opposite = across(star.a[i], star.b[i]);
    around.known[i] = {star.a[i], star.b[i], opposite};
    around.parallelogram_count += opposite != kNoVertex ? 1 : 0;
  }
  return around;
}

[[gnu::always_inline]] inline bool KnownFaces::pair_around(std::uint32_t vertex,
                                                           FacePair& pair) const noexcept {
  if (vertex >= stars_.size()) [[unlikely]]
    return false;
  const Star& star = stars_[vertex];
  const std::size_t second = std::size_t{star.known} - 1;
  if (second > 1) [[unlikely]]
    return false;
  pair.first = {star.a[0], star.b[0], across(star.a[0], star.b[0])};
  pair.second = {star.a[second], star.b[second], across(star.a[second], star.b[second])};
  pair.known_count = star.known;
  pair.faces = star.faces;
  return pair.first.opposite != kNoVertex && pair.second.opposite != kNoVertex;
}

}  // namespace deltamesh
