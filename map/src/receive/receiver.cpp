// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/receiver.h"

#include <xxhash.h>

#include <algorithm>
#include <utility>

#include "base/byte_writer.h"
#include "base/guard.h"
#include "base/try.h"
#include "message/entry_fields.h"
#include "message/frame.h"
#include "part/view_cells.h"
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
    DELTAMESH_TRY(const MessageKind kind, kind_of_message(message));
    switch (kind) {
      case MessageKind::kMap:
        return state_->apply_description(message);
      case MessageKind::kStart:
        return state_->apply_start(message);
      case MessageKind::kEntry:
        return state_->apply_entry(message);
      case MessageKind::kPart:
        return state_->apply_part(message);
      case MessageKind::kPatch:
        return state_->apply_patch(message);
      default:
        return invalid_argument("not a message for receivers", "MAP-1");
    }
  });
}

void MapReceiver::set_view(const View& view) {
  state_->view = view;
  if (state_->codec) state_->settle();
}
const View& MapReceiver::view() const noexcept { return state_->view; }

Result<std::vector<std::byte>> MapReceiver::view_message() noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    ViewMessage message{.viewer = state_->viewer,
                        .number = ++state_->number,
                        .map_id = state_->map_id,
                        .map = state_->codec ? state_->map : 0,
                        .start = state_->start,
                        .view = state_->view,
                        .held = {}};
    for (const auto& [key, part] : state_->parts.all()) {
      const auto& version = part.next && part.next->content ? part.next : part.shown;
      if (!version) continue;
      message.held.push_back({key, version->revision, version_hash(version->content->hash, version->links),
                              part.next.has_value()});
    }
    return write_view(message);
  });
}

const MapDescription* MapReceiver::description() const noexcept {
  return state_->codec ? &state_->codec->description() : nullptr;
}

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

std::uint64_t MapReceiver::hash() const {
  ByteWriter out;
  for (const auto& [key, part] : state_->parts.all()) {
    if (!part.shown) continue;
    write_key(out, key);
    out.write(part.shown->content->hash);
  }
  return XXH3_64bits(out.bytes().data(), out.size());
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
