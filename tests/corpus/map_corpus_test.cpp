// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Real meshes as maps: no crack, no face twice or missing, at several sizes of parts, by both coders, of
// any qualities, revisions and levels.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "corpus_files.h"
#include "deltamesh/io.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "map/map_covers.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

using test::chosen;
using test::face_bits;
using test::keys_of;
using test::odd_edges;
using test::random_cover;
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

/// Border vertices that are one have the same bits in all parts. How many there are.
std::size_t expect_same_borders(const std::vector<MapPart>& parts) {
  std::map<std::pair<LatticePoint, std::uint32_t>, std::array<std::uint32_t, 3>> known;
  std::size_t wrong = 0;
  for (const MapPart& part : parts) {
    for (const BorderVertex& border : part.border) {
      std::array<std::uint32_t, 3> bits{};
      for (std::size_t k = 0; k < 3; ++k)
        bits[k] = std::bit_cast<std::uint32_t>(part.mesh.positions[3 * std::size_t{border.vertex} + k]);
      const auto [place, is_new] = known.try_emplace({border.point, border.twin}, bits);
      wrong += place->second == bits ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0U);
  return known.size();
}

/// A newer revision of a part: what is not on its border has moved a little.
MapPart moved(MapPart part, double way, std::mt19937& random) {
  std::vector<bool> is_fixed(part.mesh.vertex_count());
  for (const BorderVertex& border : part.border) is_fixed[border.vertex] = true;
  for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v)
    for (std::size_t k = 0; k < 3 && !is_fixed[v]; ++k)
      part.mesh.positions[3 * v + k] +=
          static_cast<float>(way * (static_cast<double>(random() % 2001) / 1000 - 1));
  return part;
}

/// By either coder, at a random quality. Where highpass cannot keep it, predictive.
Result<MapPart> through_the_codec(const MapCodec& codec, const MapPart& part, double finest,
                                  std::mt19937& random) {
  PartQuality quality{.effort = 0};
  quality.geometry = random() % 3 == 0 ? GeometryCoder::kHighpass : GeometryCoder::kPredictive;
  quality.bounds.max_error = QualityBound{finest * (1 + static_cast<double>(random() % 8))};
  auto coded = codec.encode(part, quality);
  if (!coded && quality.geometry == GeometryCoder::kHighpass) {
    quality.geometry = GeometryCoder::kPredictive;
    coded = codec.encode(part, quality);
  }
  if (!coded) return coded.error();
  EXPECT_LE(coded->quality.max_error, quality.bounds.max_error->value);
  return codec.decode(part.key, coded->bytes);
}

/// Parts of any quality, revision and level, without attributes.
void expect_no_crack(Mesh mesh, std::uint32_t most_triangles, std::uint32_t seed) {
  mesh.attributes.clear();
  mesh.face_groups.clear();
  const double diagonal = diagonal_of(mesh);
  const double finest = 0.0002 * diagonal;
  MapDescription description{.id = seed};
  description.lattice = {.origin = mesh.origin, .step_exponent = step_exponent_for(finest)};
  description.cell_steps =
      static_cast<std::uint32_t>(std::max(1.0, diagonal / 200 / description.lattice.step()));
  const auto parts =
      split(mesh, description, {.most_triangles = most_triangles, .most_level = 5, .copy_level = 7});
  ASSERT_TRUE(parts) << describe(parts.error());
  const auto finest_keys = keys_on_level(keys_of(*parts), 0);
  const auto whole = join(chosen(*parts, finest_keys));
  EXPECT_EQ(face_bits(*whole), face_bits(mesh));
  const auto codec = MapCodec::open(description);
  std::mt19937 random(seed);
  std::vector<MapPart> decoded;
  for (const MapPart& part : *parts) {
    const bool is_newer = random() % 2 == 0;
    auto back = through_the_codec(*codec, is_newer ? moved(part, finest, random) : part, finest, random);
    ASSERT_TRUE(back) << describe(back.error());
    decoded.push_back(*std::move(back));
  }
  const std::size_t borders = expect_same_borders(decoded);
  EXPECT_TRUE(borders > 0 || parts->size() == 1 || topology_counts(*whole).components > 1);
  const auto joined = join(chosen(decoded, finest_keys));
  ASSERT_TRUE(joined);
  EXPECT_EQ(topology_counts(*joined), topology_counts(*whole));
  // Of any levels: what is closed stays closed.
  if (odd_edges(*whole) != 0) return;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(odd_edges(*join(chosen(decoded, random_cover(decoded, random)))), 0U);
}

std::vector<std::byte> color_at(const Mesh& mesh, std::size_t attribute, std::size_t vertex) {
  const Attribute& colors = mesh.attributes[attribute];
  const std::size_t size = colors.components * component_size(colors.type);
  const auto begin = colors.values.begin() + static_cast<std::ptrdiff_t>(vertex * size);
  return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

/// What is one vertex of the source has one colour in all parts.
void expect_one_color(const Mesh& mesh, std::uint32_t most_triangles, const AttributeQuality& quality) {
  const double diagonal = diagonal_of(mesh);
  MapDescription description{
      .lattice = {.origin = mesh.origin, .step_exponent = step_exponent_for(0.0004 * diagonal)}};
  description.cell_steps =
      static_cast<std::uint32_t>(std::max(1.0, diagonal / 200 / description.lattice.step()));
  for (const Attribute& a : mesh.attributes)
    description.attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name, a.linear});
  const auto parts = split(mesh, description, {.most_triangles = most_triangles, .most_level = 5});
  ASSERT_TRUE(parts) << describe(parts.error());
  const auto codec = MapCodec::open(description);
  std::map<std::tuple<std::size_t, LatticePoint, std::uint32_t, std::vector<std::byte>>,
           std::vector<std::byte>>
      known;
  std::size_t differing = 0;
  for (const MapPart& part : *parts) {
    const auto coded = codec->encode(
        part, {.bounds = {.max_error = QualityBound{0.0004 * diagonal}}, .attributes = quality, .effort = 0});
    ASSERT_TRUE(coded) << describe(coded.error());
    const auto decoded = codec->decode(part.key, coded->bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    std::map<std::pair<LatticePoint, std::uint32_t>, std::vector<std::uint32_t>> sources;
    for (const BorderVertex& b : part.border) sources[{b.point, b.twin}].push_back(b.vertex);
    for (const BorderVertex& b : decoded->border) {
      const auto& rows = sources.at({b.point, b.twin});
      for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
        if (mesh.attributes[a].kind != AttributeKind::kColor || rows.size() != 1) continue;
        const auto color = color_at(decoded->mesh, a, b.vertex);
        const auto [place, is_new] =
            known.try_emplace({a, b.point, b.twin, color_at(part.mesh, a, rows.front())}, color);
        differing += place->second != color ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(differing, 0U);
}

class MapCorpus : public ::testing::TestWithParam<std::string> {};

TEST_P(MapCorpus, NoCracksInPartsOfAnyQuality) {
  if (GetParam() == testing_corpus::kNoCorpus) GTEST_SKIP() << "no corpus";
  const auto imported = read_mesh_file((testing_corpus::corpus() / GetParam()).string());
  ASSERT_TRUE(imported);
  if (imported->mesh.triangles.empty()) GTEST_SKIP() << "no faces";
  expect_no_crack(imported->mesh, 400, 0);
  expect_no_crack(imported->mesh, 1500, 1);
  expect_no_crack(imported->mesh, 12000, 2);
}

TEST_P(MapCorpus, NoSeamsInColors) {
  if (GetParam() == testing_corpus::kNoCorpus) GTEST_SKIP() << "no corpus";
  const auto imported = read_mesh_file((testing_corpus::corpus() / GetParam()).string());
  ASSERT_TRUE(imported);
  Mesh mesh = imported->mesh;
  std::erase_if(mesh.attributes, [](const Attribute& a) { return a.kind != AttributeKind::kColor; });
  mesh.face_groups.clear();
  if (mesh.triangles.empty() || mesh.attributes.empty()) GTEST_SKIP() << "no faces or no colours";
  expect_one_color(mesh, 1500, {.color_rms = kPhotographicRms});
  expect_one_color(mesh, 12000, {.color_rms = 8});
  expect_one_color(mesh, 4000, {.color_error = 4});
}

INSTANTIATE_TEST_SUITE_P(Files, MapCorpus, ::testing::ValuesIn(testing_corpus::mesh_files()),
                         testing_corpus::test_name);

}  // namespace
}  // namespace deltamesh
