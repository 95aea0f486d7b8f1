// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Parts as bytes: equal borders whatever the quality, the same faces, bounds kept.
#include "deltamesh/map/map_codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "deltamesh/map/encode_map.h"
#include "deltamesh/map/join.h"
#include "deltamesh/map/split.h"
#include "field/marching_cubes.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

using test::attributes_of;
using test::random_mesh;
using test::topology_counts;
using test::wavy_sheet;
using test::welded;

MapDescription description_of(const Mesh& mesh, std::uint32_t cell_steps) {
  return {.id = 7, .epoch = 1, .frame = "map", .cell_steps = cell_steps, .attributes = attributes_of(mesh)};
}

PartQuality random_quality(std::mt19937& random) {
  PartQuality quality;
  quality.effort = static_cast<int>(random() % 3);
  quality.geometry = random() % 2 == 0 ? GeometryCoder::kHighpass : GeometryCoder::kPredictive;
  const double bound = 0.001 * static_cast<double>(1 + random() % 8);
  switch (random() % 3) {
    case 0:
      quality.bounds.max_error = QualityBound{bound};
      break;
    case 1:
      quality.bounds.lfe = QualityBound{bound};
      break;
    default:
      quality.bounds.max_error = QualityBound{2 * bound};
      quality.bounds.vde = QualityBound{bound};
  }
  quality.attributes.color_error = static_cast<double>(random() % 5);
  return quality;
}

/// With models that begin where primers leave them.
MapDescription primed(const MapDescription& description, const std::vector<MapPart>& parts) {
  const auto with =
      with_primers(description, parts, {.bounds = {.max_error = QualityBound{0.002}}, .effort = 0});
  EXPECT_TRUE(with) << describe(with.error());
  return with ? *with : description;
}

/// Every part in a quality of its own, and what receivers make of the whole.
void expect_no_crack(const Mesh& mesh, const MapDescription& description, const SplitOptions& options,
                     std::uint32_t seed) {
  const auto parts = split(mesh, description, options);
  ASSERT_TRUE(parts) << describe(parts.error());
  const auto codec = MapCodec::open(seed % 3 == 0 ? description : primed(description, *parts));
  ASSERT_TRUE(codec);
  std::mt19937 random(seed);
  std::vector<MapPart> decoded;
  std::map<std::pair<LatticePoint, std::uint32_t>, int> uses;
  for (const MapPart& part : *parts) {
    const PartQuality quality = random_quality(random);
    const auto coded = codec->encode(part, quality);
    ASSERT_TRUE(coded) << describe(coded.error());
    EXPECT_EQ(coded->bytes, codec->encode(part, quality)->bytes);
    if (quality.bounds.max_error) {
      EXPECT_LE(coded->quality.max_error, quality.bounds.max_error->value);
    }
    if (quality.bounds.vde) {
      EXPECT_LE(coded->quality.vde_rms, quality.bounds.vde->value);
    }
    if (quality.bounds.lfe) {
      EXPECT_LE(coded->quality.lfe_rms, quality.bounds.lfe->value);
    }
    auto back = codec->decode(part.key, coded->bytes);
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(topology_counts(back->mesh), topology_counts(part.mesh));
    ASSERT_EQ(back->border.size(), part.border.size());
    std::multiset<std::pair<LatticePoint, std::uint32_t>> source;
    std::multiset<std::pair<LatticePoint, std::uint32_t>> received;
    for (const BorderVertex& b : part.border) source.insert({b.point, b.twin});
    for (const BorderVertex& b : back->border) {
      received.insert({b.point, b.twin});
      const auto position = description.lattice.position_of(b.point);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(back->mesh.positions[3 * std::size_t{b.vertex} + k], position[k]);
    }
    EXPECT_EQ(received, source);
    decoded.push_back(*std::move(back));
  }
  for (MapPart& part : decoded) part.mesh.attributes.clear();  // the parts keep them at different qualities
  const auto joined = join(decoded);
  ASSERT_TRUE(joined);
  EXPECT_EQ(topology_counts(*joined), topology_counts(welded(mesh)));
}

TEST(MapCodec, MAP8NoCracksAtAnyQualityByEitherCoder) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh sheet = wavy_sheet(36, 24, seed, seed % 2 == 0 ? 0 : 0.006);
    expect_no_crack(sheet, description_of(sheet, 60 + 40 * seed), {100 + 100 * seed, 4}, seed);
    const Mesh soup = random_mesh(seed, 120, 300);
    expect_no_crack(soup, description_of(soup, 300), {60, 1}, seed);
  }
}

/// It is sent with the map's message in place of a message of its own.
TEST(MapCodec, MAP6ASinglePartIsAPrimerForThoseToCome) {
  const Mesh mesh = wavy_sheet(80, 60, 5, 0.002);
  const MapDescription description = description_of(mesh, 150);
  const auto parts = split(mesh, description, {.most_triangles = 400, .most_level = 3});
  ASSERT_TRUE(parts);
  ASSERT_GT(parts->size(), 2U);
  const PartQuality quality{.bounds = {.max_error = QualityBound{0.002}}, .effort = 1};
  const auto with = with_primers(description, std::span(*parts).first(1), quality);
  ASSERT_TRUE(with);
  ASSERT_EQ(with->primers.size(), 1U);
  const auto fresh = MapCodec::open(description);
  const auto primed = MapCodec::open(*with);
  EXPECT_LT(primed->encode(parts->front(), quality)->bytes.size(), 10U);
  for (const MapPart& part : std::span(*parts).subspan(1)) {
    EXPECT_LT(primed->encode(part, quality)->bytes.size(), fresh->encode(part, quality)->bytes.size());
  }
}

TEST(MapCodec, MAP6PrimersSaveBytesAndArePartsThemselves) {
  const Mesh mesh = wavy_sheet(80, 60, 5, 0.002);
  const MapDescription description = description_of(mesh, 150);
  const auto parts = split(mesh, description, {.most_triangles = 400, .most_level = 3});
  ASSERT_TRUE(parts);
  const PartQuality quality{.bounds = {.max_error = QualityBound{0.002}}, .effort = 1};
  const auto with = with_primers(description, *parts, quality);
  ASSERT_TRUE(with);
  ASSERT_FALSE(with->primers.empty());
  const auto fresh = MapCodec::open(description);
  const auto primed = MapCodec::open(*with);
  std::size_t fresh_bytes = 0;
  std::size_t primed_bytes = 0;
  std::size_t primers = 0;
  for (const MapPart& part : *parts) {
    const auto coded = primed->encode(part, quality);
    ASSERT_TRUE(coded);
    const auto decoded = primed->decode(part.key, coded->bytes);
    ASSERT_TRUE(decoded) << describe(decoded.error());
    EXPECT_EQ(topology_counts(decoded->mesh), topology_counts(part.mesh));
    fresh_bytes += fresh->encode(part, quality)->bytes.size();
    primed_bytes += coded->bytes.size();
    primers += coded->bytes.size() == 6 ? 1 : 0;
  }
  EXPECT_EQ(primers, with->primers.size());
  primed_bytes += write_description(*with)->size() - write_description(description)->size();
  EXPECT_LT(primed_bytes, fresh_bytes * 9 / 10);
  MapDescription damaged = *with;
  damaged.primers[0].stream[40] ^= std::byte{1};
  EXPECT_EQ(MapCodec::open(damaged).error().code, ErrorCode::kCorrupt);
}

TEST(MapCodec, MAP7EveryDamageIsAnError) {
  const Mesh mesh = wavy_sheet(12, 12, 5, 0);
  const MapDescription description = description_of(mesh, 100);
  const auto codec = MapCodec::open(description);
  const auto parts = split(mesh, description, {.most_triangles = 80, .most_level = 2});
  ASSERT_TRUE(parts);
  const MapPart& part = parts->front();
  const auto coded = codec->encode(part, {.bounds = {.max_error = QualityBound{0.002}}});
  ASSERT_TRUE(coded);
  for (std::size_t size = 0; size < coded->bytes.size(); ++size)
    EXPECT_FALSE(codec->decode(part.key, std::span(coded->bytes).first(size)));
  for (std::size_t i = 0; i < coded->bytes.size(); ++i) {
    auto damaged = coded->bytes;
    damaged[i] ^= std::byte{1};
    EXPECT_FALSE(codec->decode(part.key, damaged));
  }
  // Another part, another map, another epoch.
  PartKey other = part.key;
  ++other.x;
  EXPECT_EQ(codec->decode(other, coded->bytes).error().code, ErrorCode::kCorrupt);
  MapDescription next = description;
  ++next.epoch;
  EXPECT_EQ(MapCodec::open(next)->decode(part.key, coded->bytes).error().code, ErrorCode::kCorrupt);
}

TEST(MapCodec, RefusesWhatCannotBe) {
  const Mesh mesh = wavy_sheet(30, 10, 5, 0.003);
  const MapDescription description = description_of(mesh, 100);
  const auto codec = MapCodec::open(description);
  const auto parts = split(mesh, description, {.most_triangles = 80, .most_level = 2});
  ASSERT_TRUE(parts);
  const auto finer = codec->encode(parts->front(), {.bounds = {.max_error = QualityBound{1e-5}}});
  ASSERT_FALSE(finer);
  EXPECT_EQ(finer.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(finer.error().best_value, 1e-4);
  EXPECT_EQ(codec->encode(parts->front(), {.bounds = {.target_bytes = 100}}).error().code,
            ErrorCode::kInvalidArgument);
  MapPart bad = parts->front();
  bad.mesh.attributes.clear();
  EXPECT_EQ(codec->encode(bad).error().code, ErrorCode::kInvalidMesh);
  bad = parts->front();
  std::swap(bad.border[0], bad.border[1]);
  EXPECT_EQ(codec->encode(bad).error().code, ErrorCode::kInvalidMesh);
}

/// Where a part's vertices are nearly all on its border, what suits the bounds is too coarse.
TEST(MapCodec, MAP8AMapHasALatticeThatEveryPartCanKeepItsBoundsOn) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Mesh mesh = random_mesh(seed, 200, 900);
    MapSettings settings{.part_edge = 1, .most_triangles = 1500};
    settings.quality = {.geometry = GeometryCoder::kHighpass, .effort = 0};
    settings.quality.bounds.vde = QualityBound{0.05, QualityUnit::kDiagonal};
    settings.quality.bounds.lfe = QualityBound{0.2, QualityUnit::kDiagonal};
    const auto first = encode_map(mesh, settings);
    ASSERT_TRUE(first) << describe(first.error());
    for (const PartEntry& entry : first->manifest.entries)
      EXPECT_LE(entry.quality.vde_rms, first->bounds.vde->value);
    // It stays with the next state.
    const auto second = encode_map(mesh, settings, &*first);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->manifest.description, first->manifest.description);
  }
}

}  // namespace
}  // namespace deltamesh
