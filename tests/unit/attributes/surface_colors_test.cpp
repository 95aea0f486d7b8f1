// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of a surface: exact or within the bound, whatever their type, and nothing else gets through.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "attributes/colors/coder.h"
#include "attributes/colors/colors.h"
#include "attributes/colors/fields.h"
#include "entropy/coder/writer.h"
#include "support/graph_mesh.h"
#include "support/guarded.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using test::Bytes;
using test::expect_guarded;

/// A mesh, with places of its vertices or without.
struct Surface {
  explicit Surface(const test::GraphMesh& mesh, bool has_positions = true,
                   std::vector<std::uint32_t> copies_of = {})
      : triangles(mesh.triangles), geometric(std::move(copies_of)) {
    for (const Vec3& p : mesh.positions)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (has_positions) positions.push_back(static_cast<float>(p[axis]));
    count = static_cast<std::uint32_t>(mesh.positions.size());
  }
  AttributeSurface get() const { return {triangles, count, geometric, positions}; }

  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> geometric;
  std::vector<float> positions;
  std::uint32_t count = 0;
};

/// Smooth waves and noise, 0 to 1; every third vertex has the colour of the one before.
std::vector<double> waves(std::uint32_t rows, unsigned components, double noise = 0.02) {
  test::RandomBits random(5);
  std::vector<double> values;
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (unsigned c = 0; c < components; ++c) {
      const double wave = 0.5 + 0.4 * std::sin(0.13 * i + c);
      const double grain = noise * (static_cast<double>(random() % 1024) / 512 - 1);
      const double before = i > 0 ? values[values.size() - components] : 0;
      values.push_back(i % 3 == 2 ? before : std::min(std::max(wave + grain, 0.0), 1.0));
    }
  }
  return values;
}

/// Values of `type` nearest to `levels` out of `top`.
template <class T>
Bytes values_of(const std::vector<double>& numbers, double top) {
  Bytes bytes(numbers.size() * sizeof(T));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double level = std::floor(numbers[i] * top + 0.5);
    const T value = std::is_floating_point_v<T> ? static_cast<T>(level / top) : static_cast<T>(level);
    std::memcpy(bytes.data() + i * sizeof(T), &value, sizeof(T));
  }
  return bytes;
}

Bytes values_of(ComponentType type, const std::vector<double>& numbers, double float_top = 65535) {
  if (type == ComponentType::kU8) return values_of<std::uint8_t>(numbers, 255);
  if (type == ComponentType::kU16) return values_of<std::uint16_t>(numbers, 65535);
  return values_of<float>(numbers, float_top);
}

/// The largest difference of a component, 255ths.
double largest_error(ComponentType type, const Bytes& a, const Bytes& b) {
  const auto number = [type](const Bytes& bytes, std::size_t i) -> double {
    if (type == ComponentType::kU8) return std::to_integer<int>(bytes[i]);
    if (type == ComponentType::kU16) {
      std::uint16_t value = 0;
      std::memcpy(&value, bytes.data() + 2 * i, 2);
      return value / 257.0;
    }
    float value = 0;
    std::memcpy(&value, bytes.data() + 4 * i, 4);
    return 255 * static_cast<double>(value);
  };
  double largest = 0;
  for (std::size_t i = 0; i < a.size() / component_size(type); ++i)
    largest = std::max(largest, std::fabs(number(a, i) - number(b, i)));
  return largest;
}

std::optional<CodedValues<std::byte>> write_colors(const Bytes& values, ComponentType type,
                                                   unsigned components, double bound,
                                                   const AttributeSurface& surface) {
  std::vector<std::uint32_t> order(values.size() / (components * component_size(type)));
  std::iota(order.begin(), order.end(), 0U);
  const AttributeView view{
      .type = type, .components = static_cast<std::uint8_t>(components), .name = {}, .values = values};
  return write_surface_colors(type, AttributeRows(view, order), bound, surface);
}

/// What readers get, which must be what the writer said.
Bytes code(const Bytes& values, ComponentType type, unsigned components, double bound,
           const AttributeSurface& surface, std::size_t* size = nullptr) {
  const auto coded = write_colors(values, type, components, bound, surface);
  if (!coded) {
    ADD_FAILURE() << "not coded";
    return {};
  }
  const auto read = read_surface_colors(coded->bytes, type, components, surface);
  if (!read) {
    ADD_FAILURE() << read.error().message;
    return {};
  }
  EXPECT_EQ(*read, coded->values);
  EXPECT_EQ(write_colors(values, type, components, bound, surface)->bytes, coded->bytes);
  if (size != nullptr) *size = coded->bytes.size();
  return *read;
}

constexpr std::array kTypes = {ComponentType::kU8, ComponentType::kU16, ComponentType::kF32};

std::vector<test::GraphMesh> meshes() {
  std::vector<test::GraphMesh> meshes = {test::GraphMesh{},   test::sheet(1, 1), test::sheet(2, 2),
                                         test::sheet(20, 15), test::fan(300),    test::fragments()};
  meshes[0] = test::finish(std::move(meshes[0]));
  return meshes;
}

TEST(SurfaceColors, ATTR45ATTR46ExactOnesComeBackToTheBit) {
  for (const test::GraphMesh& mesh : meshes()) {
    for (const bool has_positions : {true, false}) {
      const Surface surface(mesh, has_positions);
      for (const ComponentType type : kTypes) {
        for (const unsigned components : {3U, 4U}) {
          const Bytes values = values_of(type, waves(surface.count, components));
          EXPECT_EQ(code(values, type, components, 0, surface.get()), values);
        }
      }
    }
  }
}

TEST(SurfaceColors, ATTR46BoundsHoldForEveryType) {
  for (const test::GraphMesh& mesh : meshes()) {
    const Surface surface(mesh);
    for (const ComponentType type : kTypes) {
      for (const double float_top : {255.0, 65535.0, 1e6}) {
        const Bytes values = values_of(type, waves(surface.count, 4, 0.3), float_top);
        for (const double bound : {0.25, 1.0, 2.0, 7.5, 100.0, 1e9}) {
          if (type == ComponentType::kF32 && float_top == 1e6 && bound < 0.01) continue;
          const Bytes read = code(values, type, 4, bound, surface.get());
          ASSERT_EQ(read.size(), values.size());
          EXPECT_LE(largest_error(type, values, read), bound) << float_top;
        }
      }
    }
  }
}

TEST(SurfaceColors, ATTR46SixteenBitsThatAreEightCostTheSame) {
  const Surface surface(test::sheet(20, 15));
  const auto numbers = waves(surface.count, 3);
  std::array<std::size_t, 3> sizes{};
  Bytes narrow = values_of(ComponentType::kU8, numbers);
  Bytes wide;
  for (const std::byte b : narrow) wide.insert(wide.end(), {b, b});
  EXPECT_EQ(code(narrow, ComponentType::kU8, 3, 0, surface.get(), &sizes[0]), narrow);
  EXPECT_EQ(code(wide, ComponentType::kU16, 3, 0, surface.get(), &sizes[1]), wide);
  const Bytes floats = values_of(ComponentType::kF32, numbers, 255);
  EXPECT_EQ(code(floats, ComponentType::kF32, 3, 0, surface.get(), &sizes[2]), floats);
  EXPECT_EQ(sizes[1], sizes[0]);
  EXPECT_EQ(sizes[2], sizes[0]);
}

TEST(SurfaceColors, ATTR46FloatsOfWhole255thsHaveLevels) {
  for (std::int32_t level = 0; level < 256; ++level)
    EXPECT_EQ(color_of_level(ComponentType::kF32, 8, level),
              std::bit_cast<std::uint32_t>(static_cast<float>(level) / 255.0F));
}

TEST(SurfaceColors, ATTR45ComponentsThatSayNothingCostNothing) {
  const Surface surface(test::sheet(20, 15));
  const auto rgb = waves(surface.count, 3);
  std::vector<double> opaque;
  std::vector<double> gray;
  for (std::size_t i = 0; i < surface.count; ++i) {
    opaque.insert(opaque.end(), {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 1});
    gray.insert(gray.end(), {rgb[3 * i], rgb[3 * i], rgb[3 * i], 1});
  }
  std::array<std::size_t, 4> sizes{};
  const auto size_of = [&](const std::vector<double>& numbers, unsigned components, std::size_t& size) {
    const Bytes values = values_of(ComponentType::kU8, numbers);
    EXPECT_EQ(code(values, ComponentType::kU8, components, 0, surface.get(), &size), values);
  };
  size_of(rgb, 3, sizes[0]);
  size_of(opaque, 4, sizes[1]);
  EXPECT_EQ(sizes[1], sizes[0] + 3);
  size_of(gray, 4, sizes[2]);
  EXPECT_LT(2 * sizes[2], sizes[1]);
  size_of(std::vector<double>(4 * surface.count, 0.5), 4, sizes[3]);
  EXPECT_EQ(sizes[3], 3U + 4U * 3U);
}

TEST(SurfaceColors, ATTR47ACopyHasTheColourOfTheOneBefore) {
  // Two sheets apart; each vertex of the second is a copy of one of the first, in colour, too.
  test::GraphMesh mesh;
  test::add_sheet(mesh, 12, 12, {});
  test::add_sheet(mesh, 12, 12, {});
  mesh = test::finish(std::move(mesh));
  std::vector<std::uint32_t> copies(288);
  for (std::uint32_t i = 0; i < 288; ++i) copies[i] = i % 144;
  auto numbers = waves(144, 3, 0.5);
  numbers.insert(numbers.end(), numbers.begin(), numbers.begin() + 3 * 144);
  const Bytes values = values_of(ComponentType::kU8, numbers);
  for (const bool has_positions : {true, false}) {
    std::array<std::size_t, 2> sizes{};
    EXPECT_EQ(code(values, ComponentType::kU8, 3, 0, Surface(mesh, has_positions, copies).get(), &sizes[0]),
              values);
    EXPECT_EQ(code(values, ComponentType::kU8, 3, 0, Surface(mesh, has_positions).get(), &sizes[1]), values);
    EXPECT_LT(sizes[0], sizes[1] * 3 / 4);
  }
}

TEST(SurfaceColors, ATTR47NearVerticesCountMost) {
  // Columns far apart, each of one colour and some noise.
  test::GraphMesh mesh = test::sheet(30, 30);
  test::RandomBits random(6);
  std::array<std::array<double, 3>, 30> colors{};
  for (auto& color : colors)
    for (double& level : color) level = static_cast<double>(20 + random() % 200);
  std::vector<double> numbers;
  for (Vec3& p : mesh.positions) {
    for (const double level : colors[static_cast<std::size_t>(p[0])])
      numbers.push_back((level + static_cast<double>(random() % 4)) / 255);
    p[0] *= 10;
  }
  const Bytes values = values_of(ComponentType::kU8, numbers);
  std::array<std::size_t, 2> sizes{};
  EXPECT_EQ(code(values, ComponentType::kU8, 3, 0, Surface(mesh).get(), &sizes[0]), values);
  EXPECT_EQ(code(values, ComponentType::kU8, 3, 0, Surface(mesh, false).get(), &sizes[1]), values);
  EXPECT_LT(10 * sizes[0], 9 * sizes[1]);
}

TEST(SurfaceColors, ATTR47ATTR48AnyPositionsDo) {
  const test::GraphMesh mesh = test::sheet(20, 15);
  constexpr float kLargest = std::numeric_limits<float>::max();
  test::RandomBits random(8);
  for (const float unit : {0.0F, std::numeric_limits<float>::denorm_min(), 1e-30F, 1e30F, kLargest}) {
    Surface surface(mesh);
    for (float& x : surface.positions)
      x = unit * static_cast<float>(random() % 3) * (random() % 2 == 0 ? 0.5F : -0.5F);
    for (const double bound : {0.0, 4.0}) {
      const Bytes values = values_of(ComponentType::kU8, waves(surface.count, 3, 0.2));
      EXPECT_LE(largest_error(ComponentType::kU8, values,
                              code(values, ComponentType::kU8, 3, bound, surface.get())),
                bound);
    }
  }
}

TEST(SurfaceColors, ATTR49ATTR50PatchesOfOneColourAreCopied) {
  const Surface surface(test::sheet(40, 40));
  test::RandomBits random(3);
  std::vector<double> patches;
  std::array<std::array<double, 3>, 16> colors{};
  for (auto& color : colors)
    for (double& x : color) x = static_cast<double>(random() % 256) / 255;
  for (std::uint32_t i = 0; i < surface.count; ++i) {
    const auto& color = colors[i % 40 / 10 + i / 400 * 4];
    patches.insert(patches.end(), color.begin(), color.end());
  }
  std::size_t size = 0;
  const Bytes values = values_of(ComponentType::kU8, patches);
  EXPECT_EQ(code(values, ComponentType::kU8, 3, 0, surface.get(), &size), values);
  EXPECT_LT(8 * size, surface.count);
}

TEST(SurfaceColors, ATTR51ComponentsTellOfEachOther) {
  const Surface surface(test::sheet(40, 40));
  test::RandomBits random(4);
  std::vector<double> tied;
  std::vector<double> free;
  for (std::uint32_t i = 0; i < surface.count; ++i) {
    const auto level = static_cast<double>(random() % 200);
    for (unsigned c = 0; c < 3; ++c) {
      tied.push_back((10 + level + static_cast<double>(random() % 8)) / 255);
      free.push_back((10 + static_cast<double>(random() % 200)) / 255);
    }
  }
  std::array<std::size_t, 2> sizes{};
  code(values_of(ComponentType::kU8, tied), ComponentType::kU8, 3, 0, surface.get(), &sizes[0]);
  code(values_of(ComponentType::kU8, free), ComponentType::kU8, 3, 0, surface.get(), &sizes[1]);
  EXPECT_LT(10 * sizes[0], 7 * sizes[1]);
}

TEST(SurfaceColors, ATTR52BoundsSaveBytes) {
  const Surface surface(test::sheet(60, 60));
  const Bytes values = values_of(ComponentType::kU8, waves(surface.count, 3, 0.1));
  std::size_t before = ~std::size_t{0};
  for (const double bound : {0.0, 1.0, 2.0, 4.0, 8.0}) {
    std::size_t size = 0;
    code(values, ComponentType::kU8, 3, bound, surface.get(), &size);
    EXPECT_LT(size, before);
    before = size;
  }
}

TEST(SurfaceColors, WhatHasNoLevelsIsLeftToOthers) {
  const Surface surface(test::sheet(2, 2));
  const auto code_floats = [&](float odd, double bound) {
    std::vector<float> floats(12, 0.5F);
    floats[7] = odd;
    Bytes values(48);
    std::memcpy(values.data(), floats.data(), 48);
    return write_colors(values, ComponentType::kF32, 3, bound, surface.get()).has_value();
  };
  EXPECT_FALSE(code_floats(0.5F, 0));  // between two 65535ths
  EXPECT_TRUE(code_floats(0.5F, 0.1));
  EXPECT_FALSE(code_floats(0.5F, 0.001));
  for (const float odd :
       {-0.01F, 1.01F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    EXPECT_FALSE(code_floats(odd, 1));
  EXPECT_FALSE(write_colors(Bytes(4 * 3 * 8), ComponentType::kF64, 3, 1, surface.get()));
  EXPECT_FALSE(write_colors(Bytes(4 * 3), ComponentType::kI8, 3, 1, surface.get()));
}

TEST(SurfaceColors, ATTR45HeadersAreChecked) {
  const Surface surface(test::sheet(2, 2));
  const auto fails = [&](ComponentType type, const std::vector<int>& numbers) {
    Bytes bytes;
    for (const int x : numbers) bytes.push_back(static_cast<std::byte>(x));
    const auto read = read_surface_colors(bytes, type, 3, surface.get());
    return !read && std::string(read.error().rule) == "ATTR-45";
  };
  const auto is_read = [&](ComponentType type, const std::vector<int>& numbers) {
    Bytes bytes;
    for (const int x : numbers) bytes.push_back(static_cast<std::byte>(x));
    return read_surface_colors(bytes, type, 3, surface.get()).has_value();
  };
  EXPECT_TRUE(is_read(ComponentType::kU8, {8, 127, 0, 255, 255, 0, 255, 1, 0, 255, 2, 0}));
  EXPECT_TRUE(fails(ComponentType::kU8, {16, 0, 0, 255, 255, 0, 255, 1, 0, 255, 2, 0}));
  EXPECT_TRUE(fails(ComponentType::kU16, {9, 0, 0, 255, 255, 0, 255, 1, 0, 255, 2, 0}));
  EXPECT_TRUE(fails(ComponentType::kU8, {8, 128, 0, 255, 255, 0, 255, 1, 0, 255, 2, 0}));
  EXPECT_TRUE(fails(ComponentType::kU16, {16, 0, 128, 255, 255, 0, 255, 1, 0, 255, 2, 0}));
  EXPECT_TRUE(fails(ComponentType::kU8, {8, 0, 0, 255, 0, 1, 255, 1, 0, 255, 2, 0}));  // level 256
  EXPECT_TRUE(fails(ComponentType::kU8, {8, 0, 0, 1, 1, 2}));                          // one that comes later
  EXPECT_TRUE(fails(ComponentType::kU8, {8, 0, 0, 255, 0, 0, 0, 2}));                  // one that is constant
  EXPECT_TRUE(fails(ComponentType::kU8, {8, 0, 0, 0, 0, 1}));                          // one that is a copy
}

TEST(SurfaceColors, ATTR45DamageIsNoticedOrSurvived) {
  for (const auto& mesh : {test::sheet(7, 5), test::fan(40)}) {
    const Surface surface(mesh);
    for (const ComponentType type : kTypes) {
      for (const double bound : {0.0, 3.0}) {
        const auto coded =
            write_colors(values_of(type, waves(surface.count, 4, 0.3)), type, 4, bound, surface.get());
        ASSERT_TRUE(coded);
        expect_guarded(
            coded->bytes,
            [&](const Bytes& bytes) {
              const auto read = read_surface_colors(bytes, type, 4, surface.get());
              EXPECT_TRUE(read || read.error().code != ErrorCode::kInternal);
              return read.has_value() && read->size() == coded->values.size();
            },
            "colors");
      }
    }
  }
}

TEST(SurfaceColors, ATTR52NumbersBeyondTheLevelsEndAtTheirRange) {
  // Numbers as no writer chooses them: their own levels, and far too many steps.
  const Surface surface(test::sheet(6, 6));
  const AttributeSurface of = surface.get();
  CompactWriter writer;
  constexpr ColorShape kShape{.axes = 3, .top = 255, .bound = 2};
  ColorCoder<CompactWriter> coder(writer, of, kShape, true);
  for (std::uint32_t v = 0; v < surface.count; ++v) {
    ColorLevels levels = {v % 2 == 0 ? 1000000 : -1000000, static_cast<std::int32_t>(v), -5, 0};
    coder.code_vertex(writer, v, levels);
    EXPECT_EQ(levels[0], v % 2 == 0 ? 255 : 0);
    EXPECT_EQ(levels[2], 0);
  }
}

}  // namespace
}  // namespace deltamesh
