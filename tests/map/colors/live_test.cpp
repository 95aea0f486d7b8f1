// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What receivers get of colours by what they ask, also after updates.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "scenes.h"
#include "support/color_value.h"
#include "support/label_maps.h"

namespace deltamesh {
namespace {

/// Rooms in cells of 2 units, as a mapper gives them.
class LiveColors : public ::testing::Test {
 protected:
  void start(Mesh mesh, const View& view) {
    mesh_ = std::move(mesh);
    MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 256};
    description.lattice.step_exponent = step_exponent_for(0.01);
    description.attributes = test::attributes_of(mesh_);
    const auto all = split(mesh_, description, {.most_triangles = 1U << 30, .most_level = 0});
    ASSERT_TRUE(all);
    blocks_ = *all;
    SenderOptions options;
    options.split.most_triangles = 1000;
    auto sender = MapSender::make(description, options);
    ASSERT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    receiver_ = MapReceiver(1, 1);
    receiver_.set_view(view);
    update(0, blocks_.size());
    exchange();
  }

  void update(std::size_t first, std::size_t end) {
    std::vector<MapBlock> blocks;
    for (std::size_t i = first; i < end; ++i) {
      const PartKey& key = blocks_[i].key;
      blocks.push_back({{key.x, key.y, key.z}, blocks_[i].mesh});
    }
    ASSERT_TRUE(sender_->update(blocks));
  }

  /// Returns the bytes.
  std::size_t exchange() {
    std::size_t bytes = 0;
    for (int i = 0; i < 4; ++i) {
      now_ += 2;
      EXPECT_TRUE(sender_->hear(*receiver_.view_message(), now_));
      const auto messages = sender_->messages_for(1, now_);
      for (const auto& message : *messages) {
        EXPECT_TRUE(receiver_.apply(message));
        bytes += message.size();
      }
    }
    return bytes;
  }

  /// The largest error, 255ths, of vertices by their places; on the border, so that there is one.
  double largest_error() const {
    double most = 0;
    for (const PartKey& key : receiver_.shown()) {
      std::map<std::pair<LatticePoint, std::uint32_t>, std::uint32_t> places;
      const MapPart& source = *sender_->source(key);
      for (const BorderVertex& b : source.border) places[{b.point, b.twin}] = b.vertex;
      const MapPart& part = *receiver_.find(key);
      for (const BorderVertex& b : part.border)
        most = std::max(most, color_difference(source.mesh.attributes[0], places.at({b.point, b.twin}),
                                               part.mesh.attributes[0], b.vertex));
    }
    return most;
  }

  void expect_no_seams() const {
    std::map<std::pair<LatticePoint, std::uint32_t>, std::vector<double>> known;
    std::size_t copies = 0;
    for (const PartKey& key : receiver_.shown()) {
      const MapPart& part = *receiver_.find(key);
      for (const BorderVertex& b : part.border) {
        std::vector<double> color;
        for (std::size_t c = 0; c < 3; ++c)
          color.push_back(color_value(part.mesh.attributes[0], b.vertex, c));
        const auto [place, is_new] = known.try_emplace({b.point, b.twin}, color);
        EXPECT_EQ(place->second, color);
        copies += is_new ? 0 : 1;
      }
    }
    EXPECT_GT(copies, 100U);
  }

  Mesh mesh_;
  std::vector<MapPart> blocks_;
  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_{1, 1};
  double now_ = 0;
};

View view_with(std::optional<float> color_error, std::optional<float> color_rms) {
  View view;
  view.max_error = 0.02F;
  view.color_error = color_error;
  view.color_rms = color_rms;
  return view;
}

TEST_F(LiveColors, PhotographsAreBoundedAndLabelsExactWhereNothingIsAsked) {
  start(*generate_scene(Scene::kRooms, 6000, 1), view_with({}, {}));
  EXPECT_GT(receiver_.shown().size(), 5U);
  EXPECT_GT(largest_error(), 0);
  EXPECT_LE(largest_error(), 4);  // of the border
  expect_no_seams();
  start(test::label_maps(1, 40).front().mesh, view_with({}, {}));
  EXPECT_EQ(largest_error(), 0);
}

TEST_F(LiveColors, WhatIsAskedIsDone) {
  start(*generate_scene(Scene::kRooms, 6000, 1), view_with(0.0F, {}));
  EXPECT_EQ(largest_error(), 0);
  start(*generate_scene(Scene::kRooms, 6000, 1), view_with(3.0F, {}));
  EXPECT_EQ(largest_error(), 3);
  expect_no_seams();
  start(*generate_scene(Scene::kRooms, 6000, 1), view_with({}, 6.0F));
  EXPECT_GT(largest_error(), 4);
  expect_no_seams();
}

/// A few levels up or down at every vertex; alike at places that are alike.
void repaint(Mesh& mesh, double share) {
  Attribute& colors = mesh.attributes[0];
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const float* const p = &mesh.positions[3 * v];
    const auto mix = static_cast<std::uint32_t>(std::abs(p[0] * 7919 + p[1] * 104729 + p[2] * 1299709));
    if (mix % 1000 >= share * 1000) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const int level = std::to_integer<int>(colors.values[v * colors.components + c]);
      colors.values[v * colors.components + c] = static_cast<std::byte>(std::min(255, level + 20));
    }
  }
}

TEST_F(LiveColors, UpdatesLeaveNoSeamsAndTakeWhatChanged) {
  for (const View& view : {view_with({}, 2.3F), view_with(4.0F, {})}) {
    start(*generate_scene(Scene::kRooms, 6000, 1), view);
    update(0, blocks_.size());
    EXPECT_EQ(exchange(), 0U);  // nothing has changed
    const std::size_t half = blocks_.size() / 2;
    for (MapPart& block : blocks_) repaint(block.mesh, 0.01);
    update(0, half);
    const std::size_t some = exchange();
    EXPECT_GT(some, 0U);
    update(half, blocks_.size());
    exchange();
    expect_no_seams();
    EXPECT_LE(largest_error(), 4);
    EXPECT_TRUE(sender_->counts().patches_sent > 0 || sender_->counts().kept > 0);
    EXPECT_EQ(exchange(), 0U);  // all is as it was asked
  }
}

}  // namespace
}  // namespace deltamesh
