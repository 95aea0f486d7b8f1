// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact forms of CONN, DELT, ANCH and ATTR: what was written comes back, nothing else gets through.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "attributes/attribute.h"
#include "base/byte_writer.h"
#include "base/quick_ratio.h"
#include "base/thread_team.h"
#include "base/try.h"
#include "connectivity/border.h"
#include "connectivity/connectivity.h"
#include "connectivity/op_coder.h"
#include "connectivity/traversal.h"
#include "connectivity/zipper.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "field/field_coder.h"
#include "field/large_field_coder.h"
#include "format/tags.h"
#include "geometry/anchor_list.h"
#include "geometry/delta_symbols.h"
#include "geometry/large_deltas.h"
#include "support/graph_mesh.h"
#include "support/random.h"
#include "support/soups.h"

namespace deltamesh {
namespace {

using Bytes = std::vector<std::byte>;

/// Every prefix and extension fails; with any byte flipped `read` returns (and checks what it gets).
void expect_guarded(const Bytes& bytes, const std::function<bool(const Bytes&)>& read,
                    const std::string& name) {
  ASSERT_TRUE(read(bytes)) << name;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))))
        << name << size;
  Bytes longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(read(longer)) << name;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const std::byte flip : {std::byte{1}, std::byte{0x10}, std::byte{0xff}}) {
      Bytes changed = bytes;
      changed[i] ^= flip;
      read(changed);
    }
  }
}

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
            "14000000000000001000000077ca29cb32ca5f007974a50b0200000090917c1e5a6577670100000002d8cb2900dddc0c"
            "e709f1a7512ac2ed9c468036");
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

std::vector<std::int32_t> random_deltas(std::size_t count, std::uint32_t seed, std::int32_t largest) {
  test::RandomBits random(seed);
  std::vector<std::int32_t> deltas(count);
  for (auto& q : deltas) {
    const auto range = static_cast<std::int64_t>(1) << (random() % 32);
    q = static_cast<std::int32_t>(
        std::min<std::int64_t>(static_cast<std::int64_t>(random()) % range, largest));
    if (random() % 2 == 0) q = -q;
  }
  return deltas;
}

TEST(CompactDeltas, DELT5FLD1ReadsAnyNumbers) {
  for (const auto& mesh : {test::sheet(1, 1), test::sheet(9, 7), test::fan(300), test::GraphMesh{}}) {
    const Adjacency graph =
        build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size()));
    for (const std::int32_t largest : {0, 1, 100, 70000, 1 << 30}) {
      auto deltas = random_deltas(3 * graph.vertex_count(), 17, largest);
      if (!deltas.empty() && largest > 0) deltas.front() = -largest;
      const Bytes bytes = write_compact_deltas(deltas, graph);
      const auto read = read_compact_deltas(bytes, graph);
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_TRUE(std::ranges::equal(*read, deltas));
      EXPECT_EQ(write_compact_deltas(deltas, graph), bytes);
    }
  }
}

TEST(CompactDeltas, CMP3PrefixesAndFlipsAreErrorsOrNumbersInRange) {
  const auto mesh = test::sheet(6, 5);
  for (const std::int32_t largest : {3, 1 << 30}) {
    const auto deltas = random_deltas(3 * mesh.graph.vertex_count(), 5, largest);
    const auto read = [&](const Bytes& bytes) {
      const auto back = read_compact_deltas(bytes, mesh.graph);
      if (!back) return false;
      EXPECT_EQ(back->size(), deltas.size());
      for (const std::int32_t q : *back) EXPECT_LE(std::abs(std::int64_t{q}), kLargestFieldValue);
      return true;
    };
    expect_guarded(write_compact_deltas(deltas, mesh.graph), read, "deltas");
  }
}

TEST(CompactDeltas, FLD1RejectsNumbersBeyondTheirRange) {
  const auto mesh = test::sheet(2, 2);
  std::vector<std::int32_t> deltas(12);
  deltas[0] = (1 << 30) + 1;
  CompactWriter writer;
  FieldCoder field(writer, mesh.graph);
  std::array<std::int32_t, 3> q = {deltas[0], 0, 0};
  EXPECT_FALSE(field.code_vertex(0, q, 3));
  const auto read = read_compact_deltas(writer.finish(), mesh.graph);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "FLD-1");
}

TEST(CompactDeltas, FLD8TakesTwoWalksInTurns) {
  for (const int side : {2, 5, 6}) {
    const auto mesh = test::sheet(side, side);
    const auto n = static_cast<std::uint32_t>(mesh.graph.vertex_count());
    const auto deltas = random_deltas(3 * n, 9, 40);
    const auto at = [&](std::uint32_t v) {
      return FieldNumbers{deltas[v], deltas[n + v], deltas[2 * n + v]};
    };
    CompactWriter writer;
    FieldCoder field(writer, mesh.graph, (n + 1) / 2);
    for (std::uint32_t v = 0; v < n / 2; ++v) {
      FieldNumbers q = at(v);
      FieldNumbers p = at((n + 1) / 2 + v);
      EXPECT_TRUE(field.code_pair(v, (n + 1) / 2 + v, q, p));
    }
    FieldNumbers last = at(n / 2);
    if (n % 2 != 0) {
      EXPECT_TRUE(field.code_vertex(n / 2, last, 3));
    }
    EXPECT_EQ(writer.finish(), write_compact_deltas(deltas, mesh.graph));
  }
}

/// FNV-1a, 64 bits.
std::uint64_t hash_of(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
  return hash;
}

/// No golden stream is as large: a hash keeps the rules.
TEST(CompactDeltas, FLD9FLD11FLD12LargeFieldsKeepTheirBytes) {
  const auto mesh = test::sheet(512, 256);
  const auto n = static_cast<std::uint32_t>(mesh.graph.vertex_count());
  ASSERT_EQ(n, kFewestOfLargeField);
  auto deltas = random_deltas(3 * n, 9, 40);
  for (std::uint32_t v = 0; v < n; ++v) {  // part of them alike, part large, part a multiple of x
    if (v / 5000 % 3 == 0) deltas[v] = 70;
    if (v / 5000 % 4 == 0) deltas[n + v] = 900 + static_cast<std::int32_t>(v % 3);
    if (v / 7000 % 3 == 0) deltas[2 * n + v] = -2 * deltas[v];
  }
  const auto bytes = write_compact_deltas(deltas, mesh.graph);
  EXPECT_EQ(hash_of(bytes), 3583606763406388169U);
  EXPECT_EQ(bytes, write_large_deltas({deltas.data(), n}, mesh.graph));
  EXPECT_TRUE(std::ranges::equal(*read_compact_deltas(bytes, mesh.graph), deltas));
  const ThreadTeam team(2);
  EXPECT_TRUE(std::ranges::equal(*read_compact_deltas(bytes, mesh.graph), deltas));
}

Result<std::vector<std::int32_t>> read_as_large(const Bytes& bytes, const Adjacency& graph) {
  std::vector<std::int32_t> deltas(3 * graph.vertex_count());
  DELTAMESH_CHECK(read_large_deltas(bytes, graph, {deltas.data(), graph.vertex_count()}));
  return deltas;
}

TEST(CompactDeltas, FLD9FLD10PartsOfAnyGraph) {
  for (const auto& mesh : {test::sheet(1, 1), test::sheet(2, 1), test::sheet(9, 7), test::sheet(30, 31),
                           test::fan(1500), test::fragments(), test::GraphMesh{}}) {
    const Adjacency graph =
        build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size()));
    for (const std::int32_t largest : {0, 1, 100, 3000, 70000, 1 << 30}) {
      auto deltas = random_deltas(3 * graph.vertex_count(), 17, largest);
      if (!deltas.empty() && largest > 0) deltas.front() = -largest;
      const Bytes bytes = write_large_deltas({deltas.data(), graph.vertex_count()}, graph);
      const auto read = read_as_large(bytes, graph);
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_TRUE(std::ranges::equal(*read, deltas));
    }
  }
}

TEST(CompactDeltas, FLD9DamagedPartsAreErrorsOrNumbersInRange) {
  const auto mesh = test::sheet(6, 5);
  const ThreadTeam team(2);
  for (const std::int32_t largest : {3, 1 << 30}) {
    const auto deltas = random_deltas(90, 5, largest);
    const auto read = [&](const Bytes& bytes) {
      const auto back = read_as_large(bytes, mesh.graph);
      if (!back) return false;
      for (const std::int32_t q : *back) EXPECT_LE(std::abs(std::int64_t{q}), kLargestFieldValue);
      return true;
    };
    expect_guarded(write_large_deltas({deltas.data(), 30}, mesh.graph), read, "large deltas");
  }
}

TEST(CompactDeltas, FLD1RejectsLargeNumbersBeyondTheirRange) {
  const auto mesh = test::sheet(2, 2);
  for (const std::size_t place : {0, 7}) {
    std::vector<std::int32_t> deltas(12);
    deltas[place] = -(1 << 30) - 1;
    const auto read = read_as_large(write_large_deltas({deltas.data(), 4}, mesh.graph), mesh.graph);
    ASSERT_FALSE(read);
    EXPECT_STREQ(read.error().rule, "FLD-1");
  }
}

TEST(CompactDeltas, SmoothNeighborhoodsPay) {
  const auto mesh = test::sheet(60, 60);
  const std::size_t n = mesh.graph.vertex_count();
  std::vector<std::int32_t> deltas(3 * n);
  test::RandomBits random(2);
  for (std::size_t i = 0; i < n; ++i)
    deltas[2 * n + i] = i < n / 2 ? 0 : static_cast<std::int32_t>(random() % 8);
  EXPECT_LT(write_compact_deltas(deltas, mesh.graph).size() * 8, n * 2);  // 1.5 bits of entropy each
}

TEST(CompactAnchors, ANCH5ReadsWhatWasWritten) {
  for (const std::size_t count : {0, 1, 40}) {
    test::RandomBits random(static_cast<std::uint32_t>(count));
    AnchorList list;
    for (std::size_t i = 0; i < count; ++i) list.gaps.push_back(random() % 300);
    for (std::size_t i = 0; i < 3 * count; ++i) list.steps.push_back(random() >> (random() % 32));
    const auto read = [&](const Bytes& bytes) {
      const auto back = read_anchors(Payload::compact(bytes), static_cast<std::uint32_t>(count));
      if (!back) return false;
      EXPECT_EQ(back->gaps.size(), count);
      EXPECT_EQ(back->steps.size(), 3 * count);
      return true;
    };
    const Bytes bytes = write_compact_anchors(list);
    expect_guarded(bytes, read, "anchors");
    EXPECT_EQ(read_anchors(Payload::compact(bytes), static_cast<std::uint32_t>(count))->gaps, list.gaps);
    EXPECT_EQ(read_anchors(Payload::compact(bytes), static_cast<std::uint32_t>(count))->steps, list.steps);
    EXPECT_EQ(read_anchors(write_plain_anchors(list), static_cast<std::uint32_t>(count))->steps, list.steps);
  }
}

struct Shape {
  AttributeKind kind;
  ComponentType type;
  std::uint8_t components;
};

/// Values that are near to their neighbours' in part, at the ends of their range in part.
Attribute make_attribute(const Shape& shape, std::size_t rows) {
  Attribute attribute{.kind = shape.kind, .type = shape.type, .components = shape.components, .name = "a"};
  attribute.values.resize(rows * shape.components * component_size(shape.type));
  test::RandomBits random(8);
  for (std::size_t i = 0; i < attribute.values.size(); ++i) {
    const std::uint32_t byte = random() % 4 == 0 ? random() % 256 : (i < 90 ? 100 : 250) + random() % 6;
    attribute.values[i] = static_cast<std::byte>(byte);
  }
  if (shape.type != ComponentType::kF32) return attribute;
  for (std::size_t i = 0; i < rows * shape.components; ++i) {
    const float value = shape.kind == AttributeKind::kNormal ? (i % 3 == 2 ? 1.0F : 0.0F)
                                                             : static_cast<float>(random() % 1000) / 999.0F;
    std::memcpy(attribute.values.data() + 4 * i, &value, 4);
  }
  return attribute;
}

AttributeView view(const Attribute& a) {
  return {.kind = a.kind,
          .type = a.type,
          .components = a.components,
          .normalized = a.normalized,
          .name = a.name,
          .values = a.values};
}

TEST(CompactAttributes, ATTR9EqualsThePlainForm) {
  const auto mesh = test::sheet(7, 6);
  const auto rows = static_cast<std::uint32_t>(mesh.graph.vertex_count());
  std::vector<std::uint32_t> order(rows);
  for (std::uint32_t i = 0; i < rows; ++i) order[i] = rows - 1 - i;
  using enum AttributeKind;
  using enum ComponentType;
  for (const Shape& shape :
       {Shape{kColor, kU8, 3}, Shape{kColor, kU8, 4}, Shape{kColor, kU16, 3}, Shape{kColor, kF32, 4},
        Shape{kNormal, kF32, 3}, Shape{kUv, kF32, 2}, Shape{kGeneric, kU8, 1}, Shape{kGeneric, kI16, 5}}) {
    const Attribute attribute = make_attribute(shape, rows);
    const auto plain = write_attribute(view(attribute), order, {});
    const auto compact = write_compact_attribute(view(attribute), order, {}, mesh.graph);
    ASSERT_TRUE(compact && !compact->empty());
    const auto expected = read_attribute(*plain, rows, 1 << 20);
    const auto read = [&](const Bytes& bytes) {
      const auto back = read_attribute(Payload::compact(bytes), rows, 1 << 20, &mesh.graph);
      if (!back) return false;
      EXPECT_EQ(back->values.size(), rows * back->components * component_size(back->type));
      return true;
    };
    EXPECT_EQ(read_attribute(Payload::compact(*compact), rows, 1 << 20, &mesh.graph)->values,
              expected->values);
    expect_guarded(*compact, read, "attribute");
  }
}

/// Numbers of which the hints know the size; returns the bytes they take.
std::size_t hinted_bytes(const Adjacency& graph, bool with_hints) {
  const std::size_t n = graph.vertex_count();
  test::RandomBits random(21);
  std::vector<std::array<std::int32_t, 3>> numbers(n);
  std::vector<FieldHint> hints(n);
  for (std::size_t v = 0; v < n; ++v) {
    const std::int32_t reach = random() % 2 == 0 ? 1 : 100;
    for (std::size_t a = 0; a < 3; ++a) {
      numbers[v][a] = static_cast<std::int32_t>(random() % (2 * reach + 1)) - reach;
      hints[v].spread[a] = 8 * reach;
      hints[v].offset[a] = static_cast<std::int32_t>(random() % 33) - 16;
    }
  }
  const auto code = [&](auto& coder, auto& q) {
    FieldCoder field(coder, graph);
    for (std::uint32_t v = 0; v < n; ++v)
      if (!field.code_vertex(v, q[v], 3, with_hints ? &hints[v] : nullptr)) return false;
    return true;
  };
  CompactWriter writer;
  EXPECT_TRUE(code(writer, numbers));
  const Bytes bytes = writer.finish();
  CompactReader reader(bytes);
  std::vector<std::array<std::int32_t, 3>> back(n);
  EXPECT_TRUE(code(reader, back));
  EXPECT_TRUE(reader.finish(kTagAttribute));
  EXPECT_EQ(back, numbers);
  return bytes.size();
}

TEST(CompactAttributes, FLD7HintsOfTheSizeArePaidBack) {
  const auto mesh = test::sheet(60, 60);
  EXPECT_LT(10 * hinted_bytes(mesh.graph, true), 9 * hinted_bytes(mesh.graph, false));
}

TEST(CompactAttributes, ATTR9WideSymbolsHaveNone) {
  const auto mesh = test::sheet(3, 3);
  const Attribute attribute = make_attribute({AttributeKind::kGeneric, ComponentType::kF64, 1}, 9);
  const std::vector<std::uint32_t> order = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_TRUE(write_compact_attribute(view(attribute), order, {}, mesh.graph)->empty());
  const auto plain = write_attribute(view(attribute), order, {});
  const auto read = read_attribute(Payload::compact(*plain), 9, 1 << 20, &mesh.graph);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "ATTR-9");
}

TEST(QuickRatio, CMP9IsNearTheQuotient) {
  test::RandomBits random(1);
  for (int i = 0; i < 10000; ++i) {
    const std::int64_t b = 1 + (static_cast<std::int64_t>(random()) >> (random() % 32));
    const std::int64_t a = static_cast<std::int64_t>(random() % 8000) * b / 1000 - 4 * b;
    const double exact = static_cast<double>(a) / static_cast<double>(b) * 4096;
    EXPECT_NEAR(quick_ratio(a, b), exact, 2 + std::abs(exact) / 400) << a << " / " << b;
  }
  EXPECT_EQ(quick_ratio(1'000'000, 1), 8 * 4096);
  EXPECT_EQ(quick_ratio(-1'000'000, 1), -8 * 4096);
  EXPECT_EQ(quick_ratio(0, 5), 0);
}

}  // namespace
}  // namespace deltamesh
