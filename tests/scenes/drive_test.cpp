// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A generated drive, and folders of updates.
#include "drive.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "deltamesh/io.h"
#include "sequence.h"

namespace deltamesh {
namespace {

Drive start(std::uint64_t vertices, std::uint64_t seed) {
  auto drive = Drive::make(vertices, seed);
  EXPECT_TRUE(drive);
  return std::move(*drive);
}

/// FNV-1a over ids, positions and triangles of what changed.
std::uint64_t hash_of(const SequenceStep& update) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](std::span<const std::byte> bytes) {
    for (const std::byte b : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3U;
  };
  for (const SequenceBlock& block : update.changed) {
    add(std::as_bytes(std::span(block.id)));
    add(std::as_bytes(std::span(block.mesh.positions)));
    add(std::as_bytes(std::span(block.mesh.triangles)));
    add(block.mesh.attributes[0].values);
  }
  return hash;
}

std::string scratch_folder(const char* name) {
  const std::string folder = testing::TempDir() + "deltamesh_" + name;
  std::filesystem::remove_all(folder);
  return folder;
}

TEST(Drive, BlocksAppearMoveAndVanish) {
  Drive drive = start(50000, 1);
  std::set<SequenceBlockId> known;
  std::size_t moved = 0;
  std::size_t removed = 0;
  for (int step = 0; step < 40; ++step) {
    const SequenceStep update = drive.next();
    for (const SequenceBlock& block : update.changed) moved += known.insert(block.id).second ? 0 : 1;
    for (const SequenceBlockId& id : update.removed) removed += known.erase(id);
    EXPECT_EQ(known.size(), drive.blocks().size());
  }
  EXPECT_GT(known.size(), 20U);
  EXPECT_GT(moved, 100U);
  EXPECT_GT(removed, 0U);
}

TEST(Drive, DependsOnItsArgumentsOnly) {
  Drive a = start(10000, 5);
  Drive b = start(10000, 5);
  Drive c = start(10000, 6);
  for (int step = 0; step < 3; ++step) {
    const std::uint64_t hash = hash_of(a.next());
    EXPECT_EQ(hash, hash_of(b.next()));
    EXPECT_NE(hash, hash_of(c.next()));
  }
  EXPECT_FALSE(Drive::make(11, 1));
  EXPECT_FALSE(Drive::make(kMaxDriveVertices + 1, 1));
}

TEST(Drive, IsTheSameWithEveryCompiler) {
  Drive drive = start(2000, 1);
  drive.next();
  EXPECT_EQ(hash_of(drive.next()), 11940396416733751405U);
}

/// Edges of one triangle lie where the map ends, never between two blocks: both sides have the same bits.
TEST(Drive, NoCracksBetweenBlocks) {
  Drive drive = start(10000, 2);
  for (int step = 0; step < 15; ++step) drive.next();
  using Place = std::array<float, 3>;
  std::map<std::pair<Place, Place>, int> edges;
  std::size_t inner = 0;
  for (const auto& block : drive.blocks()) {
    const auto& mesh = block.second;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto place = [&](std::size_t corner) {
        const float* p = &mesh.positions[3 * std::size_t{mesh.triangles[corner]}];
        return Place{p[0], p[1], p[2]};
      };
      const Place a = place(i);
      const Place b = place(i % 3 == 2 ? i - 2 : i + 1);
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  for (const auto& [edge, count] : edges) inner += count == 2 ? 1 : 0;
  EXPECT_GT(static_cast<double>(inner), 0.8 * static_cast<double>(edges.size()));
}

TEST(Sequence, WhatIsWrittenIsRead) {
  const std::string folder = scratch_folder("sequence");
  Drive drive = start(5000, 1);
  const SequenceHeader header{.description = "test",
                              .voxel = drive.voxel(),
                              .block_voxels = kDriveBlockVoxels,
                              .block_metres = kDriveBlockVoxels * drive.voxel(),
                              .origin = drive.origin()};
  auto writer = SequenceWriter::create(folder, header);
  ASSERT_TRUE(writer);
  std::vector<SequenceStep> steps;
  for (int i = 0; i < 3; ++i) {
    const SequenceStep& step = steps.emplace_back(drive.next());
    std::vector<SequenceBlock> blocks;
    for (const auto& [id, mesh] : drive.blocks()) blocks.push_back({id, mesh});
    ASSERT_TRUE(writer->add(step, blocks));
  }
  const auto reader = SequenceReader::open(folder);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->header().origin, header.origin);
  EXPECT_EQ(reader->header().block_metres, header.block_metres);
  ASSERT_EQ(reader->size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto step = reader->read(i);
    ASSERT_TRUE(step);
    EXPECT_EQ(step->removed, steps[i].removed);
    ASSERT_EQ(step->changed.size(), steps[i].changed.size());
    for (std::size_t b = 0; b < step->changed.size(); ++b) {
      EXPECT_EQ(step->changed[b].id, steps[i].changed[b].id);
      EXPECT_EQ(step->changed[b].mesh.positions, steps[i].changed[b].mesh.positions);
      EXPECT_EQ(step->changed[b].mesh.triangles, steps[i].changed[b].mesh.triangles);
      EXPECT_EQ(step->changed[b].mesh.attributes[0].values, steps[i].changed[b].mesh.attributes[0].values);
    }
  }
  const auto whole = reader->read_whole(2);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->vertex_count(), writer->vertices());
  std::filesystem::remove_all(folder);
}

TEST(Sequence, DamagedFoldersAreErrors) {
  const std::string folder = scratch_folder("bad_sequence");
  EXPECT_EQ(SequenceReader::open(folder).error().code, ErrorCode::kFileOpen);
  std::filesystem::create_directories(folder);
  const auto try_text = [&](std::string_view text) {
    EXPECT_TRUE(write_file(folder + "/sequence.json", std::as_bytes(std::span(text))));
    const auto reader = SequenceReader::open(folder);
    return reader ? reader->read(0).error().code : reader.error().code;
  };
  EXPECT_EQ(try_text("{"), ErrorCode::kInvalidFile);
  EXPECT_EQ(try_text("[]"), ErrorCode::kInvalidFile);
  const std::string head =
      R"({"description":"","voxel":1,"block_voxels":16,"block_metres":16,"origin":[0,0,0],"steps":)";
  EXPECT_EQ(try_text(head + "7}"), ErrorCode::kInvalidFile);
  const std::string step = R"([{"changed":"a.ply","full":"a.ply","removed":[],"blocks":[{"id":[0,0,0],)"
                           R"("first_vertex":0,"vertices":V,"first_face":0,"faces":1}]}]})";
  EXPECT_EQ(try_text(head + step), ErrorCode::kInvalidFile);
  std::string beyond = head + step;
  beyond.replace(beyond.find(":V,"), 2, ":9");
  EXPECT_EQ(try_text(beyond), ErrorCode::kFileOpen);
  Mesh mesh;
  mesh.positions.assign(12, 0);
  mesh.triangles = {1, 2, 3};
  ASSERT_TRUE(write_mesh_file(folder + "/a.ply", mesh));
  EXPECT_EQ(try_text(beyond), ErrorCode::kInvalidFile);
  beyond.replace(beyond.find(":9"), 2, ":3");
  EXPECT_EQ(try_text(beyond), ErrorCode::kInvalidFile);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace deltamesh
