// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A link in trouble, in simulated time: bursts of loss, half a minute without anything, a tenth of the rate.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <random>
#include <utility>
#include <vector>

namespace deltamesh::test {

/// Both directions of it; each has a queue without an end, and its bytes come in order.
class TroubleLink {
 public:
  using Bytes = std::vector<std::byte>;
  enum Direction { kDown, kUp };

  static constexpr double kTick = 0.05;       // seconds
  static constexpr double kTimers = 0.25;     // seconds; of both ends, in a round trip
  static constexpr std::size_t kHeader = 28;  // of IPv4 and UDP, with every message

  TroubleLink(double delay, double bytes_per_second, std::uint32_t seed)
      : random_(seed), delay_(delay), rate_(bytes_per_second) {}

  /// Goes on by a tick. `is_troubled`: whether there may be new troubles.
  void go_on(bool is_troubled) {
    now_ += kTick;
    if (now_ >= phase_end_) begin_phase(is_troubled);
    if (kind_ == Kind::kBursts && now_ >= burst_end_) {
      is_burst_ = !is_burst_;
      burst_end_ = now_ + (is_burst_ ? 0.1 + unit() : 0.5 + 2 * unit());
    }
    for (Queue& queue : queues_) carry(queue);
    if (is_dead()) dead_until_ = now_;
    // In a round trip what was lost is noticed.
    if (now_ - dead_until_ > round_trip()) {
      alive_ += kTick;
      const double kept = std::min(kept_, rate() * kTick);
      kept_ -= kept;
      carried_ += rate() * kTick - kept;
    }
  }

  void send(Direction direction, Bytes message) {
    if (is_dead() && loses_when_dead_) return;
    if (unit() < (kind_ == Kind::kGood ? 0.01 : 0.05)) return;
    Queue& queue = queues_[direction];
    queue.bytes += static_cast<double>(message.size() + kHeader);
    queue.letters.push_back(std::move(message));
  }

  std::vector<Bytes> take(Direction direction) {
    std::vector<Bytes> messages;
    auto& arriving = queues_[direction].arriving;
    for (; !arriving.empty() && arriving.front().first <= now_; arriving.pop_front())
      messages.push_back(std::move(arriving.front().second));
    return messages;
  }

  /// Nothing is on its way any more: another receiver is at the end.
  void cut() {
    for (Queue& queue : queues_) queue = {};
  }

  double alive() const { return alive_; }  ///< seconds in which it worked, a round trip after it did not
  double carried() const {
    return carried_;
  }  ///< bytes that it could carry, without what came before trouble was noticed
  double round_trip() const { return 2 * delay_ + kTimers; }
  /// Seconds that the last byte to the receiver waits.
  double queued() const { return queues_[kDown].bytes / rate(); }

 private:
  enum class Kind { kGood, kBursts, kDead, kSlow };
  struct Queue {
    std::deque<Bytes> letters;
    double bytes = 0;  ///< of these
    double ready = 0;  ///< bytes that may go
    std::deque<std::pair<double, Bytes>> arriving;
  };

  double unit() { return std::uniform_real_distribution<>(0, 1)(random_); }
  bool is_dead() const { return kind_ == Kind::kDead || (kind_ == Kind::kBursts && is_burst_); }
  double rate() const { return kind_ == Kind::kSlow ? rate_ / 10 : rate_; }

  void begin_phase(bool is_troubled) {
    if (kind_ == Kind::kDead) kept_ = queues_[kDown].bytes;
    const auto turn = is_troubled ? random_() % 5 : 0;
    kind_ = turn < 2 ? Kind::kGood : turn == 2 ? Kind::kBursts : turn == 3 ? Kind::kDead : Kind::kSlow;
    loses_when_dead_ = kind_ == Kind::kBursts || random_() % 2 == 0;
    if (kind_ == Kind::kSlow) kept_ += rate_;  // a second's, until it is noticed
    phase_end_ = now_ + (kind_ == Kind::kDead ? 30 : 5 + 30 * unit());
    is_burst_ = false;
  }

  void carry(Queue& queue) {
    if (is_dead()) return;
    queue.ready = queue.letters.empty() ? 0 : queue.ready + rate() * kTick;
    while (!queue.letters.empty()) {
      const auto size = static_cast<double>(queue.letters.front().size() + kHeader);
      if (size > queue.ready) break;
      queue.ready -= size;
      queue.bytes -= size;
      queue.arriving.emplace_back(now_ + delay_, std::move(queue.letters.front()));
      queue.letters.pop_front();
    }
  }

  std::mt19937 random_;
  double delay_;
  double rate_;
  double now_ = 0;
  Kind kind_ = Kind::kGood;
  bool loses_when_dead_ = false;
  double phase_end_ = 5;
  bool is_burst_ = false;
  double burst_end_ = 0;
  Queue queues_[2];
  double dead_until_ = -1;
  double alive_ = 0;
  double carried_ = 0;
  double kept_ = 0;  ///< bytes that came to it before its trouble was noticed, and that it still has
};

}  // namespace deltamesh::test
