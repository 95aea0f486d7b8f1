// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/lattice/component_lattice.h"
#include "attributes/payload.h"
#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/numbers/short_float.h"
#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "positions/lattice/coder.h"
#include "round_trip.h"
#include "support/attribute_coding.h"
#include "support/grid_triangles.h"
#include "support/guarded.h"
#include "support/random.h"

namespace deltamesh::lattice_test {
namespace {

using test::grid_triangles;
using test::identity;
using test::numbers;
using test::rows;

constexpr std::uint32_t kSide = 24;
constexpr std::uint32_t kVertices = kSide * kSide;

/// The same with every vertex twice, the second copies at the faces of odd numbers.
struct CopiedGrid {
  std::vector<std::uint32_t> triangles = grid_triangles(kSide, kSide);
  std::vector<std::uint32_t> geometric;
  CopiedGrid() {
    for (std::uint32_t v = 0; v < 2 * kVertices; ++v) geometric.push_back(v / 2);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      triangles[i] = 2 * triangles[i] + static_cast<std::uint32_t>(i / 3 % 2);
  }
  AttributeSurface surface() const { return {triangles, 2 * kVertices, geometric}; }
};

template <class T>
Attribute make(ComponentType type, int components, const std::vector<T>& numbers) {
  return test::attribute_of(AttributeKind::kGeneric, type, components, "thing", numbers);
}

CodedAttribute code(const Attribute& a, double bound, const AttributeSurface& surface) {
  return test::code(a, {.named = {{a.name, bound}}}, surface);
}

CodedAttribute code(const Attribute& a, double bound = 0) {
  const auto triangles = grid_triangles(kSide, kSide);
  return code(a, bound, {triangles, rows(a)});
}

AttributeCoding coding_of(const CodedAttribute& coded) {
  EXPECT_TRUE(coded.is_compact);
  return static_cast<AttributeCoding>(coded.payload[0]);
}

/// Smooth, of a size of about 1.
double wave(std::uint32_t vertex, std::size_t component) {
  const double x = vertex % kSide;
  const double y = vertex / kSide;
  const double phase = 0.7 * static_cast<double>(component);
  return (x - 11) * (y - 13 + phase) / 150 + 0.1 * std::sin(x / 5 + phase);
}

template <class T>
T cast(double x) {
  if constexpr (std::is_floating_point_v<T>) return static_cast<T>(x);
  return static_cast<T>(static_cast<std::int64_t>(x));
}

template <class T>
std::vector<T> waves(std::size_t components, double size = 1) {
  std::vector<T> result;
  for (std::uint32_t v = 0; v < kVertices; ++v)
    for (std::size_t c = 0; c < components; ++c) result.push_back(cast<T>(size * wave(v, c)));
  return result;
}

TEST(Lattice, ATTR55EveryFloatKeepsItsBoundAndZeroStaysZero) {
  for (const double bound : {1e-5, 1e-3, 0.1}) {
    for (const int components : {1, 2, 3, 4, 16}) {
      auto source = waves<float>(static_cast<std::size_t>(components));
      source[7] = 0;
      source[8] = -0.0F;
      source[9] = 1e-42F;
      const CodedAttribute coded = code(make(ComponentType::kF32, components, source), bound);
      ASSERT_EQ(coding_of(coded), AttributeCoding::kLattice);
      EXPECT_LE(coded.descriptor.error, short_float_above(bound));
      EXPECT_GT(coded.descriptor.error, 0.9 * bound);
      const auto back = numbers<float>(coded.decoded);
      for (std::size_t i = 0; i < source.size(); ++i)
        EXPECT_LE(std::fabs(double{back[i]} - source[i]), bound);
      for (const std::size_t i : {7, 8, 9}) EXPECT_EQ(std::bit_cast<std::uint32_t>(back[i]), 0U);
    }
  }
  const auto doubles = waves<double>(2, 1e6);
  const CodedAttribute coded = code(make(ComponentType::kF64, 2, doubles), 0.25);
  EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice);
  EXPECT_LE(coded.descriptor.error, short_float_above(0.25F));
  EXPECT_GT(coded.descriptor.error, 0.2F);
}

TEST(Lattice, ATTR55BoundsBelowRoundingAreExact) {
  const auto source = waves<float>(1, 1e6);
  const CodedAttribute coded = code(make(ComponentType::kF32, 1, source), 1e-3);
  EXPECT_EQ(coded.descriptor.error, 0);
  EXPECT_EQ(numbers<float>(coded.decoded), source);
}

TEST(Lattice, ATTR55FarOriginsAreCoded) {
  auto source = waves<double>(1, 40);
  for (double& x : source) x += 1.7e9;
  const CodedAttribute coded = code(make(ComponentType::kF64, 1, source), 0.01);
  EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice);
  EXPECT_LE(coded.descriptor.error, short_float_above(0.01F));
}

TEST(Lattice, ATTR55SourcesOnACoarserLatticeAreExact) {
  struct Case {
    double over;
    double bound;
  };
  for (const Case& c :
       {Case{1, 0}, {1, 0.1}, {64, 0}, {64, 1e-3}, {100, 0}, {100, 1e-3}, {255, 0}, {200, 0}}) {
    std::vector<float> floats;
    std::vector<double> doubles;
    for (const double x : waves<double>(1, 30 * c.over)) {
      doubles.push_back(std::round(x) / c.over);
      if (c.bound == 0 && doubles.back() == 0) doubles.back() = 0;  // which the sign of zero would forbid
      floats.push_back(static_cast<float>(doubles.back()));
    }
    for (const CodedAttribute& coded : {code(make(ComponentType::kF32, 1, floats), c.bound),
                                        code(make(ComponentType::kF64, 1, doubles), c.bound)}) {
      EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice) << c.over;
      EXPECT_EQ(coded.descriptor.error, 0);
      EXPECT_LT(coded.payload.size(), 3 * kVertices / 2);
    }
    EXPECT_EQ(numbers<float>(code(make(ComponentType::kF32, 1, floats), c.bound).decoded), floats);
  }
}

TEST(Lattice, ATTR55ConstantsTakeTheirBytesAlone) {
  std::vector<float> source;
  for (std::uint32_t v = 0; v < kVertices; ++v)
    for (const float x : {0.1F, -0.0F, std::numeric_limits<float>::quiet_NaN()}) source.push_back(x);
  const CodedAttribute coded = code(make(ComponentType::kF32, 3, source));
  EXPECT_EQ(coded.payload.size(), 1U + 3 * 5);
  EXPECT_EQ(std::memcmp(coded.decoded.values.data(), source.data(), coded.decoded.values.size()), 0);
}

TEST(Lattice, ATTR55FewValuesFarApartAreListed) {
  test::RandomBits random(4);
  std::vector<std::uint32_t> parts(7);
  for (std::uint32_t& part : parts) part = random();
  std::vector<std::uint32_t> source;
  std::vector<float> floats;
  const std::vector<float> odd{std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity(),
                               -0.0F,
                               1e-30F,
                               3.5F,
                               -1e30F,
                               0.1F};
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    const std::size_t part = (v % kSide / 8 + v / kSide / 6) % parts.size();
    source.push_back(parts[part]);
    floats.push_back(odd[part]);
  }
  const CodedAttribute coded = code(make(ComponentType::kU32, 1, source));
  EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice);
  EXPECT_EQ(numbers<std::uint32_t>(coded.decoded), source);
  EXPECT_LT(coded.payload.size(), 28 + kVertices / 8);
  const Attribute mixed = make(ComponentType::kF32, 1, floats);
  const CodedAttribute listed = code(mixed);
  EXPECT_EQ(coding_of(listed), AttributeCoding::kLattice);
  EXPECT_EQ(listed.decoded.values, mixed.values);
}

TEST(Lattice, ATTR56FloatsAreExactAndPredicted) {
  for (const int components : {1, 3, 5}) {
    auto source = waves<float>(static_cast<std::size_t>(components));
    source[0] = 1e-42F;
    source[static_cast<std::size_t>(components)] = -0.0F;
    const Attribute a = make(ComponentType::kF32, components, source);
    const CodedAttribute coded = code(a);
    EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice);
    EXPECT_EQ(coded.decoded.values, a.values);
    EXPECT_LT(coded.payload.size(), 7 * a.values.size() / 10);
  }
  // A constant, floats, a lattice and floats again: groups of their own.
  std::vector<float> mixed;
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    mixed.push_back(0.3F);
    mixed.push_back(static_cast<float>(wave(v, 1)));
    mixed.push_back(static_cast<float>(v / 7));
    mixed.push_back(static_cast<float>(wave(v, 2)));
  }
  const Attribute a = make(ComponentType::kF32, 4, mixed);
  EXPECT_EQ(code(a).decoded.values, a.values);
}

TEST(Lattice, ATTR56WhatMustBeExactIsPredictedWhateverItsKind) {
  const auto triangles = grid_triangles(kSide, kSide);
  const AttributeQuality exactly{.normal_error = 0, .tangent_error = 0, .uv_error = 0, .weight_error = 0};
  struct Case {
    AttributeKind kind;
    int components;
  };
  for (const Case& c : {Case{AttributeKind::kNormal, 3},
                        {AttributeKind::kUv, 2},
                        {AttributeKind::kTangent, 4},
                        {AttributeKind::kWeights, 4}}) {
    Attribute a =
        make(ComponentType::kF32, c.components, waves<float>(static_cast<std::size_t>(c.components)));
    a.kind = c.kind;
    const AttributeSurface surface(triangles, kVertices);
    const auto coded = write_attribute(test::view(a), identity(kVertices), {.quality = exactly}, surface, {});
    ASSERT_TRUE(coded);
    EXPECT_EQ(coding_of(*coded), AttributeCoding::kLattice);
    EXPECT_EQ(coded->descriptor.error, 0);
    const auto back =
        read_attribute(Payload::compact(coded->payload), coded->descriptor, surface, {}, 1 << 20);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->values, a.values);
  }
}

TEST(Lattice, WeightsThatAreNoSharesOfFourJointsAreExact) {
  std::vector<std::int8_t> values;
  for (std::uint32_t v = 0; v < kVertices; ++v)
    values.push_back(static_cast<std::int8_t>(64 + 60 * std::sin(0.3 * v)));
  Attribute a = make(ComponentType::kI8, 1, values);
  a.kind = AttributeKind::kWeights;
  const auto triangles = grid_triangles(kSide, kSide);
  const auto coded = write_attribute(test::view(a), identity(kVertices), {.quality = {.weight_error = 0.04}},
                                     {triangles, kVertices}, {});
  ASSERT_TRUE(coded);
  EXPECT_EQ(coding_of(*coded), AttributeCoding::kLattice);
  EXPECT_EQ(coded->decoded.values, a.values);
}

TEST(Lattice, ATTR56NumbersUpToTheLargestAreExact) {
  test::RandomBits random(6);
  std::vector<std::uint32_t> noise;
  for (std::uint32_t v = 0; v < 2 * kVertices; ++v) noise.push_back(random() % (kMostLatticeCells + 1));
  const CodedAttribute coded = code(make(ComponentType::kU32, 2, noise));
  EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice);
  EXPECT_EQ(numbers<std::uint32_t>(coded.decoded), noise);
}

TEST(Lattice, ExactWideValuesThatMayRepeatHaveAPlainFormToo) {
  const auto triangles = grid_triangles(kSide, kSide);
  const AttributeSurface surface(triangles, kVertices);
  const Attribute a = make(ComponentType::kF32, 1, waves<float>(1));
  const AttributeQuality quality;
  for (const int effort : {0, 1}) {
    const auto coded = write_attribute(test::view(a), identity(kVertices),
                                       {.quality = quality, .effort = effort}, surface, {});
    ASSERT_TRUE(coded);
    EXPECT_EQ(coding_of(*coded), AttributeCoding::kLattice);
    EXPECT_EQ(coded->plain.empty(), effort == 0);
    if (coded->plain.empty()) continue;
    const auto back = test::read_plain(coded->plain, coded->descriptor, kVertices);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->values, a.values);
  }
}

TEST(Lattice, NoVerticesAreCoded) {
  const CodedAttribute none = code(make(ComponentType::kF32, 2, std::vector<float>{}), 0.01);
  EXPECT_TRUE(none.decoded.values.empty());
}

template <class T>
void expect_integers(ComponentType type, double size) {
  std::vector<T> source = waves<T>(2, size);
  source[5] = std::numeric_limits<T>::max();
  source[6] = std::numeric_limits<T>::min();
  const CodedAttribute exact = code(make(type, 2, source));
  EXPECT_EQ(numbers<T>(exact.decoded), source);
  for (const double bound : {1.0, 2.5, 3.0, 100.0}) {
    const CodedAttribute coded = code(make(type, 2, source), bound);
    EXPECT_LE(coded.descriptor.error, short_float_above(bound));
    if (sizeof(T) < 4) {
      EXPECT_LT(coded.payload.size(), exact.payload.size());
    }
  }
}

TEST(Lattice, ATTR55IntegersOfEveryTypeAreExactOrWithinABound) {
  expect_integers<std::int8_t>(ComponentType::kI8, 60);
  expect_integers<std::uint8_t>(ComponentType::kU8, 60);
  expect_integers<std::int16_t>(ComponentType::kI16, 9000);
  expect_integers<std::uint16_t>(ComponentType::kU16, 9000);
  expect_integers<std::int32_t>(ComponentType::kI32, 1e6);
  expect_integers<std::uint32_t>(ComponentType::kU32, 1e6);
}

TEST(Lattice, ATTR57WhatTheNeighboursHaveCostsNearlyNothing) {
  std::vector<float> source(3 * std::size_t{kVertices}, 0.0F);
  for (std::uint32_t v = 0; v < 40; ++v) source[3 * v] = static_cast<float>(wave(v, 0));
  EXPECT_LT(code(make(ComponentType::kF32, 3, source), 1e-3).payload.size(), 150U);
  std::vector<std::uint8_t> labels;
  for (std::uint32_t v = 0; v < kVertices; ++v)
    labels.push_back(static_cast<std::uint8_t>(v % kSide / 8 * 71 + v / kSide / 8 * 13));
  EXPECT_LT(code(make(ComponentType::kU8, 1, labels)).payload.size(), kVertices / 8);
}

/// Three numbers at every vertex: `rest`, but for waves in a square of 7 x 7 vertices.
std::vector<float> patch(float rest) {
  std::vector<float> source;
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    const bool moves = v % kSide - 5 < 7 && v / kSide - 9 < 7;
    for (std::size_t c = 0; c < 3; ++c)
      source.push_back(moves ? rest + static_cast<float>(wave(v, c)) : rest);
  }
  return source;
}

TEST(Lattice, ATTR59WhatRestsIsExactAndCostsNearlyNothing) {
  const CopiedGrid copied;
  const auto moving = patch(0);
  std::vector<float> twice;
  for (std::uint32_t v = 0; v < 2 * kVertices; ++v)
    twice.insert(twice.end(), moving.begin() + 3 * (v / 2), moving.begin() + 3 * (v / 2) + 3);
  const auto triangles = grid_triangles(kSide, kSide);
  const AttributeQuality quality{.named = {{"thing", 1e-3}}};
  for (const int effort : {0, 1}) {
    for (const bool is_copied : {false, true}) {
      const Attribute a = make(ComponentType::kF32, 3, is_copied ? twice : moving);
      const AttributeSurface surface = is_copied ? copied.surface() : AttributeSurface(triangles, kVertices);
      const auto coded = write_attribute(test::view(a), identity(rows(a)),
                                         {.quality = quality, .effort = effort}, surface, {});
      ASSERT_TRUE(coded);
      EXPECT_LE(coded->descriptor.error, short_float_above(1e-3F));
      EXPECT_LT(coded->payload.size(), 200U);
      const auto back =
          read_attribute(Payload::compact(coded->payload), coded->descriptor, surface, {}, 1 << 20);
      ASSERT_TRUE(back);
      EXPECT_EQ(back->values, coded->decoded.values);
      const auto values = numbers<float>(*back);
      const auto& source = is_copied ? twice : moving;
      for (std::size_t i = 0; i < source.size(); ++i) {
        if (source[i] == 0) {
          EXPECT_EQ(std::bit_cast<std::uint32_t>(values[i]), 0U) << i;
        }
      }
    }
  }
}

TEST(Lattice, ATTR59RestIsZeroOrTheNearestToIt) {
  const auto rest = [](std::int64_t base, std::uint32_t cells) {
    return ComponentLattice{.kind = LatticeKind::kPoints, .base = base, .cells = cells}.rest();
  };
  EXPECT_EQ(rest(-5, 9), 5);
  EXPECT_EQ(rest(3, 9), 0);
  EXPECT_EQ(rest(-30, 9), 9);
  const auto listed = [](std::vector<std::uint64_t> values) {
    return ComponentLattice{.kind = LatticeKind::kListed, .values = std::move(values)}.rest();
  };
  EXPECT_EQ(listed({7, 0, 9}), 1);
  EXPECT_EQ(listed({7, 9}), 0);
  code(make(ComponentType::kF32, 3, patch(100)), 1e-3);
}

TEST(Lattice, ATTR58CopiesCostNearlyNothingWhereTheyAgree) {
  const CopiedGrid copied;
  std::vector<float> agree;
  for (std::uint32_t v = 0; v < 2 * kVertices; ++v) agree.push_back(static_cast<float>(wave(v / 2, 0)));
  std::vector<float> differ = agree;
  for (std::uint32_t v = 1; v < 2 * kVertices; v += 2) differ[v] += 5;
  std::vector<float> sometimes = agree;
  for (std::uint32_t v = 1; v < 2 * kVertices; v += 14) sometimes[v] -= 3;
  const auto size = [&](const std::vector<float>& source) {
    const CodedAttribute coded = code(make(ComponentType::kF32, 1, source), 1e-3, copied.surface());
    EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice);
    EXPECT_LE(coded.descriptor.error, short_float_above(1e-3F));
    return coded.payload.size();
  };
  const std::size_t once = code(make(ComponentType::kF32, 1, waves<float>(1)), 1e-3).payload.size();
  EXPECT_LT(size(agree), once + 30);
  EXPECT_LT(size(sometimes), once + 250);
  size(differ);
}

/// The payload of one component of doubles at two vertices, by hand.
std::vector<std::byte> by_hand(int kind, float times, float over, std::uint64_t base, std::uint64_t cells,
                               bool has_fields = true, CompactWriter numbers = {}) {
  ByteWriter out;
  out.write(std::uint8_t{8});
  out.write(static_cast<std::uint8_t>(kind));
  if (has_fields) {
    out.write(times);
    if (kind == 3) out.write(over);
  }
  out.write_varint(base);
  out.write_varint(cells);
  out.write_bytes(numbers.finish());
  return out.take();
}

const char* broken_rule(const std::vector<std::byte>& bytes, ComponentType type = ComponentType::kF64) {
  return test::broken_rule(bytes, {.type = type, .components = 1}, 2);
}

TEST(Lattice, ATTR55EachBrokenFieldIsNamed) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_STREQ(broken_rule(by_hand(6, 1, 1, 0, 1)), "ATTR-55");
  const auto bytes = [](std::initializer_list<int> values) {
    std::vector<std::byte> result;
    for (const int value : values) result.push_back(static_cast<std::byte>(value));
    return result;
  };
  EXPECT_STREQ(broken_rule(bytes({8, 4, 0})), "ATTR-55");
  EXPECT_STREQ(broken_rule(bytes({8, 4, 0x81, 0x20})), "CON-2");
  EXPECT_STREQ(broken_rule(bytes({8, 5, 1})), "ATTR-55");
  EXPECT_STREQ(broken_rule(bytes({8, 5, 255}), ComponentType::kF32), "ATTR-55");
  EXPECT_STREQ(broken_rule(by_hand(1, 1, 1, 0, 1, false)), "ATTR-55");
  EXPECT_STREQ(broken_rule(by_hand(2, 0, 1, 0, 1)), "ATTR-55");
  EXPECT_STREQ(broken_rule(by_hand(2, -1, 1, 0, 1)), "ATTR-55");
  EXPECT_STREQ(broken_rule(by_hand(3, 1, infinity, 0, 1)), "ATTR-55");
  EXPECT_STREQ(broken_rule(by_hand(3, 1e38F, 1e-38F, 2000, 1), ComponentType::kF32), "ATTR-55");
  EXPECT_STREQ(broken_rule(by_hand(2, 1, 1, 0, (1U << 28) + 1)), "CON-2");
  EXPECT_STREQ(broken_rule(by_hand(2, 1, 1, (std::uint64_t{1} << 53) + 1, 1)), "CON-2");
}

TEST(Lattice, ATTR56NumbersBeyondTheLatticeAreRefused) {
  const auto source = waves<float>(1);
  auto coded = code(make(ComponentType::kF32, 1, source), 0.01);
  // Coding, kind, step, then a base of two bytes and the number of cells, of which one is taken away.
  ByteReader in(coded.payload);
  ASSERT_TRUE(in.read_bytes(6));
  ASSERT_TRUE(in.read_varint());
  const std::size_t at = in.position();
  ASSERT_NE(coded.payload[at] & std::byte{0x7f}, std::byte{0});
  coded.payload[at] = static_cast<std::byte>(std::to_integer<unsigned>(coded.payload[at]) - 1);
  const auto triangles = grid_triangles(kSide, kSide);
  const auto read = read_attribute(Payload::compact(coded.payload), coded.descriptor,
                                   AttributeSurface(triangles, kVertices), {}, 1 << 20);
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "ATTR-56");
}

TEST(Lattice, ATTR59RunsBeyondTheVerticesAreRefused) {
  const auto rule_of_run = [](std::uint32_t length) {
    CompactWriter writer;
    writer.bits(0, 1);  // joined
    BlendTable blends = kUsualBlends;
    code_blends(writer, blends);
    writer.bits(0, 1);  // guesses
    writer.bits(1, 1);  // sparse
    NumberModel lengths;
    writer.number(length, lengths);
    return std::string(broken_rule(by_hand(2, 1, 1, 0, 1, true, std::move(writer))));
  };
  EXPECT_EQ(rule_of_run(2), "none");
  EXPECT_EQ(rule_of_run(3), "ATTR-56");
  EXPECT_EQ(rule_of_run(0xffffffff), "ATTR-56");
}

TEST(Lattice, CON3PrefixesAndExtraBytesAreRefusedAndFlippedOnesEnd) {
  const CopiedGrid copied;
  auto source = waves<float>(8, 0.2);
  source.resize(2 * kVertices);
  const Attribute a = make(ComponentType::kF32, 1, source);
  const auto coded = code(a, 0.01, copied.surface());
  const auto read = [&](const test::Bytes& bytes) {
    const auto back =
        read_attribute(Payload::compact(bytes), coded.descriptor, copied.surface(), {}, 1 << 20);
    EXPECT_TRUE(!back || rows(*back) == rows(a));
    return back.has_value();
  };
  test::expect_guarded(coded.payload, read, a.name);
}

}  // namespace
}  // namespace deltamesh::lattice_test
