// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Streams put together by hand from an encoder's, with checksums that are right and payloads that are not.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/expand_chunk.h"
#include "format/container.h"
#include "support/meshes.h"
#include "support/same_mesh.h"

namespace deltamesh {
namespace {

struct StoredPayload {
  std::uint32_t tag;
  ChunkCodec codec;  ///< raw or compact
  std::vector<std::byte> bytes;
};

/// A stream taken apart; assemble() makes it whole again, checksums included.
struct Parts {
  FileHeader header;
  std::vector<StoredPayload> payloads;

  std::vector<std::byte> assemble() const {
    std::vector<CodedChunk> chunks;
    auto attribute = header.attributes.begin();
    for (const StoredPayload& p : payloads) {
      chunks.push_back({.tag = p.tag, .codec = p.codec, .bytes = p.bytes, .decoded_bytes = p.bytes.size()});
      if (p.tag == kTagAttribute) chunks.back().attribute = *attribute++;
    }
    return write_container(header, chunks);
  }
};

Parts take_apart(const Mesh& mesh, const EncodeOptions& options) {
  const auto encoded = encode(mesh, options);
  const auto container = Container::open(encoded->bytes);
  Parts parts{.header = container->header(), .payloads = {}};
  for (const ChunkEntry& entry : container->entries()) {
    const auto chunk = expand_chunk(*container, entry);
    parts.payloads.push_back({entry.tag,
                              chunk->is_compact ? ChunkCodec::kCompact : ChunkCodec::kRaw,
                              {chunk->bytes().begin(), chunk->bytes().end()}});
  }
  return parts;
}

/// On success the promises of decode() hold.
void expect_error_or_valid(std::span<const std::byte> stream) {
  const auto mesh = decode(stream);
  if (!mesh) {
    EXPECT_NE(mesh.error().code, ErrorCode::kInternal) << describe(mesh.error());
    EXPECT_STRNE(mesh.error().message, "");
    return;
  }
  for (const std::uint32_t v : mesh->triangles) ASSERT_LT(v, mesh->vertex_count());
  for (const float x : mesh->positions) ASSERT_TRUE(std::isfinite(x));
  for (const Attribute& a : mesh->attributes)
    ASSERT_EQ(a.values.size(), mesh->vertex_count() * a.components * component_size(a.type));
}

class Payloads : public ::testing::TestWithParam<std::tuple<std::size_t, Profile>> {
 protected:
  Parts parts_ = take_apart(
      test::awkward_meshes()[std::get<0>(GetParam())].mesh,
      {.bits = 8, .profile = std::get<1>(GetParam()), .keep_order = true, .keep_unreferenced = true});
};

TEST_P(Payloads, AnyFlippedByteIsACleanErrorOrAValidMesh) {
  for (StoredPayload& payload : parts_.payloads) {
    for (std::byte& byte : payload.bytes) {
      const std::byte kept = byte;
      for (const unsigned mask : {0x01U, 0x80U, 0xffU}) {
        byte = kept ^ std::byte{static_cast<unsigned char>(mask)};
        expect_error_or_valid(parts_.assemble());
      }
      byte = kept;
    }
  }
}

TEST_P(Payloads, AnyShorterOrLongerPayloadIsACleanError) {
  for (StoredPayload& payload : parts_.payloads) {
    if (is_skippable(payload.tag)) continue;
    const std::vector<std::byte> whole = payload.bytes;
    while (!payload.bytes.empty()) {
      payload.bytes.pop_back();
      EXPECT_FALSE(decode(parts_.assemble())) << payload.bytes.size() << " of " << whole.size();
    }
    payload.bytes = whole;
    payload.bytes.push_back(std::byte{0});
    EXPECT_FALSE(decode(parts_.assemble()));
    payload.bytes = whole;
  }
}

INSTANTIATE_TEST_SUITE_P(Awkward, Payloads,
                         ::testing::Combine(::testing::Range(std::size_t{0}, test::awkward_meshes().size()),
                                            ::testing::Values(Profile::kSmallest, Profile::kZstd)));

std::string broken_rule(const Parts& parts) {
  const auto mesh = decode(parts.assemble());
  return mesh ? "none" : mesh.error().rule;
}

TEST(Stream, HDR7RejectsAnotherNumberOfComponents) {
  Parts parts = take_apart(test::bumpy_grid(9, 9), {.anchors = 5});
  ASSERT_EQ(broken_rule(parts), "none");
  parts.header.components += 1;
  EXPECT_EQ(broken_rule(parts), "HDR-7");
}

TEST(Stream, GEO1RejectsPositionsBeyondFloat32) {
  Parts parts = take_apart(test::bumpy_grid(9, 9), {.bits = 8});
  parts.header.highpass.step = 1e300;
  const auto mesh = decode(parts.assemble());
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::kInvalidStream);
}

/// A grid with normals, texture coordinates and colours as glTF names them, cut in two along a column, whose
/// vertices have two values.
Mesh small_primitive(std::uint32_t columns, std::uint32_t rows) {
  Mesh mesh = test::attributed_grid(columns, rows);
  mesh.attributes.pop_back();
  mesh.attributes[0].name = "NORMAL";
  mesh.attributes[1].name = "COLOR_0";
  mesh.attributes[1].normalized = true;
  mesh.attributes[1].linear = true;
  mesh.attributes[2].name = "TEXCOORD_0";
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3)  // no grid is left
    for (std::size_t axis = 0; axis < 3; ++axis)
      mesh.positions[i + axis] += 0.3F * std::sin(0.7F * static_cast<float>(i + 5 * axis));
  const std::vector<float> plain = test::bumpy_grid(columns, rows).positions;
  const auto seam = static_cast<float>(columns / 2);
  const std::size_t before = mesh.vertex_count();
  std::vector<std::uint32_t> copy(before, 0);
  for (std::uint32_t v = 0; v < before; ++v) {
    if (plain[3 * v] != seam) continue;
    copy[v] = static_cast<std::uint32_t>(mesh.vertex_count());
    for (std::size_t axis = 0; axis < 3; ++axis) mesh.positions.push_back(mesh.positions[3 * v + axis]);
    for (Attribute& a : mesh.attributes) {
      const std::size_t row = a.values.size() / (mesh.vertex_count() - 1);
      for (std::size_t i = 0; i < row; ++i) a.values.push_back(a.values[row * v + i]);
    }
  }
  for (std::size_t c = 0; c < mesh.triangles.size(); c += 3) {
    float x = 0;
    for (std::size_t k = 0; k < 3; ++k) x += plain[3 * std::size_t{mesh.triangles[c + k]}];
    for (std::size_t k = 0; k < 3 && x > 3 * seam; ++k)
      if (const std::uint32_t other = copy[mesh.triangles[c + k]]; other != 0) mesh.triangles[c + k] = other;
  }
  return mesh;
}

TEST(Stream, SmallPrimitivesSpendAtMost64BytesBesideTheirPayloads) {
  for (const std::uint32_t side : {4U, 10U, 20U}) {
    const auto encoded = encode(small_primitive(side, side),
                                {.quality = {.max_error = QualityBound{0.02, QualityUnit::kDiagonal}},
                                 .geometry = GeometryCoder::kPredictive});
    ASSERT_TRUE(encoded) << describe(encoded.error());
    const StreamInfo& info = encoded->report.stream;
    ASSERT_EQ(info.chunks.size(), 6U) << "CONN, SEAM, POSN and three ATTR";
    EXPECT_GT(info.vertices, info.geometric_vertices);
    EXPECT_LE(info.container_bytes, 64U) << side;
    EXPECT_EQ(decode(encoded->bytes)->attributes[0].name, "NORMAL");
  }
}

TEST(Stream, LongestPayloadsOfTheEncoderKeepDIR5) {
  for (const auto& named : test::awkward_meshes()) {
    const Parts parts = take_apart(named.mesh, {.bits = 16, .keep_order = true, .keep_unreferenced = true});
    for (const StoredPayload& p : parts.payloads)
      EXPECT_LE(p.bytes.size(), 1024 + 160 * (parts.header.vertices + parts.header.triangles)) << named.name;
  }
}

}  // namespace
}  // namespace deltamesh
