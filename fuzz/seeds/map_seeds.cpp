// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// map_seeds FOLDER: writes the seeds of maps' fuzz targets, of the present draft, below FOLDER (fuzz/corpus):
// every kind of message, a receiver's talk with a sender, a map's message with primers, and parts by both
// coders and as patches.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "deltamesh/map/fragment.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_world.h"
#include "seeds.h"
#include "targets/map/map_part_codec.h"
#include "unit/grid/grid_meshes.h"

namespace {

using namespace deltamesh;
using fuzz::Bytes;
using fuzz::check;
using fuzz::write;

constexpr std::size_t kKind = 4;               ///< where a message has its kind [MAP-1]
constexpr int kOfAKind = 2;                    ///< messages that are kept
constexpr std::size_t kOffsetOfFragment = 14;  ///< where a short one has it [MAP-25]
constexpr std::size_t kHighestByteOfVde = 38;  ///< of a view of varints below 128, without boxes [MAP-15]

/// The messages between a sender of a small map that changes and a receiver.
std::vector<Bytes> talk() {
  test::World world(3, 1);
  MapSender sender = check(MapSender::make(test::World::description()));
  MapReceiver receiver(1, test::World::description().id,
                       {.parts = 100, .octets = 1 << 20, .vertices = 1 << 16});
  View view;
  view.max_error = 0.05F;
  receiver.set_view(view);
  std::vector<Bytes> said = {check(write_description(test::World::description()))};
  if (!receiver.apply(said.front())) std::abort();
  auto changed = world.present();
  for (double now = 1; now < 20; ++now) {
    if (!world.tell(sender, changed)) std::abort();
    said.push_back(check(receiver.view_message()));
    if (!sender.hear(said.back(), now)) std::abort();
    for (Bytes& message : check(sender.messages_for(1, now))) {
      if (!receiver.apply(message)) std::abort();
      said.push_back(std::move(message));
    }
    changed = world.change();
  }
  return said;
}

void write_talk(const std::string& folder) {
  Bytes all;
  std::map<int, int> kinds;
  for (const Bytes& message : talk()) {
    if (message.size() > 0xffff) std::abort();
    all.push_back(static_cast<std::byte>(message.size() & 255));
    all.push_back(static_cast<std::byte>(message.size() >> 8));
    all.insert(all.end(), message.begin(), message.end());
    const int kind = std::to_integer<int>(message[kKind]);
    if (const int place = kinds[kind]++; place < kOfAKind)
      write(folder + "/map_messages/kind_" + std::to_string(kind) + "_" + std::to_string(place), message);
  }
  write(folder + "/map_receiver/talk", all);
  write(folder + "/map_messages/receipt",
        check(write_receipt({.viewer = 1, .number = 2, .map_id = 3, .start = 4, .receipt = {30, {5, 29}}})));
  write(folder + "/map_messages/start", check(write_start({.map = 1, .start = 2, .number = 3})));
  write(folder + "/map_messages/fault",
        check(write_fault({.map = 1, .start = 2, .number = 3, .key = {0, 1, 2, 3}, .code = 203})));
  write(
      folder + "/map_messages/pose",
      check(write_pose({.map = 1, .start = 2, .number = 3, .pose = {.stamp = 4, .translation = {5, 6, 7}}})));
  for (const Bytes& fragment : check(cut_message(Bytes(100, std::byte{7}), kLeastFragment)))
    write(folder + "/map_messages/fragment_" +
              std::to_string(std::to_integer<int>(fragment[kOffsetOfFragment])),
          fragment);
  EntryMessage entry{.map = 1, .start = 1};
  entry.entry = {
      .key = {0, 1, 2, 3}, .revision = 3, .group = 1, .bytes = 100, .hash = 5, .vertices = 4, .triangles = 2};
  entry.entry.links = {{.key = {0, 2, 2, 3}, .border = 7, .together = true, .least = 2}};
  write(folder + "/map_messages/entry", check(write_entry(entry)));
  Bytes view = check(write_view({.viewer = 1, .number = 1, .map_id = 1}));
  view[kHighestByteOfVde] = std::byte{0x80};
  write(folder + "/map_messages/view_of_minus_zero", view);
}

void write_parts(const std::string& folder) {
  const MapCodec codec = fuzz::make_codec();
  write(folder + "/map_manifest/description", check(write_description(codec.description())));
  MapDescription plain = codec.description();
  plain.primers.clear();
  write(folder + "/map_manifest/plain", check(write_description(plain)));
  int number = 0;
  for (const MapPart& part : fuzz::make_parts(plain)) {
    const auto place = static_cast<std::byte>(number);
    for (const auto& [coder, name] :
         {std::pair{GeometryCoder::kHighpass, "highpass"}, {GeometryCoder::kPredictive, "predictive"}}) {
      const CodedPart coded = check(
          codec.encode(part, {.bounds = {.max_error = QualityBound{0.002}}, .geometry = coder, .effort = 0}));
      Bytes seed = {place};
      seed.insert(seed.end(), coded.bytes.begin(), coded.bytes.end());
      write(folder + "/map_part/part_" + std::to_string(number) + "_" + name, seed);
    }
    if (++number == 3) break;
  }
}

/// Waves, higher each time where x and y are.
Mesh waves_at(int time) {
  Mesh mesh = fuzz::waves(24);
  for (std::size_t i = 2; i < mesh.positions.size(); i += 3)
    if (mesh.positions[i - 2] > 0.1F && mesh.positions[i - 1] > 0.2F)
      mesh.positions[i] += 0.006F * static_cast<float>(time);
  return mesh;
}

/// Voxels of 0.02: a ball, of which a part grows.
Mesh voxels_at(int time) {
  const auto field = [&](int x, int y, int z) {
    const float way[3] = {static_cast<float>(x) - 9, static_cast<float>(y) - 9.3F,
                          static_cast<float>(z) - 8.6F};
    const float grown = x > 11 ? 0.3F * static_cast<float>(time) : 0.0F;
    return std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]) - 6.2F - grown;
  };
  const scenes::Surface surface = test::marched(field, 20);
  Mesh mesh;
  Attribute color{AttributeKind::kColor, ComponentType::kU8, 3, true, "red", {}};
  for (const float x : surface.positions) {
    mesh.positions.push_back(0.02F * x);
    color.values.push_back(static_cast<std::byte>(8 * x + static_cast<float>(time)));
  }
  mesh.triangles = surface.triangles;
  mesh.attributes.push_back(color);
  return mesh;
}

/// Parts of the same map whose newer versions are patches.
void write_patched(const std::string& folder, const std::string& name, Mesh (*mesh_at)(int)) {
  MapDescription description = fuzz::make_codec().description();
  SenderOptions options;
  options.effort = 0;
  options.split = {.most_triangles = 300, .most_level = 2};
  MapSender sender = check(MapSender::make(description, options));
  MapReceiver receiver(1, description.id);
  receiver.set_view({.max_error = 0.002F, .color_error = 4.0F});
  for (int time = 0; time < 3; ++time) {
    const Mesh mesh = mesh_at(time);
    const std::vector<MapBlock> blocks = {{{0, 0, 0}, mesh}};
    if (!sender.update(blocks)) std::abort();
    for (const double now : {time + 1.0, time + 1.4}) {
      if (!sender.hear(check(receiver.view_message()), now)) std::abort();
      for (const Bytes& message : check(sender.messages_for(1, now)))
        if (!receiver.apply(message)) std::abort();
    }
  }
  int number = 0;
  const std::vector<MapPart> parts = fuzz::make_parts(description);
  for (const HeldPart& held : receiver.held()) {
    const auto place = std::ranges::find(parts, held.entry.key, &MapPart::key);
    if (held.octets.front() != std::byte{4} || place == parts.end()) continue;  // [MAP-17]
    Bytes seed = {static_cast<std::byte>(place - parts.begin())};
    seed.insert(seed.end(), held.octets.begin(), held.octets.end());
    write(folder + "/map_part/" + name + "_" + std::to_string(number++), seed);
    if (number == 2) break;
  }
  if (number == 0) std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return EXIT_FAILURE;
  write_talk(argv[1]);
  write_parts(argv[1]);
  write_patched(argv[1], "patched", waves_at);
  write_patched(argv[1], "beside", voxels_at);
}
