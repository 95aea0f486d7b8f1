// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Real meshes as maps: no crack, no face twice or missing, at several sizes of parts and qualities of parts.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "corpus_files.h"
#include "deltamesh/io.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

using test::face_bits;
using test::topology_counts;

double diagonal_of(const Mesh& mesh) {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double x = mesh.positions[i];
    low[i % 3] = i < 3 ? x : std::min(low[i % 3], x);
    high[i % 3] = i < 3 ? x : std::max(high[i % 3], x);
  }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

/// Without attributes: border vertices have the same bits in all parts, whatever each was asked for.
void expect_no_crack(Mesh mesh, std::uint32_t most_triangles, std::uint32_t seed) {
  mesh.attributes.clear();
  mesh.face_groups.clear();
  const double diagonal = diagonal_of(mesh);
  const double finest = 0.0002 * diagonal;
  MapDescription description{.id = seed};
  description.lattice = {.origin = mesh.origin, .step_exponent = step_exponent_for(finest)};
  description.cell_steps =
      static_cast<std::uint32_t>(std::max(1.0, diagonal / 200 / description.lattice.step()));
  const auto parts = split(mesh, description, {.most_triangles = most_triangles, .most_level = 5});
  ASSERT_TRUE(parts) << describe(parts.error());
  const auto whole = join(*parts);
  EXPECT_EQ(face_bits(*whole), face_bits(mesh));
  const auto codec = MapCodec::open(description);
  std::mt19937 random(seed);
  std::vector<MapPart> decoded;
  for (const MapPart& part : *parts) {
    PartQuality quality{.effort = 0};
    quality.geometry = random() % 4 == 0 ? GeometryCoder::kHighpass : GeometryCoder::kPredictive;
    quality.bounds.max_error = QualityBound{finest * (1 + static_cast<double>(random() % 8))};
    auto coded = codec->encode(part, quality);
    if (!coded && quality.geometry == GeometryCoder::kHighpass) {
      quality.geometry = GeometryCoder::kPredictive;
      coded = codec->encode(part, quality);
    }
    ASSERT_TRUE(coded) << describe(coded.error());
    EXPECT_LE(coded->quality.max_error, quality.bounds.max_error->value);
    auto back = codec->decode(part.key, coded->bytes);
    ASSERT_TRUE(back) << describe(back.error());
    decoded.push_back(*std::move(back));
  }
  const auto joined = join(decoded);
  ASSERT_TRUE(joined);
  EXPECT_EQ(topology_counts(*joined), topology_counts(*whole));
}

class MapCorpus : public ::testing::TestWithParam<std::string> {};

TEST_P(MapCorpus, NoCracksInPartsOfAnyQuality) {
  if (GetParam() == testing_corpus::kNoCorpus) GTEST_SKIP() << "no corpus";
  const auto imported = read_mesh_file((testing_corpus::corpus() / GetParam()).string());
  ASSERT_TRUE(imported);
  if (imported->mesh.triangles.empty()) GTEST_SKIP() << "no faces";
  expect_no_crack(imported->mesh, 1500, 1);
  expect_no_crack(imported->mesh, 12000, 2);
}

INSTANTIATE_TEST_SUITE_P(Files, MapCorpus, ::testing::ValuesIn(testing_corpus::mesh_files()),
                         testing_corpus::test_name);

}  // namespace
}  // namespace deltamesh
