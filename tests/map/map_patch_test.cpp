// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Newer versions as patches of those that receivers have.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <cmath>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "message/frame.h"
#include "part/fitness.h"
#include "patch/container.h"
#include "patch/part_or_patch.h"

namespace deltamesh {
namespace {

using Bytes = std::vector<std::byte>;

constexpr float kMaxError = 0.005F;

/// A sheet of cells, of which one changes at a time.
class MapPatch : public testing::Test {
 protected:
  MapPatch() : sheet_(test::wavy_sheet(40, 40, 5, 0.002)), receiver_(1, 1) {
    MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 64};
    description.lattice.step_exponent = step_exponent_for(kMaxError);
    description.attributes = test::attributes_of(sheet_);
    start(description);
  }

  /// With a sender and a receiver that has the sheet.
  void start(const MapDescription& description, const SplitOptions& split = {}) {
    SenderOptions options;
    options.effort = 0;
    options.split = split;
    auto sender = MapSender::make(description, options);
    ASSERT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    receiver_ = MapReceiver(1, 1);
    View view;
    view.max_error = kMaxError;
    view.color_error = 4;
    receiver_.set_view(view);
    tell();
    for (int i = 0; i < 3; ++i)
      for (const Bytes& message : ask()) EXPECT_TRUE(receiver_.apply(message));
  }

  void tell() {
    const std::vector<MapBlock> blocks = {{{0, 0, 0}, sheet_}};
    EXPECT_TRUE(sender_->update(blocks));
  }

  /// Lifts what is within a radius of a place by `height`.
  void lift(double x, double y, double radius, float height) {
    for (std::size_t v = 0; v < sheet_.vertex_count(); ++v)
      if (std::hypot(sheet_.positions[3 * v] - x, sheet_.positions[3 * v + 1] - y) < radius)
        sheet_.positions[3 * v + 2] += height;
    tell();
  }

  std::vector<Bytes> ask() {
    now_ += 2;
    EXPECT_TRUE(sender_->hear(*receiver_.view_message(), now_));
    auto messages = sender_->messages_for(1, now_);
    EXPECT_TRUE(messages);
    return std::move(*messages);
  }

  Bytes ask_for_one() {
    auto messages = ask();
    EXPECT_EQ(messages.size(), 1U);
    return messages.empty() ? Bytes() : std::move(messages.front());
  }

  const MapPart& shown() const { return *receiver_.find(receiver_.shown().front()); }

  void expect_good() const {
    EXPECT_EQ(shown().mesh.triangle_count(), sheet_.triangle_count());
    EXPECT_EQ(shown().mesh.vertex_count(), sheet_.vertex_count());
    EXPECT_LE(errors_between(sheet_, shown().mesh).max_error, kMaxError * (1 + 1e-6));
  }

  Mesh sheet_;
  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  double now_ = 0;
};

TEST_F(MapPatch, MAP17OnlyWhatIsNotGoodEnoughIsSent) {
  const std::size_t whole = receiver_.held().front().octets.size();
  for (int i = 0; i < 5; ++i) {
    lift(-0.3 + 0.1 * i, 0.05 * i, 0.06, 0.05F);
    const Bytes message = ask_for_one();
    EXPECT_EQ(*kind_of_message(message), MessageKind::kPatch);
    EXPECT_LT(message.size(), whole / 3);
    EXPECT_TRUE(receiver_.apply(message));
    expect_good();
  }
  EXPECT_EQ(sender_->counts().patches_sent, 5U);
  EXPECT_TRUE(ask().empty());
}

TEST_F(MapPatch, APrimerIsABaseAsOtherPartsAre) {
  auto splitter = Splitter::make(sender_->description());
  ASSERT_TRUE(splitter);
  const std::vector<MapBlock> blocks = {{{0, 0, 0}, sheet_}};
  const auto change = splitter->update(blocks);
  ASSERT_TRUE(change);
  std::vector<MapPart> parts = {change->changed.front().part, change->changed.front().part};
  parts.back().key.x = 1;
  PartQuality quality;
  quality.bounds.max_error = QualityBound{double{kMaxError}};
  quality.attributes.color_error = 4;
  quality.effort = 0;
  const auto description = with_primers(sender_->description(), parts, quality);
  ASSERT_TRUE(description);
  ASSERT_FALSE(description->primers.empty());
  start(*description);
  EXPECT_LT(receiver_.held().front().octets.size(), 8U);
  lift(0, 0, 0.05, 0.05F);
  const Bytes message = ask_for_one();
  EXPECT_EQ(*kind_of_message(message), MessageKind::kPatch);
  EXPECT_TRUE(receiver_.apply(message));
  expect_good();
}

TEST_F(MapPatch, WhatMovesByLittleStays) {
  lift(0, 0, 0.1, 1e-6F);
  EXPECT_TRUE(ask().empty());
  expect_good();
}

TEST_F(MapPatch, MAP17OctetsOfPatchesAreAPartOfTheirOwn) {
  for (int i = 0; i < 4; ++i) {
    lift(0.1 * i, 0.1, 0.05, 0.05F);
    ASSERT_TRUE(receiver_.apply(ask_for_one()));
  }
  const HeldPart held = receiver_.held().front();
  EXPECT_EQ(count_patches(held.octets), 4U);
  const auto codec = MapCodec::open(sender_->description());
  const auto decoded = codec->decode(held.entry.key, held.octets);
  ASSERT_TRUE(decoded) << describe(decoded.error());
  EXPECT_EQ(decoded->mesh.positions, shown().mesh.positions);
  EXPECT_EQ(decoded->mesh.triangles, shown().mesh.triangles);
  EXPECT_EQ(decoded->border, shown().border);
  EXPECT_EQ(decoded->mesh.attributes.front().values, shown().mesh.attributes.front().values);

  MapReceiver other(2, 1);
  ASSERT_TRUE(other.apply(*write_description(sender_->description())));
  ASSERT_TRUE(other.restore(held.entry, held.octets));
  EXPECT_EQ(other.hash(), receiver_.hash());
  for (std::size_t size = 0; size < held.octets.size(); size += 7)
    EXPECT_FALSE(codec->decode(held.entry.key, held.octets.first(size)));
}

TEST_F(MapPatch, MAP17AtMostSixteenOnEachOther) {
  for (int i = 0; i < 20; ++i) {
    lift(0.2, 0.2, 0.03, 0.05F);
    ASSERT_TRUE(receiver_.apply(ask_for_one()));
    EXPECT_LE(count_patches(receiver_.held().front().octets), kMostPatches);
  }
  EXPECT_GE(sender_->counts().patches_sent, 16U);
  EXPECT_LT(sender_->counts().patches_sent, 20U);
  expect_good();
}

TEST_F(MapPatch, MAP18WithoutItsBaseAPatchHasNoEffectUntilThatComes) {
  lift(0, 0, 0.05, 0.05F);
  (void)ask();  // lost
  now_ -= 1.9;  // too soon to be sent again
  lift(0.2, 0, 0.05, 0.05F);
  const Bytes patch = ask_for_one();
  EXPECT_EQ(*kind_of_message(patch), MessageKind::kPatch);
  const std::uint64_t before = receiver_.hash();
  EXPECT_TRUE(receiver_.apply(patch));
  EXPECT_EQ(receiver_.hash(), before);
  const auto again = ask();
  ASSERT_FALSE(again.empty());
  for (const Bytes& message : again) EXPECT_TRUE(receiver_.apply(message));
  expect_good();
}

TEST_F(MapPatch, MAP17DamagedPatchesAreRefused) {
  lift(0, 0, 0.05, 0.05F);
  const auto patch = read_patch(ask_for_one());
  ASSERT_TRUE(patch);
  const auto codec = MapCodec::open(sender_->description());
  const HeldPart held = receiver_.held().front();
  const std::uint64_t hash = XXH3_64bits(held.octets.data(), held.octets.size());
  EXPECT_EQ(patch->base_key, held.entry.key);
  const auto apply = [&](std::uint64_t base, const Bytes& body) {
    return apply_patch(codec->state(), held.entry.key, shown(), base, body, {});
  };
  EXPECT_TRUE(apply(hash, patch->body));
  EXPECT_EQ(apply(hash + 1, patch->body).error().code, ErrorCode::kCorrupt);
  for (std::size_t i = 0; i < patch->body.size(); i += 5) {
    Bytes damaged = patch->body;
    damaged[i] ^= std::byte{1};
    EXPECT_EQ(apply(hash, damaged).error().code, ErrorCode::kCorrupt);
    EXPECT_STREQ(apply(hash, damaged).error().rule, "MAP-17");
    damaged.resize(i);
    EXPECT_STREQ(apply(hash, damaged).error().rule, "MAP-17");
  }
}

TEST_F(MapPatch, MAP17PartsInPlaceOfALargerOneArePatchesOfIt) {
  start(sender_->description(), {.most_triangles = static_cast<std::uint32_t>(sheet_.triangle_count())});
  const Mesh beside = test::wavy_sheet(2, 2, 6, 0);
  const PartKey before = receiver_.shown().front();
  const std::vector<MapBlock> second = {{{1, 0, 0}, beside}};
  ASSERT_TRUE(sender_->update(second));
  bool is_patched = false;
  for (const Bytes& message : ask()) {
    if (*kind_of_message(message) == MessageKind::kPatch) {
      is_patched = true;
      EXPECT_EQ(read_patch(message)->base_key, before);
    }
    ASSERT_TRUE(receiver_.apply(message));
  }
  EXPECT_TRUE(is_patched);
  EXPECT_EQ(receiver_.shown(), sender_->keys());
  EXPECT_NE(receiver_.shown().front(), before);
}

}  // namespace
}  // namespace deltamesh
