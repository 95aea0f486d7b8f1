// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The sending side of a map. Each receiver asks for what it wants to see.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "deltamesh/encode.h"
#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/part_entry.h"
#include "deltamesh/map/pose.h"
#include "deltamesh/map/split.h"
#include "deltamesh/result.h"

namespace deltamesh {

struct SenderOptions {
  SplitOptions split{};
  int effort = 0;  ///< of encoding, 0 to 2: what is more costs several times the time for hardly fewer bytes
  GeometryCoder geometry = GeometryCoder::kAuto;
  /// Views of more are refused, unless another viewer has been silent for 5 seconds and makes room.
  std::size_t most_viewers = 64;
  /// A viewer that is not heard for so long is forgotten, at the next messages_for() of it or hear() of any;
  /// above 0.
  double viewer_seconds = 60;
  /// To all receivers together, in any second; 0: no limit. A call of messages_for() takes its share of what
  /// is left: one of as many as there are viewers.
  std::uint64_t bytes_per_second = 0;
  /// Of the largest message: what is longer comes in fragments [MAP-25]. 1,200 for datagrams; at least 64; 0:
  /// no limit.
  std::size_t message_bytes = 0;
  /// After so many seconds of its own messages_for() gives what it has and goes on at the next call; above 0.
  /// It ends between parts, of which it encodes one in any case: that takes up to 0.1 s, at effort 0.
  double call_seconds = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* cancel =
      nullptr;  ///< ends messages_for() in the same way when true; must outlive it
  /// Whether a receiver keeps faces of older versions that are within its bounds of the newest source: whole
  /// parts, or those that a patch with a plan leaves.
  bool keeps_good_enough = true;
};

/// Counts over all receivers.
struct SenderCounts {
  std::uint64_t parts_sent = 0;
  std::uint64_t patches_sent = 0;  ///< of these
  std::uint64_t entries_sent = 0;
  std::uint64_t encoded = 0;
  /// Versions that receivers kept as they were good enough, counted once per update and receiver.
  std::uint64_t kept = 0;
};

/// Keeps the source and the state of each receiver. It decodes everything that it sends, so that it knows the
/// receivers' maps to the bit. What is lost on the way is sent again within one exchange, if nothing newer
/// takes its place; where replies take longer than a second, and than twice the shortest, no more is on the
/// way than the link delivers in that time. Times are seconds of a steady clock: of one that is set back none
/// pass, and of one that is set forward at most 2 from call to call. A message arrives within 60 seconds or
/// not at all: then what is known of parts that no longer exist is forgotten. Where a receiver has another
/// description of the map, of another lattice, say, and of an epoch that is not older, a new epoch begins,
/// and all parts are encoded and sent anew: up to 8 times, then such views are refused. Whatever viewers say,
/// a call encodes each part at most four times: as a patch, beside its base and by a plan, as a whole, and
/// again where that cannot be as asked. What is kept of a part are encodings for present viewers' bounds and
/// versions that receivers have. Views that ask nothing of colours get them exactly until blocks with 1000
/// faces have come; these decide, once for all parts, whether they are labels, which stay exact, or those of
/// photographs (ColorContent). Not thread-safe.
class MapSender {
 public:
  /// Errors: kInvalidArgument, those of MapCodec::open().
  static Result<MapSender> make(MapDescription description, const SenderOptions& options = {}) noexcept;
  /// Continues a map that had `revision` updates and used the group numbers below `group`.
  void resume(std::uint64_t revision, std::uint64_t group) noexcept;

  /// One update of the source, as Splitter::update(), also in its errors and its cost; parts with the same
  /// borders get new links.
  Result<void> update(std::span<const MapBlock> blocks) noexcept;

  /// Tells all receivers where the map is, in one message of about 90 bytes each, before anything else.
  /// Errors: kInvalidArgument, kOutOfMemory.
  Result<void> set_pose(const MapPose& pose) noexcept;

  /// Takes a message of a receiver: a view, a receipt, or a fragment of one. Receipts of unknown viewers have
  /// no effect. Errors: 1xx codes, kInvalidArgument (of another map, or of too many epochs), kLimitExceeded
  /// (too many viewers), kOutOfMemory: the message has no effect, and a receiver whose views are refused so
  /// gets nothing and is not told. Errors of bounds, each time that a view asks for them: kUnmetRequest (a
  /// largest error below what the lattice allows; Error::best_value), kInvalidArgument with Error::where_kind
  /// kAttribute (a bound that this attribute of the map does not have): the view is taken, and served as well
  /// as can be. Parts that cannot keep a bound are named by faults_of(), and by the receiver's faults().
  Result<void> hear(std::span<const std::byte> message, double now) noexcept;
  /// Drops a viewer; its next view begins anew. So does one that is silent for too long, and a number that is
  /// used again by a receiver that has nothing yet.
  void forget(std::uint64_t viewer) noexcept;
  std::vector<std::uint64_t> viewers() const;

  /// The messages to send to a receiver now, in this order: removals first, then parts by level (coarsest
  /// first), time since they were last sent and distance from the view's boxes. In any second
  /// they have at most the receiver's bytes per second and one message more; parts that are shown together
  /// are sent after each other, all as they are when the first of them is due. Coarser copies are made here,
  /// for viewers who ask for their level, up to 65,536 triangles a call (about 0.1 s); those of earlier
  /// content stay until then. Where a receiver has nothing, it gets copies first, if the map has a level of
  /// them that takes few bytes beside the map, and then what it asks for. `now`: seconds. Errors:
  /// kInvalidArgument (unknown viewer), kOutOfMemory; parts that cannot be encoded are faults_of().
  Result<std::vector<std::vector<std::byte>>> messages_for(std::uint64_t viewer, double now) noexcept;

  /// Parts that the receiver does not get as it asked, as of the last messages_for(); ascending by key. Each
  /// call tells the receiver up to 64 changes, and lists those that were told. All other parts come as if
  /// these were not there. kLimitExceeded with "the receiver did not keep it": it refused the part twice
  /// (ReceiverLimits), and gets it again after 1, 4, 16
  /// ... 1024 seconds, or within a second where it may have room.
  std::vector<PartFault> faults_of(std::uint64_t viewer) const;

  /// Versions that the receiver has once everything sent to it has arrived, ascending by key. For parts
  /// without a known version only the key is set.
  std::vector<PartEntry> entries_of(std::uint64_t viewer) const;

  /// Of entries_of(): equal to MapReceiver::hash() once everything has arrived and is shown.
  std::uint64_t hash(std::uint64_t viewer) const;

  const MapDescription& description() const noexcept;
  std::uint64_t revision() const noexcept;
  std::uint64_t next_group() const noexcept;
  SenderCounts counts() const noexcept;
  /// The newest source of a part; null if there is none.
  const MapPart* source(const PartKey& key) const noexcept;
  std::vector<PartKey> keys() const;  ///< ascending; of copies those that somebody has asked for

  MapSender(MapSender&&) noexcept;
  MapSender& operator=(MapSender&&) noexcept;
  ~MapSender();

 private:
  struct State;
  explicit MapSender(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace deltamesh
