// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// State of a sender: its map and its receivers; makes the messages for one of them.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "deltamesh/map/fragment.h"
#include "deltamesh/map/sender.h"
#include "send/link/allowance.h"
#include "send/units.h"
#include "send/viewer_state.h"
#include "support/steady_time.h"

namespace deltamesh {

/// The version of a part to send.
struct ChosenVersion {
  KnownVersion version{};
  bool is_patch = false;  ///< of what the receiver is believed to have
};

struct MapSender::State {
  State(SourceMap source, MapCodec codec, const SenderOptions& o)
      : options(o), map(std::move(source)), encodings(std::move(codec), o, colors) {}

  SenderOptions options;
  std::uint64_t description_hash = 0;
  std::uint64_t start = 0;  ///< the map's revision when this sender was started
  SourceMap map;
  ColorContent colors{};  ///< of the blocks until it is known what they are
  Encodings encodings;
  KnownVersions known{};
  PartKey look_at_next{};  ///< for versions to forget
  std::map<std::uint64_t, Viewer> viewers{};
  SenderCounts counts{};
  std::optional<MapPose> pose{};
  SteadyTime clock{};
  FragmentJoiner fragments{};                        ///< of what viewers say
  Allowance total{};                                 ///< of all viewers together
  std::chrono::steady_clock::time_point deadline{};  ///< of the call of messages_for() that runs
  std::size_t links_made = 0;                        ///< in that call
  unsigned epochs = 0;                               ///< that began because of receivers

  /// Of so many parts, the next ones each time.
  void forget_versions(std::size_t parts);
  bool has_viewer(const PartKey& key, std::uint32_t version) const;
  Result<void> hear(std::span<const std::byte> bytes, double now);
  Result<void> hear_view(std::span<const std::byte> bytes, double now);
  Result<Viewer*> viewer_of(const ViewMessage& message, double now);
  Result<void> hear_receipt(std::span<const std::byte> bytes, double now);
  /// Begins a call of messages_for().
  void begin_call(Viewer& viewer, double now);
  /// Whether it is to end. `has_any`: whether it has done something; the next one would not come farther.
  bool is_call_over(bool has_any) const;
  Result<void> add_messages(Viewer& viewer, double now, std::vector<std::vector<std::byte>>& messages);
  /// Begins one above that of the receiver's description, which is not the sender's. Errors:
  /// kInvalidArgument.
  Result<void> begin_epoch(std::uint32_t of_receiver);
  /// Some of those that the viewer needs.
  Result<void> make_copies(Viewer& viewer, const SeenCells& seen, double now);
  /// Makes copies, plans and sends within the allowance.
  Result<void> send_what_is_due(Viewer& viewer, double now, std::vector<std::vector<std::byte>>& messages);
  /// Makes the messages of a unit, and sends what may be sent now. False: a part of it cannot be encoded,
  /// which another plan takes into account.
  Result<bool> send(const SendUnit& unit, SendPlan& plan, Viewer& viewer, double now,
                    std::vector<std::vector<std::byte>>& messages);
  Result<void> tell_pose(Viewer& viewer, double now, std::vector<std::vector<std::byte>>& messages);
  /// Sends a numbered start after a pause, so that the receiver notices if the message before it is lost.
  Result<void> tell_end(Viewer& viewer, double now, std::vector<std::vector<std::byte>>& messages);
  Result<void> tell_faults(const std::vector<PartFault>& faults, Viewer& viewer, double now,
                           std::vector<std::vector<std::byte>>& messages);
  const KnownVersion* believed_version(const Viewer& viewer, const PartKey& key) const;
  const KnownVersion* base_for(const Viewer& viewer, const PartKey& key) const;
  Result<ChosenVersion> choose_version(const SourcePart& source, const Viewer& viewer);
  Result<void> make_version(const PartKey& key, ChosenVersion chosen, const SendPlan& plan, Viewer& viewer,
                            double now);
  Result<void> make_removal(const PartKey& key, const SendPlan& plan, Viewer& viewer, double now);
};

}  // namespace deltamesh
