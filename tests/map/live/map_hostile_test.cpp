// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A hostile sender: its messages are valid, and must not cost a receiver more than others do.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"

namespace deltamesh::map_hostile_test {
namespace {

class HostileSender {
 public:
  HostileSender() : codec_(*MapCodec::open(description())) {}

  MapReceiver receiver(const ReceiverLimits& limits = {}) const {
    MapReceiver receiver(1, 7, limits);
    EXPECT_TRUE(receiver.apply(*write_description(description())));
    EXPECT_TRUE(receiver.apply(*write_start({.map = map_, .start = 1})));
    return receiver;
  }

  /// One face in cell (i, 0, 0).
  PartMessage part(int i, std::uint64_t revision) const {
    MapPart part{.key = {0, i, 0, 0}};
    const float x = 2.0F * static_cast<float>(i);
    part.mesh.positions = {x + 0.1F, 0.1F, 0.1F, x + 1, 0.1F, 0.1F, x + 0.1F, 1, 0.1F};
    part.mesh.triangles = {0, 1, 2};
    return {.map = map_,
            .start = 1,
            .key = part.key,
            .revision = revision,
            .octets = codec_.encode(part, PartQuality{})->bytes};
  }

  /// A version of the part with the octets that it has, and 4,096 links.
  EntryMessage entry_with_links(int i, int version) const {
    const PartMessage shown = part(i, 10);
    EntryMessage message{.map = map_, .start = 1};
    PartEntry& entry = message.entry;
    entry.key = shown.key;
    entry.revision = 11 + static_cast<std::uint64_t>(version);
    entry.bytes = static_cast<std::uint32_t>(shown.octets.size());
    entry.hash = XXH3_64bits(shown.octets.data(), shown.octets.size());
    entry.vertices = 3;
    entry.triangles = 1;
    entry.links.push_back({.key = {0, -5, 0, 0}, .together = true});  // so that it waits
    for (int k = 0; k < 4095; ++k) entry.links.push_back({.key = {0, -4, 5000 * version + k, i}});
    return message;
  }

 private:
  static MapDescription description() {
    MapDescription description{.id = 7, .epoch = 1, .frame = "map", .cell_steps = 8};
    description.lattice.step_exponent = -2;
    return description;
  }

  MapCodec codec_;
  std::uint64_t map_ = hash_of(description());
};

/// Processor time to take so many parts, each of which waits for the one before, and the first for none that
/// comes.
std::clock_t time_of_chain(int parts) {
  const HostileSender sender;
  MapReceiver receiver = sender.receiver();
  std::clock_t taken = 0;
  for (int i = 0; i < parts; ++i) {
    PartMessage part = sender.part(i, 10 + static_cast<std::uint64_t>(i));
    part.links = {{.key = {0, i - 1, 0, 0}, .together = true}};
    const auto message = *write_part(part);
    const std::clock_t begin = std::clock();
    EXPECT_TRUE(receiver.apply(message));
    taken += std::clock() - begin;
  }
  EXPECT_TRUE(receiver.shown().empty());
  return taken;
}

TEST(MapHostile, MAP12AChainOfPartsThatWaitForEachOtherIsSettledOnceAMessage) {
  // All that waits is looked at with each message: quadratic in all, 16, in theory; cubic would be 64.
  EXPECT_LT(time_of_chain(800), 32 * std::max(time_of_chain(200), std::clock_t{CLOCKS_PER_SEC / 100}));
}

TEST(MapHostile, MAP13EntriesKeepTheLimitOnLinks) {
  constexpr int kParts = 4;
  const HostileSender sender;
  MapReceiver receiver = sender.receiver({.parts = kParts, .octets = 1 << 20, .vertices = 1 << 16});
  int refused = 0;
  for (int i = 0; i < kParts; ++i) ASSERT_TRUE(receiver.apply(*write_part(sender.part(i, 10))));
  for (int version = 0; version < 8; ++version) {
    for (int i = 0; i < kParts; ++i) {
      const auto applied = receiver.apply(*write_entry(sender.entry_with_links(i, version)));
      if (applied) continue;
      EXPECT_EQ(applied.error().code, ErrorCode::kLimitExceeded);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 8 * kParts - 1);  // 256 links are allowed
}

}  // namespace
}  // namespace deltamesh::map_hostile_test
