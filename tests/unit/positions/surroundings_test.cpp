// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Known faces and what is expected from them, against the rules as they are written down.
#include "positions/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "positions/blend/blend.h"
#include "positions/coding_order.h"
#include "positions/lattice/pair_place.h"
#include "positions/residual_context.h"
#include "support/graph_mesh.h"
#include "support/peak_memory.h"

namespace deltamesh {
namespace {

/// Numbers that look random, the same ones every time.
class Numbers {
 public:
  std::uint32_t below(std::uint32_t range) { return (state_ = state_ * 1664525 + 1013904223) / 16 % range; }

 private:
  std::uint32_t state_ = 7;
};

/// A mesh's faces with its vertices numbered anyhow, some faces twice, some turned over, some without area.
std::vector<std::uint32_t> shuffled(const test::GraphMesh& mesh) {
  Numbers numbers;
  std::vector<std::uint32_t> number(mesh.positions.size());
  for (std::uint32_t v = 0; v < number.size(); ++v) number[v] = v;
  for (std::uint32_t i = static_cast<std::uint32_t>(number.size()); i > 1; --i)
    std::swap(number[i - 1], number[numbers.below(i)]);
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    std::array<std::uint32_t, 3> face = {number[mesh.triangles[i]], number[mesh.triangles[i + 1]],
                                         number[mesh.triangles[i + 2]]};
    const std::uint32_t fate = numbers.below(10);
    if (fate == 0) std::swap(face[0], face[1]);
    if (fate == 1) triangles.insert(triangles.end(), face.begin(), face.end());
    if (fate == 2) triangles.insert(triangles.end(), {face[0], face[1], face[0]});
    triangles.insert(triangles.end(), face.begin(), face.end());
  }
  return triangles;
}

/// [POSN-3] as it is written down: the known faces of `v` with their corners a and b.
std::vector<KnownFace> known_by_the_letter(const FaceList& list, std::uint32_t v) {
  std::vector<KnownFace> known;
  for (std::size_t i = 0; i < list.triangles.size(); i += 3) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t a = list.triangles[i + (corner + 1) % 3];
      const std::uint32_t b = list.triangles[i + (corner + 2) % 3];
      if (list.triangles[i + corner] == v && a < v && b < v && a != b && known.size() < 4)
        known.push_back({a, b, kNoVertex});
    }
  }
  return known;
}

std::uint32_t opposite_by_the_letter(const FaceList& list, const KnownFace& face) {
  const std::uint32_t low = std::min(face.a, face.b);
  for (const KnownFace& other : known_by_the_letter(list, std::max(face.a, face.b))) {
    if (other.a == low) return other.b;
    if (other.b == low) return other.a;
  }
  return kNoVertex;
}

std::vector<test::GraphMesh> meshes() {
  return {test::sheet(9, 7), test::fragments(), test::fan(40), test::sheet(1, 1)};
}

TEST(Surroundings, POSN3AreAsWritten) {
  for (const test::GraphMesh& mesh : meshes()) {
    const auto triangles = shuffled(mesh);
    const FaceList list{triangles, static_cast<std::uint32_t>(mesh.positions.size())};
    const KnownFaces faces(list);
    for (std::uint32_t v = 0; v < list.vertex_count; ++v) {
      const Surroundings around = faces.around(v);
      const auto known = known_by_the_letter(list, v);
      ASSERT_EQ(around.known_count, known.size());
      EXPECT_EQ(around.faces, std::count(triangles.begin(), triangles.end(), v));
      unsigned parallelograms = 0;
      for (unsigned i = 0; i < known.size(); ++i) {
        const bool repeated = std::any_of(known.begin(), known.end(), [&](const KnownFace& other) {
          return &other != &known[i] && other.b == known[i].a;
        });
        EXPECT_EQ(around.known[i].a, known[i].a);
        EXPECT_EQ(around.known[i].b, known[i].b);
        EXPECT_EQ(around.known[i].opposite, opposite_by_the_letter(list, known[i]));
        EXPECT_EQ(around.repeated[static_cast<int>(i)], repeated ? -1 : 0);
        parallelograms += around.known[i].opposite != kNoVertex ? 1 : 0;
      }
      EXPECT_EQ(around.parallelogram_count, parallelograms);
    }
  }
}

TEST(Surroundings, POSN10OrderIsTheNumberOfAVertex) {
  for (const test::GraphMesh& mesh : meshes()) {
    const std::vector<std::uint32_t> faces = shuffled(mesh);
    const auto count = static_cast<std::uint32_t>(mesh.positions.size()) + 3;
    for (const CodingOrder coding_order :
         {CodingOrder::kAsDecoded, CodingOrder::kBroad, CodingOrder::kDeep}) {
      std::vector<std::uint32_t> order;
      const KnownFaces ordered = known_in_order({faces, count}, coding_order, order);
      std::vector<std::uint32_t> triangles = faces;
      for (std::uint32_t& v : triangles)
        if (!order.empty())
          v = static_cast<std::uint32_t>(std::find(order.begin(), order.end(), v) - order.begin());
      const KnownFaces numbered({triangles, count});
      for (std::uint32_t v = 0; v < count; ++v) {
        const Surroundings a = ordered.around(v);
        const Surroundings b = numbered.around(v);
        ASSERT_EQ(a.known_count, b.known_count);
        EXPECT_EQ(a.faces, b.faces);
        EXPECT_EQ(v > 0 && ordered.needs_previous(v), v > 0 && numbered.needs_previous(v));
        for (unsigned i = 0; i < a.known_count; ++i) {
          EXPECT_EQ(a.known[i].a, b.known[i].a);
          EXPECT_EQ(a.known[i].b, b.known[i].b);
          EXPECT_EQ(a.known[i].opposite, b.known[i].opposite);
        }
      }
    }
  }
}

std::int64_t mean_by_the_letter(std::int64_t sum, std::int64_t count) {
  return (sum * ((65536 + count / 2) / count)) >> 16;
}

/// 1/16 steps
std::array<std::int64_t, 3> place_of(const Expectation& expected) {
  std::array<std::int64_t, 3> place{};
  for (int axis = 0; axis < 3; ++axis)
    place[static_cast<std::size_t>(axis)] = 16 * std::int64_t{expected.whole[axis]} + expected.offset[axis];
  return place;
}

struct Expected {
  std::int64_t place;
  std::int64_t spread;
};

/// [POSN-4] as it is written down, for a vertex with known faces.
Expected expected_by_the_letter(const Surroundings& around, std::span<const Cell> cells,
                                const BlendTable& table, std::size_t axis) {
  const std::int64_t base = cells[around.known[0].a][axis];
  std::int64_t sum = 0;
  std::int64_t neighbors = 0;
  std::int64_t corners = 0;
  std::int64_t edges = 0;
  std::int64_t count = 0;
  const auto at = [&](std::uint32_t v) { return cells[v][axis] - base; };
  for (unsigned i = 0; i < around.known_count; ++i) {
    const auto& [a, b, opposite] = around.known[i];
    const bool repeated = around.repeated[static_cast<int>(i)] != 0;
    sum += 16 * (at(b) + (repeated ? 0 : at(a)));
    neighbors += repeated ? 1 : 2;
    if (opposite == kNoVertex) continue;
    ++count;
    corners += 16 * (at(a) + at(b) - at(opposite));
    edges += 8 * (at(a) + at(b));
  }
  const std::int64_t mean = mean_by_the_letter(sum, neighbors);
  std::int64_t apart = 0;
  if (count == 0) {
    for (unsigned i = 0; i < around.known_count; ++i)
      apart += std::abs(16 * at(around.known[i].a) - mean) + std::abs(16 * at(around.known[i].b) - mean);
    return {16 * base + mean,
            std::min(mean_by_the_letter(apart, 2 * around.known_count), std::int64_t{1} << 30)};
  }
  const std::int64_t corner = mean_by_the_letter(corners, count);
  const std::int64_t edge = mean_by_the_letter(edges, count);
  const std::int64_t row = 6 * (count - 1) + std::clamp<std::int64_t>(around.faces, 3, 8) - 3;
  const Blend& blend = table[static_cast<std::size_t>(row)];
  for (unsigned i = 0; i < around.known_count; ++i) {
    const auto& [a, b, opposite] = around.known[i];
    if (opposite != kNoVertex) apart += std::abs(16 * (at(a) + at(b) - at(opposite)) - corner);
  }
  const std::int64_t place =
      16 * base + mean + ((blend.parallelogram * (corner - mean) + blend.edge * (edge - mean)) >> 6);
  constexpr std::int64_t kFarthest = std::int64_t{1} << 30;
  return {16 * std::clamp(place >> 4, -kFarthest, kFarthest) + (place & 15),
          std::min(mean_by_the_letter(apart, count), std::int64_t{1} << 30)};
}

TEST(Surroundings, POSN4PlacesAreAsWrittenNearAndFar) {
  BlendTable table = kUsualBlends;
  Numbers numbers;
  for (Blend& blend : table)
    blend = {.parallelogram = static_cast<std::int8_t>(numbers.below(256) - 128),
             .edge = static_cast<std::int8_t>(numbers.below(256) - 128)};
  for (const test::GraphMesh& mesh : meshes()) {
    const auto triangles = shuffled(mesh);
    const KnownFaces faces({triangles, static_cast<std::uint32_t>(mesh.positions.size())});
    for (const std::uint32_t range : {1U, 1000U, (1U << 17) - 1, 1U << 17, 1U << 18, 1U << 24, 1U << 28}) {
      std::vector<Cell> cells(mesh.positions.size());
      for (Cell& cell : cells)
        for (std::int32_t& q : cell) q = static_cast<std::int32_t>(numbers.below(range));
      for (std::uint32_t v = 0; v < cells.size(); ++v) {
        const Surroundings around = faces.around(v);
        const Expectation expected = expect_place(around, v, cells, table);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Expected letter = around.known_count > 0
                                      ? expected_by_the_letter(around, cells, table, axis)
                                      : Expected{v > 0 ? 16 * std::int64_t{cells[v - 1][axis]} : 0, 0};
          EXPECT_EQ(place_of(expected)[axis], letter.place);
          EXPECT_EQ(expected.spread[static_cast<int>(axis)], letter.spread);
          EXPECT_LT(std::abs(expected.offset[static_cast<int>(axis)]), 1 << 26);
        }
        EXPECT_EQ(expected.whole[3], 0);
        EXPECT_EQ(expected.offset[3], 0);
        FacePair pair;
        const bool is_pair = faces.pair_around(v, pair);
        EXPECT_EQ(is_pair, (around.known_count == 1 || around.known_count == 2) &&
                               around.parallelogram_count == around.known_count);
        Expectation paired;
        if (is_pair && expect_pair(pair, cells, table, paired)) {
          EXPECT_EQ(pair.known_count, around.known_count);
          EXPECT_EQ(place_of(paired), place_of(expected));
          EXPECT_EQ(paired.whole[3], 0);
          EXPECT_EQ(paired.offset[3], 0);
          for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(paired.spread[axis], expected.spread[axis]);
        }
      }
    }
  }
}

TEST(Surroundings, TakeNoMemoryForVerticesWithoutFaces) {
  // A header may declare many of them, for few bytes.
  constexpr std::uint32_t kDeclared = 1U << 23;
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 2, 1, 3};
  const long before = test::peak_memory();
  const KnownFaces faces({triangles, kDeclared});
  EXPECT_LT(test::peak_memory() - before, 4096);
  EXPECT_EQ(faces.vertex_count(), kDeclared);
  EXPECT_EQ(faces.around(3).known_count, 1U);
  EXPECT_EQ(faces.around(3).parallelogram_count, 1U);
  EXPECT_EQ(faces.around(4).known_count, 0U);
  EXPECT_EQ(faces.around(kDeclared - 1).faces, 0U);
  EXPECT_TRUE(faces.needs_previous(kDeclared - 1));
}

TEST(Surroundings, VerticesWithoutFacesMayBeAnywhere) {
  const std::vector<std::uint32_t> triangles = {1, 3, 5, 5, 3, 7};
  const KnownFaces decoded({triangles, 10});
  std::vector<std::uint32_t> order;
  const KnownFaces ordered = known_in_order({triangles, 10}, CodingOrder::kBroad, order);
  EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 7, 4, 6, 8, 9}));
  for (std::uint32_t i = 0; i < 10; ++i) {
    const Surroundings around = ordered.around(i);
    EXPECT_EQ(around.known_count, decoded.around(order[i]).known_count) << i;
    EXPECT_EQ(around.faces, decoded.around(order[i]).faces) << i;
    EXPECT_EQ(around.parallelogram_count, order[i] == 7 ? 1U : 0U) << i;
  }
}

TEST(Surroundings, POSN6QuarterOctavesAreThoseOfWholeNumbers) {
  const auto by_the_letter = [](std::uint32_t x) {
    const auto log = static_cast<std::uint32_t>(std::bit_width(x)) - 1;
    return static_cast<std::int32_t>(4 * log + (log >= 2 ? x >> (log - 2) : x << (2 - log)) % 4);
  };
  for (std::uint32_t x = 1; x < 1U << 24; x += 1 + x / 97)
    for (const std::uint32_t y : {x, (1U << 24) - x}) {
      const auto lane = static_cast<std::int32_t>(y);
      EXPECT_EQ(quarter_octaves(FourInts{lane, 1, 0, lane})[3], by_the_letter(y)) << y;
    }
  EXPECT_LT(quarter_octaves(FourInts{})[0], -100);
}

TEST(Surroundings, POSN13NeedsPreviousWhereNothingElseIsKnown) {
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 0, 2, 3, 1, 0, 4, 6, 7, 5};
  const KnownFaces faces({triangles, 8});
  EXPECT_TRUE(faces.needs_previous(1));   // no faces
  EXPECT_TRUE(faces.needs_previous(2));   // of a face with 1
  EXPECT_TRUE(faces.needs_previous(3));   // of a face with 2
  EXPECT_FALSE(faces.needs_previous(4));  // of a face with 0 and 1
  EXPECT_TRUE(faces.needs_previous(5));   // known to no face
  EXPECT_TRUE(faces.needs_previous(7));   // of a face with 5 and 6
}

}  // namespace
}  // namespace deltamesh
