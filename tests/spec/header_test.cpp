// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/header.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace deltamesh {
namespace {

FileHeader tetrahedron_header() {
  FileHeader h;
  h.vertices = 5;
  h.geometric_vertices = 4;
  h.triangles = 4;
  h.components = 1;
  h.box_max = {1, 2, 3};
  h.vde_rms = 0.25F;
  h.highpass = {.bits = 8, .step = 0.1, .anchor_bits = 12, .anchors = 1, .anchor_density = 2, .cycles = 3};
  return h;
}

Result<FileHeader> reread(const FileHeader& header) {
  const auto bytes = write_header(header);
  ByteReader in(bytes);
  return read_header(in);
}

/// The rule that a header with one field changed breaks.
std::string broken_rule(const std::function<void(FileHeader&)>& change) {
  FileHeader header = tetrahedron_header();
  change(header);
  const auto result = reread(header);
  return result ? "none" : result.error().rule;
}

/// The rule that the tetrahedron's header breaks once byte `at` is `value`.
std::string broken_rule_at(std::size_t at, std::uint8_t value) {
  auto bytes = write_header(tetrahedron_header());
  bytes[at] = std::byte{value};
  ByteReader in(bytes);
  const auto result = read_header(in);
  return result ? "none" : result.error().rule;
}

TEST(Header, HDR1RejectsAnotherMagic) { EXPECT_EQ(broken_rule_at(0, 'X'), "HDR-1"); }

TEST(Header, HDR2RejectsAnotherReleasedVersion) {
  EXPECT_EQ(broken_rule_at(3, 1), "HDR-2");
  EXPECT_EQ(broken_rule_at(3, 127), "HDR-2");
}

TEST(Header, HDR3RejectsAnotherDraft) {
  EXPECT_EQ(kFormatVersion, 128 + kFormatDraft);
  EXPECT_EQ(broken_rule_at(3, kFormatVersion + 1), "HDR-3");
  EXPECT_EQ(broken_rule_at(3, kFormatVersion - 1), "HDR-3");
}

TEST(Header, HDR5RejectsFlagsThatMeanNothing) {
  for (const unsigned flag : {0x10U, 0x20U}) {  // a lattice's
    EXPECT_EQ(broken_rule_at(4, static_cast<std::uint8_t>(flag)), "HDR-5") << "highpass";
    EXPECT_EQ(broken_rule_at(4, static_cast<std::uint8_t>(0xc0 | flag)), "HDR-5") << "floats";
  }
  EXPECT_EQ(broken_rule_at(4, 0xc8), "HDR-5") << "floats have no step";
}

TEST(Header, HDR6RejectsHugeCounts) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.vertices = 0x80000000; }), "HDR-6");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.triangles = (1U << 29) + 1; }), "HDR-6");
}

/// The tetrahedron's header where the varint at byte `at` is larger by 2^35.
std::vector<std::byte> with_long_varint(std::size_t at) {
  auto bytes = write_header(tetrahedron_header());
  bytes[at] |= std::byte{0x80};
  for (const unsigned byte : {1U, 0x80U, 0x80U, 0x80U, 0x80U})
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at + 1), static_cast<std::byte>(byte));
  return bytes;
}

TEST(Header, HDR6HDR7RejectCountsBeyond32Bits) {
  for (const std::size_t at : {5U, 6U, 7U, 8U}) {  // triangles, geometric vertices, copies, components
    const auto bytes = with_long_varint(at);
    ByteReader in(bytes);
    EXPECT_STREQ(read_header(in).error().rule, at == 8 ? "HDR-7" : "HDR-6") << at;
  }
}

TEST(Header, AnAnchorDensityBeyond32BitsIsCutOff) {
  const auto bytes = with_long_varint(write_header(tetrahedron_header()).size() - 2);
  ByteReader in(bytes);
  EXPECT_EQ(read_header(in)->highpass.anchor_density, 0xffffffff);
}

TEST(Header, HDR7RejectsCountsThatCannotBe) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.geometric_vertices = 0; }), "HDR-7");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.vertices = h.geometric_vertices = h.components = 0; }),
            "HDR-7");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.components = 5; }), "HDR-7");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.components = 0; }), "HDR-7");
}

TEST(Header, HDR8RejectsABoxThatIsNotFiniteAndOrdered) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(broken_rule([&](FileHeader& h) { h.box_min[1] = nan; }), "HDR-8");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.box_max[2] = -1; }), "HDR-8");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.origin[0] = std::numeric_limits<double>::infinity(); }),
            "HDR-8");
}

TEST(Header, HDR9RejectsFiguresThatAreNotErrors) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.lfe_rms = -1; }), "HDR-9");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.max_error = std::numeric_limits<float>::infinity(); }),
            "HDR-9");
}

TEST(Header, HDR11RejectsHighpassParametersOutOfRange) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.bits = 17; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.bits = 2; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.step = 0; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.anchor_bits = 25; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.anchors = 5; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.anchors = 0; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.cycles = kMostCycles + 1; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.cycles = 0; }), "HDR-11");
}

FileHeader predictive_header() {
  FileHeader h = tetrahedron_header();
  h.geometry = kGeometryPredictive;
  h.predictive = {.bits = 10, .lattice = {.step = {0.5, 0.5, 0.5}, .cells = {3, 4, 5}}};
  return h;
}

TEST(Header, HDR14RejectsPredictiveParametersOutOfRange) {
  const auto rule_of = [](const std::function<void(PredictiveParameters&)>& change) {
    FileHeader h = predictive_header();
    change(h.predictive);
    const auto bytes = write_header(h);
    ByteReader in(bytes);
    const auto read = read_header(in);
    return std::string(read ? "" : read.error().rule);
  };
  EXPECT_EQ(rule_of([](PredictiveParameters&) {}), "");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.bits = 29; }), "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.lattice.first[1] = kMostFirst + 1; }), "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) {
              p.kind = PositionKind::kVoxel;
              p.levels = 0;
            }),
            "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.lattice.step[1] = 0; }), "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.lattice.origin[2] = std::nan(""); }), "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.lattice.cells[0] = kMostCells + 1; }), "HDR-14");
}

TEST(Header, HDR14WritesALatticeAsShortAsItIs) {
  FileHeader h = predictive_header();
  const std::size_t shortest = write_header(h).size();
  h.predictive.lattice.first[0] = -(std::int64_t{1} << 48);
  EXPECT_EQ(write_header(h).size(), shortest + 6);
  h = predictive_header();
  h.predictive.lattice.step.fill(0.1);
  EXPECT_EQ(write_header(h).size(), shortest + 5) << "no short float";
  h.predictive.lattice.step[2] = 0.25;
  EXPECT_EQ(write_header(h).size(), shortest + 21) << "three of 8 bytes in place of 3 bytes";
  h.predictive.lattice.origin[0] = -1;
  h.predictive.lattice.first[1] = 1000;
  const auto bytes = write_header(h);
  EXPECT_EQ(bytes.size(), shortest + 21 + 24 + 1);
  ByteReader in(bytes);
  const auto back = read_header(in);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->predictive.lattice.step, h.predictive.lattice.step);
  EXPECT_EQ(back->predictive.lattice.origin, h.predictive.lattice.origin);
  EXPECT_EQ(back->predictive.lattice.first, h.predictive.lattice.first);
  EXPECT_EQ(back->predictive.lattice.cells, h.predictive.lattice.cells);
}

TEST(Header, HDR8TheBoxIsThatOfTheLattice) {
  FileHeader h = predictive_header();
  h.predictive.lattice.first = {-2, 0, 10};
  const auto back = reread(h);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->box_min, (std::array<float, 3>{-1, 0, 5}));
  EXPECT_EQ(back->box_max, (std::array<float, 3>{0.5F, 2, 7.5F}));
  h.predictive.lattice.step.fill(1e300);
  EXPECT_TRUE(std::isfinite(reread(h)->box_max[0]));
}

TEST(Header, RoundTripsEveryGeometry) {
  FileHeader h = predictive_header();
  for (const PositionKind kind : {PositionKind::kLattice, PositionKind::kVoxel, PositionKind::kFloats}) {
    h.predictive.kind = kind;
    h.predictive.levels = 9;
    const auto back = reread(h);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->geometry, kGeometryPredictive);
    EXPECT_EQ(back->predictive.kind, kind);
    EXPECT_EQ(back->predictive.bits, 10);
    EXPECT_EQ(back->predictive.levels, kind == PositionKind::kVoxel ? 9U : 1U);
  }
}

TEST(Header, HDR12OmitsAZeroOriginAndKeepsAnother) {
  FileHeader near = tetrahedron_header();
  FileHeader far = near;
  far.origin = {500000.125, 5100000.5, -3};
  EXPECT_EQ(write_header(far).size(), write_header(near).size() + 24);
  EXPECT_EQ(reread(far)->origin, far.origin);
}

TEST(Header, RoundTripsEveryField) {
  FileHeader h = tetrahedron_header();
  h.keeps_order = true;
  const auto back = reread(h);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->keeps_order);
  EXPECT_EQ(back->vertices, h.vertices);
  EXPECT_EQ(back->geometric_vertices, h.geometric_vertices);
  EXPECT_EQ(back->triangles, h.triangles);
  EXPECT_EQ(back->box_max, h.box_max);
  EXPECT_EQ(back->vde_rms, h.vde_rms);
  EXPECT_EQ(back->highpass.step, h.highpass.step);
  EXPECT_EQ(back->highpass.anchor_density, h.highpass.anchor_density);
  EXPECT_EQ(back->highpass.cycles, h.highpass.cycles);
}

TEST(Header, EveryPrefixIsTruncated) {
  const auto bytes = write_header(tetrahedron_header());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ByteReader in(std::span<const std::byte>(bytes).first(size));
    EXPECT_FALSE(read_header(in)) << size;
  }
}

}  // namespace
}  // namespace deltamesh
