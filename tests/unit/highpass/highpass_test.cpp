// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "highpass/highpass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "base/byte_writer.h"
#include "highpass/compact.h"
#include "highpass/plain/plain.h"
#include "measure/measure.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

using test::GraphMesh;
using Bytes = std::vector<std::byte>;

Result<CodedHighpass> write(const GraphMesh& mesh, int bits = 8, HighpassSettings settings = {}) {
  AnchorSequence anchors(mesh.graph, mesh.components);
  HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box);
  settings.step = coder.step_for_bits(bits);
  if (settings.anchors == 0) settings.anchors = anchors.most() / 200 + 1;
  return coder.code(settings);
}

Result<CodedHighpass> write_at(double step, const GraphMesh& mesh, int anchor_bits = 12) {
  AnchorSequence anchors(mesh.graph, mesh.components);
  HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box);
  return coder.code({.step = step, .anchors = 6, .anchor_bits = anchor_bits});
}

Result<LargeVector<Vec3>> read(const GraphMesh& mesh, const CodedHighpass& coded) {
  // Exact-size copies, so that a sanitizer sees any read past the end.
  const Bytes deltas(coded.deltas);
  const Bytes anchors(coded.anchors);
  return read_highpass(Payload::compact(deltas), Payload::compact(anchors), mesh.graph, mesh.components,
                       mesh.box, coded.parameters);
}

void expect_rule(const Result<LargeVector<Vec3>>& result, const char* rule) {
  ASSERT_FALSE(result);
  EXPECT_STREQ(result.error().rule, rule);
}

GraphMesh flat_line_mesh() {  // every vertex at the same place
  GraphMesh mesh = test::sheet(5, 4);
  for (Vec3& position : mesh.positions) position = {3, -2, 7};
  return test::finish(std::move(mesh));
}

TEST(Highpass, DELT2DecoderReturnsTheEncodersPositions) {
  for (const GraphMesh& mesh : {test::sheet(25, 17), test::fragments(), test::fan(500), test::sheet(1, 1),
                                flat_line_mesh(), test::finish({})}) {
    for (const int bits : {3, 8, 16}) {
      const auto coded = write(mesh, bits, {.anchor_bits = 4 + bits});
      ASSERT_TRUE(coded);
      const auto positions = read(mesh, *coded);
      ASSERT_TRUE(positions);
      EXPECT_EQ(*positions, coded->positions);
    }
  }
}

TEST(Highpass, EqualRequestsGiveEqualBytes) {
  const GraphMesh mesh = test::fragments();
  const auto first = write(mesh);
  const auto second = write(mesh);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->deltas, second->deltas);
  EXPECT_EQ(first->anchors, second->anchors);
}

TEST(Highpass, FineQuantisationComesBackWithinTheAnchorCell) {
  const GraphMesh mesh = test::sheet(40, 30);
  const auto coded = write_at(1e-6, mesh, 16);
  ASSERT_TRUE(coded);
  const Quality quality = measure_quality(mesh.graph, mesh.positions, coded->positions);
  const double cell = mesh.box.longest_side() / 65535;
  EXPECT_LT(quality.max_error, cell);
  EXPECT_EQ(coded->parameters.step, 1e-6);
}

TEST(Highpass, OneMoreBitHalvesTheVisualError) {
  const GraphMesh mesh = test::sheet(60, 60);
  double previous = 0;
  for (const int bits : {5, 6, 7, 8, 9}) {
    const auto coded = write(mesh, bits);
    ASSERT_TRUE(coded);
    const double vde = measure_quality(mesh.graph, mesh.positions, coded->positions).vde_rms;
    if (previous > 0) {
      EXPECT_NEAR(previous / vde, 2, 0.4);
    }
    previous = vde;
  }
}

TEST(Highpass, SmallComponentsAreExactOnTheAnchorLattice) {
  const GraphMesh mesh = test::fragments();
  const auto coded = write(mesh, 3, {.anchors = 2, .anchor_bits = 16});
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->parameters.anchors, 8U + 2U);
  const double half_cell = 0.5 * mesh.box.longest_side() / 65535;
  for (const std::size_t vertex : {63U, 64U, 65U, 74U, 75U, 76U, 77U, 78U}) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(coded->positions[vertex][axis], mesh.positions[vertex][axis], half_cell * (1 + 1e-9));
  }
}

TEST(Highpass, FarFromTheOriginLosesNothing) {
  GraphMesh near = test::sheet(20, 20);
  GraphMesh far = near;
  const Vec3 offset{1 << 22, -(1 << 21), 1 << 20};
  for (Vec3& position : far.positions) position = position + offset;
  far = test::finish(std::move(far));
  const auto coded_near = write(near);
  const auto coded_far = write(far);
  ASSERT_TRUE(coded_near && coded_far);
  const double difference =
      std::abs(measure_quality(near.graph, near.positions, coded_near->positions).lfe_rms -
               measure_quality(far.graph, far.positions, coded_far->positions).lfe_rms);
  EXPECT_LT(difference, 1e-7);
}

TEST(Highpass, RejectsAStepThatOverflowsTheSymbols) {
  const auto coded = write_at(1e-12, test::sheet(10, 10));
  ASSERT_FALSE(coded);
  EXPECT_EQ(coded.error().code, ErrorCode::kInvalidArgument);
}

TEST(Highpass, ExtremeScalesAreCoded) {
  for (const double scale : {1e-38, 1e-30, 1e30, 1e36}) {
    GraphMesh mesh = test::sheet(12, 9);
    for (Vec3& position : mesh.positions) position = scale * position;
    mesh = test::finish(std::move(mesh));
    const auto coded = write(mesh);
    ASSERT_TRUE(coded);
    EXPECT_LT(measure_quality(mesh.graph, mesh.positions, coded->positions).lfe_rms, 0.1 * scale);
  }
}

TEST(Highpass, EveryPrefixAndEveryExtraByteFails) {
  const GraphMesh mesh = test::fragments();
  const auto coded = write(mesh);
  ASSERT_TRUE(coded);
  for (Bytes CodedHighpass::*payload : {&CodedHighpass::deltas, &CodedHighpass::anchors}) {
    CodedHighpass bad = *coded;
    (bad.*payload).push_back(std::byte{0});
    expect_rule(read(mesh, bad), "CMP-3");
    for (std::size_t size = ((*coded).*payload).size(); size-- > 0;) {
      (bad.*payload)
          .assign(((*coded).*payload).begin(),
                  ((*coded).*payload).begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_FALSE(read(mesh, bad)) << size;
    }
  }
}

TEST(Highpass, EveryFlippedBitFailsOrDecodesToFinitePositions) {
  const GraphMesh mesh = test::fragments();
  const auto coded = write(mesh);
  ASSERT_TRUE(coded);
  for (Bytes CodedHighpass::*payload : {&CodedHighpass::deltas, &CodedHighpass::anchors}) {
    CodedHighpass bad = *coded;
    for (std::size_t bit = 0; bit < 8 * (bad.*payload).size(); ++bit) {
      const auto mask = static_cast<std::byte>(1U << (bit % 8));
      (bad.*payload)[bit / 8] ^= mask;
      const auto positions = read(mesh, bad);
      (bad.*payload)[bit / 8] ^= mask;
      if (!positions) continue;
      ASSERT_EQ(positions->size(), mesh.positions.size());
      for (const Vec3& position : *positions) EXPECT_TRUE(std::isfinite(length(position)));
    }
  }
}

class HighpassRules : public ::testing::Test {
 protected:
  HighpassRules() : mesh_(test::fragments()), coded_(*write(mesh_, 8, {.anchors = 2})) {}

  /// Anchors at `vertices`, all in the corner of the lattice.
  void set_anchors(const std::vector<std::uint32_t>& gaps, std::uint32_t first_step = 0) {
    std::vector<std::uint32_t> steps(3 * gaps.size(), 0);
    if (!steps.empty()) steps.front() = first_step;
    coded_.anchors = write_compact_anchors({.gaps = gaps, .steps = steps});
    coded_.parameters.anchors = static_cast<std::uint32_t>(gaps.size());
  }

  GraphMesh mesh_;
  CodedHighpass coded_;
};

TEST_F(HighpassRules, DELT1RejectsABadStep) {
  for (const double step : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    coded_.parameters.step = step;
    expect_rule(read(mesh_, coded_), "DELT-1");
  }
}

TEST_F(HighpassRules, DELT3RejectsPositionsThatAreNotFinite) {
  for (const double step : {1e36, 1e300, std::numeric_limits<double>::max()}) {
    coded_.parameters.step = step;
    expect_rule(read(mesh_, coded_), "DELT-3");
  }
}

TEST_F(HighpassRules, DELT7RejectsNoCyclesAndTooMany) {
  const GraphMesh mesh = test::sheet(25, 17);
  CodedHighpass coded = *write(mesh);
  for (const int cycles : {1, int{kMostCycles}}) {
    coded.parameters.cycles = static_cast<std::uint8_t>(cycles);
    EXPECT_TRUE(read(mesh, coded));
  }
  for (const int cycles : {0, kMostCycles + 1}) {
    coded.parameters.cycles = static_cast<std::uint8_t>(cycles);
    expect_rule(read(mesh, coded), "DELT-7");
  }
}

TEST_F(HighpassRules, ANCH1RejectsParametersOutOfRange) {
  coded_.parameters.anchor_bits = 3;
  expect_rule(read(mesh_, coded_), "ANCH-1");
  coded_.parameters.anchor_bits = 25;
  expect_rule(read(mesh_, coded_), "ANCH-1");
  coded_.parameters.anchor_bits = 12;
  coded_.parameters.anchors = 80;
  expect_rule(read(mesh_, coded_), "ANCH-1");
}

// The fragments: 63 vertices, a triangle 63..65, 8 vertices 66..73, a tetrahedron 74..77, a lone vertex 78.
TEST_F(HighpassRules, ANCH2RejectsComponentsWithTooFewAnchors) {
  set_anchors({0, 62, 0, 0, 0, 7, 0, 0, 0, 0});
  EXPECT_TRUE(read(mesh_, coded_));
  set_anchors({63, 0, 0, 0, 7, 0, 0, 0, 0});  // none in the first sheet
  expect_rule(read(mesh_, coded_), "ANCH-2");
  set_anchors({0, 62, 0, 1, 7, 0, 0, 0, 0});  // the triangle lacks one
  expect_rule(read(mesh_, coded_), "ANCH-2");
  set_anchors({0, 62, 0, 0, 0, 7, 0, 0, 0});  // the lone vertex
  expect_rule(read(mesh_, coded_), "ANCH-2");
  set_anchors({});
  expect_rule(read(mesh_, coded_), "ANCH-2");
}

TEST_F(HighpassRules, ANCH3RejectsAnchorsBeyondTheLastVertex) {
  set_anchors({0, 62, 0, 0, 0, 7, 0, 0, 0, 1});
  expect_rule(read(mesh_, coded_), "ANCH-3");
  set_anchors({0xffffffffU, 0xffffffffU});
  expect_rule(read(mesh_, coded_), "ANCH-3");
}

TEST_F(HighpassRules, ANCH4RejectsCellsOutsideTheLattice) {
  set_anchors({0, 62, 0, 0, 0, 7, 0, 0, 0, 0}, 2 * 4095);
  EXPECT_TRUE(read(mesh_, coded_));
  set_anchors({0, 62, 0, 0, 0, 7, 0, 0, 0, 0}, 2 * 4096);
  expect_rule(read(mesh_, coded_), "ANCH-4");
  set_anchors({0, 62, 0, 0, 0, 7, 0, 0, 0, 0}, 1);
  expect_rule(read(mesh_, coded_), "ANCH-4");
}

TEST(Highpass, PLN4PlainPayloadsSayTheSame) {
  for (const GraphMesh& mesh :
       {test::sheet(25, 17), test::fragments(), test::sheet(1, 1), test::finish({})}) {
    AnchorSequence anchors(mesh.graph, mesh.components);
    HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box, true);
    const auto coded = coder.code_only({.step = coder.step_for_bits(8), .anchors = anchors.most() / 200 + 1});
    ASSERT_TRUE(coded);
    const auto compact = write(mesh);
    ASSERT_TRUE(compact);
    const auto plain = read_highpass(coded->deltas, coded->anchors, mesh.graph, mesh.components, mesh.box,
                                     coded->parameters);
    ASSERT_TRUE(plain) << describe(plain.error());
    EXPECT_EQ(plain->size(), compact->positions.size());
    for (std::size_t size = 0; size < coded->anchors.size(); ++size)
      EXPECT_FALSE(read_plain_anchors(std::span(coded->anchors).first(size), mesh.positions.size(),
                                      coded->parameters, *std::make_unique<HighpassSymbols>()));
  }
}

TEST(Highpass, PLN4RejectsAnchorsThatDoNotAscendOrLeaveTheirLattice) {
  const auto rule = [](const std::vector<std::uint32_t>& anchors, std::uint32_t cell) {
    HighpassSymbols symbols;
    const auto read = read_plain_anchors(
        write_plain_anchors(anchors, std::vector<AnchorCell>(anchors.size(), {0, cell, 0})), 9,
        {.anchor_bits = 4, .anchors = static_cast<std::uint32_t>(anchors.size())}, symbols);
    return std::string(read ? "none" : read.error().rule);
  };
  EXPECT_EQ(rule({0, 3, 8}, 15), "none");
  EXPECT_EQ(rule({0, 3, 3}, 0), "ANCH-3");
  EXPECT_EQ(rule({3, 0}, 0), "ANCH-3");
  EXPECT_EQ(rule({0, 9}, 0), "ANCH-3");
  EXPECT_EQ(rule({0}, 16), "ANCH-4");
}

TEST(HighpassCoder, SettingsDoNotDependOnEarlierOnes) {
  const auto mesh = test::sheet(80, 60);
  AnchorSequence anchors(mesh.graph, mesh.components);
  HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box);
  const HighpassSettings settings{
      .step = 0.1, .rate_weight = 0.12, .centroids = true, .diffusion = 0.8, .anchors = 20};
  ASSERT_TRUE(coder.code({.step = 0.01, .anchors = 20}));
  const auto coded = coder.code(settings);
  ASSERT_TRUE(coded);
  EXPECT_NE(coded->parameters.shift, ReconstructionShift{});
  const auto read = read_highpass(Payload::compact(coded->deltas), Payload::compact(coded->anchors),
                                  mesh.graph, mesh.components, mesh.box, coded->parameters);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, coded->positions);
  const auto bytes_alone = coder.code_only(settings);
  ASSERT_TRUE(bytes_alone);
  EXPECT_NEAR(static_cast<double>(bytes_alone->deltas.size()), static_cast<double>(coded->deltas.size()), 40);
}

}  // namespace
}  // namespace deltamesh
