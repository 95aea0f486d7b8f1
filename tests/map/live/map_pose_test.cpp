// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A loop closure moves a map by one message [MAP-23].
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"

namespace deltamesh::map_pose_test {
namespace {

constexpr MapPose kPose{.stamp = 17, .rotation = {0.6, 0, 0, 0.8}, .translation = {1e7 + 0.001, -2, 3}};

TEST(MapPose, MAP23ComesBackAndIsChecked) {
  const auto written = write_pose({.map = 1, .start = 2, .number = 3, .pose = kPose});
  ASSERT_TRUE(written);
  const auto read = read_pose(*written);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pose, kPose);
  EXPECT_EQ(read->number, 3U);
  MapPose wrong = kPose;
  wrong.rotation[0] = 0.61;
  EXPECT_STREQ(write_pose({.pose = wrong}).error().rule, "MAP-23");
  wrong = kPose;
  wrong.translation[1] = std::numeric_limits<double>::infinity();
  EXPECT_STREQ(write_pose({.pose = wrong}).error().rule, "MAP-23");
  for (std::size_t size = 0; size < written->size(); ++size)
    EXPECT_FALSE(read_pose(std::span(*written).first(size)));
}

TEST(MapPose, MAP23MovesTheMapByOneMessageWhichIsSentAgainWhereItIsLost) {
  auto sender = MapSender::make({.id = 1});
  ASSERT_TRUE(sender);
  Mesh mesh;
  mesh.positions = {0, 0, 0, 0.1F, 0, 0, 0, 0.1F, 0};
  mesh.triangles = {0, 1, 2};
  ASSERT_TRUE(sender->update(std::vector<MapBlock>{{{0, 0, 0}, mesh}}));
  MapReceiver receiver(1, 1);
  double now = 0;
  const auto talk = [&](bool is_lost) {
    now += 0.5;
    std::size_t count = 0;
    const auto said = receiver.messages(now);
    EXPECT_TRUE(said);
    for (const auto& message : *said) EXPECT_TRUE(sender->hear(message, now));
    const auto messages = sender->messages_for(1, now);
    EXPECT_TRUE(messages);
    for (const auto& message : *messages) {
      ++count;
      if (!is_lost) {
        EXPECT_TRUE(receiver.apply(message));
      }
    }
    return count;
  };
  for (int i = 0; i < 4; ++i) talk(false);
  EXPECT_EQ(receiver.shown(), sender->keys());
  EXPECT_EQ(receiver.pose(), nullptr);
  ASSERT_TRUE(sender->set_pose(kPose));
  EXPECT_EQ(talk(true), 1U);
  for (int i = 0; i < 10 && receiver.pose() == nullptr; ++i) talk(false);
  ASSERT_NE(receiver.pose(), nullptr);
  EXPECT_EQ(*receiver.pose(), kPose);
  for (int i = 0; i < 3; ++i) talk(false);
  EXPECT_EQ(talk(false), 0U);
  MapPose later = kPose;
  later.stamp = 18;
  ASSERT_TRUE(sender->set_pose(later));
  EXPECT_EQ(talk(false), 1U);
  EXPECT_EQ(receiver.pose()->stamp, 18U);
  EXPECT_FALSE(sender->set_pose({.rotation = {1, 1, 0, 0}}));
}

}  // namespace
}  // namespace deltamesh::map_pose_test
