// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One bad part is one bad part: it is named, and everything else goes on [MAP-22].
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "support/grid_triangles.h"

namespace deltamesh::map_fault_test {
namespace {

using Bytes = std::vector<std::byte>;

/// The square [x, x + 1) x [0, 1) as a grid with heights of noise, but for two sides, which are level.
Mesh noise(float x, std::uint32_t edge) {
  std::mt19937 random(1);
  Mesh mesh;
  for (std::uint32_t j = 0; j <= edge; ++j)
    for (std::uint32_t i = 0; i <= edge; ++i) {
      const bool is_side = i == 0 || i == edge;
      const float z = is_side ? 0.3333F : static_cast<float>(random() % 1021) / 1021;
      for (const float coordinate : {x + static_cast<float>(i) / static_cast<float>(edge),
                                     static_cast<float>(j) / static_cast<float>(edge), z})
        mesh.positions.push_back(coordinate);
    }
  mesh.triangles = test::grid_triangles(edge + 1, edge + 1);
  return mesh;
}

/// Three blocks next to each other.
class MapFault : public testing::Test {
 protected:
  MapFault() : receiver_(1, 1) {
    MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 1024};
    description.lattice.step_exponent = -10;
    auto sender = MapSender::make(description, {.split = {.most_triangles = 1, .most_level = 0}});
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    for (const std::int32_t x : {0, 1, 2}) EXPECT_TRUE(set(x, noise(static_cast<float>(x), 4)));
    view_.max_error = 0.002F;
    receiver_.set_view(view_);
  }

  Result<void> set(std::int32_t x, const Mesh& mesh) {
    const std::vector<MapBlock> blocks = {{{x, 0, 0}, mesh}};
    return sender_->update(blocks);
  }

  void talk() {
    for (int i = 0; i < 4; ++i) {
      now_ += 1;
      ASSERT_TRUE(sender_->hear(*receiver_.view_message(), now_));
      const auto messages = sender_->messages_for(1, now_);
      ASSERT_TRUE(messages) << describe(messages.error());
      for (const Bytes& message : *messages) ASSERT_TRUE(receiver_.apply(message));
    }
  }

  /// Of hear(), once the receiver asks for `view_`.
  Error error_of_view() {
    receiver_.set_view(view_);
    const auto heard = sender_->hear(*receiver_.view_message(), now_ += 1);
    EXPECT_FALSE(heard);
    return heard ? Error{} : heard.error();
  }

  /// The receiver gets all parts, and is told what is wrong with them, although its views are errors.
  void expect_served(ErrorCode heard_as) {
    for (int i = 0; i < 4; ++i) {
      now_ += 1;
      const auto heard = sender_->hear(*receiver_.view_message(), now_);
      EXPECT_TRUE(!heard && heard.error().code == heard_as);
      const auto messages = sender_->messages_for(1, now_);
      ASSERT_TRUE(messages) << describe(messages.error());
      for (const Bytes& message : *messages) ASSERT_TRUE(receiver_.apply(message));
    }
    EXPECT_EQ(receiver_.shown(), sender_->keys());
    EXPECT_EQ(receiver_.hash(), sender_->hash(1));
    EXPECT_EQ(receiver_.faults().size(), sender_->faults_of(1).size());
    for (const PartFault& fault : receiver_.faults()) EXPECT_EQ(fault.code, ErrorCode::kUnmetRequest);
  }

  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  View view_;
  double now_ = 0;
};

constexpr PartKey kMiddle{0, 1, 0, 0};

TEST_F(MapFault, MAP22APartThatIsTooLargeIsNamedAndAllOthersGoOn) {
  talk();
  EXPECT_EQ(receiver_.shown().size(), 3U);
  ASSERT_TRUE(set(1, noise(1, 400)));
  ASSERT_TRUE(set(0, noise(0, 5)));  // another border with the middle one
  talk();
  const std::vector<PartKey> others = {{0, 0, 0, 0}, {0, 2, 0, 0}};
  EXPECT_EQ(receiver_.shown(), others);
  EXPECT_EQ(receiver_.find(others[0])->mesh.triangle_count(), 50U);
  const auto faults = sender_->faults_of(1);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].key, kMiddle);
  EXPECT_EQ(faults[0].code, ErrorCode::kLimitExceeded);
  ASSERT_EQ(receiver_.faults().size(), 1U);
  EXPECT_EQ(receiver_.faults()[0].key, kMiddle);
  EXPECT_EQ(receiver_.faults()[0].code, ErrorCode::kLimitExceeded);
  // It is not tried again and again.
  const std::uint64_t encoded = sender_->counts().encoded;
  talk();
  EXPECT_EQ(sender_->counts().encoded, encoded);
  // When it is well again, it comes.
  ASSERT_TRUE(set(1, noise(1, 4)));
  talk();
  EXPECT_EQ(receiver_.shown(), sender_->keys());
  EXPECT_TRUE(sender_->faults_of(1).empty());
  EXPECT_TRUE(receiver_.faults().empty());
}

TEST_F(MapFault, MAP22AnErrorThatCannotBeKeptGivesTheBestThatCan) {
  view_.max_error.reset();
  view_.vde = 1e-6F;
  receiver_.set_view(view_);
  talk();
  EXPECT_EQ(receiver_.shown(), sender_->keys());
  ASSERT_FALSE(receiver_.faults().empty());
  EXPECT_EQ(receiver_.faults().size(), sender_->faults_of(1).size());
  for (const PartFault& fault : sender_->faults_of(1)) EXPECT_EQ(fault.code, ErrorCode::kUnmetRequest);
  const std::uint64_t encoded = sender_->counts().encoded;
  const std::uint64_t sent = sender_->counts().parts_sent;
  talk();
  EXPECT_EQ(sender_->counts().encoded, encoded);
  EXPECT_EQ(sender_->counts().parts_sent, sent);
}

/// Of a view from the beginning, and of one that comes later.
TEST_F(MapFault, MAP22AViewWithABoundThatTheLatticeDoesNotAllowIsServedAndTold) {
  for (int i = 0; i < 2; ++i) {
    view_.max_error = 0.0001F;
    EXPECT_EQ(error_of_view().code, ErrorCode::kUnmetRequest);
    expect_served(ErrorCode::kUnmetRequest);
    EXPECT_EQ(receiver_.faults().size(), 3U);
    ASSERT_TRUE(set(1, noise(1, 5U + static_cast<std::uint32_t>(i))));
    expect_served(ErrorCode::kUnmetRequest);
    ASSERT_NE(receiver_.find(kMiddle), nullptr);
    EXPECT_EQ(receiver_.find(kMiddle)->mesh.triangle_count(), i == 0 ? 50U : 72U);
    view_.max_error = 0.002F;
    receiver_.set_view(view_);
    talk();
    EXPECT_TRUE(receiver_.faults().empty());
  }
}

TEST_F(MapFault, MAP22AViewWithABoundOfAnAttributeThatTheMapDoesNotHaveIsServedAndTold) {
  view_.attribute_errors = {1};
  EXPECT_EQ(error_of_view().where_kind, WhereKind::kAttribute);
  expect_served(ErrorCode::kInvalidArgument);
  EXPECT_EQ(receiver_.faults().size(), 3U);
  view_.attribute_errors.clear();
  receiver_.set_view(view_);
  talk();
  EXPECT_TRUE(receiver_.faults().empty());
}

TEST_F(MapFault, MAP22AnErrorOfAnUpdateNamesTheBlock) {
  Mesh mesh = noise(1, 4);
  mesh.positions[7] = std::numeric_limits<float>::quiet_NaN();
  const auto updated = set(-1, mesh);
  ASSERT_FALSE(updated);
  EXPECT_EQ(updated.error().code, ErrorCode::kNotFinite);
  EXPECT_STREQ(updated.error().found.data(), "block -1 0 0");
}

}  // namespace
}  // namespace deltamesh::map_fault_test
