// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/byte_writer.h"
#include "connectivity/groups/groups.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/coder/writer.h"
#include "entropy/planes.h"
#include "support/meshes.h"
#include "support/soups.h"

namespace deltamesh::face_groups_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// Faces and their groups.
struct Case {
  std::string name;
  Numbers triangles;
  std::uint32_t vertex_count;
  Numbers groups;
};

std::vector<Case> cases() {
  std::vector<Case> result;
  test::Random random(5);
  for (const test::Soup& soup : test::awkward_soups()) {
    const std::size_t m = soup.triangles.size() / 3;
    if (m == 0) continue;
    Numbers stripes;
    Numbers scattered;
    Numbers many;
    for (std::uint32_t f = 0; f < m; ++f) {
      stripes.push_back(f / 10);
      scattered.push_back(random.below(20));
      many.push_back(65535 - random.below(1 + f % 1000));
    }
    for (const Numbers& groups : {Numbers(m, 0), Numbers(m, 65535), stripes, scattered, many})
      result.push_back({soup.name, soup.triangles, soup.vertex_count, groups});
  }
  return result;
}

CodedFaceGroups write(const Case& c) { return write_face_groups(c.groups, c.triangles, c.vertex_count); }

/// Reads from a copy, so that a sanitizer sees the bounds.
Result<Numbers> read(Payload payload, const Case& c) {
  const std::vector<std::byte> copy(payload.bytes.begin(), payload.bytes.end());
  payload.bytes = copy;
  return read_face_groups(payload, c.triangles, c.vertex_count);
}

std::string broken_rule(Payload payload, const Case& c) {
  const auto groups = read(payload, c);
  return groups ? "none" : groups.error().rule;
}

TEST(FaceGroups, FGRP1ComeBackFromBothForms) {
  for (const Case& c : cases()) {
    const CodedFaceGroups coded = write(c);
    for (const Payload& form : {Payload(coded.payload), Payload::compact(coded.compact)}) {
      const auto groups = read(form, c);
      ASSERT_TRUE(groups) << c.name << ": " << describe(groups.error());
      EXPECT_EQ(*groups, c.groups) << c.name;
    }
  }
}

TEST(FaceGroups, FGRP1NoBytesAreNoGroups) {
  const Case c{"two", {0, 1, 2, 2, 1, 3}, 4, {}};
  EXPECT_TRUE(write(c).payload.empty());
  EXPECT_TRUE(write(c).compact.empty());
  EXPECT_TRUE(read(Payload(), c)->empty());
}

TEST(FaceGroups, FGRP1RejectsGroupsFrom65536On) {
  const Case c{"two", {0, 1, 2, 2, 1, 3}, 4, {}};
  ByteWriter out;
  write_planes(out, Numbers{7, 65536});
  EXPECT_EQ(broken_rule(out.bytes(), c), "FGRP-1");

  CompactWriter writer;
  std::array<BitModel, 8> as_prediction;
  SymbolModel choices{{8, 4, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 16, 1}};
  NumberModel names;
  writer.bit(false, as_prediction[0]);
  writer.symbol(15, Mixture<1>{{&choices}});
  writer.number(65536, names);
  EXPECT_EQ(broken_rule(Payload::compact(writer.finish()), c), "FGRP-1");
}

TEST(FaceGroups, FGRP3RejectsAPlaceBeyondTheRecentGroups) {
  const Case c{"one", {0, 1, 2}, 3, {}};
  CompactWriter writer;
  BitModel as_prediction;
  SymbolModel choices{{8, 4, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 16, 1}};
  writer.bit(false, as_prediction);
  writer.symbol(0, Mixture<1>{{&choices}});
  EXPECT_EQ(broken_rule(Payload::compact(writer.finish()), c), "FGRP-3");
}

TEST(FaceGroups, FGRP2KnowsAFaceFromItsVertices) {
  // Two sheets that share no vertex: once each has begun, its vertices tell all.
  const test::Soup sheet = test::grid(30, 30, false, false, 0, 1);
  Case c{"sheets", sheet.triangles, 2 * sheet.vertex_count, Numbers(sheet.triangles.size() / 3, 4)};
  for (const std::uint32_t v : sheet.triangles) c.triangles.push_back(v + sheet.vertex_count);
  c.groups.resize(c.triangles.size() / 3, 900);
  EXPECT_LE(write(c).compact.size(), 32U);
}

TEST(FaceGroups, PrefixesAndBytesLeftOverAreErrors) {
  for (const Case& c : cases()) {
    if (c.groups.size() > 300) continue;
    const CodedFaceGroups coded = write(c);
    for (std::size_t size = 1; size < coded.payload.size(); ++size)
      EXPECT_FALSE(read(std::span(coded.payload).first(size), c)) << c.name;
    for (std::size_t size = 1; size < coded.compact.size(); ++size)
      EXPECT_FALSE(read(Payload::compact(std::span(coded.compact).first(size)), c)) << c.name;
    for (const auto& bytes : {coded.payload, coded.compact}) {
      std::vector<std::byte> longer = bytes;
      longer.push_back(std::byte{0});
      Payload payload(longer);
      payload.is_compact = bytes == coded.compact;
      EXPECT_FALSE(read(payload, c)) << c.name;
    }
  }
}

/// Groups by the vertices of a face, rotated to start with the smallest.
std::map<Numbers, Numbers> groups_of_faces(const Mesh& mesh, const Numbers& order) {
  std::map<Numbers, Numbers> groups;
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    Numbers face;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[3 * f + k];
      face.push_back(order.empty() ? v : order[v]);
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    groups[face].push_back(mesh.face_groups[f]);
  }
  for (auto& [face, of_face] : groups) std::sort(of_face.begin(), of_face.end());
  return groups;
}

TEST(FaceGroups, FollowTheirFacesThroughAStream) {
  for (const auto& named : test::awkward_meshes()) {
    Mesh mesh = named.mesh;
    for (std::uint32_t f = 0; f < mesh.triangle_count(); ++f) mesh.face_groups.push_back(f * f % 5);
    for (const bool keep_order : {false, true}) {
      for (const EncodeOptions& options :
           {EncodeOptions{.keep_order = keep_order},
            EncodeOptions{.profile = Profile::kZstd, .keep_order = keep_order},
            EncodeOptions{.geometry = GeometryCoder::kPredictive, .effort = 0, .keep_order = keep_order}}) {
        const auto encoded = encode(mesh, options);
        ASSERT_TRUE(encoded) << named.name << ": " << describe(encoded.error());
        const auto decoded = decode(encoded->bytes);
        ASSERT_TRUE(decoded) << named.name << ": " << describe(decoded.error());
        ASSERT_EQ(decoded->face_groups.size(), mesh.triangle_count());
        if (keep_order) {
          EXPECT_EQ(decoded->face_groups, mesh.face_groups) << named.name;
        } else {
          EXPECT_EQ(groups_of_faces(*decoded, encoded->order), groups_of_faces(mesh, {})) << named.name;
        }
      }
    }
  }
}

TEST(FaceGroups, AStreamSaysWhetherThereAreAny) {
  Mesh mesh = test::bumpy_grid(5, 4);
  EXPECT_TRUE(decode(encode(mesh)->bytes)->face_groups.empty());
  mesh.face_groups.assign(mesh.triangle_count(), 0);
  const auto encoded = encode(mesh);
  EXPECT_EQ(decode(encoded->bytes)->face_groups, mesh.face_groups);
  const StreamInfo& info = encoded->report.stream;
  EXPECT_EQ(std::string(info.chunks[1].tag.data()), "FGRP");
  EXPECT_EQ(info.connectivity_bytes, info.chunks[0].coded_bytes + info.chunks[1].coded_bytes);
}

TEST(FaceGroups, MeshesThatDoNotAddUpAreRejected) {
  Mesh mesh = test::tetrahedron();
  mesh.face_groups = {0, 1, 2};
  EXPECT_EQ(encode(mesh).error().code, ErrorCode::kInvalidMesh);
  mesh.face_groups = {0, 1, 2, 65536};
  EXPECT_EQ(encode(mesh).error().code, ErrorCode::kInvalidMesh);
  EXPECT_EQ(encode(mesh).error().where, 3U);
}

}  // namespace
}  // namespace deltamesh::face_groups_test
