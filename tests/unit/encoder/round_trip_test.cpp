// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole streams: what comes out is what went in, up to the stated order and errors.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "support/meshes.h"

namespace deltamesh {
namespace {

using test::awkward_meshes;
using test::canonical_faces;
using test::NamedMesh;

std::vector<std::uint32_t> referenced_vertices(const Mesh& mesh) {
  std::vector<std::uint32_t> used = mesh.triangles;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

double largest_error(const Mesh& original, const Mesh& decoded, std::span<const std::uint32_t> order) {
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d =
          double{decoded.positions[3 * i + axis]} - double{original.positions[3 * order[i] + axis]};
      square += d * d;
    }
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

class AwkwardMesh : public ::testing::TestWithParam<std::tuple<std::size_t, bool, bool>> {
 protected:
  NamedMesh named_ = awkward_meshes()[std::get<0>(GetParam())];
  EncodeOptions options_{.keep_order = std::get<1>(GetParam()), .keep_unreferenced = std::get<2>(GetParam())};
};

TEST_P(AwkwardMesh, ComesBackWithTheSameFacesAndTheStatedError) {
  const Mesh& mesh = named_.mesh;
  const auto encoded = encode(mesh, options_);
  ASSERT_TRUE(encoded) << describe(encoded.error());
  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded) << describe(decoded.error());

  const std::vector<std::uint32_t>& order = encoded->order;
  ASSERT_EQ(order.size(), decoded->vertex_count());
  std::vector<std::uint32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> expected = referenced_vertices(mesh);
  if (options_.keep_unreferenced) {
    expected.resize(mesh.vertex_count());
    std::iota(expected.begin(), expected.end(), 0U);
  }
  EXPECT_EQ(sorted, expected) << "each kept vertex comes back once";

  std::vector<std::uint32_t> renamed;
  for (const std::uint32_t v : decoded->triangles) renamed.push_back(order[v]);
  EXPECT_EQ(canonical_faces(renamed), canonical_faces(mesh.triangles));
  if (options_.keep_order) {
    EXPECT_EQ(renamed, mesh.triangles);
    EXPECT_EQ(order, expected);
  }

  const Quality& quality = encoded->report.stream.quality;
  const double largest = largest_error(mesh, *decoded, order);
  EXPECT_LE(largest, quality.max_error * (1 + 1e-12));
  EXPECT_GE(largest, quality.max_error * (1 - 0x1p-15));
  EXPECT_LE(quality.lfe_rms, quality.max_error);
  EXPECT_EQ(decoded->origin, mesh.origin);
  EXPECT_EQ(decoded->attributes.size(), mesh.attributes.size());
  EXPECT_EQ(encoded->report.unreferenced_vertices, mesh.vertex_count() - referenced_vertices(mesh).size());
}

TEST_P(AwkwardMesh, GivesTheSameBytesTwice) {
  EXPECT_EQ(encode(named_.mesh, options_)->bytes, encode(named_.mesh, options_)->bytes);
}

TEST_P(AwkwardMesh, EveryPrefixAndEveryFlippedByteIsACleanError) {
  const auto encoded = encode(named_.mesh, options_);
  ASSERT_TRUE(encoded);
  for (std::size_t size = 0; size < encoded->bytes.size(); ++size) {
    const std::vector<std::byte> prefix(encoded->bytes.begin(),
                                        encoded->bytes.begin() + static_cast<long>(size));
    EXPECT_FALSE(decode(prefix)) << size;
  }
  for (std::size_t i = 0; i < encoded->bytes.size(); ++i) {
    std::vector<std::byte> flipped = encoded->bytes;
    flipped[i] ^= std::byte{0x10};
    EXPECT_FALSE(decode(flipped)) << "byte " << i;
  }
  std::vector<std::byte> longer = encoded->bytes;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(decode(longer));
}

INSTANTIATE_TEST_SUITE_P(All, AwkwardMesh,
                         ::testing::Combine(::testing::Range(std::size_t{0}, awkward_meshes().size()),
                                            ::testing::Bool(), ::testing::Bool()),
                         [](const auto& test) {
                           std::string name = awkward_meshes()[std::get<0>(test.param)].name;
                           for (char& c : name)
                             c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           return name + (std::get<1>(test.param) ? "_ordered" : "") +
                                  (std::get<2>(test.param) ? "_all" : "");
                         });

TEST(RoundTrip, GEO1CopiesOfAGeometricVertexStayTogether) {
  for (const NamedMesh& named : awkward_meshes()) {
    if (named.name != "seam") continue;
    const auto encoded = encode(named.mesh);
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(encoded->report.stream.vertices, encoded->report.stream.geometric_vertices + 3);
    std::size_t pairs = 0;
    for (std::size_t a = 0; a < decoded->vertex_count(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const std::size_t bytes = 3 * sizeof(float);
        if (std::memcmp(&named.mesh.positions[3 * encoded->order[a]],
                        &named.mesh.positions[3 * encoded->order[b]], bytes) != 0)
          continue;
        ++pairs;
        EXPECT_EQ(std::memcmp(&decoded->positions[3 * a], &decoded->positions[3 * b], bytes), 0);
      }
    }
    EXPECT_EQ(pairs, 3U);
  }
}

TEST(RoundTrip, AttributesFollowTheirVertices) {
  const Mesh mesh = test::attributed_grid(12, 9);
  for (const bool keep_order : {false, true}) {
    const auto encoded = encode(mesh, {.keep_order = keep_order});
    const auto decoded = decode(encoded->bytes);
    ASSERT_TRUE(decoded);
    for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
      const Attribute& before = mesh.attributes[a];
      const Attribute& after = decoded->attributes[a];
      EXPECT_EQ(after.name, before.name);
      EXPECT_EQ(after.kind, before.kind);
      EXPECT_EQ(after.type, before.type);
      const std::size_t row = before.components * component_size(before.type);
      for (std::size_t i = 0; i < decoded->vertex_count(); ++i) {
        const std::byte* x = before.values.data() + row * encoded->order[i];
        const std::byte* y = after.values.data() + row * i;
        if (before.type != ComponentType::kF32) {
          EXPECT_EQ(std::memcmp(x, y, row), 0) << before.name << " at " << i;
          continue;
        }
        for (std::size_t c = 0; c < before.components; ++c) {
          float p = 0;
          float q = 0;
          std::memcpy(&p, x + 4 * c, 4);
          std::memcpy(&q, y + 4 * c, 4);
          EXPECT_NEAR(p, q, 9e-3) << before.name << " at " << i;
        }
      }
    }
  }
}

TEST(RoundTrip, MoreBitsMeanLessErrorAndMoreBytes) {
  const Mesh mesh = test::bumpy_grid(40, 40);
  const auto coarse = encode(mesh, {.bits = 5});
  const auto fine = encode(mesh, {.bits = 10});
  EXPECT_LT(fine->report.stream.quality.vde_rms, coarse->report.stream.quality.vde_rms / 16);
  EXPECT_GT(fine->bytes.size(), coarse->bytes.size());
}

TEST(Encode, NamesTheFirstVertexThatIsNotFinite) {
  Mesh mesh = test::bumpy_grid(3, 3);
  mesh.positions[3 * 7 + 1] = std::numeric_limits<float>::quiet_NaN();
  const auto result = encode(mesh);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(result.error().where_kind, WhereKind::kVertex);
  EXPECT_EQ(result.error().where, 7U);
}

TEST(Encode, RejectsCoordinatesWhoseDecodedOnesAreNoFloats) {
  Mesh mesh = test::bumpy_grid(9, 9);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] = i % 2 == 0 ? 3.4e38F : -3.4e38F;
  for (std::size_t v = 0; v < 81; ++v) mesh.positions[3 * v] *= static_cast<float>(v) / 81;  // not all welded
  for (const EncodeOptions& options : {EncodeOptions{.bits = 3}, EncodeOptions{.step = 1e300}}) {
    const auto encoded = encode(mesh, options);
    ASSERT_FALSE(encoded);
    EXPECT_EQ(encoded.error().code, ErrorCode::kInvalidMesh) << describe(encoded.error());
  }
}

TEST(Encode, RejectsMeshesThatDoNotAddUp) {
  Mesh index = test::tetrahedron();
  index.triangles[4] = 4;
  EXPECT_EQ(encode(index).error().where, 1U) << "second triangle";
  Mesh ragged = test::tetrahedron();
  ragged.positions.pop_back();
  EXPECT_EQ(encode(ragged).error().code, ErrorCode::kInvalidMesh);
  Mesh values = test::attributed_grid(2, 2);
  values.attributes[2].values.pop_back();
  EXPECT_EQ(encode(values).error().where, 2U) << "third attribute";
}

TEST(Encode, RefusesMoreThanTheFormatHoldsBeforeItReadsAny) {
  const Mesh mesh = test::tetrahedron();
  MeshView many = mesh;
  many.triangles = {mesh.triangles.data(), 3 * ((std::size_t{1} << 29) + 1)};
  EXPECT_EQ(encode(many).error().code, ErrorCode::kLimitExceeded);
  many = mesh;
  many.positions = {mesh.positions.data(), 3 * (std::size_t{1} << 31)};
  EXPECT_EQ(encode(many).error().code, ErrorCode::kLimitExceeded);
}

TEST(Encode, RejectsOptionsOutsideTheirRange) {
  const Mesh mesh = test::tetrahedron();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const EncodeOptions& options :
       {EncodeOptions{.bits = 2}, EncodeOptions{.bits = 17}, EncodeOptions{.bits = 8, .step = 0.1},
        EncodeOptions{.step = 0.0}, EncodeOptions{.step = nan}, EncodeOptions{.anchors = 0},
        EncodeOptions{.anchors = 3, .anchor_density = 3}, EncodeOptions{.anchor_bits = 3},
        EncodeOptions{.attributes = {.normal_error = -1}},
        EncodeOptions{.attributes = {.tangent_error = nan}}, EncodeOptions{.attributes = {.uv_error = nan}},
        EncodeOptions{.attributes = {.color_error = -0.5}},
        EncodeOptions{.attributes = {.weight_error = nan}},
        EncodeOptions{.attributes = {.named = {{"heat", -1}}}}}) {
    const auto result = encode(mesh, options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidArgument);
  }
}

TEST(Decode, RefusesBeyondTheCallersLimits) {
  const auto encoded = encode(test::attributed_grid(10, 10));
  ASSERT_TRUE(encoded);
  const auto code = [&](const DecodeLimits& limits) {
    const auto result = decode(encoded->bytes, {.limits = limits});
    return result ? ErrorCode::kInternal : result.error().code;
  };
  EXPECT_EQ(code({.vertices = 120}), ErrorCode::kLimitExceeded);
  EXPECT_EQ(code({.triangles = 199}), ErrorCode::kLimitExceeded);
  EXPECT_EQ(code({.attributes = 3}), ErrorCode::kLimitExceeded);
  EXPECT_EQ(code({.attribute_bytes = 100}), ErrorCode::kLimitExceeded);
  EXPECT_TRUE(decode(encoded->bytes, {.limits = {.vertices = 121, .triangles = 200, .attributes = 4}}));
}

TEST(Decode, ReportsProgressUpToTheEnd) {
  double last = 0;
  const auto note = [&last](double share) {
    EXPECT_GE(share, last);
    last = share;
  };
  const auto encoded = encode(test::bumpy_grid(10, 10), {.progress = note});
  EXPECT_EQ(last, 1);
  last = 0;
  ASSERT_TRUE(decode(encoded->bytes, {.progress = note}));
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace deltamesh
