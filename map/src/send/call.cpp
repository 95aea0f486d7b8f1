// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a call of messages_for() may take, and what a sender does beside sending parts: copies, epochs, poses.
#include <algorithm>
#include <limits>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "send/state.h"
#include "send/wanted_parts.h"

namespace deltamesh {

void MapSender::State::begin_call(Viewer& viewer, double now) {
  using Clock = std::chrono::steady_clock;
  constexpr double kNoLimit = 1e6;  // seconds
  const std::chrono::duration<double> time(std::min(options.call_seconds, kNoLimit));
  links_made = 0;
  deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
  total.begin(static_cast<double>(options.bytes_per_second), now);
  viewer.allowance.begin(viewer.view.bytes_per_second, now,
                         total.room() / static_cast<double>(viewers.size()));
}

bool MapSender::State::is_call_over(bool has_any) const {
  if (options.cancel != nullptr && options.cancel->load()) return true;
  // A receiver that says that it has thousands of parts of another sender costs a link to each of them.
  constexpr std::size_t kMostLinksMade = std::size_t{1} << 16;
  return has_any && (links_made >= kMostLinksMade || std::chrono::steady_clock::now() >= deadline);
}

Result<void> MapSender::State::begin_epoch(std::uint32_t of_receiver) {
  constexpr unsigned kMostEpochs = 8;  // all is encoded anew each time, whoever asks
  if (epochs >= kMostEpochs || of_receiver == std::numeric_limits<std::uint32_t>::max())
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "a view of another description of the map, of a later epoch",
                 .rule = "MAP-16"};
  MapDescription description = encodings.codec().description();
  description.epoch = of_receiver + 1;
  const std::uint64_t hash = hash_of(description);
  DELTAMESH_TRY(MapCodec codec, MapCodec::open(std::move(description)));
  encodings = Encodings(std::move(codec), options, colors);
  description_hash = hash;
  known.clear();
  viewers.clear();
  ++epochs;
  return {};
}

Result<void> MapSender::set_pose(const MapPose& pose) noexcept {
  return guarded([&]() -> Result<void> {
    DELTAMESH_CHECK(write_pose({.pose = pose}));
    state_->pose = pose;
    return {};
  });
}

Result<void> MapSender::State::tell_pose(Viewer& viewer, double now,
                                         std::vector<std::vector<std::byte>>& messages) {
  if (!pose || viewer.pose == pose || !viewer.allowance.may_spend()) return {};
  const std::uint64_t number = viewer.delivery.next_number();
  DELTAMESH_TRY(auto message, write_pose({description_hash, viewer.begin, number, *pose}));
  viewer.delivery.add({.key = kNoPart, .bytes = std::move(message), .is_whole = true});
  viewer.send_made(now, messages);
  viewer.pose = pose;
  return {};
}

Result<void> MapSender::State::tell_end(Viewer& viewer, double now,
                                        std::vector<std::vector<std::byte>>& messages) {
  if (!viewer.delivery.is_end_unseen(now) || !viewer.allowance.may_spend()) return {};
  const std::uint64_t number = viewer.delivery.next_number();
  DELTAMESH_TRY(auto message,
                write_start({.map = description_hash, .start = viewer.begin, .number = number}));
  viewer.delivery.add({.key = kNoPart, .bytes = std::move(message), .is_superseded = true});
  viewer.send_made(now, messages);
  return {};
}

Result<void> MapSender::State::make_copies(Viewer& viewer, const SeenCells& seen, double now) {
  constexpr double kLongest =
      2;  // seconds: a map that changes faster than copies of it are made goes without
  if (options.split.copy_level == 0 || is_call_over(false)) return {};
  DELTAMESH_TRY(const bool is_complete, make_copies_for(viewer, map, encodings.codec().description(), seen));
  if (is_complete) viewer.copies_due_since.reset();
  if (!is_complete && !viewer.copies_due_since) viewer.copies_due_since = now;
  viewer.waits_for_copies = !is_complete && now - *viewer.copies_due_since < kLongest;
  return {};
}

}  // namespace deltamesh
