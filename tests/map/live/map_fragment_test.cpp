// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Messages in fragments [MAP-25].
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "deltamesh/map/fragment.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "scenes.h"

namespace deltamesh::map_fragment_test {
namespace {

using Bytes = std::vector<std::byte>;

Bytes some_bytes(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 7);
  return bytes;
}

TEST(MapFragment, MAP25ComesTogetherInAnyOrder) {
  std::mt19937 random(1);
  for (const std::size_t size : {65U, 100U, 1201U, 65'536U, 262'144U}) {
    for (const std::size_t most : {64U, 1200U}) {
      auto pieces = *cut_message(some_bytes(size), most);
      EXPECT_EQ(pieces.size() == 1, size <= most);
      if (pieces.size() == 1) continue;
      std::ranges::shuffle(pieces, random);
      FragmentJoiner joiner;
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_LE(pieces[i].size(), most);
        const auto joined = joiner.add(pieces[i]);
        ASSERT_TRUE(joined);
        ASSERT_EQ(joined->has_value(), i + 1 == pieces.size());
        const auto again = joiner.add(pieces[i]);  // which begins another one, after the last
        EXPECT_TRUE(again && !*again);
        if (*joined) {
          EXPECT_EQ(**joined, some_bytes(size));
        }
      }
    }
  }
}

TEST(MapFragment, MAP25WhatIsNoPieceIsRefused) {
  const auto rule_of = [](const FragmentMessage& fragment) {
    const auto written = write_fragment(fragment);
    return std::string(written ? "" : written.error().rule);
  };
  EXPECT_EQ(rule_of({1, 10, 0, some_bytes(9)}), "");
  EXPECT_EQ(rule_of({1, 10, 0, some_bytes(10)}), "MAP-25");  // the whole
  EXPECT_EQ(rule_of({1, 10, 2, some_bytes(9)}), "MAP-25");   // beyond the end
  EXPECT_EQ(rule_of({1, 10, ~std::uint64_t{0}, some_bytes(2)}), "MAP-25");
  EXPECT_EQ(rule_of({1, 10, 3, {}}), "MAP-25");
  EXPECT_EQ(rule_of({1, kMostMessageBytes + 1, 0, some_bytes(9)}), "MAP-25");
  FragmentJoiner joiner;
  ASSERT_TRUE(joiner.add(*write_fragment({1, 10, 0, some_bytes(9)})));
  const auto wrong = joiner.add(*write_fragment({1, 10, 9, some_bytes(1)}));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::kCorrupt);
  // A fragment of fragments.
  const auto inner = *cut_message(some_bytes(200), 100);
  MapReceiver receiver(1, 1);
  const auto pieces = *cut_message(inner.front(), 64);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) EXPECT_TRUE(receiver.apply(pieces[i]));
  EXPECT_STREQ(receiver.apply(pieces.back()).error().rule, "MAP-25");
}

TEST(MapFragment, MAP25TheOldestAreForgotten) {
  FragmentJoiner joiner;
  const auto first = *cut_message(some_bytes(100), 64);
  ASSERT_TRUE(joiner.add(first.front()));
  for (std::uint64_t id = 0; id < 64; ++id)
    ASSERT_TRUE(joiner.add(*write_fragment({id, 10, 0, some_bytes(9)})));
  for (std::size_t i = 1; i < first.size(); ++i) {
    const auto joined = joiner.add(first[i]);
    EXPECT_TRUE(joined && !*joined);
  }
}

TEST(MapFragment, MAP25AMapOverDatagrams) {
  const Mesh mesh = *generate_scene(Scene::kRooms, 20'000, 1);
  MapDescription description{.id = 1, .cell_steps = 4096, .attributes = test::attributes_of(mesh)};
  description.lattice = {.origin = mesh.origin, .step_exponent = -10};
  constexpr std::size_t kMost = 1200;
  auto sender = MapSender::make(description, {.message_bytes = kMost});
  ASSERT_TRUE(sender);
  const auto parts = split(mesh, description, {.most_triangles = 1, .most_level = 0});
  std::vector<MapBlock> blocks;
  for (const MapPart& part : *parts) blocks.push_back({{part.key.x, part.key.y, part.key.z}, part.mesh});
  ASSERT_TRUE(sender->update(blocks));
  MapReceiver receiver(1, 1, {.message_bytes = kMost});
  View view;
  view.max_error = 0.002F;
  receiver.set_view(view);
  std::mt19937 random(1);
  std::size_t most = 0;
  for (double now = 0; now < 60; now += 0.05) {
    const auto said = receiver.messages(now);
    ASSERT_TRUE(said);
    for (const Bytes& message : *said) {
      most = std::max(most, message.size());
      const bool is_lost = random() % 20 == 0;
      EXPECT_TRUE(is_lost || sender->hear(message, now));
    }
    if (sender->viewers().empty()) continue;
    const auto messages = sender->messages_for(1, now);
    ASSERT_TRUE(messages);
    for (const Bytes& message : *messages) {
      most = std::max(most, message.size());
      const bool is_lost = random() % 20 == 0;
      EXPECT_TRUE(is_lost || receiver.apply(message));
    }
  }
  EXPECT_LE(most, kMost);
  EXPECT_EQ(receiver.shown(), sender->keys());
  EXPECT_EQ(receiver.hash(), sender->hash(1));
}

TEST(MapFragment, MAP25TooSmallIsRefused) {
  const MapDescription description{.id = 1, .cell_steps = 64};
  EXPECT_FALSE(MapSender::make(description, {.message_bytes = 63}));
  EXPECT_TRUE(MapSender::make(description, {.message_bytes = 64}));
  EXPECT_FALSE(MapReceiver(1, 1, {.message_bytes = 63}).messages(0));
}

}  // namespace
}  // namespace deltamesh::map_fragment_test
