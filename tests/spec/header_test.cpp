// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/header.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "deltamesh/version.h"

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
  h.highpass = {.bits = 8, .step = 0.5, .anchor_bits = 12, .anchors = 1, .anchor_density = 2, .cycles = 3};
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

TEST(Header, HDR2RejectsAnotherMajorVersionAndTakesALaterMinor) {
  EXPECT_EQ(broken_rule_at(4, kFormatMajor + 1), "HDR-2");
  EXPECT_EQ(broken_rule_at(5, kFormatMinor + 1), "none");
}

TEST(Header, HDR3RejectsAnotherDraft) { EXPECT_EQ(broken_rule_at(6, kFormatDraft + 1), "HDR-3"); }

TEST(Header, HDR4SkipsFieldsOfALaterMinorVersionOnly) {
  auto bytes = write_header(tetrahedron_header());
  bytes.push_back(std::byte{77});
  bytes[8] = static_cast<std::byte>(std::to_integer<unsigned>(bytes[8]) + 1);
  ByteReader current(bytes);
  const auto rejected = read_header(current);
  ASSERT_FALSE(rejected);
  EXPECT_STREQ(rejected.error().rule, "HDR-4");
  bytes[5] = std::byte{kFormatMinor + 1};
  ByteReader later(bytes);
  EXPECT_TRUE(read_header(later));
  EXPECT_EQ(later.remaining(), 0U);
}

TEST(Header, HDR5RejectsReservedFlags) {
  EXPECT_EQ(broken_rule_at(10, 0x04), "HDR-5");
  EXPECT_EQ(broken_rule_at(11, 0x80), "HDR-5");
}

TEST(Header, HDR6RejectsHugeCounts) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.vertices = 0x80000000; }), "HDR-6");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.triangles = (1U << 29) + 1; }), "HDR-6");
}

TEST(Header, HDR7RejectsCountsThatCannotBe) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.geometric_vertices = 6; }), "HDR-7");
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

TEST(Header, HDR10RejectsAnUnknownGeometryCoder) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.geometry = 99; }), "HDR-10");
}

TEST(Header, HDR11RejectsHighpassParametersOutOfRange) {
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.bits = 17; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.bits = 2; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.step = 0; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.anchor_bits = 25; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.anchors = 5; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.anchors = 0; }), "HDR-11");
  EXPECT_EQ(broken_rule([](FileHeader& h) { h.highpass.cycles = kMostCycles + 1; }), "HDR-11");
}

FileHeader predictive_header() {
  FileHeader h = tetrahedron_header();
  h.geometry = kGeometryPredictive;
  h.predictive = {.bits = 10,
                  .lattice = {.origin = h.box().min, .step = {0.5, 0.5, 0.5}, .cells = {3, 4, 5}}};
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
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.kind = static_cast<PositionKind>(9); }), "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.lattice.step[1] = 0; }), "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.lattice.origin[2] = std::nan(""); }), "HDR-14");
  EXPECT_EQ(rule_of([](PredictiveParameters& p) { p.lattice.cells[0] = kMostCells + 1; }), "HDR-14");
}

TEST(Header, HDR14LeavesOutWhatFollowsFromTheBox) {
  FileHeader h = predictive_header();
  const std::size_t shortest = write_header(h).size();
  h.predictive.lattice.step[2] = 0.25;
  EXPECT_EQ(write_header(h).size(), shortest + 16);
  h.predictive.lattice.origin[0] -= 1;
  const auto bytes = write_header(h);
  EXPECT_EQ(bytes.size(), shortest + 40);
  ByteReader in(bytes);
  const auto back = read_header(in);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->predictive.lattice.step, h.predictive.lattice.step);
  EXPECT_EQ(back->predictive.lattice.origin, h.predictive.lattice.origin);
  EXPECT_EQ(back->predictive.lattice.cells, h.predictive.lattice.cells);
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
  h.attributes = 3;
  const auto back = reread(h);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->keeps_order);
  EXPECT_EQ(back->vertices, h.vertices);
  EXPECT_EQ(back->geometric_vertices, h.geometric_vertices);
  EXPECT_EQ(back->triangles, h.triangles);
  EXPECT_EQ(back->attributes, h.attributes);
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
