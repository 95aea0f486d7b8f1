// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/receiver.h"

#include <xxhash.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/byte_writer.h"
#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/map_codec.h"
#include "entry_fields.h"
#include "message_frame.h"
#include "received_parts.h"
#include "view_cells.h"

namespace deltamesh {

struct MapReceiver::State {
  std::uint64_t viewer = 0;
  std::uint64_t map_id = 0;
  ReceiverLimits limits{};
  View view{};
  std::uint64_t number = 0;
  std::optional<MapCodec> codec{};
  std::uint64_t map = 0;  ///< hash of the codec's description
  ReceivedParts parts{};
  std::uint64_t start = 0;                       ///< of the sender
  std::map<PartKey, std::uint64_t> announced{};  ///< revisions of entries without octets
  std::set<PartKey> touched{};                   ///< since the last take_change()

  Result<void> apply_description(std::span<const std::byte> message);
  Result<void> apply_start(std::span<const std::byte> message);
  Result<void> apply_entry(std::span<const std::byte> message);
  Result<void> apply_part(std::span<const std::byte> message);
  Result<void> take(const PartKey& key, Version version, std::span<const std::byte> octets);
  Result<std::shared_ptr<const PartContent>> decode(const PartKey& key, std::span<const std::byte> octets);
  std::shared_ptr<const PartContent> known_content(const PartKey& key, std::uint64_t hash) const;
  Result<void> check_map(std::uint64_t hash) const;
  bool is_new(const PartKey& key, std::uint64_t revision) const;
  void settle();
};

namespace {

constexpr std::size_t kLinksPerPart = 64;  // on average, at the most

Error refused(const char* message, const char* rule) {
  return {.code = ErrorCode::kInvalidArgument, .message = message, .rule = rule};
}

/// All that counts for limits.
struct Sums {
  std::size_t parts = 0;
  std::uint64_t octets = 0;
  std::uint64_t vertices = 0;
  std::size_t links = 0;

  void add(const std::optional<Version>& version) {
    if (!version) return;
    links += version->links.size();
    if (!version->content) return;
    octets += version->content->octets.size();
    vertices += version->content->part.mesh.vertex_count();
  }
};

Sums sums_of(const ReceivedParts& parts) {
  Sums sums;
  for (const auto& [key, part] : parts.all()) {
    if (part.shown || part.next) ++sums.parts;
    sums.add(part.shown);
    sums.add(part.next);
  }
  return sums;
}

}  // namespace

Result<void> MapReceiver::State::check_map(std::uint64_t hash) const {
  if (!codec) return refused("the map's message has not come yet", "MAP-5");
  if (hash != map) return refused("a message of another map or epoch", "MAP-5");
  return {};
}

/// What earlier senders said may not go with what this one says.
Result<void> MapReceiver::State::apply_start(std::span<const std::byte> message) {
  DELTAMESH_TRY(const StartMessage told, read_start(message));
  DELTAMESH_CHECK(check_map(told.map));
  start = std::max(start, told.start);
  return {};
}

/// Newer than all that is known of the part.
bool MapReceiver::State::is_new(const PartKey& key, std::uint64_t revision) const {
  const ReceivedPart* part = parts.find(key);
  return part == nullptr || revision > part->newest || (revision == 0 && !part->shown && !part->next);
}

void MapReceiver::State::settle() {
  parts.settle([this](const PartKey& key) { return is_in_view(key, view, codec->description()); }, touched);
}

Result<void> MapReceiver::State::apply_description(std::span<const std::byte> message) {
  DELTAMESH_TRY(auto description, read_description(message));
  if (description.id != map_id) return refused("another map", "MAP-5");
  if (codec && description.epoch <= codec->description().epoch) return {};
  const bool is_same_lattice = codec && codec->description().lattice == description.lattice &&
                               codec->description().cell_steps == description.cell_steps &&
                               codec->description().attributes == description.attributes;
  const std::uint64_t hash = hash_of(description);
  DELTAMESH_TRY(auto opened, MapCodec::open(std::move(description)));
  if (codec && !is_same_lattice) {
    for (const auto& [key, part] : parts.all())
      if (part.shown) touched.insert(key);
    parts = {};
  }
  announced.clear();
  codec = std::move(opened);
  map = hash;
  return {};
}

std::shared_ptr<const PartContent> MapReceiver::State::known_content(const PartKey& key,
                                                                     std::uint64_t hash) const {
  const ReceivedPart* part = parts.find(key);
  if (part == nullptr) return nullptr;
  for (const auto* version : {&part->next, &part->shown})
    if (*version && (*version)->content && (*version)->content->hash == hash) return (*version)->content;
  return nullptr;
}

Result<std::shared_ptr<const PartContent>> MapReceiver::State::decode(const PartKey& key,
                                                                      std::span<const std::byte> octets) {
  const Sums sums = sums_of(parts);
  const ReceivedPart* part = parts.find(key);
  const bool is_held = part != nullptr && (part->shown || part->next);
  if ((!is_held && sums.parts >= limits.parts) || sums.octets + octets.size() > limits.octets ||
      sums.vertices >= limits.vertices || sums.links > kLinksPerPart * limits.parts)
    return Error{.code = ErrorCode::kLimitExceeded, .message = "more parts than the receiver may hold"};
  auto content = std::make_shared<PartContent>();
  DecodeOptions options;
  options.limits.vertices = std::min(limits.vertices - sums.vertices, options.limits.vertices);
  DELTAMESH_TRY(content->part, codec->decode(key, octets, options));
  content->octets.assign(octets.begin(), octets.end());
  content->hash = XXH3_64bits(octets.data(), octets.size());
  return std::shared_ptr<const PartContent>(std::move(content));
}

Result<void> MapReceiver::State::take(const PartKey& key, Version version,
                                      std::span<const std::byte> octets) {
  version.content = known_content(key, XXH3_64bits(octets.data(), octets.size()));
  if (!version.content) {
    DELTAMESH_TRY(version.content, decode(key, octets));
  }
  const std::uint64_t revision = version.revision;
  parts.put(key, std::move(version));
  if (const auto told = announced.find(key); told != announced.end() && told->second <= revision)
    announced.erase(told);
  settle();
  return {};
}

Result<void> MapReceiver::State::apply_part(std::span<const std::byte> message) {
  DELTAMESH_TRY(PartMessage part, read_part(message));
  DELTAMESH_CHECK(check_map(part.map));
  if (part.start != start || !is_new(part.key, part.revision)) return {};
  return take(part.key, {part.revision, part.group, std::move(part.links), nullptr}, part.octets);
}

Result<void> MapReceiver::State::apply_entry(std::span<const std::byte> message) {
  if (!codec) return refused("the map's message has not come yet", "MAP-5");
  DELTAMESH_TRY(EntryMessage told, read_entry(message, codec->description().attributes.size()));
  DELTAMESH_CHECK(check_map(told.map));
  PartEntry& entry = told.entry;
  if (told.start != start || !is_new(entry.key, entry.revision)) return {};
  Version version{entry.revision, entry.group, std::move(entry.links), nullptr};
  if (entry.bytes != 0) {
    version.content = known_content(entry.key, entry.hash);
    if (!version.content) {
      if (announced.size() >= limits.parts)
        return Error{.code = ErrorCode::kLimitExceeded, .message = "more parts than the receiver may hold"};
      std::uint64_t& revision = announced[entry.key];
      revision = std::max(revision, entry.revision);
      return {};
    }
  }
  const ReceivedPart* known = parts.find(entry.key);
  if (entry.bytes == 0 && (known == nullptr || !known->shown)) {
    parts.forget(entry.key, entry.revision);
  } else {
    parts.put(entry.key, std::move(version));
  }
  if (const auto found = announced.find(entry.key);
      found != announced.end() && found->second <= entry.revision)
    announced.erase(found);
  settle();
  parts.limit_removals(limits.parts);
  return {};
}

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
      default:
        return refused("not a message for receivers", "MAP-1");
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
    if (!state_->codec) return refused("the map's message has not come yet", "MAP-5");
    DELTAMESH_CHECK(check_links(entry.key, entry.links));
    if (!state_->is_new(entry.key, entry.revision)) return {};
    return state_->take(entry.key, {entry.revision, entry.group, entry.links, nullptr}, octets);
  });
}

}  // namespace deltamesh
