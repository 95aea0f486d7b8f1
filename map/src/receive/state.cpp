// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "receive/state.h"

#include <xxhash.h>

#include <algorithm>
#include <utility>

#include "base/try.h"
#include "message/entry_fields.h"
#include "message/frame.h"
#include "part/view_cells.h"
#include "patch/container.h"
#include "patch/part_or_patch.h"

namespace deltamesh {
namespace {

constexpr std::size_t kLinksPerPart = 64;  // on average, at the most

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
  if (description.id != map_id) return invalid_argument("another map", "MAP-5");
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

/// For one more part of so many octets. Errors: kLimitExceeded.
Result<DecodeOptions> MapReceiver::State::options_for(const PartKey& key, std::size_t octets) const {
  const Sums sums = sums_of(parts);
  const ReceivedPart* part = parts.find(key);
  const bool is_held = part != nullptr && (part->shown || part->next);
  if ((!is_held && sums.parts >= limits.parts) || sums.octets + octets > limits.octets ||
      sums.vertices >= limits.vertices || sums.links > kLinksPerPart * limits.parts)
    return Error{.code = ErrorCode::kLimitExceeded, .message = "more parts than the receiver may hold"};
  DecodeOptions options;
  options.limits.vertices = std::min(limits.vertices - sums.vertices, options.limits.vertices);
  return options;
}

Result<void> MapReceiver::State::take(const PartKey& key, Version version,
                                      std::span<const std::byte> octets) {
  version.content = known_content(key, XXH3_64bits(octets.data(), octets.size()));
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
  parts.put(key, std::move(version));
  if (const auto told = announced.find(key); told != announced.end() && told->second <= revision)
    announced.erase(told);
  settle();
}

Result<void> MapReceiver::State::apply_part(std::span<const std::byte> message) {
  DELTAMESH_TRY(PartMessage part, read_part(message));
  DELTAMESH_CHECK(check_map(part.map));
  if (part.start != start || !is_new(part.key, part.revision)) return {};
  return take(part.key, {part.revision, part.group, std::move(part.links), nullptr}, part.octets);
}

/// Without the version that the patch is for it has no effect: the sender hears that it has not come.
Result<void> MapReceiver::State::apply_patch(std::span<const std::byte> message) {
  DELTAMESH_TRY(PatchMessage patch, read_patch(message));
  DELTAMESH_CHECK(check_map(patch.part.map));
  const PartKey& key = patch.part.key;
  if (patch.part.start != start || !is_new(key, patch.part.revision)) return {};
  const auto base = known_content(patch.base_key, patch.base);
  if (base == nullptr) return {};
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

}  // namespace deltamesh
