// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Streams whose models begin where another stream left them.
#include "deltamesh/model_states.h"

#include <gtest/gtest.h>

#include <span>

#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "scenes.h"
#include "states/stream_models.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

EncodeOptions options(GeometryCoder coder) {
  EncodeOptions options;
  options.geometry = coder;
  options.quality.max_error = QualityBound{0.01};
  return options;
}

TEST(ModelStates, CMP16AStreamAfterAnotherIsShorterAndTheSame) {
  for (const GeometryCoder coder : {GeometryCoder::kPredictive, GeometryCoder::kHighpass}) {
    const auto first = encode(test::attributed_grid(30, 20), options(coder));
    ASSERT_TRUE(first);
    const auto states = ModelStates::learn(first->bytes);
    ASSERT_TRUE(states);
    const Mesh mesh = test::attributed_grid(14, 13);
    EncodeOptions after = options(coder);
    const auto fresh = encode(mesh, after);
    after.starting_states = &*states;
    const auto learnt = encode(mesh, after);
    ASSERT_TRUE(fresh);
    ASSERT_TRUE(learnt);
    EXPECT_LT(learnt->bytes.size(), fresh->bytes.size());
    EXPECT_EQ(learnt->bytes, encode(mesh, after)->bytes);
    const auto a = decode(fresh->bytes);
    const auto b = decode(learnt->bytes, {.starting_states = &*states});
    ASSERT_TRUE(a);
    ASSERT_TRUE(b) << describe(b.error());
    EXPECT_EQ(a->triangles, b->triangles);
    EXPECT_EQ(a->positions.size(), b->positions.size());
    const auto wrong = decode(learnt->bytes);
    EXPECT_TRUE(!wrong || wrong->triangles != b->triangles || wrong->positions != b->positions);
  }
}

/// A map with colours and a smooth number.
Mesh with_numbers(std::uint64_t seed) {
  Mesh mesh = *generate_scene(Scene::kRooms, 2000, seed);
  Attribute number{AttributeKind::kGeneric, ComponentType::kF32, 1, false, "height", {}};
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto bytes = std::as_bytes(std::span(&mesh.positions[3 * v + 2], 1));
    number.values.insert(number.values.end(), bytes.begin(), bytes.end());
  }
  mesh.attributes.push_back(number);
  return mesh;
}

TEST(ModelStates, CMP16CoefficientsBeginAsAnotherStreamLeftThem) {
  EncodeOptions options;
  options.quality.max_error = QualityBound{0.02};
  options.attributes.color_rms = 3;
  options.attributes.named = {{.name = "height", .error = 0.05, .is_mean = true}};
  const auto first = encode(with_numbers(1), options);
  ASSERT_TRUE(first);
  const auto states = ModelStates::learn(first->bytes);
  ASSERT_TRUE(states);
  ASSERT_EQ(states->models().attributes.size(), 2U);
  EXPECT_TRUE(states->models().attributes[0].mean);
  EXPECT_FALSE(states->models().attributes[0].colors);
  EXPECT_TRUE(states->models().attributes[1].mean);
  const Mesh mesh = with_numbers(2);
  const auto fresh = encode(mesh, options);
  options.starting_states = &*states;
  const auto learnt = encode(mesh, options);
  ASSERT_TRUE(learnt);
  for (std::size_t i = 0; i < 2; ++i) {
    const AttributeInfo& before = fresh->report.stream.attributes[i];
    const AttributeInfo& after = learnt->report.stream.attributes[i];
    EXPECT_LT(static_cast<double>(after.coded_bytes), 0.97 * static_cast<double>(before.coded_bytes)) << i;
  }
  const auto decoded = decode(learnt->bytes, {.starting_states = &*states});
  ASSERT_TRUE(decoded) << describe(decoded.error());
  const auto errors = compare(mesh, *decoded);
  ASSERT_TRUE(errors && errors->corresponding);
  EXPECT_NEAR(errors->attributes[0].color_rms, 3, 0.1);
  EXPECT_NEAR(errors->attributes[1].rms, 0.05, 0.002);
  EXPECT_FALSE(decode(learnt->bytes));
}

TEST(ModelStates, LearnsFromNoStreamThatIsNone) {
  EXPECT_FALSE(ModelStates::learn({}));
  auto stream = encode(test::tetrahedron())->bytes;
  EXPECT_EQ(ModelStates::learn(stream, {.limits = {.triangles = 3}}).error().code, ErrorCode::kLimitExceeded);
  stream[12] ^= std::byte{1};
  EXPECT_FALSE(ModelStates::learn(stream));
}

}  // namespace
}  // namespace deltamesh
