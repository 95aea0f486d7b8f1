// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a sender makes of what a receiver may still show: which versions must not be beside new ones [MAP-12].
#include "send/coexistence.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace deltamesh::coexistence_test {
namespace {

constexpr PartKey kNew{0, 0, 0, 0};
constexpr PartKey kBeside{0, 1, 1, 0};

/// A triangle in the cell of kNew, at a height.
SourcePart source_at(float height) {
  SourcePart source;
  source.part.key = kNew;
  source.part.mesh.positions = {0, 0, height, 1, 0, height, 1, 1, height};
  source.part.mesh.triangles = {0, 1, 2};
  return source;
}

/// The least revision of kBeside that may be shown with it; 0: any.
std::uint64_t least_of_other(const SourcePart& source, const Viewer& viewer, const SendPlan& plan) {
  const auto links = links_for(source, source.part.mesh, viewer, plan);
  const auto link = std::ranges::find(links, kBeside, &PartLink::key);
  return link == links.end() ? 0 : link->least;
}

TEST(Coexistence, MAP12WhatAReceiverHasOfAnEarlierSenderIsAsItsLastViewSays) {
  Viewer viewer;
  take_held(viewer, {{.key = kBeside, .revision = 5, .version = 1}}, 0);
  take_held(viewer, {{.key = kBeside, .revision = 9, .version = 2}}, 0);
  SendPlan plan;
  plan.removed.insert(kBeside);
  EXPECT_EQ(least_of_other(source_at(0), viewer, plan), 10U);
}

TEST(Coexistence, MAP12WhatWasBesideAnEarlierVersionIsToldOfHoweverFarTheNewOneIs) {
  SendPlan plan;
  plan.removed.insert(kBeside);
  Viewer viewer;
  viewer.sent[kBeside] = {.revision = 7, .extent = PartBox{{1, 1, 0}, {2, 2, 0}}};
  viewer.has[kBeside] = {.revision = 7, .since = 7, .version = 1};
  EXPECT_EQ(least_of_other(source_at(0), viewer, plan), 8U);
  EXPECT_EQ(least_of_other(source_at(9), viewer, plan), 0U);  // far from all that ever was
  // Of the part itself, or of the cell around it.
  for (const PartKey& key : {kNew, ancestor(kNew, 1)}) {
    Viewer with_earlier = viewer;
    with_earlier.sent[key] = {.revision = 7, .extent = PartBox{{0, 0, 0}, {1, 1, 0}}};
    with_earlier.has[key] = {.revision = 7, .since = 7, .version = 1};
    EXPECT_EQ(least_of_other(source_at(9), with_earlier, plan), 8U) << int{key.level};
  }
}

TEST(Coexistence, MAP12WhatNeverWasOtherwiseIsNotTold) {
  SendPlan plan;
  plan.staying.insert(kBeside);
  Viewer viewer;
  for (const std::uint64_t revision : {7, 8}) {
    EXPECT_EQ(viewer.next_revision(kBeside, revision, 0), revision);
    viewer.sent[kBeside].add({{1, 1, 0}, {2, 2, 0}});
    viewer.has[kBeside] = {.revision = revision, .since = revision, .stage = Believed::Stage::kSent};
    EXPECT_EQ(least_of_other(source_at(0), viewer, plan), revision == 7 ? 0 : revision);
  }
  // A receiver that has it from elsewhere.
  Viewer other;
  take_held(other, {{.key = kBeside, .revision = 5, .version = 1}}, 0);
  (void)other.next_revision(kBeside, 7, 0);
  other.sent[kBeside].add({{1, 1, 0}, {2, 2, 0}});
  other.has[kBeside] = {.revision = 7, .since = 7, .stage = Believed::Stage::kSent};
  EXPECT_EQ(least_of_other(source_at(0), other, plan), 7U);
}

}  // namespace
}  // namespace deltamesh::coexistence_test
