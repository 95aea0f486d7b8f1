// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/sender.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "send/coexistence.h"
#include "send/state.h"

namespace deltamesh {

namespace {

constexpr double kLongestOnTheWay = 60;  // seconds: what a link holds for longer is taken to be lost
constexpr double kLeastSavings = 65536;  // bytes: a part is never too large to be sent

Error refused(ErrorCode code, const char* message) { return {.code = code, .message = message}; }

Result<void> check_options(const SenderOptions& options) {
  if (options.effort < 0 || options.effort > 2)
    return refused(ErrorCode::kInvalidArgument, "an effort out of 0 to 2");
  if (!(options.resend_seconds > 0) || !std::isfinite(options.resend_seconds))
    return refused(ErrorCode::kInvalidArgument, "a time to send again that is not above 0");
  return {};
}

/// What the receiver says it has takes the place of what was believed, but for what may be on its way.
void take_held(Viewer& viewer, const std::vector<HeldVersion>& held, double on_its_way_since) {
  const std::map<PartKey, Believed> before = viewer.has;
  std::erase_if(viewer.has, [&](const auto& entry) { return entry.second.sent < on_its_way_since; });
  for (const HeldVersion& version : held) {
    SentPart& sent = viewer.sent[version.key];
    if (sent.revision == 0) sent = {.revision = version.revision, .is_everywhere = true};
    Believed& believed = viewer.has[version.key];
    const bool is_on_its_way = std::isfinite(believed.sent);
    if (is_on_its_way && believed.revision > version.revision) continue;
    if (is_on_its_way && believed.is_gone && believed.revision == version.revision) continue;
    const auto known = before.find(version.key);
    const bool is_the_same = known != before.end() && !known->second.is_gone &&
                             known->second.version == version.version &&
                             known->second.since <= version.revision;
    believed = {.revision = version.revision,
                .since = is_the_same ? known->second.since : version.revision,
                .version = version.version,
                .is_waiting = version.is_waiting};
  }
}

/// Drops the records of parts that the map and the receiver no longer have, once no message about them can be
/// on its way. A later part of the same key has a higher revision, so that it needs no record.
void forget_gone_parts(Viewer& viewer, const SourceMap& map, double now) {
  std::erase_if(viewer.sent, [&](const auto& entry) {
    const auto& [key, sent] = entry;
    return map.find(key) == nullptr && !viewer.has.contains(key) && sent.revision < map.revision() &&
           now - sent.time > kLongestOnTheWay;
  });
}

void save_up(Viewer& viewer, double now) {
  const double rate = viewer.view.bytes_per_second;
  const double most = std::max(rate, kLeastSavings);
  const double passed = std::isfinite(viewer.asked) ? std::max(now - viewer.asked, 0.0) : 1;
  viewer.allowance = std::min(viewer.allowance + rate * passed, most);
  viewer.asked = now;
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
    auto state = std::make_unique<State>(SourceMap(std::move(splitter)), std::move(codec), options);
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
    DELTAMESH_CHECK(state_->map.update(blocks));
    state_->forget_versions();
    return {};
  });
}

Result<void> MapSender::hear(std::span<const std::byte> view_message, double now) noexcept {
  return guarded([&]() -> Result<void> {
    DELTAMESH_TRY(const ViewMessage message, read_view(view_message));
    const MapDescription& of = description();
    if (message.map_id != of.id) return refused(ErrorCode::kInvalidArgument, "a view of another map");
    const double least = std::sqrt(3.0) / 2 * of.lattice.step();
    if (message.view.max_error && *message.view.max_error < least) {
      Error error = refused(ErrorCode::kUnmetRequest, "a largest error below half a lattice cell's diagonal");
      error.best_value = least;
      return error;
    }
    const auto known = state_->viewers.find(message.viewer);
    if (known == state_->viewers.end() && state_->viewers.size() >= state_->options.most_viewers)
      return refused(ErrorCode::kLimitExceeded, "too many viewers");
    Viewer& viewer = state_->viewers[message.viewer];
    if (message.number <= viewer.number && known != state_->viewers.end()) return {};
    viewer.number = message.number;
    viewer.view = message.view;
    viewer.map = message.map;
    viewer.start = message.start;
    take_held(viewer, message.held, now - state_->options.resend_seconds);
    forget_gone_parts(viewer, state_->map, now);
    return {};
  });
}

void MapSender::forget(std::uint64_t viewer) noexcept { state_->viewers.erase(viewer); }

std::vector<std::uint64_t> MapSender::viewers() const {
  std::vector<std::uint64_t> numbers;
  for (const auto& [number, viewer] : state_->viewers) numbers.push_back(number);
  return numbers;
}

Result<std::vector<std::vector<std::byte>>> MapSender::messages_for(std::uint64_t number,
                                                                    double now) noexcept {
  return guarded([&]() -> Result<std::vector<std::vector<std::byte>>> {
    const auto found = state_->viewers.find(number);
    if (found == state_->viewers.end())
      return refused(ErrorCode::kInvalidArgument, "a viewer that has not been heard");
    Viewer& viewer = found->second;
    std::vector<std::vector<std::byte>> messages;
    save_up(viewer, now);
    if (viewer.map != state_->description_hash || viewer.start != state_->start) {
      if (now - viewer.described < state_->options.resend_seconds) return messages;
      viewer.described = now;
      if (viewer.map != state_->description_hash) {
        DELTAMESH_TRY(messages.emplace_back(), write_description(description()));
        viewer.allowance -= static_cast<double>(messages.back().size());
      }
      DELTAMESH_TRY(messages.emplace_back(),
                    write_start({.map = state_->description_hash, .start = state_->start}));
      return messages;
    }
    DELTAMESH_TRY(SendPlan plan,
                  plan_for(viewer, now - state_->options.resend_seconds, state_->map, state_->encodings,
                           state_->known, state_->options.keeps_good_enough));
    state_->counts.kept += plan.kept;
    for (const PartKey& key : plan.needed) viewer.due.try_emplace(key, state_->map.revision());
    std::erase_if(viewer.due, [&](const auto& entry) { return !plan.needed.contains(entry.first); });
    for (const SendUnit& unit : units_of(plan, viewer, state_->map, state_->known, description())) {
      if (viewer.view.bytes_per_second != 0 && viewer.allowance <= 0) break;
      DELTAMESH_CHECK(state_->send(unit, plan, viewer, now, messages));
    }
    return messages;
  });
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
