// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/receiver.h"

#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "message/entry_fields.h"
#include "message/frame.h"
#include "receive/state.h"

namespace deltamesh {

MapReceiver::MapReceiver(std::uint64_t viewer, std::uint64_t map_id, const ReceiverLimits& limits)
    : state_(std::make_unique<State>()) {
  state_->viewer = viewer;
  state_->map_id = map_id;
  state_->limits = limits;
}
MapReceiver::MapReceiver(MapReceiver&&) noexcept = default;
MapReceiver& MapReceiver::operator=(MapReceiver&&) noexcept = default;
MapReceiver::~MapReceiver() = default;

Result<void> MapReceiver::apply(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<void> {
    state_->talk.earn(message.size());
    DELTAMESH_CHECK(state_->apply(message));
    return state_->apply_early();
  });
}

Result<std::vector<std::vector<std::byte>>> MapReceiver::messages(double now) noexcept {
  now = state_->clock.at(now);
  return guarded([&]() -> Result<std::vector<std::vector<std::byte>>> {
    std::vector<std::vector<std::byte>> messages;
    const Talk::Turn turn = state_->talk.turn(now, state_->arrivals.has_any());
    if (turn == Talk::Turn::kView) {
      state_->drop_stuck(now);
      DELTAMESH_TRY(messages.emplace_back(), state_->view_message());
    } else if (turn == Talk::Turn::kReceipt) {
      DELTAMESH_TRY(messages.emplace_back(), state_->receipt_message());
    }
    if (turn == Talk::Turn::kNothing) return messages;
    state_->talk.said(turn, messages.back().size(), now);
    return cut_message(std::move(messages.back()), state_->limits.message_bytes);
  });
}

void MapReceiver::drop(const PartKey& key) {
  state_->parts.drop(key, state_->touched);
  state_->talk.want_view();
}

void MapReceiver::set_view(const View& view) {
  if (view != state_->view) state_->talk.want_view();
  state_->view = view;
  if (state_->codec) state_->settle();
}
const View& MapReceiver::view() const noexcept { return state_->view; }

Result<std::vector<std::byte>> MapReceiver::view_message() noexcept {
  return guarded([&] { return state_->view_message(); });
}

const MapDescription* MapReceiver::description() const noexcept {
  return state_->codec ? &state_->codec->description() : nullptr;
}

const MapPose* MapReceiver::pose() const noexcept { return state_->pose ? &state_->pose->pose : nullptr; }

const MapPart* MapReceiver::find(const PartKey& key) const noexcept {
  const ReceivedPart* part = state_->parts.find(key);
  return part != nullptr && part->shown ? &part->shown->content->part : nullptr;
}

std::vector<PartKey> MapReceiver::shown() const {
  std::vector<PartKey> keys;
  for (const auto& [key, part] : state_->parts.all())
    if (part.shown) keys.push_back(key);
  return keys;
}

ShownChange MapReceiver::take_change() {
  ShownChange change;
  for (const PartKey& key : state_->touched)
    (find(key) != nullptr ? change.changed : change.removed).push_back(key);
  state_->touched.clear();
  return change;
}

std::vector<PartKey> MapReceiver::lacking() const {
  std::vector<PartKey> keys;
  for (const auto& [key, revision] : state_->announced) keys.push_back(key);
  return keys;
}

std::vector<PartFault> MapReceiver::faults() const {
  std::vector<PartFault> faults;
  for (const auto& [key, fault] : state_->faults)
    if (fault.code != 0) faults.push_back({.key = key, .code = static_cast<ErrorCode>(fault.code)});
  return faults;
}

std::uint64_t MapReceiver::hash() const {
  std::vector<std::pair<PartKey, std::uint64_t>> shown;
  for (const auto& [key, part] : state_->parts.all())
    if (part.shown) shown.emplace_back(key, part.shown->content->hash);
  return hash_of_shown(shown);
}

std::vector<HeldPart> MapReceiver::held() const {
  std::vector<HeldPart> parts;
  for (const auto& [key, part] : state_->parts.all()) {
    if (!part.shown) continue;
    const PartContent& content = *part.shown->content;
    PartEntry entry{.key = key, .revision = part.shown->revision, .group = part.shown->group};
    entry.bytes = static_cast<std::uint32_t>(content.octets.size());
    entry.links = part.shown->links;
    entry.hash = content.hash;
    entry.vertices = static_cast<std::uint32_t>(content.part.mesh.vertex_count());
    entry.triangles = static_cast<std::uint32_t>(content.part.mesh.triangle_count());
    parts.push_back({std::move(entry), content.octets});
  }
  return parts;
}

Result<void> MapReceiver::restore(const PartEntry& entry, std::span<const std::byte> octets) noexcept {
  return guarded([&]() -> Result<void> {
    if (!state_->codec) return invalid_argument("the map's message has not come yet", "MAP-5");
    DELTAMESH_CHECK(check_links(entry.key, entry.links));
    if (!state_->is_new(entry.key, entry.revision)) return {};
    return state_->take(entry.key, {entry.revision, entry.group, entry.links, nullptr}, octets);
  });
}

}  // namespace deltamesh
