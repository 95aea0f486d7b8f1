// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Exports of `map` for maps that change: one receiver an instance. Outcomes live until the next call.
#include "deltamesh/map/receiver.h"

#include <optional>
#include <vector>

#include "map_outcome.h"
#include "mesh_outcome.h"
#include "runtime.h"

namespace deltamesh::web {
namespace {

/// Of a page, whose memory ends before 4 GiB do.
constexpr ReceiverLimits kLimits{.octets = std::uint64_t{1} << 27, .vertices = std::uint64_t{1} << 24};

std::optional<MapReceiver> receiver;
ErrorOutcome error;
std::vector<std::vector<std::byte>> messages;
std::vector<MessageOutcome> message_outcomes;
MessagesOutcome messages_outcome;
std::vector<KeyOutcome> changed;
std::vector<KeyOutcome> removed;
ChangeOutcome change_outcome;
std::optional<MeshOutcome> found;

std::uint64_t wide(std::uint32_t low, std::uint32_t high) noexcept { return std::uint64_t{high} << 32 | low; }

std::vector<KeyOutcome> outcomes_of(const std::vector<PartKey>& keys) {
  std::vector<KeyOutcome> outcomes;
  for (const PartKey& key : keys) outcomes.push_back({.level = key.level, .cell = {key.x, key.y, key.z}});
  return outcomes;
}

}  // namespace

extern "C" {

/// Of the map with that id, by a number that no other viewer has.
DELTAMESH_EXPORT(openReceiver)
void open_receiver(std::uint32_t viewer_low, std::uint32_t viewer_high, std::uint32_t map_low,
                   std::uint32_t map_high) {
  receiver.emplace(wide(viewer_low, viewer_high), wide(map_low, map_high), kLimits);
}

DELTAMESH_EXPORT(applyMessage) ErrorOutcome* apply_message(const std::byte* octets, std::size_t bytes) {
  const auto done = receiver->apply({octets, bytes});
  error = done ? ErrorOutcome{} : outcome_of(done.error());
  return &error;
}

/// What is to be sent to the sender; `now`: seconds.
DELTAMESH_EXPORT(messagesToSend) MessagesOutcome* messages_to_send(double now) {
  messages_outcome = {};
  auto made = receiver->messages(now);
  if (!made) {
    messages_outcome.error = outcome_of(made.error());
    return &messages_outcome;
  }
  messages = *std::move(made);
  message_outcomes.clear();
  for (const auto& message : messages)
    message_outcomes.push_back(
        {.bytes = static_cast<std::uint32_t>(message.size()), .octets = message.data()});
  messages_outcome.count = static_cast<std::uint32_t>(message_outcomes.size());
  messages_outcome.messages = message_outcomes.data();
  return &messages_outcome;
}

DELTAMESH_EXPORT(takeChange) ChangeOutcome* take_change() {
  const ShownChange change = receiver->take_change();
  changed = outcomes_of(change.changed);
  removed = outcomes_of(change.removed);
  change_outcome = {.changed_count = static_cast<std::uint32_t>(changed.size()),
                    .changed = changed.data(),
                    .removed_count = static_cast<std::uint32_t>(removed.size()),
                    .removed = removed.data(),
                    .lacking = static_cast<std::uint32_t>(receiver->lacking().size()),
                    .faults = static_cast<std::uint32_t>(receiver->faults().size())};
  return &change_outcome;
}

/// The part as it is shown; null where it is not.
DELTAMESH_EXPORT(findPart)
StreamOutcome* find_part(std::uint32_t level, std::int32_t x, std::int32_t y, std::int32_t z) {
  const MapPart* const part = receiver->find({static_cast<std::uint8_t>(level), x, y, z});
  if (part == nullptr) return nullptr;
  found.emplace();
  found->describe(part->mesh);
  return &found->outcome;
}

}  // extern "C"
}  // namespace deltamesh::web
