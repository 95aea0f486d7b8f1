// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Small messages take little memory, whatever they say.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <cmath>
#include <ctime>
#include <limits>

#include "deltamesh/map/folder.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "deltamesh/map/split.h"
#include "map/map_meshes.h"
#include "map/map_world.h"
#include "part/codec_state.h"
#include "part/container.h"
#include "support/counted_memory.h"

namespace deltamesh {
namespace {

TEST(MapLimits, MAP7APartOf100BytesTakesLessThanAMegabyte) {
  const Mesh mesh = test::wavy_sheet(40, 40, 5, 0);
  MapDescription description{.cell_steps = 100, .attributes = test::attributes_of(mesh)};
  const auto parts = split(mesh, description, {.most_triangles = 300, .most_level = 4});
  const PartQuality quality{
      .bounds = {.max_error = QualityBound{0.01}}, .attributes = {.color_error = 20}, .effort = 1};
  description = *with_primers(description, *parts, quality);
  const auto codec = MapCodec::open(description);
  ASSERT_TRUE(codec);
  std::mt19937 random(3);
  std::size_t decoded = 0;
  for (int i = 0; i < 4000; ++i) {
    const MapPart& part = (*parts)[random() % parts->size()];
    static std::vector<std::vector<std::byte>> coded(parts->size());
    auto& known = coded[static_cast<std::size_t>(&part - parts->data())];
    if (known.empty()) known = codec->encode(part, quality)->bytes;
    auto bytes = known;
    bytes.resize(std::min<std::size_t>(bytes.size(), 96));
    for (auto k = random() % 4; k > 0; --k)
      bytes[random() % std::min<std::size_t>(bytes.size(), 24)] = static_cast<std::byte>(random() % 256);
    const std::uint32_t checksum = part_checksum(codec->state().place_of(part.key), bytes);
    for (unsigned k = 0; k < 4; ++k) bytes.push_back(static_cast<std::byte>(checksum >> (8 * k)));
    test::most_memory_from_now();
    const std::size_t before = test::memory_taken();
    decoded += codec->decode(part.key, bytes) ? 1 : 0;
    EXPECT_LT(test::most_memory() - before, std::size_t{1} << 20) << i;
  }
  EXPECT_LT(decoded, 4000U);
}

TEST(MapLimits, MAP5AMessageOf100BytesTakesLessThanAMegabyte) {
  MapDescription description{.cell_steps = 100};
  description.attributes = {{AttributeKind::kColor, ComponentType::kU8, 3, true, "red"}};
  const auto message = *write_description(description);
  std::mt19937 random(4);
  for (int i = 0; i < 4000; ++i) {
    auto bytes = message;
    bytes.resize(bytes.size() - 4);
    for (auto k = 1 + random() % 3; k > 0; --k)
      bytes[4 + random() % (bytes.size() - 4)] = static_cast<std::byte>(random() % 256);
    const auto checksum = static_cast<std::uint32_t>(XXH3_64bits(bytes.data(), bytes.size()));
    for (unsigned k = 0; k < 4; ++k) bytes.push_back(static_cast<std::byte>(checksum >> (8 * k)));
    test::most_memory_from_now();
    const std::size_t before = test::memory_taken();
    (void)read_description(bytes);
    EXPECT_LT(test::most_memory() - before, std::size_t{1} << 20) << i;
  }
}

/// At most 100 bytes of a message with some of them changed, and a checksum that fits.
std::vector<std::byte> damaged(std::vector<std::byte> message, std::mt19937& random) {
  message.resize(std::min<std::size_t>(message.size() - 4, 96));
  for (auto k = random() % 4; k > 0; --k)
    message[5 + random() % (message.size() - 5)] = static_cast<std::byte>(random() % 256);
  const auto checksum = static_cast<std::uint32_t>(XXH3_64bits(message.data(), message.size()));
  for (unsigned k = 0; k < 4; ++k) message.push_back(static_cast<std::byte>(checksum >> (8 * k)));
  return message;
}

TEST(MapLimits, MAP12NoMessageOf100BytesTakesAMegabyte) {
  const test::World world(3, 1);
  auto sender = MapSender::make(test::World::description(), {.effort = 0});
  ASSERT_TRUE(sender);
  ASSERT_TRUE(world.tell(*sender, world.present()));
  MapReceiver receiver(1, test::World::description().id);
  View view;
  view.max_error = 0.05F;
  receiver.set_view(view);
  // A whole talk, and a manifest of what it tells.
  std::vector<std::vector<std::byte>> messages;
  for (int now = 2; now < 10; now += 2) {
    messages.push_back(*receiver.view_message());
    ASSERT_TRUE(sender->hear(messages.back(), now));
    const auto answers = sender->messages_for(1, now);
    ASSERT_TRUE(answers);
    for (const auto& message : *answers) {
      ASSERT_TRUE(receiver.apply(message));
      messages.push_back(message);
    }
  }
  messages.push_back(*write_entry({.map = hash_of(sender->description()),
                                   .start = 1,
                                   .entry = {.key = sender->keys()[0], .revision = 50}}));
  messages.push_back(*write_manifest({.description = sender->description(), .revision = 1, .next_group = 1}));
  std::mt19937 random(5);
  for (int i = 0; i < 20000; ++i) {
    const auto message = damaged(messages[random() % messages.size()], random);
    ASSERT_LE(message.size(), 100U);
    MapReceiver fresh(2, test::World::description().id);
    ASSERT_TRUE(fresh.apply(*write_description(test::World::description())));
    test::most_memory_from_now();
    const std::size_t before = test::memory_taken();
    (void)fresh.apply(message);
    (void)sender->hear(message, i);
    (void)read_manifest(message);
    EXPECT_LT(test::most_memory() - before, std::size_t{1} << 20) << i;
  }
}

/// What it says takes memory while it says so, and others get their map all the same.
TEST(MapLimits, MAP15AHostileViewerCostsNoMoreThanItsLastMessage) {
  const test::World world(4, 1);
  auto sender = MapSender::make(test::World::description());
  ASSERT_TRUE(sender);
  ASSERT_TRUE(world.tell(*sender, world.present()));
  const std::uint64_t map = hash_of(sender->description());
  std::mt19937 random(1);
  double now = 0;
  std::size_t after_ten = 0;
  constexpr std::int32_t kHeld = 500;
  for (std::uint64_t i = 1; i <= 300; ++i) {
    now += 0.1;
    ViewMessage view{
        .viewer = 666, .number = i, .map_id = test::World::description().id, .map = map, .epoch = 1};
    view.start = i % 3 == 0 ? 1 : 1 + random() % 1'000'000;
    view.receipt.highest = random();
    view.view.max_error = 0.05F;
    view.view.boxes.resize(kMostViewBoxes, {{-1e9F, -1e9F, -1e9F}, {1e9F, 1e9F, 1e9F}});
    for (std::int32_t k = 0; k < kHeld; ++k)
      view.held.push_back(
          {{0, static_cast<std::int32_t>(i) * kHeld + k, 7, 7}, (std::uint64_t{1} << 61) + k, 1});
    const auto message = write_view(view);
    ASSERT_TRUE(sender->hear(*message, now));
    ASSERT_TRUE(sender->messages_for(666, now));
    if (i == 10) after_ten = test::memory_taken();
  }
  EXPECT_LT(test::memory_taken(), after_ten + (std::size_t{1} << 19));
  ViewMessage beyond{
      .viewer = 667, .number = 1, .map_id = test::World::description().id, .start = ~std::uint64_t{0}};
  beyond.view.max_error = 0.05F;
  EXPECT_FALSE(sender->hear(*write_view(beyond), now));
  MapReceiver receiver(1, test::World::description().id);
  View view;
  view.max_error = 0.05F;
  receiver.set_view(view);
  for (int i = 0; i < 20; ++i) {
    now += 0.1;
    const auto said = receiver.messages(now);
    ASSERT_TRUE(said);
    for (const auto& message : *said) ASSERT_TRUE(sender->hear(message, now));
    const auto messages = sender->messages_for(1, now);
    ASSERT_TRUE(messages);
    for (const auto& message : *messages) ASSERT_TRUE(receiver.apply(message));
  }
  EXPECT_EQ(receiver.shown(), sender->keys());
}

/// Processor time of twelve views, and of the calls that follow, of a viewer who follows the protocol and
/// says that it holds `count` parts that no sender sent.
double seconds_for_who_holds(std::int32_t count, std::uint32_t rate) {
  const test::World world(40, 1);
  auto sender = MapSender::make(test::World::description(), {.split = {.most_triangles = 1}});
  EXPECT_TRUE(sender);
  EXPECT_TRUE(world.tell(*sender, world.present()));
  ViewMessage view{.viewer = 666,
                   .map_id = test::World::description().id,
                   .map = hash_of(sender->description()),
                   .epoch = 1};
  view.view.max_error = 0.05F;
  view.view.bytes_per_second = rate;
  for (std::int32_t k = 0; k < count; ++k)
    view.held.push_back({{static_cast<std::uint8_t>(k / 200), k % 200, 700, 7}, std::uint64_t{1} << 40, 1});
  std::clock_t taken = 0;
  for (view.number = 1; view.number <= 12; ++view.number) {
    const double now = 0.1 * static_cast<double>(view.number);
    const auto message = write_view(view);
    const std::clock_t begin = std::clock();
    EXPECT_TRUE(sender->hear(*message, now));
    const auto messages = sender->messages_for(666, now);
    taken += std::clock() - begin;
    EXPECT_TRUE(messages) << describe(messages.error());
    view.receipt.highest += messages->size();
    for (const auto& answer : *messages)
      if (const auto start = read_start(answer)) view.start = start->start;
  }
  EXPECT_GT(view.start, 0U);
  return static_cast<double>(taken) / CLOCKS_PER_SEC;
}

TEST(MapLimits, MAP15WhoSaysThatItHoldsWhatItDoesNotCostsNoMoreThanTheLengthOfItsMessage) {
  for (const std::uint32_t rate : {0U, 10'000U}) {
    const double few = seconds_for_who_holds(500, rate);
    const double many = seconds_for_who_holds(4000, rate);  // 64 times as long were it quadratic
    EXPECT_LT(many, 16 * few) << rate;
  }
}

/// Each time other bounds, and versions of all parts that nobody knows.
TEST(MapLimits, MAP15WhoAlwaysAsksForSomethingElseCostsEachPartOnceACallOrOnePartWhereItsTimeIsOver) {
  for (const double call_seconds : {std::numeric_limits<double>::infinity(), 1e-9}) {
    const test::World world(4, 1);
    auto sender = MapSender::make(test::World::description(),
                                  {.split = {.most_triangles = 1}, .call_seconds = call_seconds});
    ASSERT_TRUE(sender);
    ASSERT_TRUE(world.tell(*sender, world.present()));
    const std::vector<PartKey> keys = sender->keys();
    const std::size_t most = std::isinf(call_seconds) ? keys.size() : 1;
    ViewMessage view{.viewer = 666,
                     .map_id = test::World::description().id,
                     .map = hash_of(sender->description()),
                     .epoch = 1};
    std::size_t after_ten = 0;
    std::uint64_t encoded = 0;
    for (view.number = 1; view.number <= 300; ++view.number) {
      const auto now = static_cast<double>(view.number);
      view.view.max_error = 0.05F + 1e-5F * static_cast<float>(view.number);
      view.held.clear();
      for (const PartKey& key : keys) view.held.push_back({key, 1000 * view.number, 1});
      ASSERT_TRUE(sender->hear(*write_view(view), now));
      const auto messages = sender->messages_for(666, now);
      ASSERT_TRUE(messages);
      for (const auto& message : *messages) {
        if (const auto start = read_start(message)) view.start = start->start;
        if (const auto part = read_part(message)) view.receipt.highest = part->number;
      }
      EXPECT_LE(sender->counts().encoded - encoded, most) << view.number;
      encoded = sender->counts().encoded;
      if (view.number == 10) after_ten = test::memory_taken();
    }
    EXPECT_GT(encoded, 250 * most);
    EXPECT_LT(test::memory_taken(), after_ten + (std::size_t{1} << 14));
  }
}

}  // namespace
}  // namespace deltamesh
