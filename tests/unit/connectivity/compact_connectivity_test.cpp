// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact form of CONN: what was written comes back, nothing else gets through.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "connectivity/faces/border.h"
#include "connectivity/faces/faces.h"
#include "connectivity/faces/op_coder.h"
#include "connectivity/faces/traversal.h"
#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "support/guarded.h"
#include "support/soups.h"

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

TEST(CompactConnectivity, CONN7SplitsStayWithinTheComponent) {
  Border border(4);
  border.start();
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_TRUE(border.apply<true>(i, BorderOp::kBoundary, kNoIndex));
  border.start();
  EXPECT_FALSE(border.apply<true>(3, BorderOp::kSplit, 1));
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
