// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Bounds of attributes in views [MAP-15].
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "support/grid_triangles.h"

namespace deltamesh::map_attributes_test {
namespace {

constexpr std::uint32_t kEdge = 24;

template <class Value>
void append(Attribute& attribute, Value value) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&value);
  attribute.values.insert(attribute.values.end(), bytes, bytes + sizeof value);
}

/// A wavy square with normals, an intensity of noise and labels.
Mesh wavy_square() {
  std::mt19937 random(1);
  Mesh mesh;
  Attribute normal{AttributeKind::kNormal, ComponentType::kF32, 3, false, "normal", {}};
  Attribute intensity{AttributeKind::kGeneric, ComponentType::kF32, 1, false, "intensity", {}};
  Attribute label{AttributeKind::kGeneric, ComponentType::kU16, 1, false, "label", {}};
  for (std::uint32_t j = 0; j <= kEdge; ++j)
    for (std::uint32_t i = 0; i <= kEdge; ++i) {
      const float x = static_cast<float>(i) / kEdge;
      const float y = static_cast<float>(j) / kEdge;
      for (const float coordinate : {x, y, 0.1F * std::sin(6 * x)}) mesh.positions.push_back(coordinate);
      const float slope = 0.6F * std::cos(6 * x) + 0.1F * static_cast<float>(random() % 100) / 100;
      const float length = std::sqrt(1 + slope * slope);
      for (const float n : {-slope / length, 0.0F, 1 / length}) append(normal, n);
      append(intensity, 100 * x + static_cast<float>(random() % 1000) / 1000);
      append(label, static_cast<std::uint16_t>(i / 8));
    }
  mesh.triangles = test::grid_triangles(kEdge + 1, kEdge + 1);
  mesh.attributes = {std::move(normal), std::move(intensity), std::move(label)};
  return mesh;
}

class MapAttributes : public testing::Test {
 protected:
  MapAttributes() : receiver_(1, 1) {
    const Mesh mesh = wavy_square();
    MapDescription description{.id = 1, .epoch = 1, .frame = "map", .cell_steps = 1024};
    description.lattice.step_exponent = -10;
    for (const Attribute& a : mesh.attributes)
      description.attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name, a.linear});
    auto sender = MapSender::make(description);
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    EXPECT_TRUE(sender_->update(std::vector<MapBlock>{{{0, 0, 0}, mesh}}));
    view_.max_error = 0.002F;
  }

  std::size_t bytes_of(const View& view) {
    receiver_.set_view(view);
    std::size_t bytes = 0;
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(sender_->hear(*receiver_.view_message(), ++now_));
      const auto messages = sender_->messages_for(1, now_);
      EXPECT_TRUE(messages);
      for (const auto& message : *messages) {
        bytes += message.size();
        EXPECT_TRUE(receiver_.apply(message));
      }
    }
    return bytes;
  }

  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  View view_;
  double now_ = 0;
};

TEST_F(MapAttributes, MAP15BoundsOfNormalsAndIntensitiesSaveBytesAndAreKept) {
  view_.attribute_errors = {5, 1, 0};
  const std::size_t some = bytes_of(view_);
  const PartKey key = sender_->keys().front();
  const auto intensities = [&](const Mesh& mesh) {
    std::vector<float> values(mesh.vertex_count());
    std::memcpy(values.data(), mesh.attributes[1].values.data(), 4 * values.size());
    std::ranges::sort(values);
    return values;
  };
  const auto source = intensities(sender_->source(key)->mesh);
  ASSERT_NE(receiver_.find(key), nullptr);
  const auto got = intensities(receiver_.find(key)->mesh);
  ASSERT_EQ(source.size(), got.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(source[i], got[i], 1.001);
  EXPECT_NE(source, got);
  // Stricter bounds bring the part anew; what is better than asked for stays.
  view_.attribute_errors = {};
  const std::size_t all = bytes_of(view_);
  EXPECT_LT(some, all / 2);
  EXPECT_EQ(intensities(receiver_.find(key)->mesh), source);
  view_.attribute_errors = {5, 1, 0};
  EXPECT_EQ(bytes_of(view_), 0U);
}

TEST_F(MapAttributes, MAP15HearNamesTheAttribute) {
  view_.attribute_errors = {5, 1, 0, 0};
  receiver_.set_view(view_);
  const auto heard = sender_->hear(*receiver_.view_message(), 1);
  ASSERT_FALSE(heard);
  EXPECT_EQ(heard.error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(heard.error().where_kind, WhereKind::kAttribute);
  EXPECT_EQ(heard.error().where, 3U);
}

}  // namespace
}  // namespace deltamesh::map_attributes_test
