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

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "connectivity/faces/cut.h"
#include "connectivity/faces/faces.h"
#include "connectivity/faces/op_tokens.h"
#include "entropy/planes.h"
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

TEST(Connectivity, TheCompactFormAloneIsTheSame) {
  for (const Soup& soup : test::awkward_soups()) {
    const auto both = write_connectivity(soup.triangles, soup.vertex_count);
    const auto compact = write_connectivity(soup.triangles, soup.vertex_count, PayloadForms::kCompact);
    EXPECT_TRUE(compact.payload.empty());
    EXPECT_EQ(compact.compact, both.compact) << soup.name;
    EXPECT_EQ(compact.triangles, both.triangles) << soup.name;
  }
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

/// A payload put together by hand.
struct Parts {
  std::vector<std::pair<std::size_t, std::uint8_t>> tokens{};  ///< (stream, token)
  std::vector<std::uint8_t> references{};
  Indices far_targets{};
  Indices gaps{};
  Indices targets{};

  std::vector<std::byte> assemble() const {
    ByteWriter out;
    for (std::size_t s = 0; s < kTokenStreams; ++s)
      out.write_varint(
          std::count_if(tokens.begin(), tokens.end(), [&](const auto& t) { return t.first == s; }));
    out.write_varint(references.size());
    out.write_varint(far_targets.size());
    out.write_varint(gaps.size());
    for (std::size_t s = 0; s < kTokenStreams; ++s) {
      for (const auto& [stream, token] : tokens) {
        if (stream == s) out.write(token);
      }
    }
    for (const std::uint8_t reference : references) out.write(reference);
    write_planes(out, far_targets);
    write_planes(out, gaps);
    write_planes(out, targets);
    return out.take();
  }
};

constexpr std::uint8_t token(BorderOp op, std::uint8_t run = 0) {
  return static_cast<std::uint8_t>(static_cast<std::uint8_t>(op) * 32 + run);
}
constexpr std::uint8_t kB = token(BorderOp::kBoundary);
constexpr std::size_t kClosed = 8;

/// One triangle by itself.
Parts lone_triangle() { return {.tokens = {{1, kB}, {kClosed + 1, kB}, {kClosed + 1, kB}}}; }

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
  const auto read = read_connectivity(lone_triangle().assemble(), 3, 1);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, (Indices{0, 1, 2}));
}

TEST(Connectivity, CONN2RejectsCountsThatDoNotFit) {
  expect_rule(lone_triangle(), 3, 97, "CONN-2");  // more than 32 faces per token
  Parts bubble{.tokens = {{1, token(BorderOp::kEnd)}}};
  ASSERT_TRUE(read_connectivity(bubble.assemble(), 3, 2));
  expect_rule(bubble, 3, 1, "CONN-2");  // one face too many
  bubble.tokens.emplace_back(5, kB);
  expect_rule(bubble, 3, 2, "CONN-2");  // a token left over
  bubble.tokens.pop_back();
  bubble.references.push_back(2);
  expect_rule(bubble, 3, 2, "CONN-2");  // a reference left over
}

TEST(Connectivity, CONN7RejectsOpsThatDoNotFitTheBorder) {
  // The item after the gate is a known boundary edge.
  expect_rule({.tokens = {{1, kB}, {kClosed + 1, token(BorderOp::kEnd)}}}, 9, 2, "CONN-7");
  expect_rule({.tokens = {{1, kB}, {kClosed + 1, token(BorderOp::kLeft)}}}, 9, 2, "CONN-7");
  expect_rule({.tokens = {{1, kB}, {kClosed + 1, kB}, {kClosed + 1, token(BorderOp::kRight)}}}, 9, 2,
              "CONN-7");
  // E in a loop of four.
  expect_rule({.tokens = {{1, token(BorderOp::kEnd, 1)}}}, 9, 3, "CONN-7");
  // L in a loop of two would make a face with a repeated vertex.
  expect_rule({.tokens = {{1, token(BorderOp::kLeft)}, {2, token(BorderOp::kLeft)}}}, 9, 3, "CONN-7");
  // N in a loop of three comes back to the gate.
  expect_rule({.tokens = {{1, token(BorderOp::kNearSplit)}}}, 9, 2, "CONN-7");
  // S onto the gate's own end.
  expect_rule({.tokens = {{1, token(BorderOp::kSplit)}}, .references = {0}, .far_targets = {0}}, 9, 2,
              "CONN-7");
  // S onto an item that does not exist.
  expect_rule({.tokens = {{1, token(BorderOp::kSplit)}}, .references = {0}, .far_targets = {3}}, 9, 2,
              "CONN-7");
}

TEST(Connectivity, CONN9RejectsTokensThatAreNone) {
  for (const int bad : {0, 30, 7 * 32, 7 * 32 + 1, 255, 63})
    expect_rule({.tokens = {{1, static_cast<std::uint8_t>(bad)}, {1, kB}}}, 9, 2, "CONN-9");
  expect_rule({.tokens = {{2, kB}}}, 9, 1, "CONN-9");  // the stream that is asked for is empty
}

TEST(Connectivity, CONN10RejectsSplitsWithoutATarget) {
  expect_rule({.tokens = {{1, token(BorderOp::kSplit)}}}, 9, 2, "CONN-10");
  expect_rule({.tokens = {{1, token(BorderOp::kSplit)}}, .references = {0}}, 9, 2, "CONN-10");
}

TEST(Connectivity, CONN11RejectsGluingOutOfRange) {
  Parts parts = lone_triangle();
  parts.gaps = {2};
  parts.targets = {0};
  const auto degenerate = read_connectivity(parts.assemble(), 2, 1);
  ASSERT_TRUE(degenerate) << describe(degenerate.error());
  EXPECT_EQ(degenerate->triangles, (Indices{0, 1, 0}));
  expect_rule(parts, 1, 1, "CONN-11");  // two vertices, one declared
  parts.targets = {4};
  expect_rule(parts, 9, 1, "CONN-11");  // vertex 2 is yet to come
  parts.targets = {1};
  expect_rule(parts, 9, 1, "CONN-11");  // vertex -1
  parts.gaps = {3};
  expect_rule(parts, 9, 1, "CONN-11");  // the fourth of three
  parts.gaps = {0, 0, 0, 0};
  parts.targets = {0, 0, 0, 0};
  expect_rule(parts, 9, 1, "CONN-11");  // four of three
}

TEST(Connectivity, CONN3CONN5CONN6TetrahedronByHand) {
  // One new vertex, then the focus closes; the rest is a loop of three at a vertex of degree 2.
  const Parts parts{.tokens = {{1, token(BorderOp::kRight, 1)}, {16, token(BorderOp::kEnd)}}};
  const auto read = read_connectivity(parts.assemble(), 4, 4);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, (Indices{0, 1, 2, 0, 2, 3, 0, 3, 1, 2, 1, 3}));
}

TEST(Connectivity, CONN6NearSplitByHand) {
  // Splits a loop of four into one of two, which stays open, and one of three, which ends.
  const Parts parts{
      .tokens = {
          {1, token(BorderOp::kNearSplit, 1)}, {16, token(BorderOp::kEnd)}, {3, kB}, {kClosed + 3, kB}}};
  const auto read = read_connectivity(parts.assemble(), 4, 4);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, (Indices{0, 1, 2, 0, 2, 3, 0, 3, 2, 0, 2, 1}));
}

TEST(Connectivity, CONN10FarTargetsRoundTrip) {
  const Soup soup = test::grid(150, 150, true, true, 0, 1);
  const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
  ByteReader in(coded.payload);
  for (std::size_t i = 0; i < kTokenStreams + 1; ++i) ASSERT_TRUE(in.read_varint());
  const auto far_targets = in.read_varint();
  ASSERT_TRUE(far_targets);
  EXPECT_GT(*far_targets, 0U);
  expect_same_faces(soup, coded);
  const auto read = read_back(coded.payload, soup);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->triangles, coded.triangles);
}

TEST(Connectivity, CONN9LongRunsRoundTrip) {
  // Closed fans of every length around the token limits: the hub's run of new vertices is one long run.
  for (std::uint32_t blades = 28; blades < 100; ++blades) {
    const Soup soup = test::fan(blades, true);
    const auto read = read_back(write_connectivity(soup.triangles, soup.vertex_count).payload, soup);
    ASSERT_TRUE(read) << blades << ": " << describe(read.error());
  }
}

}  // namespace
}  // namespace deltamesh
