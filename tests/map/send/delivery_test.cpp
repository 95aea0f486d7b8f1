// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a sender makes of late, lost and missing replies.
#include "send/link/delivery.h"

#include <gtest/gtest.h>

#include "deltamesh/map/receiver.h"
#include "map/map_world.h"
#include "send/viewer_state.h"

namespace deltamesh {
namespace {

constexpr PartKey kKey{0, 1, 2, 3};

std::uint64_t send(Delivery& delivery, double now) {
  const std::uint64_t number = delivery.next_number();
  delivery.add({.key = kKey, .bytes = std::vector<std::byte>(100), .is_whole = true});
  (void)delivery.send_next(now);
  return number;
}

/// Replies of a link, until 10.
Delivery measured_delivery(double round_trip = 0.05) {
  Delivery delivery;
  for (double now = 8; now < 10; now += 0.4) {
    const std::uint64_t number = send(delivery, now);
    delivery.hear({number, {}}, now + round_trip);
  }
  return delivery;
}

TEST(MapDelivery, MAP21WhatIsBehindLateMessagesIsInAQueueAndNotLost) {
  Delivery delivery = measured_delivery();
  const std::uint64_t first = send(delivery, 10);
  for (int i = 1; i < 40; ++i) (void)send(delivery, 10 + 0.05 * i);
  for (int i = 0; i < 8; ++i) delivery.hear({first - 1, {}}, 10 + 0.25 * i);
  for (int i = 0; i < 40; ++i) {  // four a second: what a slower link carries
    const double now = 12 + 0.25 * i;
    delivery.hear({first + static_cast<std::uint64_t>(i), {}}, now);
    EXPECT_TRUE(delivery.take_lost(now + 0.2).empty()) << i;
    EXPECT_TRUE(i == 39 || delivery.room(now + 0.2) <= 1) << i;
  }
}

TEST(MapDelivery, MAP21TheEndOfWhatIsSentIsUnseenWhereRepliesTakeLong) {
  Delivery delivery = measured_delivery(0.3);
  const std::uint64_t last = send(delivery, 11);
  EXPECT_FALSE(delivery.is_end_unseen(11.01));
  EXPECT_TRUE(delivery.is_end_unseen(11.05));
  delivery.hear({last - 1, {}}, 11.1);
  EXPECT_TRUE(delivery.is_end_unseen(11.2));
  delivery.hear({last, {}}, 11.3);
  EXPECT_FALSE(delivery.is_end_unseen(11.35));
  Delivery fast = measured_delivery(0.05);
  (void)send(fast, 11);
  EXPECT_FALSE(fast.is_end_unseen(11.05));
}

TEST(MapDelivery, MAP21WhatWasGivenUpAndMayStillComeIsInAQueue) {
  Delivery delivery = measured_delivery();
  const std::uint64_t first = send(delivery, 10);
  for (int i = 1; i < 40; ++i) delivery.forget(send(delivery, 10 + 0.05 * i));
  // After half a minute the link works again, slowly; what it brings first was sent again and tells nothing.
  for (double now = 40; now < 50; now += 0.5) {
    delivery.hear({first, {}}, now);
    (void)delivery.take_lost(now);
    EXPECT_LE(delivery.room(now), 1) << now;
  }
  delivery.hear({send(delivery, 50), {}}, 50.1);
  EXPECT_GT(delivery.room(50.1), 1000);
}

TEST(MapDelivery, MAP21WhatIsSentAgainDoesNotDelayTheNewMessageThatTellsWhetherThereIsAQueue) {
  Delivery delivery = measured_delivery();
  const std::uint64_t first = send(delivery, 10);
  for (int i = 1; i < 10; ++i) delivery.forget(send(delivery, 10));
  delivery.hear({first - 1, {}}, 12);
  (void)delivery.send_again(first, 12);
  EXPECT_EQ(delivery.room(12), 1);
  const std::uint64_t next = send(delivery, 12);
  EXPECT_EQ(delivery.room(12.05), 0);
  delivery.hear({next, {}}, 12.05);
  EXPECT_GT(delivery.room(12.05), 1000);
}

TEST(MapDelivery, MAP21WhatIsLostIsSentTwiceWhereALinkIsSlowAndHasRoom) {
  EXPECT_FALSE(Delivery().is_slow());
  EXPECT_FALSE(measured_delivery().is_slow());
  Delivery delivery = measured_delivery(0.3);
  std::vector<std::uint64_t> numbers;
  for (int i = 0; i < 40; ++i) numbers.push_back(send(delivery, 10));
  EXPECT_TRUE(delivery.is_slow());
  double now = 13;
  for (int i = 0; i < 5; ++i) delivery.hear({numbers[static_cast<std::size_t>(i)], {}}, now += 0.1);
  EXPECT_FALSE(delivery.is_slow());  // a thousand bytes a second, and more than that is on the way
  delivery.hear({numbers.back(), {}}, now + 3.5);
  EXPECT_TRUE(delivery.is_slow());
}

TEST(MapDelivery, MAP21TheFirstRepliesMayHaveWaitedInAQueueToo) {
  Delivery delivery;
  std::vector<std::uint64_t> numbers;
  for (int i = 0; i < 80; ++i) numbers.push_back(send(delivery, 10));
  double now = 10;
  for (; now < 15; ++now) delivery.hear({}, now);
  for (const std::uint64_t number : numbers) delivery.hear({number, {}}, now += 0.1);
  // A thousand bytes a second: what it takes in two seconds may be on the way.
  EXPECT_LE(delivery.room(now), 2500);
}

TEST(MapDelivery, MAP21ALimitGrowsWithTheLargestOfWhatComesInTimeNotTheFirst) {
  Congestion congestion;
  congestion.measure(0, 0.3, 0.3, 100, 0.3);
  congestion.measure(0.5, 3, 3, 3000, 3.5);
  ASSERT_LE(congestion.limit(), 1024);
  for (double now = 4.5, flight = 100; now < 4.8; now += 0.05, flight += 150)
    congestion.measure(4, now - 4, now - 4, flight, now);
  EXPECT_GE(congestion.limit(), 2048);
}

TEST(MapDelivery, MAP21WhatComesAfterItWasGivenUpIsMeasured) {
  Delivery delivery = measured_delivery();
  const double before = delivery.timeout();
  const std::uint64_t number = send(delivery, 11);
  delivery.forget(number);
  delivery.hear({number - 1, {}}, 12.4);
  delivery.hear({number, {}}, 12.5);
  EXPECT_GT(delivery.timeout(), 2 * before);
}

TEST(MapDelivery, MAP21TheLastMessageIsSentAgainAfterTwoRoundTrips) {
  Delivery delivery = measured_delivery();
  const std::uint64_t number = send(delivery, 11);
  EXPECT_EQ(delivery.probe(11.05), std::nullopt);
  EXPECT_EQ(delivery.probe(11.2), number);
  (void)delivery.send_again(number, 11.2);
  EXPECT_EQ(delivery.probe(11.5), std::nullopt);
  EXPECT_EQ(delivery.probe(12.3), number);  // that may be lost too
  (void)delivery.next_number();
  delivery.add({.key = kKey, .bytes = std::vector<std::byte>(100)});
  EXPECT_EQ(delivery.probe(14), std::nullopt);  // it was not sent at all
}

TEST(MapDelivery, MAP21WhatIsLateInAQueueAndNotLostIsSentOnce) {
  Viewer viewer{.delivery = measured_delivery(0.3)};
  const std::uint64_t first = send(viewer.delivery, 11);
  const std::uint64_t second = send(viewer.delivery, 11);
  viewer.delivery.hear({first, {}}, 12);
  std::vector<std::vector<std::byte>> messages;
  recover(viewer, 12.1, messages);
  EXPECT_EQ(messages.size(), 1U);
  EXPECT_TRUE(viewer.delivery.is_on_the_way(second));
}

TEST(MapDelivery, MAP21WhereAllOfTheFirstMessagesAreLostOthersFollow) {
  Delivery delivery;
  for (int i = 0; i < 6; ++i) delivery.forget(send(delivery, 10));
  int sent = 0;
  for (double now = 10; now < 20; now += 0.25) {
    delivery.hear({}, now);
    if (delivery.room(now) > 0 && now > 10) ++sent, delivery.forget(send(delivery, now));
  }
  EXPECT_GE(sent, 5);
}

TEST(MapDelivery, MAP21ARemovalThatIsTakenBackLeavesWhatTheOneBeforeWaitsFor) {
  Viewer viewer;
  viewer.delivery = measured_delivery();
  const Believed before{.revision = 5, .is_gone = true, .in_place = {kKey}};
  const PartKey key{1, 0, 0, 0};
  const std::uint64_t number = viewer.delivery.next_number();
  viewer.delivery.add({.key = key, .bytes = std::vector<std::byte>(30), .before = before});
  (void)viewer.delivery.send_next(11);
  viewer.has[key] = {.revision = 6, .stage = Believed::Stage::kSent, .is_gone = true, .number = number};
  std::vector<std::vector<std::byte>> messages;
  recover(viewer, 20, messages);
  EXPECT_EQ(viewer.has[key].revision, 5U);
  EXPECT_EQ(viewer.has[key].in_place, before.in_place);
}

TEST(MapDelivery, MAP21WhoSpeaksGetsTheMapsMessageSoon) {
  auto sender = MapSender::make(test::World::description(), {});
  ASSERT_TRUE(sender);
  MapReceiver receiver(1, test::World::description().id);
  for (int tick = 0; tick < 200; ++tick) {
    const double now = 0.05 * tick;
    const auto said = receiver.messages(now);
    ASSERT_TRUE(said);
    for (const auto& message : *said) ASSERT_TRUE(sender->hear(message, now));
    if (sender->viewers().empty()) continue;
    const auto messages = sender->messages_for(1, now);
    ASSERT_TRUE(messages);
    // All is lost for eight seconds.
    for (const auto& message : *messages) EXPECT_TRUE(now < 8 || receiver.apply(message));
    EXPECT_TRUE(now < 8.5 || receiver.description() != nullptr) << now;
  }
}

}  // namespace
}  // namespace deltamesh
