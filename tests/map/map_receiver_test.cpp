// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Senders and receivers over a network without faults, and what receivers refuse.
#include <gtest/gtest.h>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_world.h"
#include "support/counted_memory.h"

namespace deltamesh {
namespace {

using test::World;
using Bytes = std::vector<std::byte>;

/// A sender of a small world and a receiver of it.
class MapTalk : public testing::Test {
 protected:
  MapTalk() : world_(4, 7), receiver_(1, World::description().id) {
    SenderOptions options;
    options.effort = 0;
    options.split.most_triangles = 2;
    auto sender = MapSender::make(World::description(), options);
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    EXPECT_TRUE(world_.tell(*sender_, world_.present()));
    View view;
    view.max_error = 0.05F;
    receiver_.set_view(view);
  }

  /// All messages of a round trip, which the receiver has not got yet.
  std::vector<Bytes> ask() {
    now_ += 2;
    EXPECT_TRUE(sender_->hear(*receiver_.view_message(), now_));
    auto messages = sender_->messages_for(1, now_);
    EXPECT_TRUE(messages);
    return std::move(*messages);
  }

  void catch_up() {
    for (int i = 0; i < 3; ++i)
      for (const Bytes& message : ask()) EXPECT_TRUE(receiver_.apply(message));
  }

  World world_;
  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  double now_ = 0;
};

TEST_F(MapTalk, MAP14AllPartsComeAndNothingIsSentTwice) {
  catch_up();
  EXPECT_EQ(receiver_.shown(), sender_->keys());
  EXPECT_EQ(receiver_.take_change().changed, sender_->keys());
  EXPECT_TRUE(receiver_.take_change().changed.empty());
  EXPECT_TRUE(receiver_.lacking().empty());
  EXPECT_TRUE(ask().empty());
  const std::uint64_t hash = receiver_.hash();
  EXPECT_NE(hash, MapReceiver(2, 9).hash());
  EXPECT_EQ(hash, sender_->hash(1));
}

TEST_F(MapTalk, MAP15AnotherViewIsAnsweredWithWhatIsMissing) {
  View view = receiver_.view();
  view.boxes = {{{0.1F, 0.1F, -1}, {0.9F, 0.9F, 2}}};
  receiver_.set_view(view);
  catch_up();
  EXPECT_LE(receiver_.shown().size(), 1U);
  view.boxes.clear();
  receiver_.set_view(view);
  const std::size_t before = receiver_.shown().size();
  EXPECT_EQ(ask().size(), sender_->keys().size() - before);
  // A coarser quality is there already, a finer one is not.
  catch_up();
  view.max_error = 0.1F;
  receiver_.set_view(view);
  EXPECT_TRUE(ask().empty());
  view.max_error = 0.014F;
  receiver_.set_view(view);
  EXPECT_FALSE(ask().empty());
  view.max_error = 0.001F;
  receiver_.set_view(view);
  EXPECT_EQ(sender_->hear(*receiver_.view_message(), now_).error().code, ErrorCode::kUnmetRequest);
}

TEST_F(MapTalk, MAP15TheRateIsKept) {
  View view = receiver_.view();
  view.bytes_per_second = 100;
  receiver_.set_view(view);
  for (int i = 0; i < 2; ++i)
    for (const Bytes& message : ask()) EXPECT_TRUE(receiver_.apply(message));
  std::size_t most = 0;
  std::size_t sum = 0;
  for (int i = 0; i < 20; ++i) {
    for (const Bytes& message : ask()) {
      most = std::max(most, message.size());
      sum += message.size();
      EXPECT_TRUE(receiver_.apply(message));
    }
  }
  EXPECT_LT(sum, 20 * 2 * 100 + 10 * most);
}

TEST_F(MapTalk, MAP1DamagedMessagesChangeNothing) {
  for (const Bytes& message : ask()) ASSERT_TRUE(receiver_.apply(message));
  const auto messages = ask();
  ASSERT_FALSE(messages.empty());
  for (std::size_t i = 0; i < messages[0].size(); ++i) {
    Bytes damaged = messages[0];
    damaged[i] ^= std::byte{1};
    EXPECT_FALSE(receiver_.apply(damaged)) << i;
  }
  for (std::size_t size = 0; size < messages[0].size(); ++size)
    EXPECT_FALSE(receiver_.apply(std::span(messages[0]).first(size)));
  EXPECT_TRUE(receiver_.shown().empty());
  EXPECT_EQ(receiver_.apply(*receiver_.view_message()).error().code, ErrorCode::kInvalidArgument);
}

TEST_F(MapTalk, MAP5OtherMapsAreRefused) {
  MapReceiver other(5, 1234);
  for (const Bytes& message : ask()) EXPECT_FALSE(other.apply(message));
  ViewMessage view{.viewer = 3, .map_id = 1234};
  EXPECT_EQ(sender_->hear(*write_view(view), 0).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(sender_->messages_for(77, 0).error().code, ErrorCode::kInvalidArgument);
}

TEST_F(MapTalk, MAP13EntriesTellWhatIsLacking) {
  for (const Bytes& message : ask()) ASSERT_TRUE(receiver_.apply(message));
  PartEntry entry{.key = {0, 1, 1, 0}, .revision = 1, .bytes = 100};
  const auto told = write_entry({.map = hash_of(World::description()), .start = 1, .entry = entry});
  ASSERT_TRUE(receiver_.apply(*told));
  EXPECT_EQ(receiver_.lacking(), std::vector<PartKey>{entry.key});
}

TEST_F(MapTalk, MAP14LimitsHold) {
  MapReceiver small(1, World::description().id, {.parts = 2});
  small.set_view(receiver_.view());
  receiver_ = std::move(small);
  for (const Bytes& message : ask()) ASSERT_TRUE(receiver_.apply(message));
  std::size_t refused = 0;
  for (const Bytes& message : ask()) {
    const auto applied = receiver_.apply(message);
    if (applied) continue;
    EXPECT_EQ(applied.error().code, ErrorCode::kLimitExceeded);
    ++refused;
  }
  EXPECT_EQ(refused, sender_->keys().size() - 2);
}

TEST_F(MapTalk, MAP12WhatWasHeldIsTakenAgain) {
  catch_up();
  MapReceiver again(2, World::description().id);
  EXPECT_EQ(again.restore({}, {}).error().code, ErrorCode::kInvalidArgument);
  ASSERT_TRUE(again.apply(*write_description(World::description())));
  for (const HeldPart& part : receiver_.held()) ASSERT_TRUE(again.restore(part.entry, part.octets));
  EXPECT_EQ(again.hash(), receiver_.hash());
}

/// Headers that promise much: every message of 100 bytes takes less than a megabyte.
TEST_F(MapTalk, MAP1SmallMessagesTakeLittleMemory) {
  for (const Bytes& message : ask()) ASSERT_TRUE(receiver_.apply(message));
  const auto messages = ask();
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    PartMessage part = *read_part(messages[random() % messages.size()]);
    for (auto k = random() % 6; k > 0; --k)
      part.octets[random() % part.octets.size()] = static_cast<std::byte>(random());
    part.octets.resize(std::min<std::size_t>(part.octets.size(), 60));
    const auto message = write_part(part);
    test::most_memory_from_now();
    const std::size_t before = test::memory_taken();
    (void)receiver_.apply(*message);
    EXPECT_LT(test::most_memory() - before, std::size_t{1} << 20);
  }
}

}  // namespace
}  // namespace deltamesh
