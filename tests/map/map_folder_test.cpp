// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole meshes as maps, and maps as folders.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "deltamesh/map/encode_map.h"
#include "map/map_meshes.h"

namespace deltamesh {
namespace {

namespace fs = std::filesystem;
using test::topology_counts;
using test::wavy_sheet;
using test::welded;

MapSettings settings() {
  MapSettings settings;
  settings.part_edge = 0.6;
  settings.most_triangles = 300;
  settings.quality.bounds.max_error = QualityBound{0.002};
  settings.quality.attributes.color_error = 4;
  settings.quality.effort = 1;
  return settings;
}

std::vector<NewPart> parts_of(const MapState& state) {
  std::vector<NewPart> parts;
  for (std::size_t i = 0; i < state.octets.size(); ++i)
    parts.push_back({state.manifest.entries[i].key, state.manifest.entries[i].revision, state.octets[i]});
  return parts;
}

Result<MapState> load_state(const std::string& folder) {
  auto manifest = load_map(folder);
  if (!manifest) return manifest.error();
  MapState state{.manifest = *std::move(manifest)};
  for (const PartEntry& entry : state.manifest.entries) {
    auto octets = load_part(folder, entry);
    if (!octets) return octets.error();
    state.octets.push_back(*std::move(octets));
  }
  return state;
}

class MapFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = (fs::temp_directory_path() / ("deltamesh_map_" + std::to_string(::getpid()))).string();
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string folder_;
};

TEST_F(MapFolder, MAP10SavedAndLoadedAMapIsTheSame) {
  const Mesh mesh = wavy_sheet(60, 40, 1, 0);
  const auto state = encode_map(mesh, settings());
  ASSERT_TRUE(state) << describe(state.error());
  EXPECT_GT(state->octets.size(), 4U);
  ASSERT_TRUE(save_map(folder_, state->manifest, parts_of(*state)));
  const auto back = load_state(folder_);
  ASSERT_TRUE(back) << describe(back.error());
  EXPECT_EQ(back->octets, state->octets);
  EXPECT_EQ(*write_manifest(back->manifest), *write_manifest(state->manifest));
  const auto joined = decode_map(*back);
  ASSERT_TRUE(joined);
  EXPECT_EQ(topology_counts(*joined), topology_counts(welded(mesh)));
}

TEST_F(MapFolder, AStateThatCannotBeWrittenLeavesTheOldOneAndNothingElse) {
  const auto first = encode_map(wavy_sheet(60, 40, 1, 0), settings());
  ASSERT_TRUE(save_map(folder_, first->manifest, parts_of(*first)));
  const auto second = encode_map(wavy_sheet(60, 40, 2, 0), settings(), &*first);
  ASSERT_TRUE(second);
  const auto parts = parts_of(*second);
  const PartEntry& last = second->manifest.entries.back();
  const fs::path taken = fs::path(folder_) / part_file(last.key, last.revision, last.hash);
  fs::create_directories(taken / "in the way");
  const auto saved = save_map(folder_, second->manifest, parts);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::kFileWrite);
  fs::remove_all(taken);
  EXPECT_EQ(load_state(folder_)->octets, first->octets);
  const auto files = fs::directory_iterator(fs::path(folder_) / "parts");
  EXPECT_EQ(static_cast<std::size_t>(std::distance(begin(files), end(files))), first->octets.size());
  ASSERT_TRUE(save_map(folder_, second->manifest, parts));
  EXPECT_EQ(load_state(folder_)->octets, second->octets);
}

TEST_F(MapFolder, AMeshWithoutExtentNeedsBoundsInModelUnits) {
  Mesh point;
  point.positions = {1, 2, 3};
  point.triangles = {0, 0, 0};
  MapSettings settings{.part_edge = 1};
  settings.quality.bounds.max_error = QualityBound{0.02, QualityUnit::kDiagonal};
  EXPECT_STREQ(encode_map(point, settings).error().message,
               "a mesh without extent needs bounds in model units, not in percent");
  // One that begins empty is bounded by the size of its parts.
  EXPECT_TRUE(encode_map(Mesh(), settings));
  settings.quality.bounds.max_error = QualityBound{0.01};
  for (const Mesh& mesh : {Mesh(), point}) {
    const auto state = encode_map(mesh, settings);
    ASSERT_TRUE(state) << describe(state.error());
    EXPECT_EQ(state->octets.size(), mesh.triangle_count());
  }
}

TEST_F(MapFolder, AnUpdateKeepsWhatIsTheSame) {
  Mesh mesh = wavy_sheet(60, 40, 1, 0);
  const auto first = encode_map(mesh, settings());
  ASSERT_TRUE(first);
  const auto same = encode_map(mesh, settings(), &*first);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->octets, first->octets);
  EXPECT_EQ(*write_manifest(same->manifest), *write_manifest(first->manifest));
  for (const PartEntry& entry : same->manifest.entries) EXPECT_EQ(entry.revision, 1U);
  for (std::size_t k = 0; k < 3; ++k) mesh.positions[3 * 70 + k] += 0.004F;
  const auto second = encode_map(mesh, settings(), &*same);
  ASSERT_TRUE(second);
  std::size_t changed = 0;
  for (const PartEntry& entry : second->manifest.entries) changed += entry.revision == 2 ? 1 : 0;
  EXPECT_GE(changed, 1U);
  EXPECT_LE(changed, 4U);  // those that have the vertex
  EXPECT_LT(changed, second->manifest.entries.size());
  EXPECT_EQ(second->manifest.description, first->manifest.description);
  MapSettings finer = settings();
  finer.quality.bounds.max_error = QualityBound{0.0004};
  const auto other = encode_map(mesh, finer, &*second);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->manifest.description.epoch, 1U);
}

TEST_F(MapFolder, InterruptedBeforeTheManifestTheOldStateStays) {
  Mesh mesh = wavy_sheet(60, 40, 1, 0);
  const auto first = encode_map(mesh, settings());
  ASSERT_TRUE(save_map(folder_, first->manifest, parts_of(*first)));
  for (float& x : mesh.positions) x *= 1.01F;
  const auto second = encode_map(mesh, settings(), &*first);
  ASSERT_TRUE(second);
  for (const NewPart& part : parts_of(*second)) {  // all that save_map() does before it replaces the manifest
    const auto& entries = second->manifest.entries;
    const auto entry = std::ranges::find(entries, part.key, &PartEntry::key);
    std::ofstream file(fs::path(folder_) / part_file(part.key, part.revision, entry->hash), std::ios::binary);
    file.write(reinterpret_cast<const char*>(part.bytes.data()),
               static_cast<std::streamsize>(part.bytes.size()));
  }
  const auto old = load_state(folder_);
  ASSERT_TRUE(old);
  EXPECT_EQ(old->octets, first->octets);
  ASSERT_TRUE(save_map(folder_, second->manifest, parts_of(*second)));
  EXPECT_EQ(load_state(folder_)->octets, second->octets);
  std::size_t files = 0;
  for (const auto& file : fs::directory_iterator(fs::path(folder_) / "parts")) files += file.exists() ? 1 : 0;
  EXPECT_EQ(files, second->octets.size());
}

TEST_F(MapFolder, DamagedFilesAreErrors) {
  const auto state = encode_map(wavy_sheet(30, 20, 1, 0), settings());
  ASSERT_TRUE(state);
  ASSERT_TRUE(save_map(folder_, state->manifest, parts_of(*state)));
  const PartEntry& entry = state->manifest.entries.front();
  const fs::path part = fs::path(folder_) / part_file(entry.key, entry.revision, entry.hash);
  fs::resize_file(part, 10);
  EXPECT_EQ(load_part(folder_, entry).error().code, ErrorCode::kCorrupt);
  fs::remove(part);
  EXPECT_EQ(load_part(folder_, entry).error().code, ErrorCode::kFileOpen);
  EXPECT_FALSE(load_map(folder_ + "/nowhere"));
}

TEST(MapManifest, MAP10RefusesWhatCannotBe) {
  const auto state = encode_map(wavy_sheet(30, 20, 1, 0), settings());
  ASSERT_TRUE(state);
  const auto bytes = *write_manifest(state->manifest);
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_FALSE(read_manifest(std::span(bytes).first(size)));
  for (std::size_t i = 0; i < bytes.size(); i += 5) {
    auto damaged = bytes;
    damaged[i] ^= std::byte{16};
    EXPECT_FALSE(read_manifest(damaged));
  }
  const auto rule_of = [&](auto change) {
    MapManifest manifest = state->manifest;
    change(manifest);
    const auto written = write_manifest(manifest);
    return written ? std::string() : std::string(written.error().rule);
  };
  EXPECT_EQ(rule_of([](MapManifest& m) { std::swap(m.entries[0], m.entries[1]); }), "MAP-10");
  EXPECT_EQ(rule_of([](MapManifest& m) { m.entries[0].bytes = 0; }), "MAP-10");
  EXPECT_EQ(rule_of([](MapManifest& m) { m.entries[0].revision = 2; }), "MAP-10");
  EXPECT_EQ(rule_of([](MapManifest& m) { m.next_group = 0; }), "MAP-10");
  EXPECT_EQ(rule_of([](MapManifest& m) { m.entries[0].attribute_errors.clear(); }), "MAP-10");
}

TEST(EncodeMap, SettingsAreChecked) {
  const Mesh mesh = wavy_sheet(4, 4, 1, 0);
  MapSettings bad = settings();
  bad.part_edge = 0;
  EXPECT_EQ(encode_map(mesh, bad).error().code, ErrorCode::kInvalidArgument);
  bad = settings();
  bad.quality.bounds.target_bytes = 10;
  EXPECT_EQ(encode_map(mesh, bad).error().code, ErrorCode::kInvalidArgument);
  for (const double value : {0.0, -1.0, kNoBound.value}) {
    bad = settings();
    bad.quality.bounds = {.max_error = QualityBound{value}};
    EXPECT_EQ(encode_map(mesh, bad).error().code, ErrorCode::kInvalidArgument);
  }
  EXPECT_TRUE(encode_map(Mesh(), settings())->octets.empty());
}

}  // namespace
}  // namespace deltamesh
