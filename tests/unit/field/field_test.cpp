// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "field/field_coder.h"
#include "field/field_history.h"
#include "field/field_prediction.h"
#include "field/octave_class.h"
#include "format/chunk/tags.h"
#include "support/graph_mesh.h"
#include "support/random.h"

namespace deltamesh {
namespace {

using test::GraphMesh;

using Numbers = std::vector<FieldNumbers>;

template <class Make>
Numbers numbers_of(const Adjacency& graph, Make make) {
  Numbers numbers(graph.vertex_count());
  for (FieldNumbers& q : numbers) q = make();
  return numbers;
}

std::vector<std::byte> write_field(const Numbers& numbers, const Adjacency& graph) {
  CompactWriter writer;
  FieldCoder<CompactWriter> field(writer, graph);
  for (std::uint32_t v = 0; v < numbers.size(); ++v) {
    FieldNumbers q = numbers[v];
    EXPECT_TRUE(field.code_vertex(v, q));
    EXPECT_EQ(q, numbers[v]);
  }
  return writer.finish();
}

double bits_per_number(const Numbers& numbers, const Adjacency& graph) {
  return 8.0 * static_cast<double>(write_field(numbers, graph).size()) /
         static_cast<double>(3 * numbers.size());
}

std::vector<FieldContext> contexts_of(const Numbers& numbers, const Adjacency& graph) {
  FieldHistory history(graph);
  std::vector<FieldContext> contexts;
  for (std::uint32_t v = 0; v < numbers.size(); ++v) {
    contexts.push_back(history.around(v));
    history.remember(v, numbers[v], contexts.back());
  }
  return contexts;
}

void expect_equal(FourInts a, FourInts b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(a[k], b[k]);
}

void expect_equal(const FieldContext& a, const FieldContext& b) {
  expect_equal(a.numbers, b.numbers);
  expect_equal(a.sizes, b.sizes);
  expect_equal(a.ties, b.ties);
  expect_equal(a.errors, b.errors);
  expect_equal(a.last_peer, b.last_peer);
  EXPECT_EQ(a.degree_class, b.degree_class);
}

TEST(OctaveClass, FLD15FourClassesPerOctave) {
  EXPECT_EQ(octave_class(0), 0U);
  for (std::uint32_t v = 0; v < kOctaveClass.size(); ++v) {
    EXPECT_EQ(kOctaveClass[v], octave_class(v));
    EXPECT_LE(octave_class(v), octave_class(v + 1));
    EXPECT_EQ(octave_class(2 * v + 4), std::min(octave_class(v) + 4, 23U));
  }
}

TEST(FieldHistory, FLD13AFirstVertexHasNoContext) {
  const GraphMesh mesh = test::sheet(6, 5);
  const FieldContext around = FieldHistory(mesh.graph).around(0);
  for (const FourInts& lanes : {around.numbers, around.sizes, around.ties, around.errors, around.last_peer})
    expect_equal(lanes, FourInts{});
}

TEST(FieldHistory, FLD13TheMeanOfEqualNumbersIsThatNumber) {
  const GraphMesh mesh = test::sheet(12, 9);
  const Numbers numbers = numbers_of(mesh.graph, [] { return FieldNumbers{40, -8, 0}; });
  const auto contexts = contexts_of(numbers, mesh.graph);
  for (std::uint32_t v = 1; v < numbers.size(); ++v) {
    const FieldContext& around = contexts[v];
    ASSERT_LT(mesh.graph.of(v).front(), v);
    // Sixteenths; a third of three is 85 of 256.
    EXPECT_NEAR(around.numbers[0], 16 * 40, 3);
    EXPECT_NEAR(around.numbers[1], 16 * -8, 1);
    EXPECT_EQ(around.numbers[2], 0);
    expect_equal(around.last_peer, FourInts{40, -8, 0, 0});
    EXPECT_LT(around.ties[0], 0) << "x and y have opposite signs";
    EXPECT_EQ(around.ties[1], 0);
  }
}

TEST(FieldHistory, FLD13OnlyLowerVerticesCount) {
  const GraphMesh mesh = test::sheet(12, 9);
  test::RandomBits random(3);
  const auto small = [&] { return static_cast<std::int32_t>(random() % 9) - 4; };
  Numbers numbers = numbers_of(mesh.graph, [&] { return FieldNumbers{small(), small(), small()}; });
  const auto before = contexts_of(numbers, mesh.graph);
  constexpr std::uint32_t kChanged = 60;
  numbers[kChanged] = {100, 200, -300};
  const auto after = contexts_of(numbers, mesh.graph);
  for (std::uint32_t v = 0; v <= kChanged; ++v) expect_equal(before[v], after[v]);
  EXPECT_NE(before[kChanged + 1].numbers[0], after[kChanged + 1].numbers[0]);
}

FieldContext context(FourInts numbers, FourInts last_peer, FourInts errors) {
  return {.numbers = numbers,
          .sizes = FourInts{400, 300, 200, 0},
          .ties = FourInts{8, 0, -8, 0},
          .errors = errors,
          .last_peer = last_peer,
          .degree_class = 3};
}

/// With small errors numbers are coded as differences to the last peer.
TEST(FieldPredictions, FLD14FLD15AMirroredFieldHasTheSameContexts) {
  for (const std::int32_t error : {1, 1000}) {
    const FourInts numbers{320, -640, 128, 0};
    const FourInts last{25, -30, 7, 0};
    const FourInts errors = FourInts{1, 1, 1, 0} * error;
    const FieldContext around = context(numbers, last, errors);
    const FieldContext mirrored = context(-numbers, -last, errors);
    FieldPredictions plain(around);
    FieldPredictions other(mirrored);
    const auto compare = [&](const FieldPrediction& a, const FieldPrediction& b) {
      EXPECT_EQ(a.base, -b.base);
      EXPECT_EQ(a.base != 0, error == 1);
      EXPECT_EQ(a.sign, -1 - b.sign);
      EXPECT_EQ(a.shift, b.shift);
      EXPECT_EQ(a.contexts, b.contexts);
      for (std::size_t k = 0; k < kFieldModels; ++k) EXPECT_LT(a.contexts[k], kFieldContexts[k]);
    };
    compare(plain.of<0>(), other.of<0>());
    plain.settle<0>(21);
    other.settle<0>(-21);
    compare(plain.of<1>(), other.of<1>());
    plain.settle<1>(-10000);
    other.settle<1>(10000);
    compare(plain.of<2>(), other.of<2>());
    EXPECT_EQ(plain.numbers(), (std::array<std::int32_t, 3>{21, -kLargestRemembered, 0}));
  }
}

TEST(FieldCoder, FLD1NumbersComeBack) {
  test::RandomBits random(4);
  const auto any = [&] {
    const std::int64_t size = static_cast<std::int64_t>(random()) % (std::int64_t{1} << random() % 31);
    return static_cast<std::int32_t>(random() % 2 == 0 ? size : -size);
  };
  for (const GraphMesh& mesh : {test::sheet(17, 13), test::fan(40), test::fragments()}) {
    Numbers numbers = numbers_of(mesh.graph, [&] { return FieldNumbers{any(), any(), any()}; });
    numbers.front() = {kLargestFieldValue, -kLargestFieldValue, 0};
    const auto bytes = write_field(numbers, mesh.graph);
    CompactReader reader(bytes);
    FieldCoder<CompactReader> field(reader, mesh.graph);
    for (std::uint32_t v = 0; v < numbers.size(); ++v) {
      FieldNumbers q{};
      ASSERT_TRUE(field.code_vertex(v, q));
      EXPECT_EQ(q, numbers[v]);
    }
    EXPECT_TRUE(reader.finish(kTagDeltas));
  }
}

TEST(FieldCoder, FLD1LargerNumbersAreRefused) {
  const GraphMesh mesh = test::sheet(3, 3);
  for (const std::int32_t q : {kLargestFieldValue + 1, -kLargestFieldValue - 1}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CompactWriter writer;
      FieldCoder<CompactWriter> field(writer, mesh.graph);
      FieldNumbers numbers{};
      numbers[axis] = q;
      EXPECT_FALSE(field.code_vertex(0, numbers));
    }
  }
}

/// What neighbours have in common costs little: equal numbers, and sizes.
TEST(FieldCoder, NeighboursSaveBits) {
  const GraphMesh mesh = test::sheet(60, 50);
  test::RandomBits random(5);
  const auto below = [&](std::uint32_t size) {
    return static_cast<std::int32_t>(random() % (2 * size + 1)) - static_cast<std::int32_t>(size);
  };
  const auto noise = [&](std::uint32_t size) {
    return numbers_of(mesh.graph, [&] { return FieldNumbers{below(size), below(size), below(size)}; });
  };
  EXPECT_LT(bits_per_number(noise(0), mesh.graph), 0.1);
  EXPECT_LT(bits_per_number(numbers_of(mesh.graph,
                                       [] {
                                         return FieldNumbers{900, -500, 70};
                                       }),
                            mesh.graph),
            0.5);
  // log2 of 15 and of 1001 equally likely numbers.
  EXPECT_LT(bits_per_number(noise(7), mesh.graph), 3.91 + 0.4);
  EXPECT_LT(bits_per_number(noise(500), mesh.graph), 9.97 + 0.4);
}

}  // namespace
}  // namespace deltamesh
