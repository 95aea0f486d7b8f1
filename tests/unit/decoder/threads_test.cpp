// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A stream decodes to the same mesh, or the same error, on any number of threads.
#include <gtest/gtest.h>

#include <cstddef>
#include <span>
#include <vector>

#include "base/threads/thread_team.h"
#include "decoder/stream_decoder.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "format/container.h"
#include "scenes.h"
#include "support/meshes.h"
#include "support/same_mesh.h"

namespace deltamesh {
namespace {

using test::expect_same;

constexpr unsigned kCounts[] = {2, 3, 4, 0};

/// Of short streams too, which decode() has no team for.
Result<Mesh> decode_by_team(std::span<const std::byte> stream, unsigned threads) {
  const auto container = Container::open(stream);
  if (!container) return container.error();
  ThreadTeam team(threads);
  return decode_container(*container, {}, &team);
}

void expect_same_for_all_counts(const Mesh& mesh, const EncodeOptions& options) {
  const auto encoded = encode(mesh, options);
  ASSERT_TRUE(encoded) << describe(encoded.error());
  const auto alone = decode(encoded->bytes);
  ASSERT_TRUE(alone) << describe(alone.error());
  for (const unsigned threads : kCounts) {
    SCOPED_TRACE(threads);
    const auto decoded = decode_by_team(encoded->bytes, threads);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    expect_same(*decoded, *alone);
  }
}

TEST(Threads, GiveTheSameBits) {
  for (const char* name : {"rooms", "fragments", "terrain"}) {
    SCOPED_TRACE(name);
    const auto scene = scene_of_name(name);
    ASSERT_TRUE(scene);
    const auto mesh = generate_scene(*scene, 6000, 1);
    ASSERT_TRUE(mesh);
    expect_same_for_all_counts(*mesh, {});
  }
  for (const auto& named : test::awkward_meshes()) {
    SCOPED_TRACE(named.name);
    expect_same_for_all_counts(named.mesh, {.keep_unreferenced = true});
  }
  expect_same_for_all_counts(test::attributed_grid(30, 20), {.keep_order = true});
  expect_same_for_all_counts(test::attributed_grid(30, 20), {.geometry = GeometryCoder::kPredictive});
}

/// With rows to share, and chunks of the finest level.
TEST(Threads, GiveTheSameBitsOfLargeMeshes) {
  const auto mesh = generate_scene(*scene_of_name("terrain"), 80000, 1);
  ASSERT_TRUE(mesh);
  expect_same_for_all_counts(*mesh, {.geometry = GeometryCoder::kHighpass, .effort = 0});
  expect_same_for_all_counts(*mesh, {.geometry = GeometryCoder::kPredictive, .effort = 0});
}

/// From its callback, on the thread that has the team.
TEST(Threads, ADecodeMayBeMadeWithinAnother) {
  const auto mesh = generate_scene(*scene_of_name("sphere"), 80000, 1);
  ASSERT_TRUE(mesh);
  const auto encoded = encode(*mesh, {.geometry = GeometryCoder::kHighpass, .effort = 0});
  ASSERT_TRUE(encoded) << describe(encoded.error());
  const auto alone = decode(encoded->bytes);
  ASSERT_TRUE(alone);
  for (const unsigned inner_threads : {1U, 2U}) {
    SCOPED_TRACE(inner_threads);
    int calls = 0;
    const auto decode_again = [&](double) {
      const auto inner = decode(encoded->bytes, {.threads = inner_threads});
      ASSERT_TRUE(inner) << describe(inner.error());
      expect_same(*inner, *alone);
      ++calls;
    };
    const auto outer = decode(encoded->bytes, {.threads = 2, .progress = decode_again});
    ASSERT_TRUE(outer) << describe(outer.error());
    expect_same(*outer, *alone);
    EXPECT_GT(calls, 0);
  }
}

TEST(Threads, GiveTheSameErrors) {
  const auto encoded = encode(test::attributed_grid(12, 9), {.profile = Profile::kZstd});
  ASSERT_TRUE(encoded);
  for (std::size_t i = 0; i < encoded->bytes.size(); i += 7) {
    std::vector<std::byte> broken = encoded->bytes;
    broken[i] ^= std::byte{0x15};
    const auto alone = decode(broken);
    const auto together = decode_by_team(broken, 2);
    SCOPED_TRACE(i);
    expect_same(together, alone);
  }
}

}  // namespace
}  // namespace deltamesh
