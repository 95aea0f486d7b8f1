// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A map as it arrives: messages in any order, twice or never; never a crack.
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

/// What a receiver is willing to hold; messages beyond are refused.
struct ReceiverLimits {
  std::size_t parts = std::size_t{1} << 16;
  std::uint64_t octets = std::uint64_t{1} << 30;
  std::uint64_t vertices = std::uint64_t{1} << 26;  ///< of all parts, decoded
};

/// Which shown parts are others than at the last call, ascending.
struct ShownChange {
  std::vector<PartKey> changed;  ///< new or with another mesh
  std::vector<PartKey> removed;
};

/// A version that a receiver holds, for a folder.
struct HeldPart {
  PartEntry entry{};  ///< without box and errors
  std::span<const std::byte> octets{};
};

/// Shows at any moment parts that fit together [MAP-12]: what has come is shown as soon as all that it is to
/// be shown with has come. Not for two threads at a time.
class MapReceiver {
 public:
  /// `viewer`: a number that no other receiver of the map has, and another one after each start.
  MapReceiver(std::uint64_t viewer, std::uint64_t map_id, const ReceiverLimits& limits = {});

  /// A message of a map, a start, an entry, a part or a patch. Old and known ones have no effect, nor has a
  /// patch of a version that is not held. Errors: 1xx codes,
  /// kInvalidArgument (of another map or epoch, or before the map's message), kLimitExceeded, kOutOfMemory;
  /// nothing has changed then. Cost: decodes the part.
  Result<void> apply(std::span<const std::byte> message) noexcept;

  /// What to ask for. Parts outside stay until they are in the way. Default: all.
  void set_view(const View& view);
  const View& view() const noexcept;

  /// The message for the sender: the view and what is held. To be sent now and then, and after each change of
  /// the view. Errors: kInvalidArgument (the view), kOutOfMemory.
  Result<std::vector<std::byte>> view_message() noexcept;

  /// Null before the map's message.
  const MapDescription* description() const noexcept;
  /// The part as it is shown, ready to draw, until the next apply(); null if it is not shown.
  const MapPart* find(const PartKey& key) const noexcept;
  std::vector<PartKey> shown() const;  ///< ascending
  ShownChange take_change();
  /// Parts that entries told of and that have not come, ascending.
  std::vector<PartKey> lacking() const;
  /// Of the keys and octets of what is shown.
  std::uint64_t hash() const;

  /// All that is shown, ascending by key. Spans hold until the next apply().
  std::vector<HeldPart> held() const;
  /// Takes what held() gave once, after the map's message. Errors: as apply().
  Result<void> restore(const PartEntry& entry, std::span<const std::byte> octets) noexcept;

  MapReceiver(MapReceiver&&) noexcept;
  MapReceiver& operator=(MapReceiver&&) noexcept;
  ~MapReceiver();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace deltamesh
