// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A Decoder gives what decode() gives, whatever it has decoded before.
#include <gtest/gtest.h>

#include <cstddef>
#include <thread>
#include <utility>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "support/meshes.h"
#include "support/same_mesh.h"

namespace deltamesh {
namespace {

using Stream = std::vector<std::byte>;

const EncodeOptions kHighpass{.geometry = GeometryCoder::kHighpass, .effort = 0};
const EncodeOptions kPredictive{.geometry = GeometryCoder::kPredictive, .effort = 0};

Stream stream_of(const Mesh& mesh, const EncodeOptions& options) {
  const auto encoded = encode(mesh, options);
  if (encoded) return encoded->bytes;
  ADD_FAILURE() << describe(encoded.error());
  return {};
}

/// Of all sizes and kinds, those with arrays that come from kept memory among them.
std::vector<Stream> streams() {
  std::vector<Stream> streams;
  const auto awkward = testing::awkward_meshes();
  for (std::size_t i = 0; i < awkward.size(); ++i) {
    const auto size = static_cast<std::uint32_t>(100 + 20 * (i * 7 % 5));
    if (i % 2 == 0)
      streams.push_back(stream_of(testing::bumpy_grid(size, size), i % 3 == 1 ? kPredictive : kHighpass));
    streams.push_back(stream_of(awkward[i].mesh, {.keep_unreferenced = true}));
  }
  streams.push_back(stream_of(testing::attributed_grid(150, 130), {.effort = 0, .keep_order = true}));
  streams.push_back(stream_of(testing::attributed_grid(12, 9), {}));
  return streams;
}

TEST(Decoder, GivesWhatDecodeGives) {
  Decoder decoder;
  unsigned threads = 0;
  for (const Stream& stream : streams()) {
    SCOPED_TRACE(stream.size());
    const DecodeOptions options{.threads = 1 + ++threads % 3};
    testing::expect_same(decoder.decode(stream, options), decode(stream));
  }
}

TEST(Decoder, GoesOnAfterErrors) {
  Decoder decoder;
  for (const GeometryCoder geometry : {GeometryCoder::kHighpass, GeometryCoder::kPredictive}) {
    const Stream whole = stream_of(testing::attributed_grid(110, 90), {.geometry = geometry, .effort = 0});
    ASSERT_GT(whole.size(), 1U << 14);  // smaller ones keep nothing
    const auto mesh = decode(whole);
    for (std::size_t i = 0; i < whole.size(); i += whole.size() / 20) {
      SCOPED_TRACE(i);
      Stream broken = whole;
      broken[i] ^= std::byte{0x15};
      testing::expect_same(decoder.decode(broken), decode(broken));
      EXPECT_FALSE(decoder.decode(std::span(whole).first(i)));
      testing::expect_same(decoder.decode(whole), mesh);
    }
    EXPECT_EQ(decoder.decode(whole, {.limits = {.vertices = 5}}).error().code, ErrorCode::kLimitExceeded);
  }
}

/// From the callback of a decode of its own.
TEST(Decoder, MayBeUsedWithinItself) {
  const Stream large = stream_of(testing::bumpy_grid(150, 150), kHighpass);
  const Stream larger = stream_of(testing::bumpy_grid(180, 150), kHighpass);
  const auto alone = decode(large);
  const auto larger_alone = decode(larger);
  for (const unsigned threads : {1U, 2U}) {
    for (const unsigned inner_threads : {1U, 2U}) {
      Decoder decoder;
      int calls = 0;
      const auto decode_within = [&](double) {
        testing::expect_same(decoder.decode(larger, {.threads = inner_threads}), larger_alone);
        ++calls;
      };
      const DecodeOptions options{.threads = threads, .progress = decode_within};
      for (int round = 0; round < 2; ++round) testing::expect_same(decoder.decode(large, options), alone);
      EXPECT_GT(calls, 0);
    }
  }
}

TEST(Decoder, MayBeMoved) {
  const Stream stream = stream_of(testing::bumpy_grid(150, 150), kHighpass);
  const auto mesh = decode(stream);
  Decoder first;
  testing::expect_same(first.decode(stream), mesh);
  Decoder second = std::move(first);
  testing::expect_same(second.decode(stream), mesh);
  testing::expect_same(first.decode(stream), mesh);  // NOLINT(bugprone-use-after-move): as it is promised
  second = Decoder();
  testing::expect_same(second.decode(stream), mesh);
}

TEST(Decoder, EachThreadMayHaveOne) {
  const Stream stream = stream_of(testing::bumpy_grid(150, 150), kHighpass);
  const auto mesh = decode(stream);
  const auto decode_some = [&] {
    Decoder decoder;
    for (int round = 0; round < 4; ++round) testing::expect_same(decoder.decode(stream), mesh);
  };
  std::thread other(decode_some);
  decode_some();
  other.join();
}

}  // namespace
}  // namespace deltamesh
