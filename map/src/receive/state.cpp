// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "receive/state.h"

#include <xxhash.h>

#include <algorithm>
#include <utility>

#include "base/try.h"
#include "message/frame.h"
#include "part/view_cells.h"
#include "patch/container.h"
#include "patch/part_or_patch.h"

namespace deltamesh {
namespace {

std::shared_ptr<const PartContent> content_of(std::vector<std::byte> octets, MapPart part) {
  const std::uint64_t hash = XXH3_64bits(octets.data(), octets.size());
  return std::make_shared<const PartContent>(PartContent{std::move(octets), hash, std::move(part)});
}

}  // namespace

Result<void> MapReceiver::State::check_map(std::uint64_t hash) const {
  if (!codec) return invalid_argument("the map's message has not come yet", "MAP-5");
  if (hash != map) return invalid_argument("a message of another map or epoch", "MAP-5");
  return {};
}

Result<void> MapReceiver::State::apply(std::span<const std::byte> message) {
  DELTAMESH_TRY(const MessageKind kind, kind_of_message(message));
  switch (kind) {
    case MessageKind::kMap:
      return apply_description(message);
    case MessageKind::kStart:
      return apply_start(message);
    case MessageKind::kEntry:
      return apply_entry(message);
    case MessageKind::kPart:
      return apply_part(message);
    case MessageKind::kPatch:
      return apply_patch(message);
    case MessageKind::kFault:
      return apply_fault(message);
    case MessageKind::kPose:
      return apply_pose(message);
    case MessageKind::kFragment: {
      DELTAMESH_TRY(const auto whole, fragments.add(message));
      if (!whole) return {};
      DELTAMESH_TRY(const MessageKind inner, kind_of_message(*whole));
      if (inner == MessageKind::kFragment) return invalid_argument("fragments of a fragment", "MAP-25");
      return apply(*whole);
    }
    default:
      return invalid_argument("not a message for receivers", "MAP-1");
  }
}

/// What earlier senders said may not go with what this one says.
Result<void> MapReceiver::State::apply_start(std::span<const std::byte> message) {
  DELTAMESH_TRY(const StartMessage told, read_start(message));
  DELTAMESH_CHECK(check_map(told.map));
  if (told.start > start) {
    start = told.start;
    forget_arrivals();
  }
  (void)is_mine(told.start, told.number);
  return {};
}

/// Newer than all that is known of the part.
bool MapReceiver::State::is_new(const PartKey& key, std::uint64_t revision) const {
  const ReceivedPart* part = parts.find(key);
  return part == nullptr || revision > part->newest ||
         (revision == 0 && !part->shown && part->waiting.empty());
}

/// New, or what messages are made from that came early.
bool MapReceiver::State::is_of_use(const PartKey& key, std::uint64_t revision) const {
  return is_new(key, revision) || early.need(key);
}

bool MapReceiver::State::is_mine(std::uint64_t of_start, std::uint64_t message_number) {
  if (of_start != start) return false;
  if (message_number != 0) talk.came(arrivals.add(message_number));
  return true;
}

/// Numbers begin anew.
void MapReceiver::State::forget_arrivals() {
  arrivals = {};
  early.clear();
  faults.clear();
  talk.want_view();
}

void MapReceiver::State::settle() {
  parts.settle([this](const PartKey& key) { return is_in_view(key, view, codec->description()); }, touched);
}

Result<void> MapReceiver::State::apply_description(std::span<const std::byte> message) {
  DELTAMESH_TRY(auto description, read_description(message));
  if (description.id != map_id) return invalid_argument("another map", "MAP-5");
  const std::uint64_t hash = hash_of(description);
  if (codec && (description.epoch < codec->description().epoch || hash == map)) return {};
  const bool is_same_lattice = codec && codec->description().lattice == description.lattice &&
                               codec->description().cell_steps == description.cell_steps &&
                               codec->description().attributes == description.attributes;
  DELTAMESH_TRY(auto opened, MapCodec::open(std::move(description)));
  if (codec && !is_same_lattice) {
    for (const auto& [key, part] : parts.all())
      if (part.shown) touched.insert(key);
    parts = {};
  }
  announced.clear();
  codec = std::move(opened);
  map = hash;
  talk.want_view();
  return {};
}

Result<void> MapReceiver::State::take(const PartKey& key, Version version,
                                      std::span<const std::byte> octets) {
  version.content = parts.content(key, XXH3_64bits(octets.data(), octets.size()));
  if (!version.content) {
    DELTAMESH_TRY(const DecodeOptions options, options_for(key, octets.size()));
    DELTAMESH_TRY(MapPart part, codec->decode(key, octets, options));
    version.content = content_of({octets.begin(), octets.end()}, std::move(part));
  }
  take(key, std::move(version));
  return {};
}

/// A version with its content.
void MapReceiver::State::take(const PartKey& key, Version version) {
  const std::uint64_t revision = version.revision;
  came.push_back(version.content);
  if (!is_new(key, revision)) return parts.remember(std::move(version.content));
  parts.put(key, std::move(version));
  if (const auto told = announced.find(key); told != announced.end() && told->second <= revision)
    announced.erase(told);
  settle();
}

Result<void> MapReceiver::State::apply_part(std::span<const std::byte> message) {
  DELTAMESH_TRY(PartMessage part, read_part(message));
  DELTAMESH_CHECK(check_map(part.map));
  if (!is_mine(part.start, part.number) || !is_of_use(part.key, part.revision)) return {};
  return take(part.key, {part.revision, part.group, std::move(part.links), nullptr}, part.octets);
}

/// Null: it has not come, or is gone.
std::shared_ptr<const PartContent> MapReceiver::State::find_base(const PatchMessage& patch) const {
  const PartPlace place = codec->state().place_of(patch.part.key);
  return parts.content(patch.base_key,
                       [&](std::uint64_t hash) { return open_body(place, hash, patch.body).has_value(); });
}

bool MapReceiver::State::is_made_from(const EarlyMessage& message, const PartContent& content) const {
  if (content.part.key != message.base) return false;
  if (message.octets) return content.hash == *message.octets;
  const auto patch = read_patch(message.bytes);
  return patch && open_body(codec->state().place_of(patch->part.key), content.hash, patch->body);
}

Result<void> MapReceiver::State::apply_early() {
  Result<void> outcome;
  while (!came.empty()) {
    const auto content = std::move(came.back());
    came.pop_back();
    const auto waits = [&](const EarlyMessage& message) { return is_made_from(message, *content); };
    while (const auto message = early.take(waits)) {
      auto applied = apply(*message);
      if (outcome && !applied) outcome = applied.error();
    }
  }
  return outcome;
}

/// Without the version that the patch is for it is kept until that comes.
Result<void> MapReceiver::State::apply_patch(std::span<const std::byte> message) {
  DELTAMESH_TRY(PatchMessage patch, read_patch(message));
  DELTAMESH_CHECK(check_map(patch.part.map));
  const PartKey& key = patch.part.key;
  if (!is_mine(patch.part.start, patch.part.number) || !is_of_use(key, patch.part.revision)) return {};
  const auto base = find_base(patch);
  if (base == nullptr) {
    if (patch.part.number != 0)
      early.keep(patch.part.number, {patch.base_key, std::nullopt, {message.begin(), message.end()}});
    return {};
  }
  std::vector<std::byte> octets = join_patched({patch.base_key, base->octets, patch.body});
  if (octets.size() > kMostPartBytes || count_patches(octets) > kMostPatches)
    return Error{.code = ErrorCode::kInvalidStream, .message = "too many patches", .rule = "MAP-17"};
  DELTAMESH_TRY(const DecodeOptions options, options_for(key, octets.size()));
  DELTAMESH_TRY(MapPart part,
                deltamesh::apply_patch(codec->state(), key, base->part, base->hash, patch.body, options));
  take(key, {patch.part.revision, patch.part.group, std::move(patch.part.links),
             content_of(std::move(octets), std::move(part))});
  return {};
}

Result<void> MapReceiver::State::apply_entry(std::span<const std::byte> message) {
  if (!codec) return invalid_argument("the map's message has not come yet", "MAP-5");
  DELTAMESH_TRY(EntryMessage told, read_entry(message, codec->description().attributes.size()));
  DELTAMESH_CHECK(check_map(told.map));
  PartEntry& entry = told.entry;
  if (!is_mine(told.start, told.number) || !is_new(entry.key, entry.revision)) return {};
  if (!entry.links.empty() && !has_room_for_links()) return beyond_limits();
  Version version{entry.revision, entry.group, std::move(entry.links), nullptr};
  if (entry.bytes != 0) {
    version.content = parts.content(entry.key, entry.hash);
    if (!version.content) {
      if (announced.size() >= limits.parts) return beyond_limits();
      std::uint64_t& revision = announced[entry.key];
      revision = std::max(revision, entry.revision);
      if (told.number != 0)
        early.keep(told.number, {entry.key, entry.hash, {message.begin(), message.end()}});
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

Result<void> MapReceiver::State::apply_fault(std::span<const std::byte> message) {
  DELTAMESH_TRY(const FaultMessage told, read_fault(message));
  DELTAMESH_CHECK(check_map(told.map));
  if (!is_mine(told.start, told.number)) return {};
  constexpr std::size_t kMostFaults = std::size_t{1} << 16;
  if (faults.size() >= kMostFaults && !faults.contains(told.key)) {
    std::erase_if(faults, [](const auto& f) { return f.second.code == 0; });
    if (faults.size() >= kMostFaults) return {};
  }
  ToldFault& fault = faults[told.key];
  if (told.number >= fault.number) fault = {told.number, told.code};
  return {};
}

Result<void> MapReceiver::State::apply_pose(std::span<const std::byte> message) {
  DELTAMESH_TRY(const PoseMessage told, read_pose(message));
  DELTAMESH_CHECK(check_map(told.map));
  if (!is_mine(told.start, told.number)) return {};
  if (!pose || pose->start != told.start || pose->number <= told.number) pose = told;
  return {};
}

}  // namespace deltamesh
