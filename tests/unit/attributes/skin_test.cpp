// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/skin/skin.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

#include "attributes/attribute.h"
#include "attributes/payload.h"
#include "base/byte_writer.h"
#include "base/numbers/short_float.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/coder/writer.h"
#include "round_trip.h"
#include "support/attribute_coding.h"
#include "support/grid_triangles.h"
#include "support/guarded.h"
#include "support/random.h"

namespace deltamesh::skin_test {
namespace {

using test::grid_triangles;
using test::numbers;
using test::rows;

constexpr std::uint32_t kSide = 30;
constexpr std::uint32_t kVertices = kSide * kSide;

template <class T>
Attribute make(AttributeKind kind, ComponentType type, const std::string& name,
               const std::vector<T>& numbers) {
  return test::attribute_of(kind, type, 4, name, numbers);
}

struct Influence {
  double joint;
  double weight;
};

/// A chain of bones along x, each of which fades into the next; the heavier one comes first.
std::array<Influence, 2> bend(std::uint32_t vertex) {
  const double place = (vertex % kSide + 0.2139 * (vertex / kSide)) / std::sqrt(37.0);
  const double bone = std::floor(place);
  const double fade = std::min(1.0, 2 * (place - bone));
  if (fade > 0.5) return {Influence{bone + 1, fade}, Influence{bone, 1 - fade}};
  return {Influence{bone, 1 - fade}, Influence{fade == 0 ? 0 : bone + 1, fade}};
}

std::vector<std::uint16_t> bent_joints() {
  std::vector<std::uint16_t> joints;
  for (std::uint32_t v = 0; v < kVertices; ++v)
    for (const double x : {bend(v)[0].joint, bend(v)[1].weight > 0 ? bend(v)[1].joint : 0, 0.0, 0.0})
      joints.push_back(static_cast<std::uint16_t>(x));
  return joints;
}

std::vector<float> bent_weights() {
  std::vector<float> weights;
  for (std::uint32_t v = 0; v < kVertices; ++v)
    for (const double x : {bend(v)[0].weight, bend(v)[1].weight, 0.0, 0.0})
      weights.push_back(static_cast<float>(x));
  return weights;
}

Attribute joints_attribute() {
  return make(AttributeKind::kJoints, ComponentType::kU16, "JOINTS_0", bent_joints());
}

CodedAttribute code(const Attribute& a, double bound, const AttributeSurface& surface,
                    std::span<const Attribute> others = {}) {
  auto coded = test::code(a, {.weight_error = bound}, surface, others);
  EXPECT_TRUE(coded.is_compact);
  return coded;
}

CodedAttribute code(const Attribute& a, double bound = 0, std::span<const Attribute> others = {}) {
  const auto triangles = grid_triangles(kSide, kSide);
  return code(a, bound, {triangles, rows(a)}, others);
}

AttributeCoding coding_of(const CodedAttribute& coded) {
  return static_cast<AttributeCoding>(coded.payload.at(0));
}

TEST(Skin, ATTR60JointsAreExactInTheirOrder) {
  const Attribute smooth = joints_attribute();
  const CodedAttribute coded = code(smooth);
  EXPECT_EQ(coding_of(coded), AttributeCoding::kJoints);
  EXPECT_EQ(coded.decoded.values, smooth.values);
  EXPECT_LT(coded.payload.size(), kVertices / 4);

  test::RandomBits random(1);
  std::vector<std::uint8_t> any;
  for (std::uint32_t i = 0; i < 4 * kVertices; ++i) any.push_back(static_cast<std::uint8_t>(random()));
  const Attribute bytes = make(AttributeKind::kJoints, ComponentType::kU8, "JOINTS_0", any);
  EXPECT_EQ(code(bytes).decoded.values, bytes.values);
  std::vector<std::uint16_t> wide;
  for (std::uint32_t i = 0; i < 4 * kVertices; ++i) wide.push_back(static_cast<std::uint16_t>(random()));
  const Attribute words = make(AttributeKind::kJoints, ComponentType::kU16, "JOINTS_0", wide);
  EXPECT_EQ(code(words).decoded.values, words.values);
}

TEST(Skin, ATTR61RowsOfTheNeighboursCostLittle) {
  std::vector<std::uint16_t> joints;
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    const auto part = static_cast<std::uint16_t>(v / kSide / 10 * 900);
    for (const int step : {7, 3, 0, 1}) joints.push_back(static_cast<std::uint16_t>(part + step));
  }
  EXPECT_LT(code(make(AttributeKind::kJoints, ComponentType::kU16, "JOINTS_0", joints)).payload.size(),
            kVertices / 9);
}

TEST(Skin, ATTR63WeightsKeepTheirBoundTheirSumAndTheirZeros) {
  const std::vector<Attribute> others{joints_attribute()};
  const auto source = bent_weights();
  for (const double bound : {0.01, 1.0 / 1024, 1e-4}) {
    const auto coded =
        code(make(AttributeKind::kWeights, ComponentType::kF32, "WEIGHTS_0", source), bound, others);
    ASSERT_EQ(coding_of(coded), AttributeCoding::kWeights);
    EXPECT_LE(coded.descriptor.error, short_float_above(bound));
    EXPECT_GT(coded.descriptor.error, bound / 3);
    const auto back = numbers<float>(coded.decoded);
    for (std::size_t i = 0; i < back.size(); i += 4) {
      EXPECT_NEAR(double{back[i]} + back[i + 1] + back[i + 2] + back[i + 3], 1, 2e-7);
      for (std::size_t slot = i; slot < i + 4; ++slot)
        if (source[slot] == 0) {
          EXPECT_EQ(back[slot], 0);
        }
    }
  }
}

TEST(Skin, ATTR63WeightsOfFourJointsKeepTheirSum) {
  test::RandomBits random(9);
  std::vector<float> source;
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    std::array<double, 4> row{};
    for (double& x : row) x = random() % 1000;
    row[0] += 1;
    const double sum = std::accumulate(row.begin(), row.end(), 0.0);
    for (const double x : row) source.push_back(static_cast<float>(x / sum));
  }
  const auto coded =
      code(make(AttributeKind::kWeights, ComponentType::kF32, "WEIGHTS_0", source), 1.0 / 1024);
  EXPECT_EQ(coding_of(coded), AttributeCoding::kWeights);
  EXPECT_LE(coded.descriptor.error, short_float_above(1.0F / 1024));
  EXPECT_LT(coded.payload.size(), 4 * kVertices);
}

template <class T>
void expect_exact_integers(ComponentType type, double top) {
  const std::vector<Attribute> others{joints_attribute()};
  std::vector<T> source;
  for (const float weight : bent_weights()) source.push_back(static_cast<T>(std::lround(weight * top)));
  for (std::size_t i = 0; i < source.size(); i += 4) source[i] = static_cast<T>(top - source[i + 1]);
  const Attribute a = make(AttributeKind::kWeights, type, "WEIGHTS_0", source);
  const CodedAttribute exact = code(a, 0, others);
  EXPECT_EQ(coding_of(exact), AttributeCoding::kWeights);
  EXPECT_EQ(exact.decoded.values, a.values);
  const CodedAttribute coarse = code(a, 0.05, others);
  EXPECT_LE(coarse.descriptor.error, short_float_above(0.05F));
  EXPECT_LT(coarse.payload.size(), exact.payload.size());
  const auto back = numbers<T>(coarse.decoded);
  for (std::size_t i = 0; i < back.size(); i += 4)
    EXPECT_EQ(back[i] + back[i + 1] + back[i + 2] + back[i + 3], static_cast<int>(top));
}

TEST(Skin, ATTR63IntegerWeightsAreExactOrWithinABound) {
  expect_exact_integers<std::uint8_t>(ComponentType::kU8, 255);
  expect_exact_integers<std::uint16_t>(ComponentType::kU16, 65535);
}

TEST(Skin, ATTR55WeightsThatDoNotAddUpToOneAreExact) {
  // Two sets that add up to 1 together: within a bound each, they would no longer.
  std::vector<float> first;
  std::vector<float> second;
  for (const float weight : bent_weights()) {
    first.push_back(0.6F * weight);
    second.push_back(weight - first.back());
  }
  for (const auto& source : {first, second}) {
    const Attribute weights = make(AttributeKind::kWeights, ComponentType::kF32, "WEIGHTS", source);
    for (const double bound : {1e-3, 0.02}) {
      const auto coded = code(weights, bound);
      EXPECT_EQ(coding_of(coded), AttributeCoding::kLattice);
      EXPECT_EQ(coded.decoded.values, weights.values);
    }
  }
}

TEST(Skin, ATTR62ATTR64JointsTellWhichWeightIsWhose) {
  const Attribute weights = make(AttributeKind::kWeights, ComponentType::kF32, "WEIGHTS_0", bent_weights());
  const std::vector<Attribute> none{};
  const std::vector<Attribute> others{joints_attribute()};
  const std::vector<Attribute> wrong{
      make(AttributeKind::kJoints, ComponentType::kF32, "JOINTS_0", bent_weights())};
  const std::size_t with = code(weights, 1e-3, others).payload.size();
  EXPECT_LT(10 * with, 9 * code(weights, 1e-3, none).payload.size());
  EXPECT_EQ(code(weights, 1e-3, wrong).payload, code(weights, 1e-3, none).payload);
  // The second set of weights has the second set of joints.
  std::vector<Attribute> two{joints_attribute(), weights, joints_attribute()};
  two[0].values.assign(two[0].values.size(), std::byte{3});
  EXPECT_EQ(code(weights, 1e-3, two).payload.size(), with);
}

TEST(Skin, ATTR65WeightsThatFollowTheirNeighboursCostLittle) {
  const std::vector<Attribute> others{joints_attribute()};
  std::vector<float> source;
  for (std::uint32_t v = 0; v < kVertices; ++v)
    for (const float x : {1.0F, 0.0F, 0.0F, 0.0F}) source.push_back(x);
  EXPECT_LT(
      code(make(AttributeKind::kWeights, ComponentType::kF32, "W", source), 1e-3, others).payload.size(),
      50U);
}

TEST(Skin, ATTR58CopiesOfAVertexCostNearlyNothing) {
  std::vector<std::uint32_t> triangles = grid_triangles(kSide, kSide);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    triangles[i] = 2 * triangles[i] + static_cast<std::uint32_t>(i / 3 % 2);
  std::vector<std::uint32_t> geometric;
  for (std::uint32_t v = 0; v < 2 * kVertices; ++v) geometric.push_back(v / 2);
  const AttributeSurface surface(triangles, 2 * kVertices, geometric);
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
  for (std::uint32_t v = 0; v < 2 * kVertices; ++v) {
    for (std::size_t slot = 0; slot < 4; ++slot) {
      joints.push_back(bent_joints()[v / 2 * 4 + slot]);
      weights.push_back(bent_weights()[v / 2 * 4 + slot]);
    }
  }
  auto copied_joints = make(AttributeKind::kJoints, ComponentType::kU16, "JOINTS_0", joints);
  auto copied_weights = make(AttributeKind::kWeights, ComponentType::kF32, "WEIGHTS_0", weights);
  const std::size_t once = code(joints_attribute()).payload.size();
  EXPECT_LT(code(copied_joints, 0, surface).payload.size(), once + 30);
  code(copied_weights, 1e-3, surface, std::vector{copied_joints});
  joints[4 * 101] = 77;
  weights[4 * 101] = 0;
  weights[4 * 101 + 3] = 1;
  weights[4 * 101 + 1] = 0;
  copied_joints = make(AttributeKind::kJoints, ComponentType::kU16, "JOINTS_0", joints);
  copied_weights = make(AttributeKind::kWeights, ComponentType::kF32, "WEIGHTS_0", weights);
  EXPECT_EQ(code(copied_joints, 0, surface).decoded.values, copied_joints.values);
  EXPECT_LE(code(copied_weights, 1e-3, surface, std::vector{copied_joints}).descriptor.error,
            short_float_above(1e-3F));
}

TEST(Skin, ATTR11WeightsMayBeListedBeforeTheirJoints) {
  Mesh mesh;
  mesh.triangles = grid_triangles(kSide, kSide);
  for (std::uint32_t v = 0; v < kVertices; ++v)
    for (const float x : {static_cast<float>(v % kSide), static_cast<float>(v / kSide), 0.0F})
      mesh.positions.push_back(x);
  mesh.attributes = {make(AttributeKind::kWeights, ComponentType::kF32, "WEIGHTS_0", bent_weights()),
                     joints_attribute()};
  const auto encoded = encode(mesh, {.keep_order = true});
  ASSERT_TRUE(encoded);
  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->attributes[1].values, mesh.attributes[1].values);
  const auto back = numbers<float>(decoded->attributes[0]);
  const auto source = bent_weights();
  for (std::size_t i = 0; i < back.size(); ++i) EXPECT_NEAR(back[i], source[i], 1.0 / 1024);
}

const char* broken_rule(AttributeKind kind, ComponentType type, const std::vector<std::byte>& bytes) {
  return test::broken_rule(bytes, {.kind = kind, .type = type, .components = 4}, 1);
}

/// The coding's byte, `sum` where it is not 0, and what `code` writes.
template <class Code>
std::vector<std::byte> by_hand(int coding, std::uint32_t sum, Code code) {
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(coding));
  if (sum > 0) out.write_varint(sum);
  CompactWriter writer;
  writer.bits(0, 1);
  code(writer);
  out.write_bytes(writer.finish());
  return out.take();
}

TEST(Skin, ATTR60ATTR63BrokenStreamsAreNamed) {
  const auto nothing = [](CompactWriter&) {};
  for (const std::uint32_t sum : {2U, 256U})
    EXPECT_STREQ(broken_rule(AttributeKind::kWeights, ComponentType::kU8, by_hand(9, sum, nothing)),
                 "ATTR-63");
  EXPECT_STREQ(broken_rule(AttributeKind::kWeights, ComponentType::kF32, by_hand(9, 65537, nothing)),
               "CON-2");
  // A joint of 300 among bytes: the difference to 0.
  const auto too_large = by_hand(10, 0, [](CompactWriter& writer) {
    SymbolModel slot{{16, 6, 4, 3, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 6}};
    SymbolModel other = slot;
    MixWeights weights;
    writer.symbol(15, Mixture<2>{{&slot, &other}, &weights});
    NumberModel steps;
    writer.number(600, steps);
  });
  EXPECT_STREQ(broken_rule(AttributeKind::kJoints, ComponentType::kU8, too_large), "ATTR-60");
  // A number between 0 and a sum of 1.
  const auto between = by_hand(9, 1, [](CompactWriter& writer) {
    SymbolModel kind{{10, 6, 10, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
    SymbolModel other = kind;
    MixWeights weights;
    writer.symbol(2, Mixture<2>{{&kind, &other}, &weights});
  });
  EXPECT_STREQ(broken_rule(AttributeKind::kWeights, ComponentType::kF32, between), "ATTR-65");
}

TEST(Skin, CON3PrefixesAndExtraBytesAreRefusedAndFlippedOnesEnd) {
  const auto triangles = grid_triangles(kSide, kSide);
  const AttributeSurface surface(triangles, kVertices);
  const std::vector<Attribute> others{joints_attribute()};
  for (const Attribute& a :
       {joints_attribute(), make(AttributeKind::kWeights, ComponentType::kF32, "W", bent_weights())}) {
    const auto coded = code(a, 1e-3, surface, others);
    const auto read = [&](const test::Bytes& bytes) {
      const auto back = read_attribute(Payload::compact(bytes), coded.descriptor, surface, others, 1 << 20);
      EXPECT_TRUE(!back || rows(*back) == rows(a));
      return back.has_value();
    };
    test::expect_guarded(coded.payload, read, a.name);
  }
}

}  // namespace
}  // namespace deltamesh::skin_test
