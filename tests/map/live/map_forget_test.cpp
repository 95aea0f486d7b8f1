// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a sender forgets: parts that no longer exist, once no message about them can be on its way.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"

namespace deltamesh::map_forget_test {
namespace {

using Bytes = std::vector<std::byte>;

/// Two triangles on the square [x, x + 1) x [0, 1), lifted at its far side.
Mesh square(float x, float height) {
  Mesh mesh;
  mesh.positions = {x, 0, 0, x + 1, 0, height, x, 1, 0, x + 1, 1, height};
  mesh.triangles = {0, 1, 2, 1, 3, 2};
  return mesh;
}

class MapForget : public testing::Test {
 protected:
  MapForget() : receiver_(1, 1) {
    MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 64};
    description.lattice.step_exponent = -6;
    auto sender = MapSender::make(
        description, {.split = {.most_triangles = 1, .most_level = 0}, .keeps_good_enough = false});
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    View view;
    view.max_error = 0.05F;
    receiver_.set_view(view);
  }

  void set_block(std::int32_t x, const Mesh& mesh) {
    const std::vector<MapBlock> blocks = {{{x, 0, 0}, mesh}};
    EXPECT_TRUE(sender_->update(blocks));
  }

  /// The links of the parts that the receiver gets at `now`.
  std::vector<PartKey> links_at(double now) {
    EXPECT_TRUE(sender_->hear(*receiver_.view_message(), now));
    std::vector<PartKey> linked;
    const auto messages = sender_->messages_for(1, now);
    EXPECT_TRUE(messages);
    for (const Bytes& message : *messages) {
      if (const auto part = read_part(message))
        for (const PartLink& link : part->links) linked.push_back(link.key);
      EXPECT_TRUE(receiver_.apply(message));
    }
    return linked;
  }

  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
};

TEST_F(MapForget, RecordsOfPartsThatNoLongerExist) {
  const PartKey gone{.level = 0, .x = 0, .y = 0, .z = 0};
  set_block(0, square(0, 0));
  set_block(1, square(1, 0));
  for (const double now : {1.0, 3.0, 5.0}) links_at(now);
  ASSERT_EQ(receiver_.shown().size(), 2U);

  set_block(0, Mesh{});
  for (const double now : {7.0, 9.0}) links_at(now);
  ASSERT_EQ(receiver_.shown().size(), 1U);

  // An older version may still be on its way, beside which the neighbour must not be shown.
  set_block(1, square(1, 0.25F));
  const auto soon = links_at(11);
  EXPECT_NE(std::ranges::find(soon, gone), soon.end());
  links_at(13);

  set_block(1, square(1, 0.5F));
  for (double now = 15; now < 100; now += 2) EXPECT_FALSE(sender_->messages_for(1000, now));
  const auto later = links_at(100);
  EXPECT_EQ(std::ranges::find(later, gone), later.end());
  EXPECT_EQ(receiver_.shown().size(), 1U);

  // A part of the same key is a new one.
  set_block(0, square(0, 0.5F));
  for (const double now : {102.0, 104.0, 106.0}) links_at(now);
  EXPECT_EQ(receiver_.shown().size(), 2U);
  EXPECT_TRUE(sender_->messages_for(1, 108)->empty());
}

}  // namespace
}  // namespace deltamesh::map_forget_test
