// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/attribute.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "attributes/payload.h"
#include "attributes/plain/levels.h"
#include "attributes/plain/octahedral.h"
#include "attributes/plain/symbols.h"
#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "support/attribute_coding.h"

namespace deltamesh {
namespace {

using test::identity;
using test::rows;

class Random {
 public:
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state_ >> 32);
  }
  double symmetric() { return next() / 2147483648.0 - 1; }

 private:
  std::uint64_t state_ = 7;
};

template <class T>
Attribute make(AttributeKind kind, ComponentType type, int components, const std::vector<T>& numbers) {
  Attribute attribute;
  attribute.kind = kind;
  attribute.type = type;
  attribute.components = static_cast<std::uint8_t>(components);
  attribute.name = "thing";
  const auto bytes = std::as_bytes(std::span(numbers));
  attribute.values.assign(bytes.begin(), bytes.end());
  return attribute;
}

CodedAttribute coded(const Attribute& a, const AttributeQuality& quality = {}) {
  auto written = test::write_plain(a, identity(rows(a)), quality);
  EXPECT_TRUE(written);
  return *written;
}

/// What a reader gets, which is what the writer said.
Attribute decoded(const Attribute& a, const AttributeQuality& quality = {}) {
  const CodedAttribute written = coded(a, quality);
  auto back = test::read_plain(written.plain, written.descriptor, rows(a));
  EXPECT_TRUE(back) << (back ? "" : describe(back.error()));
  if (!back) return {};
  EXPECT_EQ(back->values, written.decoded.values);
  return *back;
}

template <class T>
std::vector<T> numbers(const Attribute& a) {
  std::vector<T> result(a.values.size() / sizeof(T));
  if (!result.empty()) std::memcpy(result.data(), a.values.data(), a.values.size());
  return result;
}

void expect_exact(const Attribute& a) {
  const Attribute back = decoded(a);
  EXPECT_EQ(coded(a).descriptor.error, 0);
  EXPECT_EQ(back.kind, a.kind);
  EXPECT_EQ(back.type, a.type);
  EXPECT_EQ(back.components, a.components);
  EXPECT_EQ(back.normalized, a.normalized);
  EXPECT_EQ(back.name, a.name);
  EXPECT_EQ(back.values, a.values);
}

std::vector<float> unit_vectors(std::size_t count) {
  Random random;
  std::vector<float> result;
  while (result.size() < 3 * count) {
    const Vec3 v{random.symmetric(), random.symmetric(), random.symmetric()};
    const double size = length(v);
    if (size < 0.01) continue;
    for (const double x : v) result.push_back(static_cast<float>(x / size));
  }
  return result;
}

double angle(const float* a, const std::array<float, 3>& b) {
  const Vec3 p{a[0], a[1], a[2]};
  const Vec3 q{b[0], b[1], b[2]};
  return std::atan2(length(cross(p, q)), dot(p, q));
}

constexpr double kDegree = 3.14159265358979 / 180;

TEST(Octahedral, ATTR5ErrorStaysWithinHalfACellDiagonal) {
  const auto vectors = unit_vectors(20000);
  for (const int bits : {2, 3, 8, 10, 15}) {
    // A cell of side 1/h on the octahedron, whose faces are at least 1/sqrt(3) from the centre, and
    // stretched by at most sqrt(3) when unfolded.
    const double bound = std::sqrt(0.5) * std::sqrt(3.0) * std::sqrt(2.0) / octahedral_half(bits);
    double largest = 0;
    for (std::size_t i = 0; i < vectors.size(); i += 3) {
      const Vec3 v{vectors[i], vectors[i + 1], vectors[i + 2]};
      largest = std::max(largest, angle(&vectors[i], decode_octahedral(encode_octahedral(v, bits), bits)));
    }
    EXPECT_LT(largest, bound) << bits << " bits";
    EXPECT_GT(largest, 0);
  }
}

TEST(Octahedral, ATTR5KeepsAxesDiagonalsAndZero) {
  for (const int bits : {2, 10, 15}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Vec3 v{};
        v[axis] = sign;
        const auto back = decode_octahedral(encode_octahedral(v, bits), bits);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(back[c], static_cast<float>(v[c]));
      }
    }
    EXPECT_EQ(decode_octahedral(encode_octahedral({0, 0, 0}, bits), bits), (std::array<float, 3>{}));
  }
}

TEST(Octahedral, ATTR5EveryCodeIsAUnitVectorThatKeepsItsPlace) {
  const int bits = 6;
  const auto side = static_cast<std::uint32_t>(2 * octahedral_half(bits) + 1);
  for (std::uint32_t u = 0; u < side; ++u) {
    for (std::uint32_t v = 0; v < side; ++v) {
      const auto n = decode_octahedral({u, v}, bits);
      const Vec3 normal{n[0], n[1], n[2]};
      EXPECT_NEAR(length(normal), 1, 1e-6);
      EXPECT_EQ(decode_octahedral(encode_octahedral(normal, bits), bits), n);
    }
  }
}

TEST(Levels, ATTR6IntegersComeBackWithinHalfALevel) {
  for (std::uint32_t v = 0; v < 256; ++v) {
    EXPECT_EQ(rescale_level(rescale_level(v, 255, 255), 255, 255), v);
    EXPECT_EQ(rescale_level(rescale_level(v, 255, 65535), 65535, 255), v);
    const std::uint32_t back = rescale_level(rescale_level(v, 255, 31), 31, 255);
    EXPECT_LE(std::abs(static_cast<int>(back) - static_cast<int>(v)), 4);
  }
}

TEST(Levels, ATTR7ExtremeRangesStayFinite) {
  const float top = std::numeric_limits<float>::max();
  const LevelRange range{-top, top};
  for (const int bits : {1, 12, 24}) {
    EXPECT_EQ(value_of(level_of(-top, range, top_level(bits)), range, top_level(bits)), -top);
    EXPECT_EQ(value_of(level_of(top, range, top_level(bits)), range, top_level(bits)), top);
  }
  EXPECT_EQ(value_of(level_of(3.5F, {3.5F, 3.5F}, 4095), {3.5F, 3.5F}, 4095), 3.5F);
}

TEST(Symbols, ATTR3DifferencesFoldAndUnfoldAtEveryWidth) {
  Random random;
  for (unsigned width = 1; width <= 64; ++width) {
    for (int i = 0; i < 100; ++i) {
      const std::uint64_t value = ((std::uint64_t{random.next()} << 32) | random.next()) & symbol_mask(width);
      EXPECT_LE(fold_difference(value, width), symbol_mask(width));
      EXPECT_EQ(unfold_difference(fold_difference(value, width), width), value);
    }
  }
  EXPECT_EQ(fold_difference(~std::uint64_t{0}, 10), 1U);
  EXPECT_EQ(fold_difference(1, 10), 2U);
}

TEST(Symbols, ATTR3EveryPredictionIsChosenWhereItPaysAndComesBack) {
  Random random;
  std::vector<std::uint64_t> noise, ramp, like_noise, noise_and_ramp;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    noise.push_back(random.next() & 0x3f);
    ramp.push_back((i * 3 + 70) & 0xff);
    like_noise.push_back((noise.back() + 5 + (random.next() & 1)) & 0xff);
    noise_and_ramp.push_back((noise.back() + i) & 0xff);
  }
  const auto check = [](const std::vector<std::uint64_t>& symbols, const std::vector<std::uint64_t>& before,
                        int choice) {
    ByteWriter out;
    write_symbols(out, symbols, before, 8);
    EXPECT_EQ(std::to_integer<int>(out.bytes()[0]), choice);
    ByteReader in(out.bytes());
    EXPECT_EQ(*read_symbols(in, symbols.size(), before, 8), symbols);
    EXPECT_TRUE(in.finish());
  };
  check(noise, {}, 0);
  check(ramp, noise, kPredictVertex);
  check(like_noise, noise, kPredictComponent);
  check(noise_and_ramp, noise, kPredictVertex | kPredictComponent);
}

TEST(Symbols, ATTR3RejectsUnknownPredictionsAndWideSymbols) {
  const auto read = [](std::vector<int> values, unsigned width, std::vector<std::uint64_t> before) {
    std::vector<std::byte> bytes;
    for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
    ByteReader in(bytes);
    return read_symbols(in, 1, before, width);
  };
  EXPECT_STREQ(read({4, 1, 0}, 8, {1}).error().rule, "ATTR-3");
  EXPECT_STREQ(read({2, 1, 0}, 8, {}).error().rule, "ATTR-3");
  EXPECT_STREQ(read({0, 1, 32}, 5, {}).error().rule, "ATTR-3");
  EXPECT_STREQ(read({1, 1, 32}, 5, {}).error().rule, "ATTR-3");
  EXPECT_TRUE(read({1, 1, 31}, 5, {}));
  EXPECT_EQ(read({0, 2, 1}, 16, {}).error().code, ErrorCode::kTruncated);
}

TEST(Attribute, ATTR5NormalsAreQuantisedAndZeroSurvives) {
  std::vector<float> normals = unit_vectors(1000);
  normals.insert(normals.begin() + 30, {0, 0, 0});
  const Attribute a = make(AttributeKind::kNormal, ComponentType::kF32, 3, normals);
  const auto back = numbers<float>(decoded(a));
  ASSERT_EQ(back.size(), normals.size());
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    if (i == 30) {
      EXPECT_EQ(back[i], 0);
      EXPECT_EQ(back[i + 2], 0);
    } else {
      EXPECT_LT(angle(&normals[i], {back[i], back[i + 1], back[i + 2]}), 0.5 * kDegree);
    }
  }
  EXPECT_GT(coded(a).descriptor.error, 0.25F);  // degrees, of 0.5 asked for
  EXPECT_LE(coded(a).descriptor.error, 0.5F);
  EXPECT_LT(coded(a).plain.size(), 4 * 1001 + 40);
}

TEST(Attribute, ATTR4NormalsThatAreNoDirectionsAreKept) {
  std::vector<float> normals = unit_vectors(50);
  normals[7] *= 3;
  expect_exact(make(AttributeKind::kNormal, ComponentType::kF32, 3, normals));
  normals = unit_vectors(50);
  normals[149] = std::numeric_limits<float>::quiet_NaN();
  expect_exact(make(AttributeKind::kNormal, ComponentType::kF32, 3, normals));
  expect_exact(make(AttributeKind::kNormal, ComponentType::kI8, 3, std::vector<std::int8_t>{0, 0, 127}));
}

TEST(Attribute, ATTR6ColorsOfEightBitsAreExact) {
  Random random;
  std::vector<std::uint8_t> colors;
  for (int i = 0; i < 4000; ++i) colors.push_back(static_cast<std::uint8_t>(random.next()));
  Attribute a = make(AttributeKind::kColor, ComponentType::kU8, 4, colors);
  a.normalized = true;
  expect_exact(a);
  const auto back = numbers<std::uint8_t>(decoded(a, {.color_error = 4}));
  for (std::size_t i = 0; i < colors.size(); ++i) EXPECT_LE(std::abs(back[i] - colors[i]), 4);
  colors.resize(3999);
  expect_exact(make(AttributeKind::kColor, ComponentType::kU8, 3, colors));
}

TEST(Attribute, ATTR6WideAndFloatColorsKeepTheirType) {
  const std::vector<std::uint16_t> wide{0, 65535, 257, 30000, 40000, 1};
  const Attribute a = make(AttributeKind::kColor, ComponentType::kU16, 3, wide);
  expect_exact(a);
  const AttributeQuality half_a_level{.color_error = 0.51};
  const auto back = numbers<std::uint16_t>(decoded(a, half_a_level));
  for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_LE(std::abs(back[i] - wide[i]), 131);

  const std::vector<float> shares{0, 1, 0.5F, 0.25F, 0.126F, 0.999F};
  const Attribute b = make(AttributeKind::kColor, ComponentType::kF32, 3, shares);
  expect_exact(b);
  const auto floats = numbers<float>(decoded(b, half_a_level));
  for (std::size_t i = 0; i < shares.size(); ++i) EXPECT_NEAR(floats[i], shares[i], 0.51 / 255);
  EXPECT_EQ(floats[0], 0);
  EXPECT_EQ(floats[1], 1);
}

TEST(Attribute, ATTR4ColorsBeyondTheirRangeOrShapeAreKept) {
  expect_exact(make(AttributeKind::kColor, ComponentType::kF32, 3, std::vector<float>{0, 1.5F, -0.25F}));
  expect_exact(make(AttributeKind::kColor, ComponentType::kF64, 3, std::vector<double>{0, 0.3, 1}));
  expect_exact(make(AttributeKind::kColor, ComponentType::kF32, 3,
                    std::vector<float>{0, std::numeric_limits<float>::infinity(), 1}));
}

TEST(Attribute, ATTR7UvsAreQuantisedOverTheirRange) {
  Random random;
  std::vector<float> uvs;
  for (int i = 0; i < 500; ++i) {
    uvs.push_back(static_cast<float>(3 + 2 * random.symmetric()));
    uvs.push_back(-0.5F);
  }
  const auto back = numbers<float>(decoded(make(AttributeKind::kUv, ComponentType::kF32, 2, uvs)));
  for (std::size_t i = 0; i < uvs.size(); i += 2) {
    EXPECT_NEAR(back[i], uvs[i], 1.0 / 4096);
    EXPECT_EQ(back[i + 1], -0.5F);
  }
  uvs[11] = std::numeric_limits<float>::quiet_NaN();
  expect_exact(make(AttributeKind::kUv, ComponentType::kF32, 2, uvs));
}

TEST(Attribute, ATTR1ErrorsStayFiniteHoweverLargeTheBound) {
  const float most = std::numeric_limits<float>::max();
  const Attribute uvs = make(AttributeKind::kUv, ComponentType::kF32, 2,
                             std::vector<float>{most, most, -most, -most, 0, most / 2, -most / 3, 1});
  const CodedAttribute written = coded(uvs, {.uv_error = 1e300});
  EXPECT_TRUE(std::isfinite(written.descriptor.error)) << written.descriptor.error;
}

TEST(Attribute, ATTR4GenericValuesOfEveryTypeKeepTheirBits) {
  Random random;
  for (int type = 0; type <= static_cast<int>(ComponentType::kF64); ++type) {
    for (const int components : {1, 5, 16}) {
      std::vector<std::uint32_t> words;
      for (int i = 0; i < 2 * 40 * components; ++i) words.push_back(random.next());
      Attribute a = make(AttributeKind::kGeneric, static_cast<ComponentType>(type), components, words);
      a.name = std::string(255, 'n');
      expect_exact(a);
    }
  }
  expect_exact(make(AttributeKind::kGeneric, ComponentType::kF32, 1,
                    std::vector<float>{std::bit_cast<float>(0x7fc12345U), -0.0F, 1e-45F}));
  Attribute empty = make(AttributeKind::kGeneric, ComponentType::kF64, 3, std::vector<double>{});
  empty.name.clear();
  expect_exact(empty);
}

TEST(Attribute, ATTR1FollowsTheCodingOrderAndDropsUnusedRows) {
  const Attribute a =
      make(AttributeKind::kGeneric, ComponentType::kU16, 2, std::vector<std::uint16_t>{1, 2, 3, 4, 5, 6});
  const std::vector<std::uint32_t> order{2, 0};
  const auto written = test::write_plain(a, order);
  ASSERT_TRUE(written);
  const auto back = test::read_plain(written->plain, written->descriptor, 2, 8);
  ASSERT_TRUE(back);
  EXPECT_EQ(numbers<std::uint16_t>(*back), (std::vector<std::uint16_t>{5, 6, 1, 2}));
}

TEST(Attribute, WriterRejectsSizesThatDisagree) {
  Attribute a = make(AttributeKind::kGeneric, ComponentType::kU16, 2, std::vector<std::uint16_t>{1, 2, 3, 4});
  EXPECT_EQ(test::write_plain(a, identity(3)).error().code, ErrorCode::kInvalidMesh);
  a.values.pop_back();
  EXPECT_EQ(test::write_plain(a, identity(1)).error().code, ErrorCode::kInvalidMesh);
  a.values.push_back(std::byte{0});
  a.components = 17;
  EXPECT_EQ(test::write_plain(a, {}).error().code, ErrorCode::kInvalidMesh);
  a.components = 0;
  EXPECT_EQ(test::write_plain(a, {}).error().code, ErrorCode::kInvalidMesh);
  a.components = 1;
  a.name = std::string(256, 'n');
  EXPECT_EQ(test::write_plain(a, {}).error().code, ErrorCode::kInvalidMesh);
}

TEST(Attribute, ATTR8RefusesMoreThanTheLimit) {
  const Attribute a =
      make(AttributeKind::kColor, ComponentType::kU8, 3, std::vector<std::uint8_t>(30, std::uint8_t{7}));
  const auto [payload, compact, descriptor, back] = coded(a);
  EXPECT_TRUE(test::read_plain(payload, descriptor, 10, 30));
  const auto refused = test::read_plain(payload, descriptor, 10, 29);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kLimitExceeded);
  EXPECT_FALSE(test::read_plain(payload, descriptor, 0xffffffffU, 1 << 20));
}

std::vector<Attribute> one_of_each_coding() {
  return {make(AttributeKind::kGeneric, ComponentType::kF64, 2, std::vector<double>{1, 2.5, -3, 1e300}),
          make(AttributeKind::kNormal, ComponentType::kF32, 3, unit_vectors(5)),
          make(AttributeKind::kColor, ComponentType::kU8, 3, std::vector<std::uint8_t>{1, 2, 3, 40, 5, 60}),
          make(AttributeKind::kUv, ComponentType::kF32, 2, std::vector<float>{0, 1, 0.3F, 0.2F})};
}

TEST(Attribute, CON3EveryPrefixAndEveryExtraByteIsRefused) {
  for (const Attribute& a : one_of_each_coding()) {
    auto [payload, compact, descriptor, back] = coded(a);
    for (std::size_t size = 0; size < payload.size(); ++size) {
      const std::vector<std::byte> prefix(payload.begin(),
                                          payload.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_FALSE(test::read_plain(prefix, descriptor, rows(a)));
    }
    payload.push_back(std::byte{0});
    EXPECT_STREQ(test::read_plain(payload, descriptor, rows(a)).error().rule, "CON-3");
  }
}

TEST(Attribute, AnyFlippedByteEndsInAnErrorOrAWholeAttribute) {
  for (const Attribute& a : one_of_each_coding()) {
    const auto [payload, compact, descriptor, whole] = coded(a);
    for (std::size_t i = 0; i < payload.size(); ++i) {
      for (unsigned value = 0; value < 256; ++value) {
        auto bad = payload;
        bad[i] = static_cast<std::byte>(value);
        const auto back = test::read_plain(bad, descriptor, rows(a), 1 << 20);
        EXPECT_TRUE(!back || rows(*back) == rows(a));
      }
    }
  }
}

struct BrokenByte {
  const char* rule;
  std::size_t attribute;  ///< index into one_of_each_coding()
  std::size_t offset;
  int value;
};

TEST(Attribute, ATTR2ATTR7EachRuleIsNamed) {
  // The coding, then its fields.
  const BrokenByte cases[] = {
      {"ATTR-2", 0, 0, 1},  {"ATTR-2", 0, 0, 200}, {"ATTR-2", 1, 0, 2},    {"ATTR-2", 1, 1, 1},
      {"ATTR-2", 1, 1, 16}, {"ATTR-2", 3, 1, 25},  {"ATTR-7", 3, 5, 0x7f}, {"ATTR-7", 3, 5, 0x41},
  };
  const auto attributes = one_of_each_coding();
  for (const BrokenByte& broken : cases) {
    auto [payload, compact, descriptor, whole] = coded(attributes[broken.attribute]);
    payload[broken.offset] = static_cast<std::byte>(broken.value);
    if (broken.value == 0x7f) payload[broken.offset - 1] = std::byte{0x80};  // infinity
    const auto back = test::read_plain(payload, descriptor, rows(attributes[broken.attribute]));
    ASSERT_FALSE(back) << broken.rule << ' ' << broken.offset;
    EXPECT_STREQ(back.error().rule, broken.rule) << broken.offset << ' ' << broken.value;
  }
}

TEST(Attribute, ATTR5RejectsHalfAZeroCode) {
  ByteWriter out;
  for (const int byte : {1, 2}) out.write(static_cast<std::uint8_t>(byte));              // octahedral, 2 bits
  for (const int byte : {0, 1, 3, 0, 1, 2}) out.write(static_cast<std::uint8_t>(byte));  // u = 3, v = 2
  const AttributeDescriptor normals{.kind = AttributeKind::kNormal, .components = 3};
  EXPECT_STREQ(test::read_plain(out.bytes(), normals, 1).error().rule, "ATTR-5");
}

TEST(Attribute, TheSameInputGivesTheSameBytes) {
  for (const Attribute& a : one_of_each_coding()) EXPECT_EQ(coded(a).plain, coded(a).plain);
}

}  // namespace
}  // namespace deltamesh
