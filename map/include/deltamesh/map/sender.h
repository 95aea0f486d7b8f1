// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A map for receivers who each ask for what they want to see.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/part_entry.h"
#include "deltamesh/map/split.h"
#include "deltamesh/result.h"

namespace deltamesh {

struct SenderOptions {
  SplitOptions split{};
  int effort = 0;  ///< of encoding, 0 to 9: what is more costs several times the time for hardly fewer bytes
  GeometryCoder geometry = GeometryCoder::kAuto;
  double resend_seconds = 1;      ///< what a receiver does not tell of after so long is sent again; above 0
  std::size_t most_viewers = 64;  ///< views of more are refused
  /// Whether a receiver keeps faces of older versions that are within its bounds of the newest source: whole
  /// parts, or those that a patch leaves.
  bool keeps_good_enough = true;
};

/// What a sender has done for all receivers.
struct SenderCounts {
  std::uint64_t parts_sent = 0;
  std::uint64_t patches_sent = 0;  ///< of these
  std::uint64_t entries_sent = 0;
  std::uint64_t encoded = 0;
  /// Versions that receivers kept as they were good enough, counted once per update and receiver.
  std::uint64_t kept = 0;
};

/// Keeps the source and what each receiver has. It decodes all that it sends, so that it knows the receivers'
/// maps to the bit. Times are seconds of any steady clock. Not for two threads at a time.
class MapSender {
 public:
  /// Errors: kInvalidArgument, those of MapCodec::open().
  static Result<MapSender> make(MapDescription description, const SenderOptions& options = {}) noexcept;
  /// Goes on with a map that had `revision` updates and used the group numbers below `group`.
  void resume(std::uint64_t revision, std::uint64_t group) noexcept;

  /// One update of the source, as Splitter::update(). On an error nothing has changed.
  Result<void> update(std::span<const MapBlock> blocks) noexcept;

  /// Takes a view's message. Errors: 1xx codes, kInvalidArgument (of another map), kLimitExceeded (too many
  /// viewers), kUnmetRequest (a largest error below what the lattice allows), kOutOfMemory.
  Result<void> hear(std::span<const std::byte> view_message, double now) noexcept;
  void forget(std::uint64_t viewer) noexcept;
  std::vector<std::uint64_t> viewers() const;

  /// What to send to a receiver now, in this order, within its bytes per second (saved up for a second at the
  /// most; what is shown together goes together, and what that is too much is made up for later): first what
  /// removes, then the coarsest, longest unsent and nearest to its boxes. Of a map with coarser copies the
  /// receiver first gets the coarsest, then, call by call, what is below, down to the level of its view.
  /// Errors: kInvalidArgument (a viewer that has not been heard), those of MapCodec::encode(), kOutOfMemory.
  Result<std::vector<std::vector<std::byte>>> messages_for(std::uint64_t viewer, double now) noexcept;

  /// Versions that the receiver has once all that was sent to it has come, ascending by key. Of parts without
  /// a known version only the key is filled in.
  std::vector<PartEntry> entries_of(std::uint64_t viewer) const;

  const MapDescription& description() const noexcept;
  std::uint64_t revision() const noexcept;
  std::uint64_t next_group() const noexcept;
  const SenderCounts& counts() const noexcept;
  /// The newest source of a part; null if there is none.
  const MapPart* source(const PartKey& key) const noexcept;
  std::vector<PartKey> keys() const;  ///< ascending

  MapSender(MapSender&&) noexcept;
  MapSender& operator=(MapSender&&) noexcept;
  ~MapSender();

 private:
  struct State;
  explicit MapSender(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace deltamesh
