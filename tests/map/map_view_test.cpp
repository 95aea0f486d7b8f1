// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Views of a generated building: a receiver gets the boxes and the quality that it asks for, as a comparison
// of its map with the source tells, and after a change of the view only what it lacks.
#include <gtest/gtest.h>

#include <cmath>

#include "deltamesh/compare.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_meshes.h"
#include "part/view_cells.h"
#include "scenes.h"

namespace deltamesh {
namespace {

using Bytes = std::vector<std::byte>;

class MapView : public testing::Test {
 protected:
  MapView() : mesh_(*generate_scene(Scene::kRooms, 30000, 1)), receiver_(1, 1) {
    description_ = {.id = 1, .cell_steps = 1024, .attributes = test::attributes_of(mesh_)};
    description_.lattice = {.origin = mesh_.origin, .step_exponent = -10};
    start({.most_triangles = 2000});
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      low_[i % 3] = i < 3 ? mesh_.positions[i] : std::min(low_[i % 3], mesh_.positions[i]);
      high_[i % 3] = i < 3 ? mesh_.positions[i] : std::max(high_[i % 3], mesh_.positions[i]);
    }
    diagonal_ = std::hypot(high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2]);
  }

  /// A sender of the mesh.
  void start(const SplitOptions& options) {
    // Blocks as a mapper has them.
    const auto blocks = split(mesh_, description_, {.most_triangles = 1, .most_level = 0});
    EXPECT_TRUE(blocks);
    std::vector<MapBlock> update;
    for (const MapPart& part : *blocks) update.push_back({{part.key.x, part.key.y, part.key.z}, part.mesh});
    auto sender = MapSender::make(description_, {.split = options, .effort = 1});
    EXPECT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    EXPECT_TRUE(sender_->update(update));
  }

  /// VDE 0.02 % and LFE 0.05 % of the diagonal, of a part of the building from one end on.
  View view_of(float share) const {
    View view;
    view.boxes = {{low_, high_}};
    view.boxes[0].high[0] = low_[0] + share * (high_[0] - low_[0]);
    view.vde = 0.0002F * diagonal_;
    view.lfe = 0.0005F * diagonal_;
    return view;
  }

  /// Bytes and keys of parts that come until nothing does.
  std::pair<std::size_t, std::set<PartKey>> catch_up(const View& view) {
    receiver_.set_view(view);
    std::pair<std::size_t, std::set<PartKey>> came;
    for (int i = 0; i < 4; ++i) {
      now_ += 2;
      EXPECT_TRUE(sender_->hear(*receiver_.view_message(), now_));
      const auto messages = sender_->messages_for(1, now_);
      EXPECT_TRUE(messages);
      for (const Bytes& message : *messages) {
        came.first += message.size();
        if (const auto part = read_part(message)) came.second.insert(part->key);
        EXPECT_TRUE(receiver_.apply(message));
      }
    }
    return came;
  }

  std::set<PartKey> keys_in(const View& view) const {
    std::set<PartKey> keys;
    for (const PartKey& key : sender_->keys())
      if (is_in_view(key, view, description_)) keys.insert(key);
    return keys;
  }

  /// Of the receiver's parts in a view, joined, against those of the source.
  Quality measured(const View& view) const {
    std::vector<MapPart> source;
    std::vector<MapPart> got;
    for (const PartKey& key : keys_in(view)) {
      source.push_back(*sender_->source(key));
      EXPECT_NE(receiver_.find(key), nullptr);
      got.push_back(*receiver_.find(key));
    }
    const auto comparison = compare(*join(source), *join(got));
    EXPECT_TRUE(comparison);
    EXPECT_TRUE(comparison->corresponding);
    return comparison->quality;
  }

  Mesh mesh_;
  MapDescription description_;
  std::unique_ptr<MapSender> sender_;
  MapReceiver receiver_;
  std::array<float, 3> low_{};
  std::array<float, 3> high_{};
  float diagonal_ = 0;
  double now_ = 0;
};

TEST_F(MapView, MAP15ABoxComesAsItWasAskedForAndNothingElse) {
  const View view = view_of(0.4F);
  const auto keys = keys_in(view);
  ASSERT_GT(keys.size(), 3U);
  ASSERT_LT(keys.size(), sender_->keys().size() - 3);
  const auto [bytes, came] = catch_up(view);
  EXPECT_EQ(came, keys);
  EXPECT_EQ(receiver_.shown(), std::vector<PartKey>(keys.begin(), keys.end()));
  const Quality quality = measured(view);
  EXPECT_LE(quality.vde_rms, *view.vde);
  EXPECT_LE(quality.lfe_rms, *view.lfe);
  RecordProperty("vde_of_bound", std::to_string(quality.vde_rms / *view.vde));
  RecordProperty("lfe_of_bound", std::to_string(quality.lfe_rms / *view.lfe));
  EXPECT_GT(std::max(quality.vde_rms / *view.vde, quality.lfe_rms / *view.lfe), 0.5);  // not much better
}

TEST_F(MapView, MAP15AChangeOfTheViewBringsOnlyWhatIsMissing) {
  View view = view_of(0.4F);
  const auto [bytes, first] = catch_up(view);
  // A larger box: the rest of it.
  const View larger = view_of(0.7F);
  const auto [more_bytes, more] = catch_up(larger);
  for (const PartKey& key : more) EXPECT_FALSE(first.contains(key));
  EXPECT_EQ(first.size() + more.size(), keys_in(larger).size());
  EXPECT_LE(measured(larger).vde_rms, *larger.vde);
  EXPECT_LE(measured(larger).lfe_rms, *larger.lfe);
  // Back, and with less to ask for: nothing.
  EXPECT_EQ(catch_up(view).first, 0U);
  view.vde = 4 * *view.vde;
  view.lfe = 4 * *view.lfe;
  EXPECT_EQ(catch_up(view).first, 0U);
  // Better, of what is in the view: all of that, and no more.
  View better = view_of(0.4F);
  better.vde = *better.vde / 4;
  const auto [better_bytes, anew] = catch_up(better);
  EXPECT_LE(measured(better).vde_rms, *better.vde);
  for (const PartKey& key : anew) EXPECT_TRUE(keys_in(better).contains(key));
  EXPECT_GT(better_bytes, bytes / 2);
}

TEST_F(MapView, MAP19CoarseBeforeFine) {
  // All coordinates are positive, so that one cell can hold everything.
  for (std::size_t k = 0; k < 3; ++k) description_.lattice.origin[k] += std::floor(low_[k]) - 1;
  start({.most_triangles = 2000, .most_level = 1, .copy_level = 6});
  View view;
  view.max_error = 0.004F;
  receiver_.set_view(view);
  const auto finest = sender_->keys();  // no copy is made before somebody asks
  for (const PartKey& key : finest) EXPECT_LE(key.level, 1);
  std::vector<std::vector<PartKey>> seen;
  std::vector<std::size_t> bytes;
  while (receiver_.shown() != finest) {
    ASSERT_LT(bytes.size(), 20U);
    now_ += 0.3;
    ASSERT_TRUE(sender_->hear(*receiver_.view_message(), now_));
    const auto messages = sender_->messages_for(1, now_);
    ASSERT_TRUE(messages);
    bytes.push_back(0);
    for (const Bytes& message : *messages) {
      bytes.back() += message.size();
      ASSERT_TRUE(receiver_.apply(message));
    }
    if (const auto shown = receiver_.shown(); !shown.empty()) seen.push_back(shown);
  }
  // All of it in few parts at first sight, then all at once as it is asked for.
  ASSERT_GE(seen.size(), 2U);
  const auto& first = seen[seen.size() - 2];
  EXPECT_LT(first.size(), finest.size() / 4);
  for (const PartKey& key : finest)
    EXPECT_TRUE(std::ranges::any_of(first, [&](const PartKey& other) { return overlap(key, other); }));
  std::size_t before = 0;
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i) before += bytes[i];
  EXPECT_LT(before, bytes.back() / 3);
  // A coarser view takes what is finer out of the way, and back.
  view.level = 3;
  catch_up(view);
  const auto coarse = receiver_.shown();
  EXPECT_EQ(coarse, keys_on_level(sender_->keys(), 3));
  for (const PartKey& key : coarse) EXPECT_GE(key.level, 3);  // 4: where a copy of 3 has too many triangles
  view.level = 0;
  catch_up(view);
  catch_up(view);
  EXPECT_EQ(receiver_.shown(), finest);
}

TEST_F(MapView, MAP19NoCopyComesToAViewInWhichNothingIs) {
  start({.most_triangles = 2000, .most_level = 1, .copy_level = 6});
  View above;  // the building, in a cell of which a copy may be made
  above.boxes = {{low_, high_}};
  above.boxes[0].low[2] = high_[2] + 3;
  above.boxes[0].high[2] = high_[2] + 4;
  ASSERT_TRUE(keys_in(above).empty());
  EXPECT_TRUE(catch_up(above).second.empty());
  EXPECT_TRUE(keys_in(above).empty());
  // Not when others have asked for copies either.
  View coarse;
  coarse.level = 3;
  catch_up(coarse);
  ASSERT_FALSE(receiver_.shown().empty());
  ASSERT_FALSE(keys_in(above).empty());
  EXPECT_TRUE(catch_up(above).second.empty());
  for (const PartKey& key : receiver_.shown()) EXPECT_FALSE(is_in_view(key, above, description_));
}

TEST_F(MapView, CopiesAreMadeAnewForThoseWhoSeeThem) {
  start({.most_triangles = 2000, .most_level = 1, .copy_level = 3});
  View view;
  view.max_error = 0.004F;
  view.level = 3;
  catch_up(view);
  const auto coarse = receiver_.shown();
  ASSERT_FALSE(coarse.empty());
  // A block moves; until its copy is made anew the earlier one is shown.
  const PartKey fine = sender_->keys().front();
  ASSERT_EQ(fine.level, 0);
  Mesh moved = sender_->source(fine)->mesh;
  for (float& x : moved.positions) x += 0.05F;
  ASSERT_TRUE(sender_->update(std::vector<MapBlock>{{{fine.x, fine.y, fine.z}, moved}}));
  const PartKey copy = ancestor(fine, 3);
  EXPECT_EQ(sender_->source(copy), nullptr);
  EXPECT_EQ(receiver_.shown(), coarse);
  (void)receiver_.take_change();
  catch_up(view);
  EXPECT_NE(sender_->source(copy), nullptr);
  EXPECT_EQ(receiver_.shown(), coarse);
  const auto changed = receiver_.take_change().changed;
  EXPECT_NE(std::ranges::find(changed, copy), changed.end());
}

}  // namespace
}  // namespace deltamesh
