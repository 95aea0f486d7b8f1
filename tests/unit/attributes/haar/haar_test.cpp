// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours by the transform: readers get what the writer says, at the error that was asked for, from any bytes
// nothing worse than an error.
#include "attributes/haar/haar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/colors/fields.h"
#include "attributes/error.h"
#include "attributes/haar/color_axes.h"
#include "attributes/haar/models.h"
#include "attributes/haar/picture.h"
#include "attributes/haar/steps.h"
#include "attributes/haar/surroundings.h"
#include "attributes/haar/writer.h"
#include "haar/meshes.h"
#include "support/attribute_coding.h"
#include "support/guarded.h"

namespace deltamesh::haar_test {
namespace {

using test::Bytes;

constexpr unsigned kBytesPerColor = 3;

Attribute attribute_of(const Colored& mesh, ComponentType type, std::uint8_t components) {
  const std::size_t size = component_size(type);
  Attribute a{.kind = AttributeKind::kColor, .type = type, .components = components, .normalized = true};
  a.values.resize(mesh.count * size * components);
  for (std::uint32_t v = 0; v < mesh.count; ++v)
    for (std::size_t c = 0; c < components; ++c) {
      const std::int32_t level =
          c < kBytesPerColor ? mesh.colors[kBytesPerColor * v + c] : static_cast<std::int32_t>(v / 7 % 200);
      store_component(&a.values[(components * v + c) * size], size, color_of_level(type, 8, level));
    }
  return a;
}

CodedValues<std::byte> write_colors(const Colored& mesh, const std::vector<HaarLevel>& levels,
                                    std::uint32_t step) {
  const Attribute source = attribute_of(mesh, ComponentType::kU8, kBytesPerColor);
  const auto order = test::identity(mesh.count);
  auto picture = picture_of_colors(source.type, AttributeRows(test::view(source), order));
  return HaarWriter(*std::move(picture), levels).code(step, source.type);
}

Result<Bytes> read_colors(std::span<const std::byte> bytes, const Colored& mesh) {
  const Attribute shape{
      .kind = AttributeKind::kColor, .type = ComponentType::kU8, .components = kBytesPerColor};
  return read_haar_values(bytes, shape, mesh.surface());
}

/// The coded colours, which a reader gets back.
CodedValues<std::byte> coded(const Colored& mesh, const std::vector<HaarLevel>& levels, std::uint32_t step) {
  auto coded = write_colors(mesh, levels, step);
  EXPECT_EQ(coded.values.size(), mesh.colors.size());
  const auto read = read_colors(coded.bytes, mesh);
  if (!read) {
    ADD_FAILURE() << read.error().message;
  } else {
    EXPECT_EQ(*read, coded.values);
  }
  return coded;
}

double rms(const Colored& mesh, const Bytes& values) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double error = mesh.colors[i] - std::to_integer<int>(values[i]);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::vector<Colored> meshes(bool grey) {
  std::vector<Colored> meshes;
  for (const test::GraphMesh& mesh :
       {test::sheet(1, 1), test::sheet(2, 2), test::sheet(40, 30), test::fan(300), test::fragments()})
    meshes.push_back(colored(mesh, grey));
  return meshes;
}

TEST(HaarColors, HAAR7ReadersGetWhatTheWriterSays) {
  for (const bool grey : {false, true}) {
    for (Colored& mesh : meshes(grey)) {
      for (int positions = 0; positions < 2; ++positions) {
        const auto levels = make_haar_levels(mesh.surface());
        for (const std::uint32_t step : {1U, 64U, 700U, 9000U, kMostHaarStep}) coded(mesh, levels, step);
        mesh.positions.clear();
      }
    }
  }
}

TEST(HaarColors, HAAR13SmallStepsAreNearlyExact) {
  for (const Colored& mesh : meshes(false)) {
    const auto levels = make_haar_levels(mesh.surface());
    EXPECT_LT(rms(mesh, coded(mesh, levels, 16).values), 0.6);
  }
}

TEST(HaarColors, HAAR7OneVertexAndNone) {
  Colored one = points({1, 2, 3});
  one.colors = {200, 10, 60};
  const auto value = coded(one, make_haar_levels(one.surface()), 640);
  EXPECT_EQ(value.values, (Bytes{std::byte{200}, std::byte{10}, std::byte{60}}));
  const Colored none = points({});
  EXPECT_EQ(coded(none, make_haar_levels(none.surface()), 640).bytes.size(), 3U);
}

TEST(HaarColors, HAAR6RejectsOtherAxesAndNoStep) {
  const Colored mesh = colored(test::sheet(4, 4));
  const auto levels = make_haar_levels(mesh.surface());
  const Bytes bytes = coded(mesh, levels, 640).bytes;
  const auto rule_of = [&](std::size_t at, std::vector<std::uint8_t> values) {
    Bytes changed = bytes;
    for (std::size_t i = 0; i < values.size(); ++i) changed[at + i] = static_cast<std::byte>(values[i]);
    const auto read = read_colors(changed, mesh);
    return read ? std::string() : std::string(read.error().rule);
  };
  for (const std::uint8_t axes : std::to_array<std::uint8_t>({0, 2, 4, 255}))
    EXPECT_EQ(rule_of(0, {axes}), "HAAR-6");
  EXPECT_EQ(rule_of(1, {0, 0}), "HAAR-6");
}

TEST(HaarColors, HAAR6BytesThatAreCutOrChangedDoNoHarm) {
  for (const bool grey : {false, true}) {
    const Colored mesh = colored(test::sheet(7, 6), grey);
    const Bytes bytes = coded(mesh, make_haar_levels(mesh.surface()), 300).bytes;
    test::expect_guarded(
        bytes, [&](const Bytes& b) { return read_colors(b, mesh).has_value(); }, "colours");
  }
}

TEST(HaarColors, HAAR9WhateverIsCodedSumsFit) {
  // Random words: the wildest numbers, at the largest and smallest steps.
  const Colored mesh = colored(test::fan(400));
  test::RandomBits random(8);
  for (int trial = 0; trial < 60; ++trial) {
    Bytes bytes = {std::byte{3}, static_cast<std::byte>(random()),
                   static_cast<std::byte>(trial % 3 == 0 ? 0xff : random())};
    bytes.push_back(std::byte{0x88});
    for (int i = 0; i < 4000; ++i) bytes.push_back(static_cast<std::byte>(random()));
    bytes[11] = bytes[19] = std::byte{0x7f};
    const auto read = read_colors(bytes, mesh);
    EXPECT_FALSE(read.has_value());
  }
}

TEST(HaarColors, HAAR8SharesFallWithTheDistance) {
  EXPECT_EQ(kHaarShares[0], 193U);
  EXPECT_EQ(kHaarShares[kHaarShareReach], 41U);
  for (std::size_t i = 1; i < kHaarShares.size(); ++i) EXPECT_LE(kHaarShares[i], kHaarShares[i - 1]);
  EXPECT_EQ(kHaarShares.back(), 0U);
}

TEST(HaarColors, HAAR9AWayUpIsExpectedToGoOn) {
  // 0 - 1 = 2 - 3 in a row, 1 and 2 being children: values 0 and 640 at the ends.
  Colored mesh = points({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0});
  mesh.triangles = {0, 1, 1, 1, 2, 2, 2, 3, 3};
  const HaarLevel level = make_haar_levels(mesh.surface())[0];
  std::vector<HaarRecord> records(4);
  for (std::size_t i = 0; i < 4; ++i) records[i].node = level.nodes[i];
  const HaarRecord parent{.lanes = EightShorts{320, 0, 0, 0, 48}, .node = {}};
  records[0].lanes = EightShorts{0, 0, 0, 0, 32};
  records[3].lanes = EightShorts{640, 0, 0, 0, 32};
  const auto around = HaarNeighborhood(level, records.data()).look<3>({1, 2, 32768}, parent);
  // share 41 of 41 + 38: 2 * 320 * 41 / 79 * 182 / 256
  EXPECT_NEAR(around.difference[0], -236, 2);
  EXPECT_NEAR(around.spread[0], 320, 1);
  EXPECT_NEAR(around.sizes[0], 32, 1);
  EXPECT_EQ(around.difference[1], 0);
}

TEST(HaarColors, HAAR10StepsByTheWeights) {
  const HaarSteps steps(640);
  EXPECT_EQ(steps.of(1, 1).size, 905U);  // 640 sqrt 2
  EXPECT_EQ(steps.of(1, 1).per_value, (1U << 20) / 905);
  EXPECT_EQ(steps.of(2, 2).size, 640U);
  EXPECT_EQ(steps.of(100, 1).size, 643U);
  EXPECT_EQ(steps.of(1U << 30, 1U << 30).size, 1U);
}

TEST(HaarColors, HAAR11ContextsOfSizes) {
  EXPECT_EQ(haar_size_class(0), 0U);
  EXPECT_EQ(haar_size_class(16), 4U * 4 - 4 + 0);
  const HaarContext quiet(0, 0, 0, 2, 1);
  EXPECT_EQ(quiet.shift, 0U);
  EXPECT_EQ(quiet.models[0], 2U * 3 + 1);
  EXPECT_EQ(quiet.models[1], 1U);
  const HaarContext loud(64, 1U << 20, 1U << 20, 0, 0);
  EXPECT_EQ(loud.shift, 1U);
  EXPECT_EQ(loud.scale, haar_size_class(32) + 5);
  EXPECT_EQ(loud.models[1], (11U * 12 + 11) * 3);
  const HaarContext loudest(0xffffff, 0, 0, 0, 2);
  EXPECT_LT(loudest.scale, kHaarScaleClasses);
}

TEST(HaarColors, HAAR12FreshModelsAreNarrowWhereLittleIsExpected) {
  HaarModels models;
  const auto share_of_zero = [&](std::size_t scale) { return models.symbols[0][scale * 9].share(7); };
  EXPECT_GT(share_of_zero(0), kLaneOne * 8 / 10);
  EXPECT_LT(share_of_zero(20), kLaneOne / 8);
  EXPECT_EQ(models.symbols[0][9].share(6), models.symbols[0][9].share(8));
}

TEST(HaarColors, HAAR14ColoursOfValues) {
  for (const Rgb color : {Rgb{0, 0, 0}, Rgb{255, 255, 255}, Rgb{255, 0, 0}, Rgb{0, 255, 0}, Rgb{0, 0, 255},
                          Rgb{12, 200, 99}, Rgb{254, 1, 255}})
    EXPECT_EQ(rgb_of(haar_value_of(color), 3), color);
  EXPECT_EQ(rgb_of({-5000, 0, 0}, 1), (Rgb{0, 0, 0}));
  EXPECT_EQ(rgb_of({24000, 8000, -8000}, 3), (Rgb{200, 255, 255}));
  EXPECT_EQ(rgb_of({64 * 7 + 31, 9, 9}, 1), (Rgb{7, 7, 7}));
}

TEST(HaarColors, GreyCostsLess) {
  Colored grey = colored(test::sheet(60, 60), true);
  const auto levels = make_haar_levels(grey.surface());
  const auto of_grey = coded(grey, levels, 640);
  for (std::size_t i = 0; i < of_grey.values.size(); i += 3)
    EXPECT_EQ(of_grey.values[i], of_grey.values[i + 1]);
  const Colored bright = colored(test::sheet(60, 60));
  EXPECT_LT(3 * of_grey.bytes.size(), 2 * coded(bright, levels, 640).bytes.size());
}

TEST(HaarColors, SmoothColoursTakeFewBytes) {
  Colored mesh = colored(test::sheet(100, 100));
  for (std::uint32_t v = 0; v < mesh.count; ++v)
    for (std::uint32_t c = 0; c < 3; ++c)
      mesh.colors[3 * v + c] = static_cast<std::uint8_t>(v % 100 + v / 100 + c * 20);
  const auto smooth = coded(mesh, make_haar_levels(mesh.surface()), 640);
  EXPECT_LT(smooth.bytes.size(), mesh.count / 8);
  EXPECT_LT(rms(mesh, smooth.values), 3);
}

/// From 24 to 50 dB within 1 %; where a mean error is less than a level of 8 bits, within 1.5 %.
TEST(HaarColors, HAAR10AnyMeanErrorIsMetByTheStep) {
  for (const std::uint64_t seed : {1, 2}) {
    const Colored mesh = rooms(seed == 1 ? 20000 : 6000, seed);
    const Attribute source = attribute_of(mesh, ComponentType::kU8, kBytesPerColor);
    const auto order = test::identity(mesh.count);
    const AttributeRows rows(test::view(source), order);
    std::size_t before = mesh.colors.size();
    for (const double decibels : {50.0, 44.0, 38.0, 31.0, 24.0}) {
      const double wanted = 255 / std::pow(10, decibels / 20);
      const auto best = write_haar_values(ComponentType::kU8, rows, wanted, mesh.surface());
      ASSERT_TRUE(best.has_value()) << decibels;
      const double reached = rms(mesh, best->values);
      EXPECT_LE(reached, wanted) << decibels;
      EXPECT_GE(reached, (wanted < 1 ? 0.985 : 0.99) * wanted) << decibels;
      EXPECT_LT(best->bytes.size(), before) << decibels;
      before = best->bytes.size();
      const auto read = read_colors(best->bytes, mesh);
      ASSERT_TRUE(read.has_value());
      EXPECT_EQ(*read, best->values);
    }
  }
}

TEST(HaarColors, HAAR6OtherTypesAndAlpha) {
  const Colored mesh = colored(test::sheet(30, 40));
  const auto order = test::identity(mesh.count);
  for (const ComponentType type : {ComponentType::kU8, ComponentType::kU16, ComponentType::kF32}) {
    for (const std::uint8_t components : std::to_array<std::uint8_t>({3, 4})) {
      Attribute source = attribute_of(mesh, type, components);
      for (const bool constant : {false, true}) {
        const std::size_t row = source.values.size() / mesh.count;
        const std::size_t alpha = component_size(type) * 3;
        for (std::size_t v = 1; v < mesh.count && constant; ++v)
          std::copy(source.values.data() + alpha, source.values.data() + row,
                    source.values.data() + v * row + alpha);
        const AttributeSurface surface = mesh.surface();
        const AttributeView view = test::view(source);
        const AttributeRows rows(view, order);
        const auto coded = write_haar_values(type, rows, 3, surface);
        ASSERT_TRUE(coded);
        EXPECT_NEAR(color_rms(type, rows, coded->values), 3, 0.031);
        const Attribute shape{.kind = source.kind, .type = type, .components = components};
        const auto read = read_haar_values(coded->bytes, shape, surface);
        ASSERT_TRUE(read) << describe(read.error());
        EXPECT_EQ(*read, coded->values);
        for (std::size_t v = 0; v < mesh.count && constant; ++v)
          EXPECT_TRUE(std::equal(source.values.data() + alpha, source.values.data() + row,
                                 read->data() + v * row + alpha));
      }
    }
  }
}

TEST(HaarColors, HAAR6FloatsThatAreNoColoursAreExceptions) {
  const Colored mesh = colored(test::sheet(30, 40));
  Attribute source = attribute_of(mesh, ComponentType::kF32, kBytesPerColor);
  store_component(source.values.data(), sizeof(float), std::bit_cast<std::uint32_t>(2.5F));
  const AttributeQuality quality{.color_rms = 3};
  const AttributeSurface surface = mesh.surface();
  const auto coded =
      write_attribute(test::view(source), test::identity(mesh.count), {.quality = quality}, surface, {});
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->payload[0], std::byte{128 + 11});
  EXPECT_GT(coded->descriptor.rms, 2.9);
  const auto read = read_attribute(Payload::compact(coded->payload), coded->descriptor, surface, {}, 1 << 20);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_TRUE(
      std::equal(source.values.begin(), source.values.begin() + 3 * sizeof(float), read->values.begin()));
}

TEST(HaarColors, MeanErrorsThatLevelsCannotKeepAreExact) {
  const Colored mesh = colored(test::sheet(30, 40));
  const Attribute source = attribute_of(mesh, ComponentType::kU8, kBytesPerColor);
  const AttributeQuality quality{.color_rms = 1e-6};
  const auto coded = write_attribute(test::view(source), test::identity(mesh.count), {.quality = quality},
                                     mesh.surface(), {});
  ASSERT_TRUE(coded);
  EXPECT_EQ(coded->descriptor.error, 0);
  EXPECT_EQ(coded->decoded.values, source.values);
}

}  // namespace
}  // namespace deltamesh::haar_test
