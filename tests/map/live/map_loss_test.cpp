// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is lost on the way is noticed by its number, and sent again within one exchange if nothing newer takes
// its place [MAP-21].
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "message/frame.h"
#include "support/grid_triangles.h"

namespace deltamesh::map_loss_test {
namespace {

using Bytes = std::vector<std::byte>;
using Messages = std::vector<Bytes>;

/// A sheet of 12 x 12 squares on [0, 1) x [0, 1), lifted at its corner by `height`.
Mesh sheet(float x, float height) {
  Mesh mesh;
  constexpr std::uint32_t kEdge = 12;
  for (std::uint32_t j = 0; j <= kEdge; ++j)
    for (std::uint32_t i = 0; i <= kEdge; ++i)
      for (const float coordinate : {x + static_cast<float>(i) / kEdge, static_cast<float>(j) / kEdge,
                                     i < 3 && j < 3 ? height : 0.25F})
        mesh.positions.push_back(coordinate);
  mesh.triangles = test::grid_triangles(kEdge + 1, kEdge + 1);
  return mesh;
}

/// Blocks far apart, so that each is a group of its own.
class MapLoss : public testing::Test {
 protected:
  MapLoss() : receiver_(1, 1) {
    MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 64};
    description.lattice.step_exponent = -6;
    auto sender = MapSender::make(description, {.split = {.most_triangles = 1, .most_level = 0}});
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    View view;
    view.max_error = 0.02F;
    receiver_.set_view(view);
    set(0, 0.25F);
    set(4, 0.25F);
    for (int i = 0; i < 4; ++i) apply(exchange());
    EXPECT_EQ(receiver_.shown().size(), 2U);
  }

  void set(std::int32_t x, float height) {
    const Mesh mesh = sheet(static_cast<float>(x), height);
    const std::vector<MapBlock> blocks = {{{x, 0, 0}, mesh}};
    EXPECT_TRUE(sender_->update(blocks));
  }

  Messages ask() {
    const auto messages = sender_->messages_for(1, now_);
    EXPECT_TRUE(messages);
    return *messages;
  }
  void apply(const Messages& messages) {
    for (const Bytes& message : messages) EXPECT_TRUE(receiver_.apply(message));
  }
  /// What the receiver says now.
  Messages said() {
    const auto messages = receiver_.messages(now_);
    EXPECT_TRUE(messages);
    return *messages;
  }
  /// The sender hears it.
  void tell() {
    for (const Bytes& message : said()) EXPECT_TRUE(sender_->hear(message, now_));
  }
  /// What the sender answers 10 ms later.
  Messages exchange() {
    tell();
    now_ += 0.01;
    return ask();
  }
  /// Over a link that takes 0.15 s: a change of the other block arrives, and its receipt is answered.
  Messages exchange_slowly() {
    constexpr double kWay = 0.15;  // seconds
    other_height_ = 0.75F - other_height_;
    set(4, other_height_);
    const Messages other = ask();
    now_ += kWay;
    apply(other);
    const Messages receipts = said();
    now_ += kWay;
    for (const Bytes& message : receipts) EXPECT_TRUE(sender_->hear(message, now_));
    return ask();
  }
  bool shows(std::int32_t x, float height) const {
    const auto& p = receiver_.find({0, x, 0, 0})->mesh.positions;
    for (std::size_t i = 2; i < p.size(); i += 3)
      if (std::abs(p[i] - height) < 0.03F) return true;
    return false;
  }

  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  double now_ = 0;
  float other_height_ = 0.25F;
};

TEST_F(MapLoss, MAP21AGapIsAskedForAtOnce) {
  set(0, 0.5F);
  ASSERT_EQ(ask().size(), 1U);  // lost
  set(4, 0.5F);
  apply(ask());
  const Messages receipts = said();
  ASSERT_EQ(receipts.size(), 1U);
  const auto receipt = read_receipt(receipts.front());
  ASSERT_TRUE(receipt);
  EXPECT_EQ(receipt->receipt.missing, std::vector{receipt->receipt.highest - 1});
  EXPECT_LT(receipts.front().size(), 40U);
  // Within this exchange, long before any reply is overdue.
  ASSERT_TRUE(sender_->hear(receipts.front(), now_));
  apply(ask());
  EXPECT_TRUE(shows(0, 0.5F));
}

TEST_F(MapLoss, MAP21WhatIsSupersededIsNotSentAgain) {
  set(0, 0.5F);
  const Messages lost = ask();
  ASSERT_EQ(lost.size(), 1U);
  set(4, 0.5F);
  apply(ask());
  set(0, 0.75F);
  tell();
  const Messages again = ask();  // the newest alone, of what the receiver has
  ASSERT_EQ(again.size(), 1U);
  EXPECT_NE(again, lost);
  apply(again);
  EXPECT_TRUE(shows(0, 0.75F));
  EXPECT_FALSE(shows(0, 0.5F));
}

TEST_F(MapLoss, MAP21APatchWaitsForItsBase) {
  set(0, 0.5F);
  const Messages first = ask();
  set(0, 0.75F);
  const Messages second = ask();
  ASSERT_EQ(second.size(), 1U);
  ASSERT_TRUE(read_patch(second.front()));
  apply(second);
  EXPECT_TRUE(shows(0, 0.25F));
  EXPECT_FALSE(shows(0, 0.75F));
  const Messages again = exchange();  // the one that the second is made from, as it was
  ASSERT_FALSE(again.empty());
  EXPECT_EQ(again.front(), first.front());
  apply(again);
  EXPECT_TRUE(shows(0, 0.75F));
  EXPECT_TRUE(exchange().empty());
}

TEST_F(MapLoss, MAP21WhatTakesThePlaceOfALostPatchIsAPatchOfWhatTheReceiverHas) {
  set(0, 0.5F);
  const Messages lost = ask();
  ASSERT_EQ(lost.size(), 1U);
  ASSERT_TRUE(read_patch(lost.front()));
  set(4, 0.5F);
  apply(ask());
  set(0, 0.75F);
  tell();
  const Messages again = ask();
  ASSERT_EQ(again.size(), 1U);
  EXPECT_TRUE(read_patch(again.front()));
  apply(again);
  EXPECT_TRUE(shows(0, 0.75F));
}

TEST_F(MapLoss, MAP21TheLaterWhatIsLostComesTheMoreOftenItIsSentWhereALinkIsSlow) {
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(exchange_slowly().empty());
  set(0, 0.5F);
  ASSERT_EQ(ask().size(), 1U);  // lost
  const Messages again = exchange_slowly();
  ASSERT_EQ(again.size(), 2U);  // lost as well
  EXPECT_EQ(again.front(), again.back());
  const Messages later = exchange_slowly();
  EXPECT_EQ(later.size(), 3U);
  apply(later);
  EXPECT_TRUE(shows(0, 0.5F));
}

TEST_F(MapLoss, MAP21WhatWasLostAndIsNotNeededAnyMoreIsNotLate) {
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(exchange_slowly().empty());
  set(0, 0.5F);
  ASSERT_EQ(ask().size(), 1U);  // lost
  const View all = receiver_.view();
  View other = all;
  other.boxes = {{{4, 0, 0}, {5, 1, 1}}};
  receiver_.set_view(other);
  tell();
  for (int i = 0; i < 10; ++i) apply(exchange_slowly());
  receiver_.set_view(all);
  tell();
  const Messages messages = ask();
  EXPECT_EQ(messages.size(), 1U);
  apply(messages);
  EXPECT_TRUE(shows(0, 0.5F));
}

TEST_F(MapLoss, MAP21TheLastMessageIsSentAgainWhenAReplyIsOverdue) {
  set(0, 0.5F);
  ASSERT_EQ(ask().size(), 1U);  // lost, and nothing follows
  now_ += 0.02;
  EXPECT_TRUE(ask().empty());
  now_ += 1.1;
  apply(ask());
  EXPECT_TRUE(shows(0, 0.5F));
}

TEST_F(MapLoss, MAP21OnASlowLinkTheLossOfTheLastMessageIsSeenAtOnce) {
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(exchange_slowly().empty());
  set(0, 0.5F);
  ASSERT_EQ(ask().size(), 1U);  // lost, and nothing follows
  now_ += 0.05;
  const Messages end = ask();
  ASSERT_EQ(end.size(), 1U);
  EXPECT_TRUE(read_start(end.front()));
  EXPECT_LT(end.front().size(), 30U);
  EXPECT_TRUE(ask().empty());
  now_ += 0.15;
  apply(end);
  const Messages receipts = said();
  ASSERT_EQ(receipts.size(), 1U);
  const auto receipt = read_receipt(receipts.front());
  ASSERT_TRUE(receipt);
  EXPECT_EQ(receipt->receipt.missing, std::vector{receipt->receipt.highest - 1});
  now_ += 0.15;
  ASSERT_TRUE(sender_->hear(receipts.front(), now_));
  apply(ask());
  EXPECT_TRUE(shows(0, 0.5F));
}

TEST_F(MapLoss, MAP21TheEndThatIsLostItselfIsNotSentAgain) {
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(exchange_slowly().empty());
  set(0, 0.5F);
  apply(ask());
  now_ += 0.05;
  ASSERT_EQ(ask().size(), 1U);  // the end, lost
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(exchange_slowly().empty());
}

TEST_F(MapLoss, MAP21NothingIsSentToASilentViewer) {
  set(0, 0.5F);
  for (int call = 0; call < 5; ++call) {
    (void)ask();
    now_ += 1.2;
  }
  set(0, 0.75F);
  EXPECT_TRUE(ask().empty());
  apply(exchange());
  EXPECT_TRUE(shows(0, 0.75F));
}

TEST_F(MapLoss, MAP21NoViewerIsSilentBecauseAClockWasSet) {
  set(0, 0.5F);
  (void)ask();
  now_ += 100;
  set(0, 0.75F);
  apply(ask());
  EXPECT_TRUE(shows(0, 0.75F));
}

TEST_F(MapLoss, MAP21LittleWaitsOnALinkThatKeepsWhatIsSaidForHalfAMinute) {
  MapReceiver receiver(2, 1);
  std::size_t bytes = 0;
  for (double now = 0; now < 30; now += 0.05) {
    const auto said = receiver.messages(now);
    ASSERT_TRUE(said);
    for (const Bytes& message : *said) bytes += message.size() + 28;  // with headers
  }
  EXPECT_LE(bytes, 5000U);
}

TEST_F(MapLoss, MAP21ReceiptsAreFew) {
  std::size_t messages = 0;
  std::size_t bytes = 0;
  const double end = now_ + 10;
  for (int tick = 0; now_ < end; ++tick) {
    if (tick % 20 == 0) {
      set(0, 0.3F + 0.01F * static_cast<float>(tick % 7));
      apply(ask());
    }
    for (const Bytes& message : said()) {
      ++messages;
      bytes += message.size();
      ASSERT_TRUE(sender_->hear(message, now_));
    }
    now_ += 0.01;
  }
  EXPECT_LE(messages, 10U * 2 * 5 + 20);
  EXPECT_LE(bytes / messages, 60U);
}

TEST(MapReceipt, MAP21ReceiptsAreReadAsTheyAreWritten) {
  ReceiptMessage message{.viewer = 4, .number = 1000, .map_id = 6, .start = 8};
  EXPECT_EQ(*read_receipt(*write_receipt(message)), message);
  message.receipt = {.highest = 300, .missing = {44, 45, 100, 299}};
  EXPECT_EQ(*read_receipt(*write_receipt(message)), message);
  for (const std::vector<std::uint64_t>& wrong :
       {std::vector<std::uint64_t>{43}, {300}, {0}, {100, 99}, {7, 7}}) {
    message.receipt.missing = wrong;
    EXPECT_STREQ(write_receipt(message).error().rule, "MAP-21");
  }
}

TEST(MapReceipt, MAP21ReceiptsWithBitsTooManyAreRefused) {
  const auto rule_of = [](std::uint64_t highest, const std::vector<std::uint8_t>& bits) {
    ByteWriter out = begin_message(MessageKind::kReceipt);
    out.write(std::uint64_t{1});
    out.write_varint(1);
    out.write(std::uint64_t{1});
    out.write_varint(1);
    out.write_varint(highest);
    out.write(static_cast<std::uint8_t>(bits.size()));
    for (const std::uint8_t byte : bits) out.write(byte);
    const auto read = read_receipt(end_message(std::move(out)));
    return std::string(read ? "" : read.error().rule);
  };
  EXPECT_EQ(rule_of(9, {1}), "");
  EXPECT_EQ(rule_of(9, {1, 0}), "MAP-21");  // longer than it needs to be
  EXPECT_EQ(rule_of(9, {0, 1}), "MAP-21");  // of the number 0
  EXPECT_EQ(rule_of(900, std::vector<std::uint8_t>(33, 1)), "MAP-21");
}

}  // namespace
}  // namespace deltamesh::map_loss_test
