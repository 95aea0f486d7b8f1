// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Streams whose models begin where another stream left them.
#include "deltamesh/model_states.h"

#include <gtest/gtest.h>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
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

TEST(ModelStates, LearnsFromNoStreamThatIsNone) {
  EXPECT_FALSE(ModelStates::learn({}));
  auto stream = encode(test::tetrahedron())->bytes;
  EXPECT_EQ(ModelStates::learn(stream, {.limits = {.triangles = 3}}).error().code, ErrorCode::kLimitExceeded);
  stream[12] ^= std::byte{1};
  EXPECT_FALSE(ModelStates::learn(stream));
}

}  // namespace
}  // namespace deltamesh
