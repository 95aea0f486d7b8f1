// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "connectivity/faces/border.h"
#include "connectivity/faces/cut.h"
#include "connectivity/faces/faces.h"
#include "connectivity/faces/gluing.h"
#include "connectivity/faces/op_coder.h"
#include "connectivity/faces/traversal.h"
#include "entropy/coder/writer.h"
#include "support/soups.h"
#include "topology/adjacency.h"
#include "topology/mesh_edges.h"

namespace deltamesh {
namespace {

using test::Indices;
using test::Soup;

bool is_permutation_of_all(const Indices& values, std::size_t n) {
  std::vector<std::uint8_t> seen(n, 0);
  for (const std::uint32_t v : values) {
    if (v >= n || seen[v] != 0) return false;
    seen[v] = 1;
  }
  return values.size() == n;
}

/// The coded faces are the input's under the three maps that the writer hands out.
void expect_same_faces(const Soup& soup, const CodedConnectivity& coded) {
  ASSERT_TRUE(is_permutation_of_all(coded.vertex_order, soup.vertex_count)) << soup.name;
  ASSERT_TRUE(is_permutation_of_all(coded.face_order, soup.triangles.size() / 3)) << soup.name;
  ASSERT_EQ(coded.triangles.size(), soup.triangles.size()) << soup.name;
  ASSERT_EQ(coded.face_rotation.size(), coded.face_order.size()) << soup.name;
  for (std::size_t f = 0; f < coded.face_order.size(); ++f) {
    ASSERT_LT(coded.face_rotation[f], 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = coded.triangles[3 * f + k];
      ASSERT_LT(v, soup.vertex_count);
      ASSERT_EQ(coded.vertex_order[v],
                soup.triangles[std::size_t{3} * coded.face_order[f] + (k + coded.face_rotation[f]) % 3])
          << soup.name << " face " << f;
    }
  }
}

/// What a reader hands on beside the faces says the same as these.
void expect_same_graph(const Connectivity& read, const Soup& soup) {
  const Adjacency graph = build_adjacency(read.triangles, soup.vertex_count);
  const Adjacency quick = build_adjacency(read.triangles, read.open_edges, soup.vertex_count);
  EXPECT_EQ(quick.offsets, graph.offsets) << soup.name;
  EXPECT_EQ(quick.neighbors, graph.neighbors) << soup.name;
  const Components components = find_components(graph);
  const Components by_runs = read.runs.components(soup.vertex_count);
  EXPECT_EQ(read.runs.count(soup.vertex_count), components.count) << soup.name;
  EXPECT_EQ(by_runs.count, components.count) << soup.name;
  EXPECT_EQ(by_runs.label, components.label) << soup.name;
  EXPECT_EQ(by_runs.size, components.size) << soup.name;
}

TEST(Connectivity, CONN8RoundTripsEverySoup) {
  for (const Soup& soup : test::awkward_soups()) {
    const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
    expect_same_faces(soup, coded);
    const auto read = read_connectivity(coded.payload, soup.vertex_count,
                                        static_cast<std::uint32_t>(soup.triangles.size() / 3));
    ASSERT_TRUE(read) << soup.name << ": " << describe(read.error());
    EXPECT_EQ(read->triangles, coded.triangles) << soup.name;
    expect_same_graph(*read, soup);
    EXPECT_EQ(write_connectivity(soup.triangles, soup.vertex_count).payload, coded.payload) << soup.name;
  }
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted_edges(const MeshEdges& edges) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted;
  edges.for_each([&](std::uint32_t a, std::uint32_t b) { sorted.emplace_back(std::minmax(a, b)); });
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

TEST(Connectivity, TheWriterKnowsComponentsAndEdges) {
  std::size_t told = 0;
  for (const Soup& soup : test::awkward_soups()) {
    const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
    EXPECT_EQ(coded.components, find_components(build_adjacency(coded.triangles, soup.vertex_count)).count)
        << soup.name;
    if (coded.new_edges.empty()) continue;
    ++told;
    EXPECT_EQ(sorted_edges({.triangles = coded.triangles, .visited = coded.new_edges}),
              sorted_edges(find_edges(coded.triangles, soup.vertex_count)))
        << soup.name;
  }
  EXPECT_GT(told, 4U);
  EXPECT_EQ(write_connectivity(Indices{0, 1, 2, 3, 4, 5, 0, 6, 3}, 8).components, 2U);
}

TEST(Connectivity, HalfEdgesBesidesOneAndItsMatchAreRepeated) {
  EXPECT_TRUE(match_half_edges(Indices{0, 1, 2, 2, 1, 3}, 4).repeated.empty());
  EXPECT_EQ(match_half_edges(Indices{0, 1, 2, 1, 2, 3}, 4).repeated, Indices{3});
  EXPECT_EQ(match_half_edges(Indices{0, 1, 2, 2, 1, 3, 2, 1, 4}, 5).repeated, Indices{3});
  EXPECT_FALSE(match_half_edges(Indices{0, 1, 2, 1, 2, 3}, 4).degenerate);
  EXPECT_TRUE(match_half_edges(Indices{0, 1, 1}, 2).degenerate);
}

TEST(Connectivity, UnreferencedVerticesComeLastAscending) {
  const CodedConnectivity coded = write_connectivity(Indices{6, 2, 4}, 8);
  EXPECT_EQ(coded.vertex_order, (Indices{6, 2, 4, 0, 1, 3, 5, 7}));
  EXPECT_EQ(coded.triangles, (Indices{0, 1, 2}));
}

/// Fans of linked corners: the manifold vertices.
std::size_t count_fans(const Soup& soup, const Indices& opposite) {
  std::size_t linked_ends = 0;
  std::size_t closed = 0;
  std::vector<bool> seen(opposite.size());
  for (std::uint32_t corner = 0; corner < opposite.size(); ++corner) {
    if (opposite[corner] == kNoIndex) ++linked_ends;  // the one end of a fan that is open here
    std::uint32_t c = corner;
    bool fresh = true;
    do {
      fresh = fresh && !seen[c];
      EXPECT_EQ(soup.triangles[c], soup.triangles[corner]);
      c = opposite[c] == kNoIndex ? kNoIndex : next_in_face(opposite[c]);
    } while (c != corner && c != kNoIndex);
    if (c == kNoIndex || !fresh) continue;
    ++closed;
    do {
      seen[c] = true;
      c = next_in_face(opposite[c]);
    } while (c != corner);
  }
  return linked_ends + closed;
}

TEST(Connectivity, HalfEdgesAreMatchedInPairsOfOppositeDirection) {
  for (const Soup& soup : test::awkward_soups()) {
    const Indices opposite = match_half_edges(soup.triangles, soup.vertex_count).opposite;
    for (std::uint32_t h = 0; h < opposite.size(); ++h) {
      if (opposite[h] == kNoIndex) continue;
      EXPECT_EQ(opposite[opposite[h]], h) << soup.name;
      EXPECT_EQ(soup.triangles[opposite[h]], soup.triangles[next_in_face(h)]) << soup.name;
      EXPECT_EQ(soup.triangles[next_in_face(opposite[h])], soup.triangles[h]) << soup.name;
    }
  }
}

TEST(Connectivity, DecodedFacesAreManifoldWhereTheInputIs) {
  const Soup torus = test::grid(30, 20, true, true, 0, 1);
  const Indices opposite = match_half_edges(torus.triangles, torus.vertex_count).opposite;
  EXPECT_EQ(count_fans(torus, opposite), torus.vertex_count);
  EXPECT_EQ(std::count(opposite.begin(), opposite.end(), kNoIndex), 0);
}

TEST(Connectivity, CutSeparatesFansThatMeetInAPoint) {
  const Soup soup{"bow tie", {0, 1, 2, 0, 3, 4}, 5};
  EXPECT_EQ(count_fans(soup, match_half_edges(soup.triangles, soup.vertex_count).opposite), 6U);
}

TEST(Connectivity, ConesThatMeetInAPointAreTwoFans) {
  Soup soup = test::fan(5, true);
  const Soup other = test::fan(7, true);
  for (const std::uint32_t v : other.triangles)
    soup.triangles.push_back(v == other.triangles.front() ? soup.triangles.front() : v + soup.vertex_count);
  soup.vertex_count += other.vertex_count;
  const Indices opposite = match_half_edges(soup.triangles, soup.vertex_count).opposite;
  EXPECT_EQ(count_fans(soup, opposite), 14U);
  expect_same_faces(soup, write_connectivity(soup.triangles, soup.vertex_count));
}

TEST(Connectivity, TwoSidedSheetsStayWhole) {
  const Soup soup = test::two_sided(test::grid(20, 20, false, false, 0, 3));
  // Interior edges continue within their side; along the rim the two sides meet.
  EXPECT_LT(count_fans(soup, match_half_edges(soup.triangles, soup.vertex_count).opposite),
            2 * soup.vertex_count + 1);
}

Result<Connectivity> read_back(std::span<const std::byte> payload, const Soup& soup) {
  // An exact-size copy, so that the address sanitizer sees reads past the end.
  const std::vector<std::byte> copy(payload.begin(), payload.end());
  return read_connectivity(copy, soup.vertex_count, static_cast<std::uint32_t>(soup.triangles.size() / 3));
}

std::vector<Soup> small_soups() {
  std::vector<Soup> soups = test::awkward_soups();
  std::erase_if(soups, [](const Soup& s) { return s.triangles.empty() || s.triangles.size() > 3 * 130; });
  return soups;
}

TEST(Connectivity, CON3EveryPrefixAndExtensionFails) {
  for (const Soup& soup : small_soups()) {
    std::vector<std::byte> payload = write_connectivity(soup.triangles, soup.vertex_count).payload;
    for (std::size_t size = 0; size < payload.size(); ++size)
      EXPECT_FALSE(read_back(std::span(payload).first(size), soup)) << soup.name << " " << size;
    payload.push_back(std::byte{0});
    EXPECT_FALSE(read_back(payload, soup)) << soup.name;
  }
}

TEST(Connectivity, FlippedBytesGiveAnErrorOrValidFaces) {
  for (const Soup& soup : small_soups()) {
    std::vector<std::byte> payload = write_connectivity(soup.triangles, soup.vertex_count).payload;
    for (std::size_t i = 0; i < payload.size(); ++i) {
      for (const std::byte flip :
           {std::byte{1}, std::byte{0x20}, std::byte{0x40}, std::byte{0x80}, std::byte{0xff}}) {
        payload[i] ^= flip;
        const auto read = read_back(payload, soup);
        payload[i] ^= flip;
        if (!read) continue;
        ASSERT_EQ(read->triangles.size(), soup.triangles.size());
        ASSERT_TRUE(std::all_of(read->triangles.begin(), read->triangles.end(),
                                [&](std::uint32_t v) { return v < soup.vertex_count; }));
        expect_same_graph(*read, soup);
      }
    }
  }
}

using Op = BorderOp;

/// Hands out given steps, to a border that may refuse them.
class GivenSteps {
 public:
  GivenSteps(CompactWriter& writer, const std::vector<BorderStep>& steps) : ops_(writer), steps_(steps) {}

  static void start(const Border&) {}
  BorderStep next(const Border& border, const Gate& gate) {
    if (next_ == steps_.size()) return {};
    const BorderStep step = steps_[next_++];
    ops_.code(step, border, gate);
    return step;
  }
  static bool failed() { return false; }

 private:
  OpCoder<CompactWriter> ops_;
  const std::vector<BorderStep>& steps_;
  std::size_t next_ = 0;
};

/// A payload put together by hand.
struct Parts {
  std::vector<BorderStep> steps{};
  std::uint32_t faces = 1;  ///< that the border holds while it is written
  Indices gaps{};
  Indices targets{};

  std::vector<std::byte> assemble() const {
    CompactWriter writer;
    Border border(faces);
    GivenSteps guide(writer, steps);
    traverse(border, guide);
    NumberModel counts;
    NumberModel gap_models;
    NumberModel target_models;
    writer.number(static_cast<std::uint32_t>(gaps.size()), counts);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      writer.number(gaps[i], gap_models);
      writer.number(targets[i], target_models);
    }
    return writer.finish();
  }
};

/// One triangle by itself.
const std::vector<BorderStep> kLoneTriangle = {{Op::kBoundary}, {Op::kBoundary}, {Op::kBoundary}};

void expect_rule(const Parts& parts, std::uint32_t vertices, std::uint32_t faces, const char* rule) {
  const auto read = read_connectivity(parts.assemble(), vertices, faces);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, rule) << describe(read.error());
}

TEST(Connectivity, CONN1NoFacesNoBytes) {
  EXPECT_TRUE(write_connectivity({}, 9).payload.empty());
  EXPECT_TRUE(read_connectivity({}, 9, 0));
  EXPECT_FALSE(read_connectivity(std::vector<std::byte>(1), 9, 0));
}

TEST(Connectivity, CONN4StartsAComponent) {
  const auto read = read_connectivity(Parts{.steps = kLoneTriangle}.assemble(), 3, 1);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, (Indices{0, 1, 2}));
}

TEST(Connectivity, CONN2RejectsFacesThatAreTooMany) {
  const Parts bubble{.steps = {{Op::kEnd}}, .faces = 2};
  ASSERT_TRUE(read_connectivity(bubble.assemble(), 3, 2));
  expect_rule(bubble, 3, 1, "CONN-2");
}

TEST(Connectivity, CONN7RejectsOpsThatDoNotFitTheBorder) {
  // The item after the gate is a known boundary edge.
  expect_rule({.steps = {{Op::kBoundary}, {Op::kEnd}}, .faces = 9}, 9, 2, "CONN-7");
  expect_rule({.steps = {{Op::kBoundary}, {Op::kLeft}}, .faces = 9}, 9, 2, "CONN-7");
  expect_rule({.steps = {{Op::kBoundary}, {Op::kBoundary}, {Op::kRight}}, .faces = 9}, 9, 2, "CONN-7");
  // E in a loop of four.
  expect_rule({.steps = {{Op::kNewVertex}, {Op::kEnd}}, .faces = 9}, 9, 3, "CONN-7");
  // L in a loop of two would make a face with a repeated vertex.
  expect_rule({.steps = {{Op::kLeft}, {Op::kLeft}}, .faces = 9}, 9, 3, "CONN-7");
  // N in a loop of three comes back to the gate.
  expect_rule({.steps = {{Op::kNearSplit}}, .faces = 9}, 9, 2, "CONN-7");
  // S onto the gate's own end, and onto an item that does not exist.
  expect_rule({.steps = {{Op::kSplit, 0}}, .faces = 9}, 9, 2, "CONN-7");
  expect_rule({.steps = {{Op::kSplit, 3}}, .faces = 9}, 9, 2, "CONN-7");
}

TEST(Connectivity, CONN11RejectsGluingOutOfRange) {
  const auto glue = [](const Indices& gaps, const Indices& targets) {
    return *glue_vertices({.gaps = gaps, .targets = targets}, 3, 2);
  };
  EXPECT_EQ(glue({2}, {0}), (LargeVector<std::uint32_t>{0, 1, 0}));
  const auto rule = [](const Indices& gaps, const Indices& targets, std::uint32_t vertices) {
    return std::string(glue_vertices({.gaps = gaps, .targets = targets}, 3, vertices).error().rule);
  };
  EXPECT_EQ(rule({2}, {0}, 1), "CONN-11");                    // two vertices, one declared
  EXPECT_EQ(rule({2}, {4}, 9), "CONN-11");                    // vertex 2 is yet to come
  EXPECT_EQ(rule({2}, {1}, 9), "CONN-11");                    // vertex -1
  EXPECT_EQ(rule({3}, {0}, 9), "CONN-11");                    // the fourth of three
  EXPECT_EQ(rule({0, 0, 0, 0}, {0, 0, 0, 0}, 9), "CONN-11");  // four of three
}

TEST(Connectivity, CONN3CONN5CONN6TetrahedronByHand) {
  // One new vertex, then the focus closes; the rest is a loop of three at a vertex of degree 2.
  const Parts parts{.steps = {{Op::kNewVertex}, {Op::kRight}, {Op::kEnd}}, .faces = 4};
  const auto read = read_connectivity(parts.assemble(), 4, 4);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, (Indices{0, 1, 2, 0, 2, 3, 0, 3, 1, 2, 1, 3}));
}

TEST(Connectivity, CONN6NearSplitByHand) {
  // Splits a loop of four into one of two, which stays open, and one of three, which ends.
  const Parts parts{
      .steps = {{Op::kNewVertex}, {Op::kNearSplit}, {Op::kEnd}, {Op::kBoundary}, {Op::kBoundary}},
      .faces = 4};
  const auto read = read_connectivity(parts.assemble(), 4, 4);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, (Indices{0, 1, 2, 0, 2, 3, 0, 3, 2, 0, 2, 1}));
}

TEST(Connectivity, CONN10FarTargetsRoundTrip) {
  const Soup soup = test::grid(150, 150, true, true, 0, 1);  // whose border comes together far away
  const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
  expect_same_faces(soup, coded);
  const auto read = read_back(coded.payload, soup);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, coded.triangles);
}

TEST(Connectivity, LongRunsRoundTrip) {
  // Closed fans: the hub's run of new vertices is one long run.
  for (std::uint32_t blades = 28; blades < 100; ++blades) {
    const Soup soup = test::fan(blades, true);
    const auto read = read_back(write_connectivity(soup.triangles, soup.vertex_count).payload, soup);
    ASSERT_TRUE(read) << blades << ": " << describe(read.error());
  }
}

}  // namespace
}  // namespace deltamesh
