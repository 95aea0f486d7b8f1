// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rate of a view is kept in every second, whatever changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "scenes.h"

namespace deltamesh::map_rate_test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::uint32_t kRate = 10'000;

class MapRate : public testing::Test {
 protected:
  MapRate() : receiver_(1, 1) {
    const Mesh mesh = *generate_scene(Scene::kRooms, 30000, 1);
    MapDescription description{.id = 1, .cell_steps = 1024, .attributes = test::attributes_of(mesh)};
    description.lattice = {.origin = mesh.origin, .step_exponent = -10};
    auto sender = MapSender::make(description, {.split = {.most_triangles = 2000}});
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    const auto parts = split(mesh, description, {.most_triangles = 1, .most_level = 0});
    std::vector<MapBlock> blocks;
    for (const MapPart& part : *parts) blocks.push_back({{part.key.x, part.key.y, part.key.z}, part.mesh});
    EXPECT_TRUE(sender_->update(blocks));
    view_.max_error = 0.02F;
    view_.bytes_per_second = kRate;
    receiver_.set_view(view_);
  }

  /// Whether something came.
  bool talk() {
    now_ += 0.1;
    EXPECT_TRUE(sender_->hear(*receiver_.view_message(), now_));
    const auto messages = sender_->messages_for(1, now_);
    EXPECT_TRUE(messages);
    for (const Bytes& message : *messages) {
      EXPECT_TRUE(receiver_.apply(message));
      last_second_.emplace_back(now_, message.size());
      largest_ = std::max(largest_, message.size());
      sum_ += message.size();
    }
    while (!last_second_.empty() && last_second_.front().first <= now_ - 0.999) last_second_.pop_front();
    std::size_t sum = 0;
    for (const auto& [time, size] : last_second_) sum += size;
    EXPECT_LE(sum, kRate + largest_) << "at " << now_;
    return !messages->empty();
  }

  /// Seconds until nothing has come for two seconds.
  double settle() {
    const double begin = now_;
    double last = now_;
    while (now_ - last < 2) last = talk() ? now_ : last;
    return last - begin;
  }

  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  View view_;
  std::deque<std::pair<double, std::size_t>> last_second_;
  std::size_t largest_ = 0;
  std::size_t sum_ = 0;
  double now_ = 0;
};

TEST_F(MapRate, MAP15TheRateIsKeptInEverySecond) {
  const double first = settle();
  EXPECT_EQ(receiver_.shown(), sender_->keys());
  EXPECT_LT(first, static_cast<double>(sum_) / kRate + 2);  // and it is used
  // A finer view: everything anew, part by part, each shown as it comes.
  sum_ = 0;
  view_.max_error = 0.002F;
  receiver_.set_view(view_);
  (void)receiver_.take_change();
  for (int i = 0; i < 20; ++i) (void)talk();
  const std::size_t changed = receiver_.take_change().changed.size();
  EXPECT_GT(changed, 0U);
  EXPECT_LT(changed, sender_->keys().size());
  const double second = settle();
  EXPECT_LT(second, static_cast<double>(sum_) / kRate + 2);
  EXPECT_EQ(receiver_.shown(), sender_->keys());
}

}  // namespace
}  // namespace deltamesh::map_rate_test
