// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/sender.h"

#include <algorithm>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "message/entry_fields.h"
#include "send/state.h"
#include "support/errors.h"

namespace deltamesh {

namespace {

constexpr double kMostWait = 4;            // seconds; for a reply to the map's message
constexpr std::size_t kPartsAtOnce = 256;  // of which an update forgets versions

Result<void> check_options(const SenderOptions& options) {
  if (options.effort < 0 || options.effort > 2) return invalid_argument("an effort out of 0 to 2");
  if (!(options.viewer_seconds > 0))
    return invalid_argument("a time to forget viewers after that is not above 0");
  if (options.message_bytes != 0 && options.message_bytes < kLeastFragment)
    return invalid_argument("a largest message of less than 64 bytes");
  if (!(options.call_seconds > 0)) return invalid_argument("a time for a call that is not above 0");
  return {};
}

}  // namespace

MapSender::MapSender(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
MapSender::MapSender(MapSender&&) noexcept = default;
MapSender& MapSender::operator=(MapSender&&) noexcept = default;
MapSender::~MapSender() = default;

Result<MapSender> MapSender::make(MapDescription description, const SenderOptions& options) noexcept {
  return guarded([&]() -> Result<MapSender> {
    DELTAMESH_CHECK(check_options(options));
    DELTAMESH_TRY(Splitter splitter, Splitter::make(description, options.split));
    const std::uint64_t hash = hash_of(description);
    DELTAMESH_TRY(MapCodec codec, MapCodec::open(std::move(description)));
    auto state = std::make_unique<State>(SourceMap(std::move(splitter), options.split.copy_level),
                                         std::move(codec), options);
    state->description_hash = hash;
    state->start = 1;
    return MapSender(std::move(state));
  });
}

void MapSender::resume(std::uint64_t revision, std::uint64_t group) noexcept {
  state_->map.resume(revision, group);
  state_->start = state_->map.revision();
}

Result<void> MapSender::update(std::span<const MapBlock> blocks) noexcept {
  return guarded([&]() -> Result<void> {
    DELTAMESH_TRY(const std::vector<PartKey> gone, state_->map.update(blocks));
    for (const PartKey& key : gone) state_->encodings.forget(key);
    state_->forget_versions(kPartsAtOnce + 2 * blocks.size());
    if (state_->colors.is_known()) return {};
    for (const MapBlock& block : blocks) DELTAMESH_CHECK(state_->colors.add(block.mesh));
    return {};
  });
}

Result<void> MapSender::hear(std::span<const std::byte> message, double now) noexcept {
  return guarded([&] { return state_->hear(message, state_->clock.at(now)); });
}

void MapSender::forget(std::uint64_t viewer) noexcept { state_->viewers.erase(viewer); }

std::vector<std::uint64_t> MapSender::viewers() const {
  std::vector<std::uint64_t> numbers;
  for (const auto& [number, viewer] : state_->viewers) numbers.push_back(number);
  return numbers;
}

Result<std::vector<std::vector<std::byte>>> MapSender::messages_for(std::uint64_t number,
                                                                    double now) noexcept {
  now = state_->clock.at(now);
  return guarded([&]() -> Result<std::vector<std::vector<std::byte>>> {
    const auto found = state_->viewers.find(number);
    if (found == state_->viewers.end()) return invalid_argument("a viewer that has not been heard");
    Viewer& viewer = found->second;
    std::vector<std::vector<std::byte>> messages;
    state_->begin_call(viewer, now);
    const std::uint64_t encoded = state_->encodings.encoded();
    const auto added = state_->add_messages(viewer, now, messages);
    state_->forget_versions(2 * (state_->encodings.encoded() - encoded));
    std::vector<std::vector<std::byte>> pieces;
    for (auto& message : messages) {
      const std::size_t size = message.size();
      DELTAMESH_TRY(auto cut, cut_message(std::move(message), state_->options.message_bytes));
      std::size_t sum = 0;
      for (auto& piece : cut) {
        sum += piece.size();
        pieces.push_back(std::move(piece));
      }
      viewer.allowance.spend(sum - size);
      state_->total.spend(sum);
    }
    DELTAMESH_CHECK(added);
    if (now - viewer.heard > state_->options.viewer_seconds) state_->viewers.erase(found);
    return pieces;
  });
}

Result<void> MapSender::State::add_messages(Viewer& viewer, double now,
                                            std::vector<std::vector<std::byte>>& messages) {
  if (viewer.map != description_hash || viewer.start != viewer.begin) {
    if (now < viewer.describe_next || !viewer.allowance.may_spend()) return {};
    viewer.describe_next = now + viewer.describe_wait;
    viewer.describe_wait = std::min(2 * viewer.describe_wait, kMostWait);
    if (viewer.map != description_hash) {
      DELTAMESH_TRY(messages.emplace_back(), write_description(encodings.codec().description()));
      viewer.allowance.spend(messages.back().size());
    }
    DELTAMESH_TRY(messages.emplace_back(), write_start({.map = description_hash, .start = viewer.begin}));
    return {};
  }
  viewer.describe_next = 0;
  viewer.describe_wait = kDescribeWait;
  if (viewer.delivery.is_silent(now)) return {};
  recover(viewer, now, messages);
  viewer.allowance.limit(viewer.delivery.room(now));
  DELTAMESH_CHECK(tell_pose(viewer, now, messages));
  viewer.send_made(now, messages);
  if (viewer.delivery.has_unsent()) return {};
  DELTAMESH_CHECK(send_what_is_due(viewer, now, messages));
  return tell_end(viewer, now, messages);
}

std::vector<PartFault> MapSender::faults_of(std::uint64_t number) const {
  const auto viewer = state_->viewers.find(number);
  return viewer == state_->viewers.end() ? std::vector<PartFault>() : viewer->second.faults;
}

std::vector<PartEntry> MapSender::entries_of(std::uint64_t number) const {
  std::vector<PartEntry> entries;
  const auto viewer = state_->viewers.find(number);
  if (viewer == state_->viewers.end()) return entries;
  for (const auto& [key, believed] : viewer->second.has) {
    if (believed.is_gone) continue;
    const KnownVersion* version = find_version(state_->known, key, believed.version);
    PartEntry entry{.key = key, .revision = believed.revision};
    if (version != nullptr) {
      entry.links = version->links;
      entry.hash = version->encoding->hash;
      entry.bytes = static_cast<std::uint32_t>(version->encoding->octets.size());
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::uint64_t MapSender::hash(std::uint64_t viewer) const {
  std::vector<std::pair<PartKey, std::uint64_t>> shown;
  for (const PartEntry& entry : entries_of(viewer)) shown.emplace_back(entry.key, entry.hash);
  return hash_of_shown(shown);
}

const MapDescription& MapSender::description() const noexcept {
  return state_->encodings.codec().description();
}
std::uint64_t MapSender::revision() const noexcept { return state_->map.revision(); }
std::uint64_t MapSender::next_group() const noexcept { return state_->map.next_group(); }
SenderCounts MapSender::counts() const noexcept {
  SenderCounts counts = state_->counts;
  counts.encoded = state_->encodings.encoded();
  return counts;
}
const MapPart* MapSender::source(const PartKey& key) const noexcept {
  const SourcePart* part = state_->map.find(key);
  return part == nullptr ? nullptr : &part->part;
}
std::vector<PartKey> MapSender::keys() const {
  std::vector<PartKey> keys;
  for (const auto& [key, part] : state_->map.parts()) keys.push_back(key);
  return keys;
}

}  // namespace deltamesh
