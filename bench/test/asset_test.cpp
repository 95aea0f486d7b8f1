// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors of attributes, and Draco's part of the comparison of assets.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "asset/coders/draco.h"
#include "asset/coders/draco_values.h"
#include "asset/mesh_error.h"
#include "asset/source.h"

namespace deltamesh::bench {
namespace {

Attribute floats(AttributeKind kind, std::uint8_t components, const std::vector<float>& values) {
  Attribute attribute{.kind = kind, .type = ComponentType::kF32, .components = components};
  attribute.values.resize(values.size() * sizeof(float));
  std::memcpy(attribute.values.data(), values.data(), attribute.values.size());
  return attribute;
}

constexpr DracoSetting kSetting{.position_bits = 12, .normal_bits = 8, .uv_bits = 10};

TEST(MeshError, AnglesDistancesAndOrder) {
  Mesh original;
  original.positions = {0, 0, 0, 1, 0, 0};
  original.triangles = {0, 1, 1};
  original.attributes = {floats(AttributeKind::kNormal, 3, {0, 0, 2, 0, 1, 0}),
                         floats(AttributeKind::kUv, 2, {0, 0, 1, 1})};
  Mesh decoded;
  decoded.positions = {1, 0, 0.5F, 0, 0, 0};
  decoded.triangles = {1, 0, 0};
  decoded.attributes = {floats(AttributeKind::kNormal, 3, {0, 1, 1, 0, 0, 1}),
                        floats(AttributeKind::kUv, 2, {1, 1, 0.3F, 0.4F})};
  MeshErrorMeter meter;
  ASSERT_TRUE(meter.add(original, decoded, std::vector<std::uint32_t>{1, 0}));
  const MeshError error = meter.error();
  EXPECT_NEAR(error.rms, 0.5 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(error.largest[index_of(Part::kGeometry)], 0.5, 1e-12);
  EXPECT_NEAR(error.largest[index_of(Part::kNormals)], 45, 1e-9);
  EXPECT_NEAR(error.largest[index_of(Part::kUvs)], 0.5, 1e-7);
  MeshError tighter = error;
  tighter.largest[index_of(Part::kUvs)] = 0.4;
  EXPECT_TRUE(is_within(error, error));
  EXPECT_FALSE(is_within(error, tighter));
  EXPECT_TRUE(is_within(tighter, error));
}

TEST(MeshError, FlippedTangentIsTheLargestError) {
  Mesh original;
  original.positions = {0, 0, 0};
  original.triangles = {0, 0, 0};
  original.attributes = {floats(AttributeKind::kTangent, 4, {1, 0, 0, 1})};
  Mesh decoded = original;
  decoded.attributes = {floats(AttributeKind::kTangent, 4, {1, 0, 0, -1})};
  MeshErrorMeter meter;
  ASSERT_TRUE(meter.add(original, decoded, std::vector<std::uint32_t>{0}));
  EXPECT_EQ(meter.error().largest[index_of(Part::kTangents)], 180);
}

TEST(DracoMesh, PartsAddUpAndErrorsAreThoseOfItsStreams) {
  const auto asset = generated_asset(1000).load();
  ASSERT_TRUE(asset);
  ASSERT_EQ(asset->meshes.size(), 1U);
  const AssetMesh& mesh = asset->meshes.front();
  const auto coded = code_with_draco(mesh, kSetting);
  ASSERT_TRUE(coded);
  std::size_t bytes = 0;
  for (const auto& stream : coded->streams) bytes += stream.size();
  EXPECT_EQ(sum(coded->bytes), bytes);
  EXPECT_GT(coded->bytes[index_of(Part::kNormals)], 0U);
  EXPECT_GT(coded->bytes[index_of(Part::kUvs)], 0U);
  EXPECT_GT(coded->error.rms, 0);
  EXPECT_LT(coded->error.largest[index_of(Part::kNormals)], 1);
}

TEST(DracoValues, OtherBitsDoNotPassTheCheck) {
  const auto asset = generated_asset(1000).load();
  ASSERT_TRUE(asset);
  const Primitive& primitive = asset->meshes.front().primitives.front();
  const auto stream = encode_draco(*merged_draco(primitive), kSetting, kDracoLevel);
  ASSERT_TRUE(stream);
  EXPECT_TRUE(decodes_to(*stream, draco_values(primitive.mesh, kSetting)));
  DracoSetting finer = kSetting;
  finer.uv_bits = 11;
  EXPECT_FALSE(decodes_to(*stream, draco_values(primitive.mesh, finer)));
}

}  // namespace
}  // namespace deltamesh::bench
