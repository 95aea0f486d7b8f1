// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact form of CONN, whole and in halves: what was written comes back, nothing else gets through.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/byte_writer.h"
#include "base/thread_team.h"
#include "connectivity/border.h"
#include "connectivity/connectivity.h"
#include "connectivity/op_coder.h"
#include "connectivity/traversal.h"
#include "connectivity/zipper.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "support/guarded.h"
#include "support/soups.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::expect_guarded;

TEST(CompactConnectivity, CONN12CONN13CONN14ReadsEverySoup) {
  for (const test::Soup& soup : test::awkward_soups()) {
    const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
    if (soup.triangles.empty()) continue;
    const auto faces = static_cast<std::uint32_t>(soup.triangles.size() / 3);
    const auto read = read_connectivity(Payload::compact(coded.compact), soup.vertex_count, faces);
    ASSERT_TRUE(read) << soup.name << " " << read.error().message;
    EXPECT_EQ(read->triangles, coded.triangles) << soup.name;
    EXPECT_FALSE(read_connectivity(Payload::compact(coded.compact), soup.vertex_count, faces + 1));
    EXPECT_FALSE(read_connectivity(Payload::compact(coded.compact), soup.vertex_count, faces - 1));
  }
}

TEST(CompactConnectivity, CONN12ReadsRunsOfEveryLength) {
  for (std::uint32_t blades = 3; blades < 40; ++blades) {
    for (const bool is_closed : {false, true}) {
      const test::Soup soup = test::fan(blades, is_closed);
      const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
      const auto read = read_connectivity(Payload::compact(coded.compact), soup.vertex_count, blades);
      ASSERT_TRUE(read) << blades << " " << read.error().message;
      EXPECT_EQ(read->triangles, coded.triangles) << blades;
    }
  }
}

TEST(CompactConnectivity, CONN12RejectsCodesThatAreNoOps) {
  for (const std::uint32_t code : {7U, 15U}) {
    CompactWriter writer;
    OpCoder<CompactWriter> ops(writer);
    Border border(2);
    border.start();
    ops.code({static_cast<BorderOp>(code)}, border, border.gate_at<false>(2));
    const auto bytes = writer.finish();
    const auto read = read_connectivity(Payload::compact(bytes), 10, 2);
    ASSERT_FALSE(read) << code;
    EXPECT_STREQ(read.error().rule, "CONN-7") << code;
  }
}

TEST(CompactConnectivity, CMP3PrefixesAndFlipsAreErrorsOrValidFaces) {
  for (const test::Soup& soup : test::awkward_soups()) {
    if (soup.triangles.empty() || soup.triangles.size() > 200) continue;
    const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
    const auto read = [&](const Bytes& bytes) {
      const auto faces = read_connectivity(Payload::compact(bytes), soup.vertex_count,
                                           static_cast<std::uint32_t>(soup.triangles.size() / 3));
      if (!faces) return false;
      EXPECT_EQ(faces->triangles.size(), soup.triangles.size());
      for (const std::uint32_t v : faces->triangles) EXPECT_LT(v, soup.vertex_count);
      return true;
    };
    expect_guarded(coded.compact, read, soup.name);
  }
}

/// As if it were large.
Result<Connectivity> read_halves(const Bytes& bytes, const test::Soup& soup) {
  return read_connectivity(Payload::compact(bytes), soup.vertex_count,
                           static_cast<std::uint32_t>(soup.triangles.size() / 3), Halving::kAlways);
}

CodedConnectivity write_halves(const test::Soup& soup) {
  return write_connectivity(soup.triangles, soup.vertex_count, PayloadForms::kBoth, Halving::kAlways);
}

/// A torus of side x side vertices.
test::Soup torus(std::uint32_t side) {
  test::Soup soup{.name = "torus", .triangles = {}, .vertex_count = side * side};
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return x % side + side * (y % side); };
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      for (const std::uint32_t v :
           {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1)})
        soup.triangles.push_back(v);
    }
  }
  return soup;
}

std::vector<test::Soup> soups_to_halve() {
  std::vector<test::Soup> soups = test::awkward_soups();
  soups.push_back(torus(40));
  return soups;
}

TEST(CompactConnectivity, CONN15HalvesOfEverySoupAreItsWhole) {
  for (const test::Soup& soup : soups_to_halve()) {
    const CodedConnectivity coded = write_halves(soup);
    const auto read = read_halves(coded.compact, soup);
    ASSERT_TRUE(read) << soup.name << describe(read.error());
    EXPECT_EQ(read->triangles, coded.triangles) << soup.name;
    const auto plain = read_connectivity(coded.payload, soup.vertex_count,
                                         static_cast<std::uint32_t>(soup.triangles.size() / 3));
    ASSERT_TRUE(plain) << soup.name << describe(plain.error());
    EXPECT_EQ(plain->triangles, coded.triangles) << soup.name;
    const Adjacency graph = build_adjacency(read->triangles, soup.vertex_count);
    const Adjacency quick = build_adjacency(read->triangles, read->open_edges, soup.vertex_count);
    EXPECT_EQ(quick.offsets, graph.offsets) << soup.name;
    EXPECT_EQ(quick.neighbors, graph.neighbors) << soup.name;
    const Components components = find_components(graph);
    EXPECT_EQ(read->runs.count(soup.vertex_count), components.count) << soup.name;
    EXPECT_EQ(read->runs.components(soup.vertex_count).label, components.label) << soup.name;
    EXPECT_EQ(coded.components, components.count) << soup.name;
    const ThreadTeam team(2);
    const auto shared = read_halves(coded.compact, soup);
    ASSERT_TRUE(shared) << soup.name;
    EXPECT_EQ(shared->triangles, read->triangles) << soup.name;
  }
}

TEST(CompactConnectivity, CONN15TheWriterKnowsEdgesOfHalves) {
  for (const test::Soup& soup : soups_to_halve()) {
    const CodedConnectivity coded = write_halves(soup);
    if (coded.new_edges.empty()) continue;
    std::size_t edges = 0;
    for (const std::uint8_t bits : coded.new_edges) edges += static_cast<std::size_t>(std::popcount(bits));
    EXPECT_EQ(2 * edges, build_adjacency(coded.triangles, soup.vertex_count).neighbors.size()) << soup.name;
  }
}

TEST(CompactConnectivity, CONN16HalvesAreZipped) {
  const test::Soup soup = torus(200);
  const CodedConnectivity whole = write_connectivity(soup.triangles, soup.vertex_count);
  const CodedConnectivity halves = write_halves(soup);
  EXPECT_LE(halves.compact.size(), whole.compact.size() + 150);
  const auto read = read_halves(halves.compact, soup);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->open_edges.empty());
}

TEST(CompactConnectivity, CONN15CONN16PrefixesAndFlipsAreErrorsOrValidFaces) {
  std::size_t tried = 0;
  std::vector<test::Soup> soups = test::awkward_soups();
  soups.push_back(torus(8));
  for (const test::Soup& soup : soups) {
    if (soup.triangles.empty() || soup.triangles.size() > 400) continue;
    ++tried;
    const auto read = [&](const Bytes& bytes) {
      const auto faces = read_halves(bytes, soup);
      if (!faces) return false;
      EXPECT_EQ(faces->triangles.size(), soup.triangles.size());
      for (const std::uint32_t v : faces->triangles) EXPECT_LT(v, soup.vertex_count);
      const Adjacency graph = build_adjacency(faces->triangles, soup.vertex_count);
      const Adjacency quick = build_adjacency(faces->triangles, faces->open_edges, soup.vertex_count);
      EXPECT_EQ(quick.neighbors, graph.neighbors) << soup.name;
      return true;
    };
    expect_guarded(write_halves(soup).compact, read, soup.name);
  }
  EXPECT_GT(tried, 8U);
}

TEST(CompactConnectivity, CONN15RejectsWrongNumbersOfVertices) {
  const test::Soup soup = torus(8);
  const Bytes bytes = write_halves(soup).compact;
  for (const std::uint32_t vertices : {0U, 1U, 3U * 64U, 3U * 64U + 1, 0xffffffffU}) {
    Bytes changed = bytes;
    std::memcpy(changed.data() + 8, &vertices, 4);
    const auto read = read_halves(changed, soup);
    ASSERT_FALSE(read) << vertices;
    EXPECT_STREQ(read.error().rule, "CONN-15") << vertices;
  }
}

TEST(CompactConnectivity, CONN15LargeMeshesAreHalved) {
  const test::Soup large = torus(512);
  ASSERT_EQ(large.triangles.size(), 3U << 19);
  test::Soup smaller = large;
  smaller.triangles.resize(large.triangles.size() - 3);
  for (const test::Soup& soup : {large, smaller}) {
    const auto by_size = write_connectivity(soup.triangles, soup.vertex_count, PayloadForms::kCompact);
    const auto halved =
        write_connectivity(soup.triangles, soup.vertex_count, PayloadForms::kCompact, Halving::kAlways);
    EXPECT_EQ(by_size.compact == halved.compact, soup.triangles.size() == large.triangles.size());
    const auto read = read_connectivity(Payload::compact(by_size.compact), soup.vertex_count,
                                        static_cast<std::uint32_t>(soup.triangles.size() / 3));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->triangles, by_size.triangles);
  }
}

TEST(CompactConnectivity, CONN15CONN16HalvesKeepTheirBytes) {
  std::string text;
  for (const std::byte byte : write_halves(torus(4)).compact) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += kDigits[std::to_integer<unsigned>(byte) / 16];
    text += kDigits[std::to_integer<unsigned>(byte) % 16];
  }
  EXPECT_EQ(text,
            "0d00000000000000100000007532a2d90463b773cd1a211d02"
            "6786655e2e5b6701bd595b112110764a1d4d95441e9c");
}

TEST(CompactConnectivity, CONN7SplitsStayWithinTheComponent) {
  Border border(4);
  border.start();
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_TRUE(border.apply<true>(i, BorderOp::kBoundary, kNoIndex));
  border.start();
  EXPECT_FALSE(border.apply<true>(3, BorderOp::kSplit, 1));
  EXPECT_TRUE(border.is_open(1));
}

/// Two triangles, each a half of its own, zipped as told.
Result<Connectivity> read_zipped_pair(std::span<const Zip> zips) {
  std::array<CompactWriter, 2> writers;
  std::array<Border, 2> borders = {Border(1), Border(1, 3)};
  for (std::size_t half = 0; half < 2; ++half) {
    OpCoder<CompactWriter> ops(writers[half]);
    struct Boundary {
      OpCoder<CompactWriter>& ops;
      void start(const Border&) {}
      static constexpr bool failed() { return false; }
      BorderStep next(const Border& border, const Gate& gate) {
        return ops.code({BorderOp::kBoundary}, border, gate);
      }
    } guide{ops};
    EXPECT_TRUE(traverse(borders[half], guide));
  }
  write_zips(writers[1], zips, borders[0], borders[1]);
  NumberModel glued;
  writers[1].number(0, glued);
  const Bytes first = writers[0].finish();
  ByteWriter out;
  out.write(std::uint64_t{first.size()});
  out.write(std::uint32_t{3});
  out.write_bytes(first);
  out.write_bytes(writers[1].finish());
  return read_connectivity(Payload::compact(out.take()), 6, 2, Halving::kAlways);
}

TEST(CompactConnectivity, CONN16ZipsByHand) {
  const auto one = read_zipped_pair(std::vector<Zip>{{.item = 0, .partner = 0, .edges = 1}});
  ASSERT_TRUE(one) << describe(one.error());
  EXPECT_EQ(one->triangles, (std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3}));
  EXPECT_EQ(one->open_edges.size(), 4U);
  const auto all = read_zipped_pair(std::vector<Zip>{{.item = 1, .partner = 1, .edges = 3}});
  ASSERT_TRUE(all) << describe(all.error());
  EXPECT_EQ(all->triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 1}));
  EXPECT_TRUE(all->open_edges.empty());
  EXPECT_EQ(all->runs.count(3), 1U);
  const std::vector<std::vector<Zip>> wrong = {
      {{.item = 3, .partner = 0, .edges = 1}},
      {{.item = 0, .partner = 3, .edges = 1}},
      {{.item = 0, .partner = 0, .edges = 4}},
      {{.item = 0, .partner = 0, .edges = 1}, {.item = 0, .partner = 1, .edges = 1}},
      {{.item = 0, .partner = 0, .edges = 1}, {.item = 1, .partner = 0, .edges = 1}},
      {{.item = 0, .partner = 0, .edges = 1}, {.item = 1, .partner = 1, .edges = 1}},
  };
  for (const std::vector<Zip>& zips : wrong) {
    const auto read = read_zipped_pair(zips);
    ASSERT_FALSE(read);
    EXPECT_STREQ(read.error().rule, "CONN-16");
  }
}

TEST(CompactConnectivity, CONN2FacesAreBoundedByTheBytes) {
  const auto refused = read_connectivity(Payload::compact(Bytes(8)), 10, 8 * 42400 + 1);
  ASSERT_FALSE(refused);
  EXPECT_STREQ(refused.error().rule, "CONN-2");
  const auto read = read_connectivity(Payload::compact(Bytes(8)), 10, 8 * 42400);
  ASSERT_FALSE(read);
  EXPECT_STRNE(read.error().message, refused.error().message);
}

/// Says what a reader is to read.
class SaidOps {
 public:
  static constexpr bool kWrites = false;

  explicit SaidOps(std::vector<unsigned> said) : said_(std::move(said)) {}

  unsigned symbol(unsigned, const Mixture<2>&) { return said_.at(at_++); }
  std::uint32_t bits(std::uint32_t, unsigned) { return 0; }
  std::uint32_t number(std::uint32_t, NumberModel&) { return 0; }

 private:
  std::vector<unsigned> said_;
  std::size_t at_ = 0;
};

TEST(CompactConnectivity, CONN12RunsThatNoWriterMakes) {
  Border border(10);
  border.start();
  const Gate gate = border.gate_at<false>(0);
  for (const unsigned goes_on : {14U, 15U}) {
    SaidOps coder({goes_on});
    const auto run = OpCoder<SaidOps>(coder).run(gate);
    EXPECT_EQ(run.new_vertices, 7U);
    EXPECT_EQ(run.closing, BorderOp::kNewVertex);
  }
  for (const BorderOp rare : {BorderOp::kNewVertex, BorderOp::kRight}) {
    SaidOps coder({8, static_cast<unsigned>(rare)});  // after one op C
    OpCoder<SaidOps> ops(coder);
    EXPECT_EQ(ops.code({}, border, gate).op, BorderOp::kNewVertex);
    EXPECT_EQ(ops.code({}, border, gate).op, rare);
  }
}

}  // namespace
}  // namespace deltamesh
