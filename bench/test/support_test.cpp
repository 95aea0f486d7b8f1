// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What all programs share: timing in turn, tables, the choice of sources, parts of meshes.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/table.h"
#include "support/command_line.h"
#include "support/timing.h"
#include "support/vertex_picker.h"

namespace deltamesh::bench {
namespace {

TEST(Timing, MedianAndItsRatio) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median_ratio({2, 9, 4}, {1, 3, 2}), 2);
}

TEST(Timing, WorksTakeTurnsAndErrorsEndThem) {
  std::string turns;
  const auto note = [&](char c) {
    return [&turns, c]() -> Result<void> {
      turns += c;
      return turns.size() < 9 ? Result<void>() : Error{.code = ErrorCode::kInternal};
    };
  };
  const auto times = time_in_turn({.rounds = 3}, note('a'), note('b'));
  ASSERT_TRUE(times);
  EXPECT_EQ(turns, "ababab");
  EXPECT_EQ((*times)[1].size(), 3U);
  EXPECT_FALSE(time_in_turn({.rounds = 3}, note('c')));
  EXPECT_EQ(turns, "abababccc");
  turns.clear();
  EXPECT_TRUE(time_in_turn({.rounds = 3, .seconds = 0}, note('d')));
  EXPECT_EQ(turns, "d") << "one round in any case";
}

TEST(Table, MarkdownAndCsv) {
  EXPECT_EQ(table_head({"mesh", "bytes"}), "| mesh | bytes |\n|---|---:|\n");
  EXPECT_EQ(table_row({"a", "", "1"}), "| a | | 1 |\n");
  EXPECT_EQ(csv_row({quoted("say \"a\""), "", "1"}), "\"say \"\"a\"\"\",,1\r\n");
}

TEST(Choice, TakesNamesThatMatchAndQuickOnes) {
  const std::vector<MeshSource> all = {{"models/a", {}}, {"models/b", {}}, {"paper/a", {}}};
  const auto left = [&](const Choice& choice) {
    std::vector<MeshSource> sources = all;
    keep_chosen(sources, choice, [](const std::string& name) { return name == "models/a"; });
    std::string names;
    for (const MeshSource& source : sources) names += source.name + " ";
    return names;
  };
  EXPECT_EQ(left({}), "models/a models/b paper/a ");
  EXPECT_EQ(left({.names = "a$"}), "models/a paper/a ");
  EXPECT_EQ(left({.names = "a$", .quick = true}), "models/a ");
  EXPECT_EQ(left({.quick = true}), "models/a ");
}

TEST(VertexPicker, KeepsAttributesAndWeldsOnDemand) {
  Mesh mesh;
  mesh.positions = {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  mesh.attributes = {{.kind = AttributeKind::kColor, .type = ComponentType::kU8}};
  for (const int value : {7, 1, 2, 1, 3}) mesh.attributes.front().values.push_back(std::byte(value));
  const auto pick = [&](bool welds) {
    VertexPicker picker(mesh, welds);
    for (const std::uint32_t v : {3U, 2U, 1U, 4U, 2U, 3U}) picker.add_corner(v);
    return picker.take();
  };
  const Mesh welded = pick(true);
  EXPECT_EQ(welded.triangles, (std::vector<std::uint32_t>{0, 1, 0, 2, 1, 0})) << "4 has another colour";
  EXPECT_EQ(welded.positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(welded.attributes.front().values, (std::vector{std::byte{1}, std::byte{2}, std::byte{3}}));
  EXPECT_EQ(pick(false).triangles, (std::vector<std::uint32_t>{0, 1, 2, 3, 1, 0}));
}

TEST(WeldedGeometry, DropsAttributesAndDegenerateFaces) {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 5, 5, 5};
  mesh.triangles = {0, 1, 3, 2, 3, 0};
  mesh.attributes = {{.type = ComponentType::kU8, .values = std::vector<std::byte>(5)}};
  const Mesh welded = welded_geometry(mesh);
  EXPECT_EQ(welded.positions, (std::vector<float>{0, 1, 0, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(welded.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(welded.attributes.empty());
}

}  // namespace
}  // namespace deltamesh::bench
