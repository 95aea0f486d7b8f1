// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// patched_parts FOLDER VOXELS: writes what a receiver has of a generated drive after a few updates, at a
// largest error of so many voxels: `map`, the map's message, and of every part `L_X_Y_Z`, its octets, and
// `L_X_Y_Z.mesh`, the numbers of its vertices and faces, positions, faces, and colours.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "deltamesh/map/split.h"
#include "drive.h"

namespace {

using namespace deltamesh;

constexpr int kUpdates = 8;

template <class T>
T check(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().message);
    std::abort();
  }
  return *std::move(result);
}

template <class T>
void append(std::ofstream& out, std::span<const T> values) {
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
}

MapDescription description_of(const Drive& drive, double max_error, const std::vector<MapBlock>& blocks) {
  MapDescription description{.id = 1, .epoch = 1, .frame = "map"};
  description.lattice = {.origin = drive.origin(), .step_exponent = step_exponent_for(max_error)};
  description.cell_steps =
      static_cast<std::uint32_t>(std::lround(kDriveBlockVoxels * drive.voxel() / description.lattice.step()));
  description.grid = VoxelGrid{{}, {drive.voxel(), drive.voxel(), drive.voxel()}};
  for (const AttributeView& a : blocks.front().mesh.attributes)
    description.attributes.push_back(
        {a.kind, a.type, a.components, a.normalized, std::string(a.name), a.linear});
  Splitter splitter = check(Splitter::make(description, {.most_triangles = 1000}));
  const MapChange change = check(splitter.update(blocks));
  std::vector<MapPart> parts;
  for (const ChangedPart& changed : change.changed) parts.push_back(changed.part);
  return check(
      with_primers(description, parts, {.bounds = {.max_error = QualityBound{max_error}}, .effort = 0}));
}

void write(const std::string& path, const MapPart& part, std::span<const std::byte> octets) {
  std::ofstream bytes(path, std::ios::binary);
  append(bytes, octets);
  std::ofstream mesh(path + ".mesh", std::ios::binary);
  const std::array counts{static_cast<std::uint32_t>(part.mesh.vertex_count()),
                          static_cast<std::uint32_t>(part.mesh.triangle_count())};
  append(mesh, std::span<const std::uint32_t>(counts));
  append(mesh, std::span<const float>(part.mesh.positions));
  append(mesh, std::span<const std::uint32_t>(part.mesh.triangles));
  for (const Attribute& attribute : part.mesh.attributes)
    append(mesh, std::span<const std::byte>(attribute.values));
  if (!bytes.flush() || !mesh.flush()) std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  const std::string folder = argv[1];
  Drive drive = check(Drive::make(4000, 1));
  const double max_error = std::atof(argv[2]) * drive.voxel();
  std::optional<MapSender> sender;
  MapReceiver receiver(1, 1);
  View view;
  view.max_error = static_cast<float>(max_error);
  view.color_error = 4.0F;
  receiver.set_view(view);
  double now = 0;
  for (int i = 0; i < kUpdates; ++i) {
    const SequenceStep update = drive.next();
    const Mesh nothing;
    std::vector<MapBlock> blocks;
    for (const SequenceBlock& block : update.changed) blocks.push_back({block.id, block.mesh});
    for (const SequenceBlockId& id : update.removed) blocks.push_back({id, nothing});
    if (!sender) {
      const MapDescription description = description_of(drive, max_error, blocks);
      SenderOptions options;
      options.split.most_triangles = 1000;
      sender = check(MapSender::make(description, options));
      std::ofstream message(folder + "/map", std::ios::binary);
      append(message, std::span<const std::byte>(check(write_description(description))));
    }
    if (!sender->update(blocks)) std::abort();
    for (int round = 0; round < 2; ++round) {
      if (!sender->hear(check(receiver.view_message()), now += 2)) std::abort();
      for (const auto& message : check(sender->messages_for(1, now)))
        if (!receiver.apply(message)) std::abort();
    }
  }
  for (const HeldPart& held : receiver.held()) {
    const PartKey& key = held.entry.key;
    std::string name = std::to_string(int{key.level});
    for (const std::int32_t x : {key.x, key.y, key.z}) name.append(1, '_').append(std::to_string(x));
    write(folder + "/" + name, *receiver.find(key), held.octets);
  }
  return sender->counts().patches_sent > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
