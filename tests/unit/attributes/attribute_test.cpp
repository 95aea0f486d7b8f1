// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/attribute.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "attributes/plain/plain.h"
#include "base/byte_writer.h"
#include "entropy/arrays.h"
#include "support/attribute_coding.h"

namespace deltamesh {
namespace {

using test::identity;
using test::numbers;
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
  return test::attribute_of(kind, type, components, "thing", numbers);
}

CodedAttribute coded(const Attribute& a, const AttributeQuality& quality = {}) {
  auto written = test::write_plain(a, identity(rows(a)), quality);
  EXPECT_TRUE(written);
  return *written;
}

/// What a reader gets, which is what the writer said.
Attribute decoded(const Attribute& a, const AttributeQuality& quality = {}) {
  const CodedAttribute written = coded(a, quality);
  auto back = test::read_plain(written.payload, written.descriptor, rows(a));
  EXPECT_TRUE(back) << (back ? "" : describe(back.error()));
  if (!back) return {};
  EXPECT_EQ(back->values, written.decoded.values);
  return *back;
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

TEST(Attribute, PLN7NormalsAreQuantisedAndZeroSurvives) {
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
      EXPECT_NEAR(length({back[i], back[i + 1], back[i + 2]}), 1, 1e-6);
    }
  }
  EXPECT_GT(coded(a).descriptor.error, 0.25F);  // degrees, of 0.5 asked for
  EXPECT_LE(coded(a).descriptor.error, 0.5F);
  EXPECT_LT(coded(a).payload.size(), 6 * 1001 + 100);
}

TEST(Attribute, PLN6NormalsThatAreNoDirectionsAreKept) {
  std::vector<float> normals = unit_vectors(50);
  normals[7] *= 3;
  expect_exact(make(AttributeKind::kNormal, ComponentType::kF32, 3, normals));
  normals = unit_vectors(50);
  normals[149] = std::numeric_limits<float>::quiet_NaN();
  expect_exact(make(AttributeKind::kNormal, ComponentType::kF32, 3, normals));
  expect_exact(make(AttributeKind::kNormal, ComponentType::kI8, 3, std::vector<std::int8_t>{0, 0, 127}));
}

TEST(Attribute, PLN7TangentsKeepTheirSign) {
  std::vector<float> tangents;
  const std::vector<float> directions = unit_vectors(100);
  for (std::size_t i = 0; i < directions.size(); i += 3)
    tangents.insert(tangents.end(),
                    {directions[i], directions[i + 1], directions[i + 2], i % 2 == 0 ? 1.0F : -1.0F});
  const Attribute a = make(AttributeKind::kTangent, ComponentType::kF32, 4, tangents);
  const auto back = numbers<float>(decoded(a));
  for (std::size_t i = 0; i < back.size(); i += 4) {
    EXPECT_LT(angle(&tangents[i], {back[i], back[i + 1], back[i + 2]}), 0.5 * kDegree);
    EXPECT_EQ(back[i + 3], tangents[i + 3]);
  }
  EXPECT_LT(coded(a).payload.size(), 100 * 6 + 100 * 4 + 100U);
}

TEST(Attribute, PLN6GenericValuesKeepTheirBound) {
  Random random;
  std::vector<float> values;
  for (int i = 0; i < 300; ++i) values.push_back(static_cast<float>(1000 * random.symmetric()));
  values[7] = 0;
  const Attribute a = make(AttributeKind::kGeneric, ComponentType::kF32, 1, values);
  const AttributeQuality quality{.named = {{.name = "thing", .error = 0.5}}};
  const auto back = numbers<float>(decoded(a, quality));
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(back[i], values[i], 0.5);
  EXPECT_EQ(back[7], 0);
  EXPECT_LT(coded(a, quality).payload.size(), 300 * 2 + 20U);
  const Attribute b =
      make(AttributeKind::kGeneric, ComponentType::kI16, 1, std::vector<std::int16_t>{-32768, 32767, 5});
  const auto whole = numbers<std::int16_t>(decoded(b, {.named = {{.name = "thing", .error = 3}}}));
  EXPECT_NEAR(whole[0], -32768, 3);
  EXPECT_NEAR(whole[1], 32767, 3);
}

TEST(Attribute, PLN6ColorsOfEightBitsAreExact) {
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

TEST(Attribute, PLN6WideAndFloatColorsKeepTheirType) {
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
}

TEST(Attribute, PLN6ColorsThatAreNotFiniteAreKept) {
  expect_exact(make(AttributeKind::kColor, ComponentType::kF32, 3, std::vector<float>{0, 1.5F, -0.25F}));
  const float infinity = std::numeric_limits<float>::infinity();
  const Attribute a = make(AttributeKind::kColor, ComponentType::kF32, 3, std::vector<float>{0, infinity, 1});
  EXPECT_EQ(decoded(a, {.color_error = 4}).values, a.values);
}

TEST(Attribute, PLN6UvsAreQuantisedOverTheirRange) {
  Random random;
  std::vector<float> uvs;
  for (int i = 0; i < 500; ++i) {
    uvs.push_back(static_cast<float>(3 + 2 * random.symmetric()));
    uvs.push_back(-0.5F);
  }
  const auto back = numbers<float>(decoded(make(AttributeKind::kUv, ComponentType::kF32, 2, uvs)));
  for (std::size_t i = 0; i < uvs.size(); i += 2) {
    EXPECT_NEAR(back[i], uvs[i], 1.0 / 4096);
    EXPECT_NEAR(back[i + 1], -0.5F, 1.0 / 4096);
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

TEST(Attribute, PLN6GenericValuesOfEveryTypeKeepTheirBits) {
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
  const auto back = test::read_plain(written->payload, written->descriptor, 2, 8);
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
  const auto [payload, is_compact, plain, descriptor, back] = coded(a);
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
    auto [payload, is_compact, plain, descriptor, back] = coded(a);
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
    const auto [payload, is_compact, plain, descriptor, whole] = coded(a);
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

/// A payload of one value of each component: the coding, then step, first number and code of each.
struct Column {
  double step = 0;
  std::int64_t first = 0;
  std::uint64_t number = 0;
};
std::vector<std::byte> payload_of(int coding, const std::vector<Column>& columns, unsigned width = 32) {
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(coding));
  for (const Column& column : columns) {
    out.write(column.step);
    if (column.step != 0) out.write(column.first);
    write_differences(out, std::array{column.number}, column.step == 0 ? width : 32);
  }
  return out.take();
}

std::string rule_of(const std::vector<std::byte>& payload, AttributeKind kind, ComponentType type,
                    std::uint8_t components) {
  const auto read = test::read_plain(payload, {.kind = kind, .type = type, .components = components}, 1);
  return read ? "none" : read.error().rule;
}

TEST(Attribute, PLN6PLN7EachRuleIsNamed) {
  const auto generic = [](const Column& column) {
    return rule_of(payload_of(0, {column}), AttributeKind::kGeneric, ComponentType::kF32, 1);
  };
  const std::int64_t most = std::int64_t{1} << 52;
  EXPECT_EQ(generic({.step = 0.5, .first = -most, .number = 0xffffffff}), "none");
  EXPECT_EQ(generic({.step = -0.5}), "PLN-6");
  EXPECT_EQ(generic({.step = std::numeric_limits<double>::infinity()}), "PLN-6");
  EXPECT_EQ(generic({.step = std::numeric_limits<double>::quiet_NaN()}), "PLN-6");
  EXPECT_EQ(generic({.step = 0.5, .first = most + 1}), "PLN-6");
  EXPECT_EQ(generic({.step = 0.5, .first = -most - 1}), "PLN-6");
  const auto normal = [](int coding, double step, ComponentType type = ComponentType::kF32) {
    return rule_of(payload_of(coding, {{step}, {0.5}, {0.5}}), AttributeKind::kNormal, type, 3);
  };
  EXPECT_EQ(normal(1, 1), "none");
  EXPECT_EQ(normal(1, 1.5), "PLN-7");
  EXPECT_EQ(normal(1, 0), "PLN-7");
  EXPECT_EQ(normal(2, 1), "PLN-7");
  EXPECT_EQ(normal(1, 1, ComponentType::kF64), "PLN-7");
  EXPECT_EQ(rule_of(payload_of(1, {{0.5}, {0.5}}), AttributeKind::kUv, ComponentType::kF32, 2), "PLN-7");
}

TEST(Attribute, PLN6ValuesAreCutToTheirType) {
  const auto read = [](const Column& column, ComponentType type) {
    return *test::read_plain(payload_of(0, {column}),
                             {.kind = AttributeKind::kGeneric, .type = type, .components = 1}, 1);
  };
  EXPECT_EQ(numbers<std::uint8_t>(read({.step = 100, .number = 3}, ComponentType::kU8))[0], 255);
  EXPECT_EQ(numbers<std::int8_t>(read({.step = 0.5, .first = -3}, ComponentType::kI8))[0], -1);
  EXPECT_EQ(numbers<float>(read({.step = 1e300, .number = 3}, ComponentType::kF32))[0],
            std::numeric_limits<float>::max());
}

TEST(Attribute, TheSameInputGivesTheSameBytes) {
  for (const Attribute& a : one_of_each_coding()) EXPECT_EQ(coded(a).payload, coded(a).payload);
}

}  // namespace
}  // namespace deltamesh
