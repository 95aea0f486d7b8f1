// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The receiving side of a map. Messages may come in any order, twice or never; the map that is shown never
// has a crack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/part.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Upper limits of what a receiver holds. Parts outside of the view, the farthest first, make room for those
/// in it; messages that would still exceed a limit are refused. The sender notices: a part that was refused
/// twice is one of faults(), an older version of it is removed, and it is sent again ever more rarely, until
/// it changes. When the view changes or a part goes it is sent again within a second.
struct ReceiverLimits {
  std::size_t parts = std::size_t{1} << 16;
  std::uint64_t octets = std::uint64_t{1} << 30;
  std::uint64_t vertices = std::uint64_t{1} << 26;  ///< of all parts, decoded
  std::size_t message_bytes = 0;  ///< of the largest message that it gives, as of a sender's
};

/// Differences of the parts shown since the last call; keys ascending.
struct ShownChange {
  std::vector<PartKey> changed;  ///< new or with another mesh
  std::vector<PartKey> removed;
};

/// A version that a receiver holds, for a folder.
struct HeldPart {
  PartEntry entry{};  ///< without box and errors
  std::span<const std::byte> octets{};
};

/// Shows parts that fit together at any moment [MAP-12]: a part is shown as soon as all parts that it must be
/// shown with have arrived. Not thread-safe.
class MapReceiver {
 public:
  /// `viewer`: a number that no other receiver of the map has, and another one after each start.
  MapReceiver(std::uint64_t viewer, std::uint64_t map_id, const ReceiverLimits& limits = {});

  /// Applies a message: a map, a start, an entry, a part or a patch, or a fragment of one. Old and known
  /// messages have no effect. A patch of a version that is not held waits for it, and so may an entry; then
  /// errors may be theirs. Errors: 1xx codes, kInvalidArgument (of another map or start, or before the map's
  /// message), kLimitExceeded, kOutOfMemory; on an error nothing has changed. Cost: decodes the part.
  Result<void> apply(std::span<const std::byte> message) noexcept;

  /// Drops a part. The sender sends it again only if it is in the view.
  void drop(const PartKey& key);

  /// Sets the request. Parts outside the view stay as they are until others take their place, need their room
  /// or no longer fit to them: a part in the view that changes across the view's edge. Those that have begun
  /// to change go after a few seconds where the rest of the change is not asked for any more. Default: the
  /// whole map.
  void set_view(const View& view);
  const View& view() const noexcept;

  /// What is to be sent to the sender now: the view once a second and after each change, and receipts of a
  /// few dozen bytes: at once where a message is missing, else 20 times a second at the most. To be called
  /// after apply(), and 20 times a second. `now`: seconds of any steady clock. Errors: as view_message(),
  /// kInvalidArgument (ReceiverLimits::message_bytes).
  Result<std::vector<std::vector<std::byte>>> messages(double now) noexcept;

  /// The view alone, in one message, with what is held and what has come, for callers who choose the time
  /// themselves: at least every few seconds, and after each change of the view. Errors: kInvalidArgument (the
  /// view), kOutOfMemory.
  Result<std::vector<std::byte>> view_message() noexcept;

  /// Null before the map's message.
  const MapDescription* description() const noexcept;
  /// Where the map is; null: the sender has not said it.
  const MapPose* pose() const noexcept;
  /// The part as it is shown, ready to draw, until the next call that is not const; null if it is not shown.
  const MapPart* find(const PartKey& key) const noexcept;
  std::vector<PartKey> shown() const;  ///< ascending
  ShownChange take_change();
  /// Parts that entries announced and that have not arrived, ascending.
  std::vector<PartKey> lacking() const;
  /// Parts that do not come as the view asks, as the sender told, ascending by key: kLimitExceeded for those
  /// that this receiver refuses because of its limits, or that are too large to be sent. 65,536 at most.
  std::vector<PartFault> faults() const;
  /// Hash of the keys and octets of the parts shown.
  std::uint64_t hash() const;

  /// All parts shown, ascending by key. Spans are valid until the next call that is not const.
  std::vector<HeldPart> held() const;
  /// Takes what held() gave once: after the map's message and before the next messages(), so that the sender
  /// knows of it when it begins [MAP-16]. Errors: as apply().
  Result<void> restore(const PartEntry& entry, std::span<const std::byte> octets) noexcept;

  MapReceiver(MapReceiver&&) noexcept;
  MapReceiver& operator=(MapReceiver&&) noexcept;
  ~MapReceiver();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace deltamesh
