// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers that are no colours, one for each vertex, at a mean error.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/error.h"
#include "attributes/haar/haar.h"
#include "haar/meshes.h"
#include "support/attribute_coding.h"
#include "support/guarded.h"

namespace deltamesh::haar_test {
namespace {

using test::Bytes;

/// What a sensor saw: the luma of the rooms' colours, `scale` times, above `low`.
Attribute intensities(const Colored& mesh, ComponentType type, double low, double scale) {
  Attribute a{.kind = AttributeKind::kGeneric, .type = type, .components = 1, .name = "intensity"};
  a.values.resize(mesh.count * component_size(type));
  for (std::size_t v = 0; v < mesh.count; ++v) {
    const double number = low + scale * (mesh.colors[3 * v] + 2 * mesh.colors[3 * v + 1]) / 3.0;
    store_component(&a.values[v * component_size(type)], component_size(type),
                    type == ComponentType::kF32 ? std::bit_cast<std::uint32_t>(static_cast<float>(number))
                                                : static_cast<std::uint32_t>(number));
  }
  return a;
}

Result<CodedAttribute> coded_at(const Attribute& source, const Colored& mesh, double rms) {
  const AttributeQuality quality{.named = {{.name = source.name, .error = rms, .is_mean = true}}};
  return write_attribute(test::view(source), test::identity(mesh.count), {.quality = quality}, mesh.surface(),
                         {});
}

bool is_by_transform(const CodedAttribute& coded) {
  return (coded.payload[0] & std::byte{127}) == std::byte{11};
}

TEST(HaarNumbers, HAAR15AnyMeanErrorIsMetInTheUnitOfTheNumbers) {
  const Colored mesh = rooms(6000, 1);
  struct Case {
    ComponentType type;
    double low;
    double scale;
  };
  for (const Case& c : {Case{ComponentType::kU8, 0, 1}, Case{ComponentType::kU16, 300, 200},
                        Case{ComponentType::kF32, -40, 1e-3}, Case{ComponentType::kF32, 1e6, 1e3}}) {
    const Attribute source = intensities(mesh, c.type, c.low, c.scale);
    for (const double share : {1.0, 3.0, 10.0}) {
      const double wanted = share * c.scale;
      const auto coded = coded_at(source, mesh, wanted);
      ASSERT_TRUE(coded);
      EXPECT_TRUE(is_by_transform(*coded)) << wanted;
      EXPECT_LE(coded->descriptor.rms, 1.0001 * wanted);
      EXPECT_GE(coded->descriptor.rms, (share > 1 ? 0.985 : 0.95) * wanted);  // whole numbers of 8 bits
      const auto read =
          read_attribute(Payload::compact(coded->payload), coded->descriptor, mesh.surface(), {}, 1 << 20);
      ASSERT_TRUE(read) << describe(read.error());
      EXPECT_EQ(read->values, coded->decoded.values);
    }
  }
}

TEST(HaarNumbers, AMeanErrorTakesFewerBytesThanTheLargestErrorOfTheSameMean) {
  const Colored mesh = rooms(20000, 2);
  const Attribute source = intensities(mesh, ComponentType::kF32, 0, 1);
  const auto mean = coded_at(source, mesh, 3);
  const AttributeQuality largest{.named = {{source.name, 3 * std::sqrt(3.0)}}};
  const auto bounded = write_attribute(test::view(source), test::identity(mesh.count), {.quality = largest},
                                       mesh.surface(), {});
  ASSERT_TRUE(mean && bounded);
  EXPECT_LT(10 * mean->payload.size(), 9 * bounded->payload.size());
}

TEST(HaarNumbers, NumbersThatAreNotFiniteAreExceptions) {
  const Colored mesh = rooms(3000, 3);
  Attribute source = intensities(mesh, ComponentType::kF32, 0, 1);
  const float bad = std::numeric_limits<float>::quiet_NaN();
  store_component(&source.values[40], sizeof(float), std::bit_cast<std::uint32_t>(bad));
  const auto coded = coded_at(source, mesh, 3);
  ASSERT_TRUE(coded);
  EXPECT_TRUE(is_by_transform(*coded));
  EXPECT_GT(coded->descriptor.rms, 2.9);
  EXPECT_LE(coded->descriptor.rms, 3.0001);
  const auto read =
      read_attribute(Payload::compact(coded->payload), coded->descriptor, mesh.surface(), {}, 1 << 20);
  ASSERT_TRUE(read);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(bad), load_component(&read->values[40], sizeof(float)));
}

TEST(HaarNumbers, OtherShapesKeepTheMeanErrorAsALargestOne) {
  const Colored mesh = rooms(3000, 4);
  Attribute source = intensities(mesh, ComponentType::kF32, 0, 1);
  source.components = 3;
  source.values.resize(3 * source.values.size());
  const auto coded = coded_at(source, mesh, 2);
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->descriptor.rms, 0);
  EXPECT_LE(coded->descriptor.error, 2.0001);
  EXPECT_GT(coded->descriptor.error, 0);
}

/// One far value leaves the others too few levels; equal ones need none.
TEST(HaarNumbers, NumbersThatLevelsCannotHoldKeepTheirMeanErrorOtherwise) {
  const Colored mesh = rooms(3000, 5);
  Attribute source = intensities(mesh, ComponentType::kF32, 0, 1);
  store_component(&source.values[0], sizeof(float), std::bit_cast<std::uint32_t>(1e9F));
  const auto far = coded_at(source, mesh, 2);
  ASSERT_TRUE(far);
  EXPECT_LE(far->descriptor.rms, 2.0001);
  const Attribute equal = intensities(mesh, ComponentType::kF32, 7, 0);
  const auto same = coded_at(equal, mesh, 2);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->decoded.values.size(), equal.values.size());
  EXPECT_LE(same->descriptor.rms, 2.0001);
}

TEST(HaarNumbers, HAAR6RejectsNumbersWithoutAScale) {
  const Colored mesh = rooms(500, 6);
  const Attribute source = intensities(mesh, ComponentType::kF32, 0, 1);
  const auto order = test::identity(mesh.count);
  const auto coded =
      write_haar_values(source.type, AttributeRows(test::view(source), order), 3, mesh.surface());
  ASSERT_TRUE(coded);
  const auto rule_with = [&](std::size_t at, float number) {
    Bytes changed = coded->bytes;
    store_component(&changed[at], sizeof(float), std::bit_cast<std::uint32_t>(number));
    const auto read = read_haar_values(changed, source, mesh.surface());
    return read ? std::string() : std::string(read.error().rule);
  };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(rule_with(0, kInfinity), "HAAR-6");
  for (const float unit : {0.0F, -1.0F, kInfinity, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(rule_with(4, unit), "HAAR-6");
  test::expect_guarded(
      coded->bytes, [&](const Bytes& b) { return read_haar_values(b, source, mesh.surface()).has_value(); },
      "numbers");
}

}  // namespace
}  // namespace deltamesh::haar_test
