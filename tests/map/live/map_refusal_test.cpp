// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A receiver that has no room for all that its view asks for.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_world.h"

namespace deltamesh::map_refusal_test {
namespace {

using test::World;

class MapRefusal : public testing::Test {
 protected:
  MapRefusal() : world_(5, 7) {
    auto sender = MapSender::make(World::description(), {.split = {.most_triangles = 1, .most_level = 0}});
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    EXPECT_TRUE(world_.tell(*sender_, world_.present()));
    view_.max_error = 0.05F;
  }

  void start(const ReceiverLimits& limits) {
    receiver_ = std::make_unique<MapReceiver>(1, World::description().id, limits);
    receiver_->set_view(view_);
  }

  /// The bytes that the sender sends in so many seconds.
  std::size_t bytes_in(int seconds) {
    std::size_t bytes = 0;
    for (const double end = now_ + seconds; now_ < end; now_ += 0.25) {
      const auto said = receiver_->messages(now_);
      EXPECT_TRUE(said);
      for (const auto& message : *said) EXPECT_TRUE(sender_->hear(message, now_));
      if (sender_->viewers().empty()) continue;
      const auto messages = sender_->messages_for(1, now_);
      EXPECT_TRUE(messages);
      for (const auto& message : *messages) {
        bytes += message.size();
        const auto applied = receiver_->apply(message);
        EXPECT_TRUE(applied || applied.error().code == ErrorCode::kLimitExceeded);
      }
    }
    return bytes;
  }

  /// All parts of the map that are not shown are told to be refused, on both sides, and no other.
  void expect_told() const {
    std::vector<PartKey> keys = receiver_->shown();
    const auto at_sender = sender_->faults_of(1);
    ASSERT_EQ(receiver_->faults().size(), at_sender.size());
    for (const PartFault& fault : receiver_->faults()) {
      EXPECT_EQ(fault.code, ErrorCode::kLimitExceeded);
      keys.push_back(fault.key);
    }
    std::ranges::sort(keys);
    EXPECT_EQ(keys, sender_->keys());
  }

  World world_;
  std::unique_ptr<MapSender> sender_;
  std::unique_ptr<MapReceiver> receiver_;
  View view_;
  double now_ = 0;
};

TEST_F(MapRefusal, MAP22WhatIsRefusedIsNamedAndSentEverMoreRarely) {
  start({});
  const std::size_t whole = bytes_in(10);
  const std::size_t parts = sender_->keys().size();
  ASSERT_GT(parts, 10U);
  ASSERT_EQ(receiver_->shown().size(), parts);
  for (const ReceiverLimits& limits : {ReceiverLimits{.parts = parts - 1}, ReceiverLimits{.parts = parts / 2},
                                       ReceiverLimits{.octets = 400}, ReceiverLimits{.vertices = 30}}) {
    sender_->forget(1);
    start(limits);
    bytes_in(10);
    EXPECT_LT(receiver_->shown().size(), parts);
    EXPECT_GT(receiver_->shown().size(), 3U);
    expect_told();
    EXPECT_LT(bytes_in(600), 4 * whole);
    expect_told();
    EXPECT_EQ(sender_->hash(1), receiver_->hash());
  }
}

TEST_F(MapRefusal, MAP22WhatWasRefusedComesSoonWhereThereIsRoom) {
  const std::size_t most = sender_->keys().size() / 2;
  start({.parts = most});
  bytes_in(100);
  EXPECT_EQ(receiver_->shown().size(), most);
  view_.boxes = {{{0.1F, 0.1F, -1}, {1.9F, 4.9F, 2}}};
  receiver_->set_view(view_);
  bytes_in(3);
  EXPECT_TRUE(receiver_->faults().empty());
  EXPECT_TRUE(sender_->faults_of(1).empty());
  EXPECT_EQ(sender_->hash(1), receiver_->hash());
  view_.boxes.clear();
  receiver_->set_view(view_);
  bytes_in(100);
  expect_told();
  // Shown ones go from the map.
  World empty(0, 1);
  const std::vector<PartKey> shown = receiver_->shown();
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_TRUE(empty.tell(*sender_, {{shown[i].x, shown[i].y, shown[i].z}}));
  bytes_in(4);
  EXPECT_EQ(receiver_->shown().size(), most);
  expect_told();
}

TEST_F(MapRefusal, MAP12UpdatesGoOnBesideWhatIsRefused) {
  start({.parts = sender_->keys().size() - 2});
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(world_.tell(*sender_, world_.change()));
    bytes_in(1);
  }
  bytes_in(10);
  expect_told();
  EXPECT_EQ(sender_->hash(1), receiver_->hash());
}

}  // namespace
}  // namespace deltamesh::map_refusal_test
