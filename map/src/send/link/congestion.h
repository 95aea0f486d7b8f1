// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How many bytes may be on the way to a receiver, so that they do not queue up before a link that is slower
// than its view's rate.
#pragma once

#include <algorithm>
#include <limits>

namespace deltamesh {

/// As long as replies come in time, there is no limit. Where even the fastest of a while take more than
/// kLongest, only what the link delivers in that time may be on the way: bytes on the way over the time they
/// took are its rate (Little's law). Loss alone is no sign.
class Congestion {
 public:
  /// A reply came `round_trip` seconds after a message that was sent at `sent`, when `flight` bytes were on
  /// the way with it. `at_least`: what it certainly took.
  void measure(double sent, double round_trip, double at_least, double flight, double now) noexcept {
    least_ = std::min(least_, round_trip);
    if (sent < changed_) return;  // it says nothing of the limit
    if (at_least < fastest_) {
      fastest_ = at_least;
      flight_ = flight;
    }
    if (at_least < kShort * longest()) in_time_ = std::max(in_time_, flight);
    if (now - decided_ >= kWhile) decide(now);
  }

  double limit() const noexcept { return limit_; }
  /// The longest that a reply takes where nothing queues up, seconds: 2 at most, as even the shortest round
  /// trip may have been in a queue.
  double longest() const noexcept { return std::clamp(2 * least_, kLongest, kMostLongest); }
  /// Whether a reply takes so long that there must be a queue, to which the limit is still to follow.
  bool is_too_long(double seconds) const noexcept { return seconds > kTooLong * longest(); }
  /// The shortest round trip so far: that without a queue, seconds; infinite: none.
  double least_round_trip() const noexcept { return least_; }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kWhile = 0.2;        // seconds
  static constexpr double kShort = 0.75;       // of the longest: there may be more
  static constexpr double kLongest = 1;        // seconds, or twice the shortest round trip
  static constexpr double kMostLongest = 2;    // seconds
  static constexpr double kTooLong = 1.5;      // of the longest
  static constexpr double kLeastLimit = 1024;  // bytes; one message may be on the way in any case

  void decide(double now) noexcept {
    const double before = limit_;
    if (fastest_ > longest()) {
      limit_ = std::max(flight_ / fastest_ * longest(), kLeastLimit);
    } else if (in_time_ > limit_ / 2) {
      limit_ *= 2;
    }
    if (limit_ != before) changed_ = now;
    fastest_ = kNever;
    in_time_ = 0;
    decided_ = now;
  }

  double least_ = kNever;
  double limit_ = kNever;
  double fastest_ = kNever;  ///< round trip of messages that were measured since the last decision
  double flight_ = 0;        ///< bytes on the way then
  double in_time_ = 0;       ///< most bytes on the way of which replies came in time
  double decided_ = 0;       ///< when, seconds
  double changed_ = 0;       ///< when the limit changed last, seconds
};

}  // namespace deltamesh
