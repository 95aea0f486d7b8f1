// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The worked example of maps: two triangles in two parts.
#include <gtest/gtest.h>

#include <string>

#include "deltamesh/map/fragment.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/split.h"
#include "spec/example_lines.h"

namespace deltamesh {
namespace {

using test::bytes_of;
using test::line_of;

const MapDescription kDescription = {
    .id = 7, .epoch = 1, .frame = "map", .lattice = {.step_exponent = -2}, .cell_steps = 8};

TEST(MapExamples, MAP5MessageOfTheMap) {
  const auto message = bytes_of("map.md", "message");
  const auto written = write_description(kDescription);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, message);
  const auto read = read_description(message);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(*read, kDescription);
}

TEST(MapExamples, MAP2MAP4MAP7MAP8MAP11TwoParts) {
  Mesh mesh;
  mesh.positions = line_of<float>("map.md", "positions");
  mesh.triangles = {0, 1, 2, 2, 1, 3};
  const auto points = line_of<std::int32_t>("map.md", "points");
  ASSERT_EQ(points.size(), mesh.positions.size());
  for (std::size_t at = 0; at < points.size(); at += 3) {
    const float* p = mesh.positions.data() + at;
    EXPECT_EQ(kDescription.lattice.nearest({p[0], p[1], p[2]}),
              (LatticePoint{points[at], points[at + 1], points[at + 2]}));
  }
  const auto parts = split(mesh, kDescription, {.most_level = 0});
  ASSERT_TRUE(parts) << describe(parts.error());
  ASSERT_EQ(parts->size(), 2U);
  const auto codec = MapCodec::open(kDescription);
  ASSERT_TRUE(codec);
  for (const std::size_t i : {0, 1}) {
    const std::string number = std::to_string(i);
    const MapPart& part = (*parts)[i];
    const auto coded = codec->encode(
        part,
        {.bounds = {.max_error = QualityBound{0.25}}, .geometry = GeometryCoder::kPredictive, .effort = 0});
    ASSERT_TRUE(coded) << describe(coded.error());
    EXPECT_EQ(coded->bytes, bytes_of("map.md", "part-" + number));
    const auto decoded = codec->decode(part.key, coded->bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    EXPECT_EQ(decoded->mesh.positions, line_of<float>("map.md", "decoded-" + number));
    std::vector<std::uint32_t> border;
    for (const BorderVertex& vertex : decoded->border) border.push_back(vertex.vertex);
    EXPECT_EQ(border, line_of<std::uint32_t>("map.md", "border-" + number));
  }
}

TEST(MapExamples, MAP23MAP25APoseInFragments) {
  const PoseMessage pose{.map = hash_of(kDescription),
                         .start = 1,
                         .number = 5,
                         .pose = {1'500'000'000, {0.5, 0.5, 0.5, 0.5}, {1, 2, -0.5}}};
  const auto written = write_pose(pose);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, bytes_of("map.md", "pose"));
  const auto pieces = cut_message(*written, 64);
  ASSERT_TRUE(pieces);
  FragmentJoiner joiner;
  for (std::size_t i = pieces->size(); i-- > 0;) {
    EXPECT_EQ((*pieces)[i], bytes_of("map.md", "fragment-" + std::to_string(i)));
    const auto whole = joiner.add((*pieces)[i]);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->value_or(std::vector<std::byte>()), i == 0 ? *written : std::vector<std::byte>());
  }
}

}  // namespace
}  // namespace deltamesh
