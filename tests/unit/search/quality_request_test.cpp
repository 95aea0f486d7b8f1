// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Quality requests through the public interface.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "measure/error_peaks.h"
#include "support/graph_mesh.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

QualityBound percent(double value) { return {.value = value, .unit = QualityUnit::kDiagonal}; }

/// `count` copies of a small strip of 10 vertices, side by side.
Mesh fragments(std::uint32_t count) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float x = static_cast<float>(3 * (i % 40));
    const float y = static_cast<float>(3 * (i / 40));
    for (std::uint32_t k = 0; k < 10; ++k) {
      const float bump = 0.1F * static_cast<float>((k * 7 + i * 3) % 11);
      mesh.positions.insert(mesh.positions.end(),
                            {x + 0.4F * static_cast<float>(k / 2), y + static_cast<float>(k % 2), bump});
    }
    for (std::uint32_t k = 0; k < 8; ++k)
      mesh.triangles.insert(mesh.triangles.end(),
                            {10 * i + k, 10 * i + k + 1 + k % 2, 10 * i + k + 2 - k % 2});
  }
  return mesh;
}

Mesh flat_grid() {
  Mesh mesh = test::bumpy_grid(30, 30);
  for (std::size_t i = 2; i < mesh.positions.size(); i += 3) mesh.positions[i] = 0;
  return mesh;
}

Mesh one_triangle() {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2};
  return mesh;
}

/// The stream's declared figures are those of its decoded mesh.
void expect_declared_quality(const Mesh& mesh, const Encoded& encoded) {
  const auto decoded = decode(encoded.bytes);
  ASSERT_TRUE(decoded);
  const auto comparison = compare(mesh, *decoded, encoded.order);
  ASSERT_TRUE(comparison && comparison->corresponding);
  const Quality& told = encoded.report.stream.quality;
  EXPECT_NEAR(comparison->quality.vde_rms, told.vde_rms, 1e-3 * told.vde_rms + 1e-9);
  EXPECT_NEAR(comparison->quality.lfe_rms, told.lfe_rms, 1e-3 * told.lfe_rms + 1e-9);
}

/// A grid whose vertices are shaken by a fixed pseudo-random sequence: no two deltas are alike.
Mesh shaken_grid() {
  Mesh mesh = test::bumpy_grid(70, 60);
  std::uint32_t state = 1;
  for (float& x : mesh.positions) {
    state = 1664525 * state + 1013904223;
    x += 0.3F * static_cast<float>(state >> 8) / static_cast<float>(1 << 24);
  }
  return mesh;
}

TEST(QualityRequest, LandsOnAGrid) {
  const Mesh mesh = shaken_grid();
  const auto diagonal = encode(mesh)->report.stream.diagonal;
  for (const double share : {0.1, 0.05, 0.01}) {
    const auto visual = encode(mesh, {.quality = {.vde = percent(share)}});
    ASSERT_TRUE(visual) << describe(visual.error());
    expect_declared_quality(mesh, *visual);
    EXPECT_LE(visual->report.stream.quality.vde_rms, share / 100 * diagonal);
    EXPECT_GE(visual->report.stream.quality.vde_rms, 0.9 * share / 100 * diagonal);
    const auto positional = encode(mesh, {.quality = {.lfe = percent(share)}});
    ASSERT_TRUE(positional) << describe(positional.error());
    expect_declared_quality(mesh, *positional);
    EXPECT_LE(positional->report.stream.quality.lfe_rms, share / 100 * diagonal);
    EXPECT_GE(positional->report.stream.quality.lfe_rms, 0.85 * share / 100 * diagonal);
  }
}

TEST(QualityRequest, UnitsAgree) {
  const Mesh mesh = test::bumpy_grid(30, 30);
  const StreamInfo info = encode(mesh)->report.stream;
  const double vde = 0.0005 * info.diagonal;
  const PaperQuality paper = paper_form({.vde_rms = vde}, info.geometric_vertices, info.diagonal);
  const auto model = encode(mesh, {.quality = {.vde = QualityBound{.value = vde}}});
  const auto relative = encode(mesh, {.quality = {.vde = percent(0.05)}});
  const auto sum =
      encode(mesh, {.quality = {.vde = QualityBound{.value = paper.vde, .unit = QualityUnit::kPaper}}});
  ASSERT_TRUE(model && relative && sum);
  EXPECT_NEAR(model->report.stream.step, relative->report.stream.step, 1e-6 * model->report.stream.step);
  EXPECT_NEAR(model->report.stream.step, sum->report.stream.step, 1e-6 * model->report.stream.step);
}

TEST(QualityRequest, EqualRequestsGiveEqualBytes) {
  const Mesh mesh = test::bumpy_grid(40, 40);
  const EncodeOptions options{.quality = {.vde = percent(0.05), .lfe = percent(0.1)}};
  EXPECT_EQ(encode(mesh, options)->bytes, encode(mesh, options)->bytes);
}

TEST(QualityRequest, ContainersDoNotChangeTheStream) {
  const Mesh mesh = test::bumpy_grid(40, 40);
  EncodeOptions options{.quality = {.vde = percent(0.05), .lfe = percent(0.1)}};
  const auto alone = encode(mesh, options);
  options.anchor_containers = std::make_shared<AnchorContainers>();
  const auto first = encode(mesh, options);
  const auto searches = options.anchor_containers->searches();
  EXPECT_GT(searches, 0U);
  const auto second = encode(mesh, options);
  EXPECT_EQ(options.anchor_containers->searches(), searches);
  ASSERT_TRUE(alone && first && second);
  EXPECT_EQ(first->bytes, alone->bytes);
  EXPECT_EQ(second->bytes, alone->bytes);
}

TEST(QualityRequest, MaxErrorIsKeptOnAwkwardMeshes) {
  for (const auto& named : test::awkward_meshes()) {
    const auto plain = encode(named.mesh);
    ASSERT_TRUE(plain);
    const double diagonal = plain->report.stream.diagonal;
    if (!(diagonal > 0)) continue;
    for (const int effort : {0, 1}) {
      const double asked = 0.002 * diagonal;
      const auto encoded =
          encode(named.mesh, {.quality = {.max_error = QualityBound{asked}}, .effort = effort});
      ASSERT_TRUE(encoded) << named.name << ": " << describe(encoded.error());
      EXPECT_LE(encoded->report.stream.quality.max_error, asked) << named.name;
    }
  }
}

/// Anchors keep the bound where planned cycles alone would break it.
TEST(QualityRequest, DELT7LargestErrorsGetPlannedCycles) {
  const Mesh mesh = shaken_grid();
  for (const double asked : {0.02, 0.1}) {
    const auto encoded =
        encode(mesh, {.quality = {.max_error = QualityBound{asked}}, .geometry = GeometryCoder::kHighpass});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    expect_declared_quality(mesh, *encoded);
    EXPECT_GT(encoded->report.stream.cycles, 0) << asked;
    EXPECT_LE(encoded->report.stream.quality.max_error, asked);
  }
}

TEST(QualityRequest, SmallFragmentedAndFlatMeshesSucceed) {
  for (const Mesh& mesh : {one_triangle(), fragments(1000), flat_grid(), Mesh{}}) {
    for (const QualityRequest& request :
         {QualityRequest{.vde = percent(0.02)}, QualityRequest{.lfe = percent(0.1)},
          QualityRequest{.vde = percent(0.02), .lfe = percent(0.1)},
          QualityRequest{.max_error = QualityBound{0.01}}, QualityRequest{.target_bytes = 40000}}) {
      const auto encoded = encode(mesh, {.quality = request, .effort = 1});
      ASSERT_TRUE(encoded) << mesh.vertex_count() << ' ' << describe(encoded.error());
      const StreamInfo& stream = encoded->report.stream;
      if (request.vde) {
        EXPECT_LE(stream.quality.vde_rms, 0.02 / 100 * stream.diagonal);
      }
      if (request.lfe) {
        EXPECT_LE(stream.quality.lfe_rms, 0.1 / 100 * stream.diagonal);
      }
      if (request.max_error) {
        EXPECT_LE(stream.quality.max_error, 0.01);
      }
      if (request.target_bytes) {
        EXPECT_LE(stream.bytes, 40000U);
      }
    }
  }
}

TEST(QualityRequest, TargetBytesIsNearlyUsedUp) {
  const Mesh mesh = shaken_grid();
  for (const std::uint64_t target : {6000U, 9000U, 16000U}) {
    const auto encoded = encode(mesh, {.quality = {.target_bytes = target}});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    EXPECT_LE(encoded->bytes.size(), target);
    EXPECT_GE(static_cast<double>(encoded->bytes.size()), 0.95 * static_cast<double>(target));
  }
}

/// Coarse lattices, whose VDE says little: of those that fit the finest is taken.
TEST(QualityRequest, ASmallBudgetIsNearlyUsedUpByALattice) {
  const Mesh mesh = shaken_grid();
  for (const std::uint64_t target : {400U, 700U, 1000U, 1500U, 2200U, 3200U, 5000U}) {
    const auto encoded =
        encode(mesh, {.quality = {.target_bytes = target}, .geometry = GeometryCoder::kPredictive});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    EXPECT_LE(encoded->bytes.size(), target);
    EXPECT_GE(static_cast<double>(encoded->bytes.size()), 0.9 * static_cast<double>(target)) << target;
  }
}

/// Heights over a grid, which no lattice of one step for all axes suits.
TEST(QualityRequest, AsManyBytesAsABoundTakesGiveItsQuality) {
  Mesh heights = shaken_grid();
  const Mesh grid = test::bumpy_grid(70, 60);
  for (std::size_t i = 0; i < grid.positions.size(); ++i)
    if (i % 3 != 2) heights.positions[i] = grid.positions[i];
  for (const Mesh& mesh : {shaken_grid(), heights}) {
    for (const double share : {0.02, 0.1, 0.5}) {
      const auto bounded =
          encode(mesh, {.quality = {.max_error = percent(share)}, .geometry = GeometryCoder::kPredictive});
      ASSERT_TRUE(bounded);
      const auto fitting = encode(
          mesh, {.quality = {.target_bytes = bounded->bytes.size()}, .geometry = GeometryCoder::kPredictive});
      ASSERT_TRUE(fitting) << describe(fitting.error());
      EXPECT_LE(fitting->bytes.size(), bounded->bytes.size());
      EXPECT_LE(fitting->report.stream.quality.max_error, 1.4 * bounded->report.stream.quality.max_error);
    }
  }
}

/// All colours are within 1 of each other: exact ones take many bytes, those that may be off by 1 none.
TEST(QualityRequest, BytesThatColorsNeedNoMoreGoToPlaces) {
  Mesh mesh = shaken_grid();
  Attribute colors{.kind = AttributeKind::kColor, .type = ComponentType::kU8, .components = 3, .name = "red"};
  for (std::uint32_t i = 0; i < 3 * mesh.vertex_count(); ++i)
    colors.values.push_back(static_cast<std::byte>(100 + (i * 2654435761U >> 8) % 3));
  mesh.attributes = {colors};
  const auto usual = encode(mesh);
  ASSERT_TRUE(usual);
  const StreamInfo& stream = usual->report.stream;
  const std::uint64_t target = stream.bytes - stream.attribute_bytes * 9 / 10;
  const auto encoded = encode(mesh, {.quality = {.target_bytes = target}});
  ASSERT_TRUE(encoded) << describe(encoded.error());
  EXPECT_LE(encoded->bytes.size(), target);
  EXPECT_GE(static_cast<double>(encoded->bytes.size()), 0.95 * static_cast<double>(target));
}

TEST(QualityRequest, ABudgetBelowBothCodersTellsTheSmallerSize) {
  const Mesh mesh = shaken_grid();
  for (const int effort : {0, 1}) {
    const auto least_bytes = [&](GeometryCoder geometry, const QualityRequest& quality) {
      const auto encoded = encode(mesh, {.quality = quality, .geometry = geometry, .effort = effort});
      EXPECT_FALSE(encoded);
      EXPECT_EQ(encoded.error().code, ErrorCode::kUnmetRequest);
      return encoded.error().best_bytes;
    };
    for (const QualityRequest& quality :
         {QualityRequest{.vde = percent(0.05), .target_bytes = 500},
          QualityRequest{.lfe = percent(0.01), .target_bytes = 500}, QualityRequest{.target_bytes = 30}}) {
      const auto highpass = least_bytes(GeometryCoder::kHighpass, quality);
      const auto predictive = least_bytes(GeometryCoder::kPredictive, quality);
      EXPECT_EQ(least_bytes(GeometryCoder::kAuto, quality), std::min(highpass, predictive)) << effort;
    }
  }
}

TEST(QualityRequest, ABudgetThatOneCoderKeepsIsKept) {
  const Mesh mesh = shaken_grid();
  const auto size = [&](GeometryCoder geometry, std::optional<std::uint64_t> target) {
    const auto encoded =
        encode(mesh, {.quality = {.vde = percent(0.2), .target_bytes = target}, .geometry = geometry});
    EXPECT_TRUE(encoded) << describe(encoded.error());
    return encoded ? encoded->bytes.size() : 0;
  };
  const auto highpass = size(GeometryCoder::kHighpass, std::nullopt);
  const auto predictive = size(GeometryCoder::kPredictive, std::nullopt);
  const auto target = std::min(highpass, predictive);
  EXPECT_LE(size(GeometryCoder::kAuto, target), target);
}

TEST(QualityRequest, CoordinatesNearTheLargestFloatAreKept) {
  Mesh mesh = shaken_grid();
  float largest = 0;
  for (const float x : mesh.positions) largest = std::max(largest, std::abs(x));
  // With all deltas 0 some figures would be beyond float32.
  for (float& x : mesh.positions) x = 0.9F * x / largest * std::numeric_limits<float>::max();
  for (const QualityRequest& quality :
       {QualityRequest{.vde = percent(2)}, QualityRequest{.vde = percent(0.01)},
        QualityRequest{.lfe = percent(0.1)}}) {
    const auto encoded = encode(mesh, {.quality = quality});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    EXPECT_TRUE(decode(encoded->bytes));
    const auto highpass = encode(mesh, {.quality = quality, .geometry = GeometryCoder::kHighpass});
    EXPECT_TRUE(highpass || highpass.error().code == ErrorCode::kInvalidMesh);
  }
}

TEST(QualityRequest, BadRequestsAreRefused) {
  const auto refused = [](const EncodeOptions& options) {
    const auto valid = validate(options);
    return !valid && valid.error().code == ErrorCode::kInvalidArgument;
  };
  for (const double bad : {0.0, -1.0, kNan, kInf}) {
    EXPECT_TRUE(refused({.quality = {.vde = percent(bad)}})) << bad;
    EXPECT_TRUE(refused({.quality = {.lfe = QualityBound{.value = bad}}})) << bad;
    EXPECT_TRUE(refused({.quality = {.max_error = QualityBound{bad}}}) || bad == kNoBound.value) << bad;
  }
  EXPECT_TRUE(refused({.quality = {.target_bytes = 0}}));
  EXPECT_TRUE(refused({.quality = {.vde = percent(1)}, .bits = 8}));
  EXPECT_TRUE(refused({.quality = {.vde = percent(1)}, .step = 0.1}));
  EXPECT_TRUE(refused({.quality = {.target_bytes = 1000}, .bits = 8}));
  EXPECT_TRUE(refused({.quality = {.max_error = QualityBound{1}}, .bits = 8}));
  EXPECT_TRUE(refused({.quality = {.lfe = percent(1)}, .anchors = 8}));
  EXPECT_TRUE(refused({.quality = {.max_error = QualityBound{1}}, .anchor_density = 8}));
  EXPECT_TRUE(refused({.effort = -1}));
  EXPECT_TRUE(refused({.effort = 3}));
  EXPECT_TRUE(validate({.quality = {.vde = percent(1)}, .anchors = 8}));
  EXPECT_TRUE(validate({.quality = {.lfe = percent(1)}, .bits = 8}));
}

TEST(QualityRequest, WithoutOptionsNothingIsLostThatOneCouldTell) {
  for (const auto& named : test::awkward_meshes()) {
    for (const int effort : {0, 1}) {
      const auto encoded = encode(named.mesh, {.effort = effort});
      if (!encoded) continue;  // what floats cannot hold
      const StreamInfo& stream = encoded->report.stream;
      EXPECT_LE(stream.quality.max_error, 0.00021 * stream.diagonal) << named.name;
      for (const AttributeInfo& attribute : stream.attributes)
        EXPECT_LE(attribute.error, attribute.kind == AttributeKind::kNormal ? 0.5001 : 1.0 / 4095)
            << named.name;
    }
  }
  // A fine mesh keeps its looks too: edges of a 500th of the diagonal, and errors of a 25th of these.
  const auto fine = encode(test::bumpy_grid(350, 350));
  EXPECT_LT(fine->report.stream.quality.max_error, 0.05 * 1.3);
}

/// A highpass stream cannot keep 0.02 % of a mesh of such uneven scale in few anchors, or says so.
TEST(QualityRequest, DefaultsAreKeptByEveryCoderOrTheCallFails) {
  Mesh uneven;
  uneven.positions = {0, 0, 0, 1e-6F, 0, 0, 0, 1e-6F, 0, 1e6F, 0, 0, 1e6F, 0.1F, 0, 1000000.125F, 0, 0};
  uneven.triangles = {0, 1, 2, 3, 4, 5};
  for (const Mesh& mesh : {uneven, shaken_grid(), fragments(30)}) {
    for (const GeometryCoder geometry :
         {GeometryCoder::kAuto, GeometryCoder::kHighpass, GeometryCoder::kPredictive}) {
      const auto encoded = encode(mesh, {.geometry = geometry});
      if (!encoded) {
        EXPECT_EQ(encoded.error().code, ErrorCode::kUnmetRequest);
        EXPECT_GT(encoded.error().best_value, 0);
        continue;
      }
      const StreamInfo& stream = encoded->report.stream;
      EXPECT_LE(stream.quality.max_error, 0.0002 * stream.diagonal);
    }
  }
}

TEST(QualityRequest, VdeAloneImpliesALargestError) {
  // Every delta is 0 at such a VDE: the coarsest stream there is.
  const Mesh mesh = test::bumpy_grid(60, 60);
  EncodeOptions options{.quality = {.vde = percent(5)}, .geometry = GeometryCoder::kHighpass};
  const auto implied = encode(mesh, options);
  options.quality.max_error = kNoBound;
  const auto free = encode(mesh, options);
  ASSERT_TRUE(implied && free) << describe(implied.error());
  EXPECT_LE(implied->report.stream.quality.max_error, 0.01 * implied->report.stream.diagonal);
  EXPECT_GT(free->report.stream.quality.max_error, 0.01 * free->report.stream.diagonal);
  EXPECT_LT(free->bytes.size(), implied->bytes.size());
  const auto nothing = encode(mesh, {.quality = {.max_error = kNoBound}});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::kInvalidArgument);
}

TEST(QualityRequest, MoreBytesThanTheFinestStepTakesAreNoError) {
  const Mesh mesh = test::attributed_grid(20, 20);
  const EncodeOptions options{.quality = {.target_bytes = 1'000'000}, .geometry = GeometryCoder::kHighpass};
  const auto encoded = encode(mesh, options);
  ASSERT_TRUE(encoded) << describe(encoded.error());
  EXPECT_LE(encoded->bytes.size(), 1'000'000);
}

TEST(QualityRequest, ProgressNeverFalls) {
  const Mesh mesh = test::attributed_grid(40, 40);
  for (const QualityRequest& quality :
       {QualityRequest{}, QualityRequest{.vde = percent(0.05)}, QualityRequest{.target_bytes = 9000}}) {
    double last = 0;
    int calls = 0;
    const auto note = [&](double share) {
      EXPECT_GE(share, last);
      EXPECT_LE(share, 1);
      last = share;
      ++calls;
    };
    const auto encoded = encode(mesh, {.quality = quality, .progress = note});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    EXPECT_EQ(last, 1);
    EXPECT_GT(calls, 5);
  }
}

TEST(QualityRequest, ACallbackThatThrowsIsAnError) {
  const Mesh mesh = test::bumpy_grid(20, 20);
  for (const double when : {0.0, 0.2, 1.0}) {
    const auto encoded = encode(mesh, {.progress = [when](double share) {
                                  if (share >= when) throw 7;
                                }});
    ASSERT_FALSE(encoded);
    EXPECT_EQ(encoded.error().code, ErrorCode::kInvalidArgument);
    EXPECT_NE(describe(encoded.error()).find("a callback threw"), std::string::npos);
  }
  const auto encoded = encode(mesh);
  ASSERT_TRUE(encoded);
  const auto decoded = decode(encoded->bytes, {.progress = [](double) { throw 7; }});
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error().code, ErrorCode::kInvalidArgument);
}

/// Of fewer bytes than the defaults take: both positions and attributes are coarser.
TEST(QualityRequest, BytesAreSharedBetweenPositionsAndAttributes) {
  Mesh mesh = test::attributed_grid(60, 50);
  mesh.attributes.pop_back();  // the score, which stays exact
  const auto whole = encode(mesh);
  for (const int effort : {0, 1}) {
    const std::uint64_t target = whole->bytes.size() * 6 / 10;
    const auto small = encode(mesh, {.quality = {.target_bytes = target}, .effort = effort});
    ASSERT_TRUE(small) << describe(small.error());
    EXPECT_LE(small->bytes.size(), target);
    EXPECT_GT(small->bytes.size(), target * 6 / 10);
    EXPECT_GT(small->report.stream.attributes[0].error, whole->report.stream.attributes[0].error);
  }
}

TEST(QualityRequest, WhatFloatsCannotHoldIsUnmet) {
  const Mesh mesh = test::bumpy_grid(20, 20);
  for (const QualityRequest& request : {QualityRequest{.vde = QualityBound{.value = 1e-12}},
                                        QualityRequest{.lfe = QualityBound{.value = 1e-12}},
                                        QualityRequest{.max_error = QualityBound{1e-12}}}) {
    const auto encoded = encode(mesh, {.quality = request, .geometry = GeometryCoder::kHighpass});
    ASSERT_FALSE(encoded);
    EXPECT_EQ(encoded.error().code, ErrorCode::kUnmetRequest);
    EXPECT_GT(encoded.error().best_value, 1e-12);
    EXPECT_GT(encoded.error().best_bytes, 0U);
    EXPECT_NE(describe(encoded.error()).find("the best is"), std::string::npos);
  }
  const auto tiny = encode(mesh, {.quality = {.target_bytes = 20}});
  ASSERT_FALSE(tiny);
  EXPECT_EQ(tiny.error().code, ErrorCode::kUnmetRequest);
  EXPECT_GT(tiny.error().best_bytes, 20U);
}

/// Bounds of attributes that are asked for hold within a number of bytes; others grow with the errors of
/// positions.
TEST(QualityRequest, BytesDoNotExceedBoundsOfAttributes) {
  Mesh mesh = shaken_grid();
  Attribute colors{.kind = AttributeKind::kColor, .type = ComponentType::kU8, .components = 3, .name = "red"};
  for (std::uint32_t i = 0; i < 3 * mesh.vertex_count(); ++i)
    colors.values.push_back(static_cast<std::byte>(i * 2654435761U >> 24));
  mesh.attributes = {colors};
  constexpr double kBound = 8;
  const auto usual = encode(mesh, {.attributes = {.color_error = kBound}});
  ASSERT_TRUE(usual) << describe(usual.error());
  const StreamInfo& stream = usual->report.stream;
  const std::uint64_t target = stream.bytes - (stream.bytes - stream.attribute_bytes) / 3;
  for (const bool is_asked : {false, true}) {
    const EncodeOptions options{.quality = {.target_bytes = target},
                                .attributes = {.color_error = kBound, .is_asked = is_asked}};
    const auto encoded = encode(mesh, options);
    ASSERT_TRUE(encoded) << describe(encoded.error());
    EXPECT_LE(encoded->bytes.size(), target);
    EXPECT_EQ(encoded->report.stream.attributes[0].error > kBound, !is_asked);
  }
  const auto refused = encode(mesh, {.quality = {.target_bytes = stream.attribute_bytes / 2},
                                     .attributes = {.color_error = kBound, .is_asked = true}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnmetRequest);
}

/// Mean errors that are asked for, too.
TEST(QualityRequest, BytesDoNotExceedMeanErrorsOfAttributes) {
  Mesh mesh = shaken_grid();
  Attribute colors{.kind = AttributeKind::kColor, .type = ComponentType::kU8, .components = 3, .name = "red"};
  Attribute glow{
      .kind = AttributeKind::kGeneric, .type = ComponentType::kU8, .components = 1, .name = "glow"};
  for (std::uint32_t i = 0; i < 3 * mesh.vertex_count(); ++i) {
    const double smooth = 128 + 60 * std::sin(0.02 * i) + 20 * std::sin(0.9 * i);
    const auto noise = static_cast<double>((i * 2654435761U) >> 28);
    colors.values.push_back(static_cast<std::byte>(smooth + noise));
    if (i % 3 == 0) glow.values.push_back(static_cast<std::byte>(smooth + noise));
  }
  mesh.attributes = {colors, glow};
  const AttributeQuality asked{
      .color_rms = 1.5, .named = {{.name = "glow", .error = 2, .is_mean = true}}, .is_asked = true};
  const auto usual = encode(mesh, {.attributes = asked});
  ASSERT_TRUE(usual) << describe(usual.error());
  const std::uint64_t places = usual->report.stream.bytes - usual->report.stream.attribute_bytes;
  for (const std::uint64_t saved : {places / 5, places / 3, places / 2}) {
    const auto encoded =
        encode(mesh, {.quality = {.target_bytes = usual->bytes.size() - saved}, .attributes = asked});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded);
    const auto comparison = compare(mesh, *decoded, encoded->order);
    ASSERT_TRUE(comparison);
    EXPECT_LE(comparison->attributes[0].color_rms, 1.5);
    EXPECT_LE(comparison->attributes[1].rms, 2);
  }
}

TEST(ErrorPeaks, AreLargestFirstAndApart) {
  const auto mesh = test::sheet(20, 20);
  std::vector<double> errors(400, 0.1);
  std::vector<std::uint8_t> excluded(400, 0);
  errors[0] = 1;
  errors[1] = 0.9;  // beside the first
  errors[210] = 2;
  errors[399] = 0.5;
  errors[19] = 3;
  excluded[19] = 1;
  EXPECT_EQ(error_peaks(mesh.graph, errors, excluded, 0.3, 10), (std::vector<std::uint32_t>{210, 0, 399}));
  EXPECT_EQ(error_peaks(mesh.graph, errors, excluded, 0.3, 1), (std::vector<std::uint32_t>{210}));
  EXPECT_TRUE(error_peaks(mesh.graph, errors, excluded, 5, 10).empty());
}

}  // namespace
}  // namespace deltamesh
