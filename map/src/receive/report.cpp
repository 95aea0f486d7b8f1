// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a receiver tells its sender [MAP-15, MAP-21].
#include <utility>

#include "part/view_cells.h"
#include "receive/state.h"

namespace deltamesh {

void MapReceiver::State::drop_stuck(double now) {
  constexpr double kLong = 4;  // seconds, some round trips
  if (!codec) return;
  View places = view;
  places.level = 0;  // parts below the view's level stay until copies come in their place
  const std::map<PartKey, double> before = std::exchange(stuck_since, {});
  for (const auto& [key, part] : parts.all()) {
    if (part.waiting.empty() || is_in_view(key, places, codec->description())) continue;
    const auto found = before.find(key);
    stuck_since[key] = found == before.end() ? now : found->second;
  }
  for (const auto& [key, since] : stuck_since)
    if (now - since > kLong) parts.drop(key, touched);
  settle();
}

Result<std::vector<std::byte>> MapReceiver::State::view_message() {
  ViewMessage message{.viewer = viewer,
                      .number = ++number,
                      .map_id = map_id,
                      .map = codec ? map : 0,
                      .epoch = codec ? codec->description().epoch : 0,
                      .start = start,
                      .receipt = arrivals.receipt(),
                      .view = view,
                      .held = {}};
  for (const auto& [key, part] : parts.all()) {
    const Version* newest = part.shown ? &*part.shown : nullptr;
    if (!part.waiting.empty() && part.waiting.back().content) newest = &part.waiting.back();
    if (newest == nullptr) continue;
    message.held.push_back(
        {key, newest->revision, version_hash(newest->content->hash, newest->links), !part.waiting.empty()});
  }
  return write_view(message);
}

Result<std::vector<std::byte>> MapReceiver::State::receipt_message() {
  return write_receipt({viewer, ++number, map_id, start, arrivals.receipt()});
}

}  // namespace deltamesh
