// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// State of a receiver, and how each kind of message changes it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "deltamesh/map/fragment.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/receiver.h"
#include "receive/arrivals.h"
#include "receive/early_messages.h"
#include "receive/received_parts.h"
#include "support/errors.h"
#include "support/steady_time.h"

namespace deltamesh {

struct ToldFault {
  std::uint64_t number = 0;  ///< of the message
  std::uint16_t code = 0;    ///< 0: none any more
};

/// kLimitExceeded [ReceiverLimits].
Error beyond_limits() noexcept;

struct MapReceiver::State {
  std::uint64_t viewer = 0;
  std::uint64_t map_id = 0;
  ReceiverLimits limits{};
  View view{};
  std::uint64_t number = 0;
  std::optional<MapCodec> codec{};
  std::uint64_t map = 0;  ///< hash of the codec's description
  ReceivedParts parts{};
  std::uint64_t start = 0;  ///< of the sender
  Arrivals arrivals{};      ///< of its numbered messages
  EarlyMessages early{};
  std::vector<std::shared_ptr<const PartContent>> came{};  ///< that early messages may wait for
  FragmentJoiner fragments{};
  Talk talk{};
  SteadyTime clock{};
  std::map<PartKey, std::uint64_t> announced{};  ///< revisions of entries without octets
  std::map<PartKey, ToldFault> faults{};         ///< as the sender told
  std::optional<PoseMessage> pose{};             ///< the last one
  std::set<PartKey> touched{};                   ///< since the last take_change()
  std::map<PartKey, double> stuck_since{};       ///< parts beside the view that wait; seconds

  Result<void> apply(std::span<const std::byte> message);
  /// Applies the early messages whose content has come, and those that wait for what these bring. Errors: the
  /// first of theirs; the others are applied all the same.
  Result<void> apply_early();
  Result<void> apply_description(std::span<const std::byte> message);
  Result<void> apply_start(std::span<const std::byte> message);
  Result<void> apply_entry(std::span<const std::byte> message);
  Result<void> apply_part(std::span<const std::byte> message);
  Result<void> apply_patch(std::span<const std::byte> message);
  Result<void> apply_fault(std::span<const std::byte> message);
  Result<void> apply_pose(std::span<const std::byte> message);
  Result<void> take(const PartKey& key, Version version, std::span<const std::byte> octets);
  void take(const PartKey& key, Version version);
  /// Drops the part outside of the view that is farthest from it; false: there is none.
  bool make_room(const PartKey& but);
  bool has_room_for_links() const;
  Result<DecodeOptions> options_for(const PartKey& key, std::size_t octets);
  /// Whether a message is of the start whose messages are taken; takes note of its number.
  bool is_mine(std::uint64_t of_start, std::uint64_t message_number);
  void forget_arrivals();
  /// Drops parts outside the view that have waited for more than four seconds: what they wait for may never
  /// be requested again, and the sender cannot know which version is shown.
  void drop_stuck(double now);
  Result<std::vector<std::byte>> view_message();
  Result<std::vector<std::byte>> receipt_message();
  Result<void> check_map(std::uint64_t hash) const;
  std::shared_ptr<const PartContent> find_base(const PatchMessage& patch) const;
  bool is_made_from(const EarlyMessage& message, const PartContent& content) const;
  bool is_new(const PartKey& key, std::uint64_t revision) const;
  bool is_of_use(const PartKey& key, std::uint64_t revision) const;
  void settle();
};

}  // namespace deltamesh
