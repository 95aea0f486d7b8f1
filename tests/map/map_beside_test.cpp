// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Newer versions of parts from voxels, coded beside those that receivers have [MAP-26 to MAP-30].
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "message/frame.h"
#include "part/fitness.h"
#include "unit/grid/grid_meshes.h"

namespace deltamesh {
namespace {

using Bytes = std::vector<std::byte>;

constexpr float kVoxel = 0.05F;
constexpr float kMaxError = kVoxel / 9;
constexpr int kUpdates = 5;

/// A ball of voxels that grows where x is high, with colours that change at one side.
Mesh ball_at(int time) {
  const auto field = [&](int x, int y, int z) {
    const double way[3] = {x - 11.2, y - 12.3, z - 11.6};
    const double grown = x > 14 ? 0.3 * time : 0;
    return static_cast<float>(std::hypot(way[0], way[1], way[2]) - 8.2 - grown);
  };
  const scenes::Surface surface = test::marched(field, 26);
  Mesh mesh;
  mesh.triangles = surface.triangles;
  Attribute color{AttributeKind::kColor, ComponentType::kU8, 3, true, "red", {}};
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    mesh.positions.push_back(kVoxel * surface.positions[i]);
    const int change = surface.positions[i - i % 3 + 1] < 9 ? 11 * time : 0;
    color.values.push_back(static_cast<std::byte>(100 + change + 4 * static_cast<int>(surface.positions[i])));
  }
  mesh.attributes.push_back(color);
  return mesh;
}

/// The half of it whose faces are low in x, or the other one.
Mesh half_of(const Mesh& mesh, bool is_low) {
  Mesh half;
  half.attributes.push_back(mesh.attributes[0]);
  half.attributes[0].values.clear();
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::size_t f = 0; f < mesh.triangles.size(); f += 3) {
    double x = 0;
    for (std::size_t c = 0; c < 3; ++c) x += mesh.positions[3 * std::size_t{mesh.triangles[f + c]}];
    if ((x < 3 * 11.5 * double{kVoxel}) != is_low) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.triangles[f + c];
      const auto [number, is_new] = numbers.try_emplace(v, static_cast<std::uint32_t>(numbers.size()));
      half.triangles.push_back(number->second);
      for (std::size_t k = 0; is_new && k < 3; ++k) {
        half.positions.push_back(mesh.positions[3 * std::size_t{v} + k]);
        half.attributes[0].values.push_back(mesh.attributes[0].values[3 * std::size_t{v} + k]);
      }
    }
  }
  return half;
}

class MapBeside : public testing::TestWithParam<bool> {
 protected:
  MapBeside() : receiver_(1, 1) {
    MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 128};
    description.lattice.step_exponent = step_exponent_for(kMaxError);
    description.attributes = test::attributes_of(ball_at(0));
    SenderOptions options;
    options.effort = 0;
    options.split = {.most_triangles = 1000};
    sender_ = std::make_unique<MapSender>(*MapSender::make(description, options));
    View view;
    view.max_error = kMaxError;
    if (GetParam())
      view.color_rms = 3.0F;
    else
      view.color_error = 2;
    receiver_.set_view(view);
    tell(0);
  }

  /// How many parts came as patches, and of these beside their base.
  struct Came {
    int patches = 0;
    int beside = 0;
    std::size_t bytes = 0;
  };
  Came tell(int time) {
    const Mesh mesh = ball_at(time);
    halves_ = {half_of(mesh, true), half_of(mesh, false)};
    const std::vector<MapBlock> blocks = {{{0, 0, 0}, halves_[0]}, {{1, 0, 0}, halves_[1]}};
    EXPECT_TRUE(sender_->update(blocks));
    Came came;
    for (int i = 0; i < 3; ++i) {
      now_ += 2;
      EXPECT_TRUE(sender_->hear(*receiver_.view_message(), now_));
      const auto messages = sender_->messages_for(1, now_);
      EXPECT_TRUE(messages);
      for (const Bytes& message : *messages) {
        came.bytes += message.size();
        if (*kind_of_message(message) == MessageKind::kPatch) {
          ++came.patches;
          came.beside += read_patch(message)->body.front() == std::byte{0} ? 1 : 0;
        }
        EXPECT_TRUE(receiver_.apply(message));
      }
    }
    return came;
  }

  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  std::vector<Mesh> halves_;
  double now_ = 0;
};

TEST_P(MapBeside, MAP17EveryUpdateIsBesideWhatWasThere) {
  for (int time = 1; time <= kUpdates; ++time) {
    SCOPED_TRACE(time);
    const Came came = tell(time);
    EXPECT_GT(came.patches, 0);
    EXPECT_EQ(came.beside, came.patches);
    const auto codec = MapCodec::open(sender_->description());
    ASSERT_EQ(receiver_.held().size(), 2U);
    for (const HeldPart& held : receiver_.held()) {
      const MapPart& shown = *receiver_.find(held.entry.key);
      const auto decoded = codec->decode(held.entry.key, held.octets);
      ASSERT_TRUE(decoded);
      EXPECT_EQ(decoded->mesh.positions, shown.mesh.positions);
      EXPECT_EQ(decoded->mesh.triangles, shown.mesh.triangles);
      EXPECT_EQ(decoded->border, shown.border);
      EXPECT_EQ(decoded->streamed_border, shown.streamed_border);
      EXPECT_EQ(decoded->mesh.attributes[0].values, shown.mesh.attributes[0].values);
      EXPECT_FALSE(shown.border.empty());
      const Mesh& half = halves_[static_cast<std::size_t>(held.entry.key.x)];
      EXPECT_EQ(shown.mesh.triangle_count(), half.triangle_count());
      EXPECT_LE(errors_between(half, shown.mesh).max_error, kMaxError * (1 + 1e-6));
    }
  }
}

/// An update without any change in faces takes little beside the first one.
TEST_P(MapBeside, MAP28MAP29MAP30WhatHasNotChangedTakesLittle) {
  const std::size_t first = receiver_.held()[0].octets.size() + receiver_.held()[1].octets.size();
  EXPECT_LT(3 * tell(1).bytes, 2 * first);
}

/// A whole part must be longer, so that short messages make no large meshes.
TEST(MapBesideABase, MAP7WhatTheBaseHasNeedsNoBytes) {
  const auto field = [](int x, int y, int z) {
    return static_cast<float>(std::hypot(x - 25.2, y - 25.3, z - 25.6) - 23.2);
  };
  const scenes::Surface ball = test::marched(field, 52);
  Mesh mesh;
  mesh.positions = ball.positions;
  mesh.triangles = ball.triangles;
  MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 1U << 12};
  description.lattice.step_exponent = step_exponent_for(0.1);
  auto sender = MapSender::make(description, {.split = {.most_triangles = 100'000}});
  ASSERT_TRUE(sender);
  MapReceiver receiver(1, 1);
  View view;
  view.max_error = 0.1F;
  receiver.set_view(view);
  double now = 0;
  const auto bytes_of_update = [&] {
    std::size_t bytes = 0;
    EXPECT_TRUE(sender->update(std::vector<MapBlock>{{{0, 0, 0}, mesh}}));
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(sender->hear(*receiver.view_message(), now += 2));
      const auto messages = sender->messages_for(1, now);
      for (const Bytes& message : *messages) {
        bytes += message.size();
        EXPECT_TRUE(receiver.apply(message));
      }
    }
    return bytes;
  };
  const std::size_t needed = (mesh.vertex_count() + mesh.triangle_count()) / 32;
  EXPECT_GT(bytes_of_update(), needed);
  // One vertex moves along its edge.
  float* const moved = mesh.positions.data();
  for (std::size_t k = 0; k < 3; ++k)
    if (moved[k] != std::floor(moved[k]))
      moved[k] = std::floor(moved[k]) + (moved[k] - std::floor(moved[k]) < 0.5F ? 0.8F : 0.2F);
  EXPECT_LT(2 * bytes_of_update(), needed);
  const MapPart& shown = *receiver.find(receiver.held()[0].entry.key);
  EXPECT_EQ(shown.mesh.triangle_count(), mesh.triangle_count());
  EXPECT_LE(errors_between(mesh, shown.mesh).max_error, 0.1 * (1 + 1e-6));
}

INSTANTIATE_TEST_SUITE_P(ColoursByRms, MapBeside, testing::Bool());

}  // namespace
}  // namespace deltamesh
