// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A sender that comes back with another lattice under the same id [MAP-16], and limits of a sender's calls.
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <memory>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"

namespace deltamesh::map_epoch_test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::int32_t kBlocks = 20;

MapDescription description_of(std::int8_t exponent, std::uint32_t epoch) {
  MapDescription description{.id = 1, .epoch = epoch, .frame = "map"};
  description.lattice.step_exponent = exponent;
  description.cell_steps = std::uint32_t{1} << -exponent;
  return description;
}

std::unique_ptr<MapSender> sender_of(std::int8_t exponent, std::uint32_t epoch, SenderOptions options = {}) {
  options.split = {.most_triangles = 1, .most_level = 0};
  auto sender = MapSender::make(description_of(exponent, epoch), options);
  EXPECT_TRUE(sender);
  std::vector<Mesh> meshes;
  for (std::int32_t x = 0; x < kBlocks; ++x) {
    Mesh mesh = test::wavy_sheet(12, 12, static_cast<std::uint32_t>(x), 0.05);
    mesh.attributes.clear();
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3)
      mesh.positions[i] = mesh.positions[i] / 20 + static_cast<float>(x);
    meshes.push_back(std::move(mesh));
  }
  std::vector<MapBlock> blocks;
  for (std::int32_t x = 0; x < kBlocks; ++x)
    blocks.push_back({{x, 0, 0}, meshes[static_cast<std::size_t>(x)]});
  EXPECT_TRUE(sender->update(blocks));
  return std::make_unique<MapSender>(*std::move(sender));
}

MapReceiver receiver_of(std::uint64_t viewer) {
  MapReceiver receiver(viewer, 1);
  View view;
  view.max_error = 0.1F;
  receiver.set_view(view);
  return receiver;
}

/// Bytes of the messages of one call.
std::size_t talk(MapSender& sender, MapReceiver& receiver, std::uint64_t viewer, double now) {
  EXPECT_TRUE(sender.hear(*receiver.view_message(), now));
  const auto messages = sender.messages_for(viewer, now);
  EXPECT_TRUE(messages);
  std::size_t bytes = 0;
  for (const Bytes& message : *messages) {
    bytes += message.size();
    EXPECT_TRUE(receiver.apply(message));
  }
  return bytes;
}

TEST(MapEpoch, MAP16AnotherLatticeUnderTheSameIdBeginsAnEpoch) {
  for (const std::uint32_t epoch : {std::uint32_t{7}, std::uint32_t{0}}) {
    MapReceiver receiver = receiver_of(1);
    auto sender = sender_of(-6, 7);
    for (int i = 0; i < 3; ++i) talk(*sender, receiver, 1, i);
    EXPECT_EQ(receiver.shown(), sender->keys());
    const std::uint64_t revision = sender->revision();
    sender = sender_of(-7, epoch);
    sender->resume(revision, 100);
    for (int i = 0; i < 3; ++i) talk(*sender, receiver, 1, 10 + i);
    EXPECT_EQ(sender->description().epoch, 8U);
    ASSERT_NE(receiver.description(), nullptr);
    EXPECT_EQ(*receiver.description(), sender->description());
    EXPECT_EQ(receiver.shown(), sender->keys());
    EXPECT_EQ(receiver.hash(), sender->hash(1));
  }
}

TEST(MapEpoch, MAP16ReceiversCannotMakeEpochsForever) {
  auto sender = sender_of(-6, 0);
  ViewMessage message{.viewer = 1, .map_id = 1, .map = 5};
  unsigned heard = 0;
  for (std::uint32_t i = 1; i < 20; ++i) {
    message.number = i;
    message.epoch = 10 * i;
    if (sender->hear(*write_view(message), i)) ++heard;
  }
  EXPECT_EQ(heard, 8U);
  message.epoch = 0;
  EXPECT_TRUE(sender->hear(*write_view(message), 30));
}

TEST(MapCall, ACallEndsWhenItsTimeIsOverAndGoesOnInTheNext) {
  auto sender = sender_of(-6, 0, {.call_seconds = 1e-9});
  MapReceiver receiver = receiver_of(1);
  int calls = 0;
  for (; receiver.shown() != sender->keys() && calls < 3 * kBlocks; ++calls)
    talk(*sender, receiver, 1, calls);
  EXPECT_EQ(receiver.shown(), sender->keys());
  EXPECT_GE(calls, kBlocks);
  std::atomic<bool> cancel = true;
  auto cancelled = sender_of(-6, 0, {.cancel = &cancel});
  MapReceiver other = receiver_of(1);
  for (int i = 0; i < 3; ++i) talk(*cancelled, other, 1, i);
  EXPECT_LT(other.shown().size(), 3U);
  cancel = false;
  for (int i = 3; i < 6; ++i) talk(*cancelled, other, 1, i);
  EXPECT_EQ(other.shown(), cancelled->keys());
}

TEST(MapCall, MAP16WhatAReceiverHasOfAnEarlierSenderIsNotSentAgainWhereThereIsNoTimeToLookForItBefore) {
  for (const double call_seconds : {std::numeric_limits<double>::infinity(), 1e-9}) {
    MapReceiver receiver = receiver_of(1);
    auto sender = sender_of(-6, 0);
    for (int i = 0; i < 3; ++i) talk(*sender, receiver, 1, i);
    const std::uint64_t revision = sender->revision();
    sender = sender_of(-6, 0, {.call_seconds = call_seconds});
    sender->resume(revision, 100);
    for (int i = 0; i < 3 + 2 * kBlocks; ++i) talk(*sender, receiver, 1, 10 + i);
    EXPECT_EQ(receiver.hash(), sender->hash(1));
    EXPECT_EQ(sender->counts().encoded, std::uint64_t{kBlocks});
    EXPECT_EQ(sender->counts().parts_sent, 0U);
    EXPECT_LE(sender->counts().entries_sent, std::uint64_t{kBlocks});
  }
}

TEST(MapCall, AllViewersTogetherKeepTheSendersRate) {
  constexpr double kRate = 2000;
  auto sender = sender_of(-6, 0, {.bytes_per_second = static_cast<std::uint64_t>(kRate)});
  std::vector<MapReceiver> receivers;
  for (std::uint64_t viewer = 1; viewer <= 3; ++viewer) receivers.push_back(receiver_of(viewer));
  std::vector<double> bytes;  // of each tenth of a second
  for (int tick = 0; tick < 600; ++tick) {
    bytes.push_back(0);
    for (std::uint64_t viewer = 1; viewer <= 3; ++viewer)
      bytes.back() += static_cast<double>(talk(*sender, receivers[viewer - 1], viewer, 0.1 * tick));
  }
  for (std::size_t i = 0; i + 10 <= bytes.size(); ++i) {
    double second = 0;
    for (std::size_t k = i; k < i + 10; ++k) second += bytes[k];
    EXPECT_LE(second, kRate + 3 * 1000) << i;  // and a message for each
  }
  for (const MapReceiver& receiver : receivers) EXPECT_EQ(receiver.shown(), sender->keys());
}

}  // namespace
}  // namespace deltamesh::map_epoch_test
