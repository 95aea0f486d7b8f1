// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A map that changes, from a sender to a receiver over a link, in simulated time or over UDP.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "live/link.h"
#include "map/updates.h"

namespace deltamesh::bench {

struct LiveSettings {
  LinkSettings link{};
  double seconds_between_updates = 0.2;
  double max_error = 0.05;            ///< voxels
  std::uint32_t view_rate = 125'000;  ///< bytes per second that the view asks for
  std::size_t message_bytes = 0;      ///< of the largest message, both ways; 0: no limit
  std::uint32_t seed = 1;
  bool has_errors = false;  ///< in samples
};

inline constexpr double kFarOff = 4;  // voxels

/// What a receiver has at a time.
struct LiveSample {
  double seconds = 0;
  std::uint64_t bytes = 0;  ///< to it so far
  std::size_t behind = 0;   ///< parts that were sent and that it does not show
  double age = 0;           ///< of these, since when there is something newer than what it shows, seconds
  double error = 0;         ///< as ShownError, voxels, at most kFarOff
};

struct LiveResult {
  std::vector<double> changes;                    ///< seconds at which the receiver showed something else
  std::vector<std::pair<double, double>> idle{};  ///< from when to when it had all that was sent, seconds
  double seconds = 0;                             ///< of the updates
  std::uint64_t bytes = 0;                        ///< to the receiver
  std::uint64_t bytes_back = 0;
  std::vector<LiveSample> samples{};  ///< five a second
  double settled = 0;  ///< seconds from the last update until the receiver has all; negative: it never has
};

/// Times in which the receiver showed nothing new although it had not got all that was sent, and a receiver
/// without loss (`reference`) showed something, seconds.
std::vector<double> freezes(const LiveResult& result, const LiveResult& reference);

/// Library with default options. Exits where sender or receiver fails.
LiveResult run_live(const MapUpdates& updates, const LiveSettings& settings);

/// The same in real time, by datagrams on loopback; of the link's settings only the loss is the same. Ends a
/// minute after the last update at the latest.
LiveResult run_live_over_udp(const MapUpdates& updates, const LiveSettings& settings);

}  // namespace deltamesh::bench
