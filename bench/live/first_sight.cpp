// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/first_sight.h"

#include <algorithm>
#include <ctime>
#include <vector>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "live/link.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr double kCallSeconds = 0.05;
constexpr double kMostSeconds = 1000;
constexpr double kViewError = 0.05;  // voxels

template <class Call>
double milliseconds_of(Call call) {
  const std::clock_t begin = std::clock();
  call();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Cells of opposite signs are in no common cell of any level: here all are positive, and the map's zero is
/// not where large cells end.
constexpr std::int32_t kFirstCell = 0x555;

MapDescription description_of(const MapUpdates& map) {
  MapDescription description = map_description(map, kViewError * map.voxel);
  for (std::int32_t& x : description.cell_origin)
    x -= kFirstCell * static_cast<std::int32_t>(description.cell_steps);
  return description;
}

void take_shifted(const SequenceStep& step, MapSender& sender) {
  std::vector<MapBlock> blocks;
  for (const SequenceBlock& block : step.changed) {
    blocks.push_back({block.id, block.mesh});
    for (std::int32_t& x : blocks.back().cell) x += kFirstCell;
  }
  check_or_exit(sender.update(blocks));
}

/// Whether every part of the finest level, or one around it, or what it was copied from, is shown.
bool is_all_seen(const std::vector<PartKey>& finest, const MapReceiver& receiver) {
  const std::vector<PartKey> shown = receiver.shown();
  return std::ranges::all_of(finest, [&](const PartKey& key) {
    return std::ranges::any_of(shown, [&](const PartKey& other) { return overlap(key, other); });
  });
}

}  // namespace

FirstSight measure_first_sight(const MapUpdates& map, std::uint8_t copy_level, double rate) {
  MapSender sender =
      value_or_exit(MapSender::make(description_of(map), {.split = {.copy_level = copy_level}}));
  FirstSight sight{.all_seen = -1, .all_there = -1};
  sight.update = milliseconds_of([&] { take_shifted(map.steps.front(), sender); });
  const std::vector<PartKey> finest = sender.keys();
  MapReceiver receiver(1, sender.description().id);
  View view;
  view.max_error = static_cast<float>(kViewError * map.voxel);
  view.color_error = 4;
  view.bytes_per_second = static_cast<std::uint32_t>(rate);
  receiver.set_view(view);
  const LinkSettings settings{.delay = 0.01, .bytes_per_second = rate};
  Link down(settings, 1);
  Link up(settings, 2);
  for (double now = 0; sight.all_there < 0 && now < kMostSeconds; now += kCallSeconds) {
    for (auto& message : value_or_exit(receiver.messages(now))) up.send(std::move(message), now);
    for (const auto& message : up.take(now)) check_or_exit(sender.hear(message, now));
    if (!sender.viewers().empty()) {
      std::vector<std::vector<std::byte>> messages;
      const double call = milliseconds_of([&] { messages = value_or_exit(sender.messages_for(1, now)); });
      sight.longest_call = std::max(sight.longest_call, call);
      for (auto& message : messages) {
        const auto part = read_part(message);
        if (part && !std::ranges::binary_search(finest, part->key)) sight.copy_bytes += message.size();
        down.send(std::move(message), now);
      }
    }
    for (const auto& message : down.take(now)) check_or_exit(receiver.apply(message));
    if (sight.all_seen < 0 && is_all_seen(finest, receiver)) sight.all_seen = now;
    if (receiver.shown() == finest) sight.all_there = now;
  }
  sight.bytes = down.bytes();
  return sight;
}

}  // namespace deltamesh::bench
