// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Viewers that come and go, move on and start again.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"

namespace deltamesh::map_viewers_test {
namespace {

using Bytes = std::vector<std::byte>;

Mesh square(float x) {
  Mesh mesh;
  mesh.positions = {x, 0, 0, x + 1, 0, 0, x, 1, 0, x + 1, 1, 0};
  mesh.triangles = {0, 1, 2, 1, 3, 2};
  return mesh;
}

/// A row of 20 squares.
class MapViewers : public testing::Test {
 protected:
  MapViewers() { start(-6); }

  void start(int step_exponent) {
    MapDescription description{.id = 1, .epoch = 1, .frame = "map"};
    description.lattice.step_exponent = step_exponent;
    description.cell_steps = 1U << -step_exponent;
    auto sender =
        MapSender::make(description, {.split = {.most_triangles = 1, .most_level = 0}, .most_viewers = 4});
    ASSERT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    std::vector<Mesh> meshes;
    for (int x = 0; x < 20; ++x) meshes.push_back(square(static_cast<float>(x)));
    std::vector<MapBlock> blocks;
    for (int x = 0; x < 20; ++x) blocks.push_back({{x, 0, 0}, meshes[static_cast<std::size_t>(x)]});
    ASSERT_TRUE(sender_->update(blocks));
  }

  static View view_from(float x) {
    View view;
    view.max_error = 0.05F;
    view.boxes = {{{x + 0.1F, 0.1F, -1}, {x + 3.9F, 0.9F, 1}}};
    return view;
  }

  void talk(MapReceiver& receiver, std::uint64_t viewer, int rounds = 6) {
    for (int i = 0; i < rounds; ++i) {
      now_ += 0.3;
      for (const Bytes& message : say(receiver)) ASSERT_TRUE(sender_->hear(message, now_));
      const auto messages = sender_->messages_for(viewer, now_);
      ASSERT_TRUE(messages) << describe(messages.error());
      for (const Bytes& message : *messages) ASSERT_TRUE(receiver.apply(message));
    }
  }
  std::vector<Bytes> say(MapReceiver& receiver) const {
    auto said = receiver.messages(now_);
    EXPECT_TRUE(said);
    return *std::move(said);
  }

  std::unique_ptr<MapSender> sender_;
  double now_ = 0;
};

TEST_F(MapViewers, MAP12WhoJoinsLateSeesAGrownMapPartByPart) {
  for (int x = 20; x < 40; ++x) {  // each shares its border with the one before
    const Mesh mesh = square(static_cast<float>(x));
    const std::vector<MapBlock> blocks = {{{x, 0, 0}, mesh}};
    ASSERT_TRUE(sender_->update(blocks));
  }
  MapReceiver receiver(1, 1);
  View view;
  view.max_error = 0.05F;
  receiver.set_view(view);
  std::size_t parts = 0;
  for (int i = 0; i < 10; ++i) {
    now_ += 0.3;
    for (const Bytes& message : say(receiver)) ASSERT_TRUE(sender_->hear(message, now_));
    const auto messages = sender_->messages_for(1, now_);
    ASSERT_TRUE(messages);
    for (const Bytes& message : *messages) {
      EXPECT_FALSE(read_entry(message, 0)) << "a part once more";
      ASSERT_TRUE(receiver.apply(message));
      if (read_part(message)) ++parts;
      EXPECT_EQ(receiver.shown().size(), parts);
    }
  }
  EXPECT_EQ(parts, 40U);
}

TEST_F(MapViewers, SilentOnesMakeRoom) {
  for (std::uint64_t viewer = 1; viewer <= 70; ++viewer) {  // restarts, every two seconds
    MapReceiver receiver(viewer, 1);
    receiver.set_view(view_from(0));
    talk(receiver, viewer);
    EXPECT_EQ(receiver.shown().size(), 4U);
    now_ += 0.2;
  }
  EXPECT_LE(sender_->viewers().size(), 4U);
  for (const double end = now_ + 61; now_ < end; now_ += 2)  // a longer step is a clock that was set
    EXPECT_FALSE(sender_->messages_for(1000, now_));
  MapReceiver last(100, 1);
  talk(last, 100, 1);
  EXPECT_EQ(sender_->viewers(), std::vector<std::uint64_t>{100});
}

TEST_F(MapViewers, SilentOnesAreForgottenAlthoughNobodyElseSpeaks) {
  for (const std::uint64_t viewer : {1, 2}) {
    MapReceiver receiver(viewer, 1);
    receiver.set_view(view_from(0));
    talk(receiver, viewer);
  }
  ASSERT_EQ(sender_->viewers().size(), 2U);
  for (const double end = now_ + 63; now_ < end; now_ += 0.5)
    for (const std::uint64_t viewer : sender_->viewers()) EXPECT_TRUE(sender_->messages_for(viewer, now_));
  EXPECT_TRUE(sender_->viewers().empty());
}

/// Of two that change together, and then are outside of the view, one is lost.
TEST_F(MapViewers, MAP15WhatWaitsBesideTheViewGoesSoThatBothSidesKnowWhatIsShown) {
  MapReceiver receiver(1, 1);
  receiver.set_view(view_from(0));
  talk(receiver, 1);
  ASSERT_EQ(receiver.shown().size(), 4U);
  Mesh left = square(0);
  Mesh right = square(1);
  for (const std::size_t corner : {1, 3}) left.positions[3 * corner + 2] = 0.25F;
  for (const std::size_t corner : {0, 2}) right.positions[3 * corner + 2] = 0.25F;
  ASSERT_TRUE(sender_->update(std::vector<MapBlock>{{{0, 0, 0}, left}, {{1, 0, 0}, right}}));
  now_ += 0.3;
  const auto messages = sender_->messages_for(1, now_);
  ASSERT_TRUE(messages);
  ASSERT_EQ(messages->size(), 2U);
  ASSERT_TRUE(receiver.apply(messages->front()));
  receiver.set_view(view_from(10));
  talk(receiver, 1, 40);
  EXPECT_EQ(receiver.hash(), sender_->hash(1));
  EXPECT_EQ(receiver.shown().size(), 7U);
  receiver.set_view(view_from(0));
  talk(receiver, 1);
  EXPECT_EQ(receiver.hash(), sender_->hash(1));
  EXPECT_EQ(receiver.shown().size(), 8U);
}

TEST_F(MapViewers, MAP15AViewThatComesAfterALaterReceiptCounts) {
  MapReceiver receiver(1, 1);
  receiver.set_view(view_from(0));
  talk(receiver, 1);
  receiver.set_view(view_from(10));
  const auto late = read_view(*receiver.view_message());
  ASSERT_TRUE(late);
  ASSERT_TRUE(sender_->hear(
      *write_receipt({1, late->number + 1, 1, late->start, {late->receipt.highest, {}}}), now_));
  ASSERT_TRUE(sender_->hear(*write_view(*late), now_));
  const auto messages = sender_->messages_for(1, now_);
  ASSERT_TRUE(messages);
  for (const Bytes& message : *messages) ASSERT_TRUE(receiver.apply(message));
  EXPECT_NE(receiver.find({0, 13, 0, 0}), nullptr);
}

TEST_F(MapViewers, ANumberThatIsUsedAgainBeginsAnew) {
  for (int life = 0; life < 3; ++life) {
    MapReceiver receiver(7, 1);
    receiver.set_view(view_from(0));
    talk(receiver, 7, 10 - life);
    EXPECT_EQ(receiver.shown().size(), 4U) << life;
    now_ += 0.3;
  }
}

TEST_F(MapViewers, MAP12WhatWasSentToTheEarlierReceiverOfANumberMayStillCome) {
  MapReceiver receiver(7, 1);
  View view = view_from(0);
  view.boxes[0].high[1] = 2;
  receiver.set_view(view);
  const std::vector<Bytes> first = say(receiver);  // one comes late, and is taken for another receiver's
  talk(receiver, 7, 1);
  for (const Bytes& message : say(receiver)) ASSERT_TRUE(sender_->hear(message, now_));
  const auto on_the_way = sender_->messages_for(7, now_);
  ASSERT_TRUE(on_the_way);
  ASSERT_GE(on_the_way->size(), 4U);
  ASSERT_TRUE(receiver.apply(on_the_way->back()));  // first
  now_ += 1;
  for (const Bytes& message : first) ASSERT_TRUE(sender_->hear(message, now_));
  // Three squares go, and behind the second one comes one that rises from where that was.
  Mesh higher = square(1);
  for (std::size_t i = 0; i < higher.positions.size(); i += 3) {
    higher.positions[i + 1] += 1;
    if (i > 0) higher.positions[i + 2] = 0.25F;
  }
  const Mesh nothing;
  ASSERT_TRUE(sender_->update(std::vector<MapBlock>{
      {{0, 0, 0}, nothing}, {{1, 0, 0}, nothing}, {{2, 0, 0}, nothing}, {{1, 1, 0}, higher}}));
  talk(receiver, 7, 8);
  ASSERT_NE(receiver.find({0, 1, 1, 0}), nullptr);
  for (const Bytes& message : *on_the_way) ASSERT_TRUE(receiver.apply(message));
  EXPECT_EQ(receiver.find({0, 1, 0, 0}), nullptr);
}

TEST_F(MapViewers, WhatIsFarFromTheViewMakesRoom) {
  MapReceiver receiver(1, 1, {.parts = 6});
  for (int x = 0; x <= 16; x += 2) {
    receiver.set_view(view_from(static_cast<float>(x)));
    talk(receiver, 1, 8);
    for (int i = 0; i < 4; ++i) EXPECT_NE(receiver.find({0, x + i, 0, 0}), nullptr) << x << " " << i;
    EXPECT_LE(receiver.shown().size(), 6U);
  }
  receiver.set_view(view_from(0));  // and back
  talk(receiver, 1, 8);
  EXPECT_NE(receiver.find({0, 0, 0, 0}), nullptr);
  // By hand: what is in the view comes again, the rest does not.
  for (const PartKey& key : receiver.shown()) receiver.drop(key);
  EXPECT_TRUE(receiver.shown().empty());
  talk(receiver, 1);
  EXPECT_EQ(receiver.shown().size(), 4U);
}

TEST_F(MapViewers, AnotherLatticeIsTaken) {
  MapReceiver receiver(1, 1);
  receiver.set_view(view_from(0));
  talk(receiver, 1);
  EXPECT_EQ(receiver.shown().size(), 4U);
  start(-7);  // the same id and epoch
  talk(receiver, 1, 8);
  EXPECT_EQ(receiver.description()->lattice.step_exponent, -7);
  EXPECT_EQ(receiver.shown().size(), 4U);
}

}  // namespace
}  // namespace deltamesh::map_viewers_test
