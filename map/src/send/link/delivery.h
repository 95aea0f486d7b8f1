// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The numbered messages to one receiver: which have arrived, which are lost, and how long a round trip takes
// [MAP-21].
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "deltamesh/map/messages.h"
#include "send/link/believed.h"
#include "send/link/congestion.h"

namespace deltamesh {

/// A message that the receiver has not told of yet.
struct SentMessage {
  PartKey key{};
  std::vector<std::byte> bytes{};
  std::optional<Believed> before{};  ///< what the receiver was believed to have of the part
  bool is_whole = false;             ///< of use without earlier messages about the part
  /// When it was sent first, seconds; where it replaces lost messages, when the first of them was. Empty: it
  /// replaces none and was not sent yet.
  std::optional<double> since{};
  bool is_superseded = false;  ///< a later message about the part is whole, or nothing is lost with it
  double time = 0;             ///< when it was sent last, seconds
  double flight = 0;           ///< bytes on the way then, with its own
  std::uint64_t after = 0;     ///< the highest number that was sent by then
  unsigned times = 0;          ///< how often it was sent
};

class Delivery {
 public:
  using Messages = std::map<std::uint64_t, SentMessage>;  ///< by number

  /// Numbers follow that of the highest message that the receiver has of this start.
  explicit Delivery(std::uint64_t highest = 0) noexcept : last_(highest), sent_(highest), told_(highest) {}

  std::uint64_t next_number() noexcept { return ++last_; }
  /// Remembers a message with the last number, which is to be sent.
  void add(SentMessage message);
  /// Whether some of these are still to be sent.
  bool has_unsent() const noexcept { return !unsent_.empty(); }
  /// The first one of them is sent.
  const SentMessage& send_next(double now);
  /// The message is to be sent once more.
  const SentMessage& send_again(std::uint64_t number, double now);
  void forget(std::uint64_t number) { give_up(on_the_way_.find(number)); }
  /// Forgets a lost message that nothing is made from.
  void skip(std::uint64_t number);

  /// Takes what the receiver tells. O(messages on the way).
  void hear(const Receipt& receipt, double now);

  const Messages& on_the_way() const noexcept { return on_the_way_; }
  const SentMessage& at(std::uint64_t number) const { return on_the_way_.at(number); }
  bool is_on_the_way(std::uint64_t number) const { return on_the_way_.contains(number); }
  /// Numbers of messages that are taken to be lost, ascending: later ones have come, or a reply is overdue.
  /// Where replies are overdue, the next ones may take twice as long.
  std::vector<std::uint64_t> take_lost(double now);
  /// The last message, where it is unanswered for so long that it is worth another try: what comes of it
  /// tells what is lost (RFC 8985, tail loss probe).
  std::optional<std::uint64_t> probe(double now) const;
  /// Whether the last message was sent a moment ago, a reply takes long, and nothing was sent after it that
  /// would show the receiver if it is lost.
  bool is_end_unseen(double now) const noexcept;
  /// Whether receipts still tell of a message of this number.
  bool is_told_of(std::uint64_t number) const noexcept { return number + kReceiptNumbers >= told_; }

  /// Seconds after which a message without a reply is taken to be lost (RFC 6298).
  double timeout() const noexcept;
  /// Whether a message that is lost once more would be late, and there is room to send it more than once.
  bool is_slow() const noexcept {
    return round_trip_ && congestion_.least_round_trip() > kSlow && overdue_ <= 1 &&
           flight_ < congestion_.limit() / 4;
  }
  /// Bytes that may be sent before they would queue up on their way; one message in any case if it is above
  /// 0. It is 0 while messages of long ago are unanswered. Where nothing new was sent for two round trips, it
  /// is one message.
  double room(double now) const noexcept;
  /// Whether the receiver has not been heard for so long that nothing is worth sending.
  bool is_silent(double now) const noexcept;

 private:
  struct Sent {
    double time = 0;    ///< seconds
    double flight = 0;  ///< bytes on the way then, with its own
  };

  static constexpr double kSlow = 0.1;  // seconds
  /// Later messages have come.
  bool is_passed(std::uint64_t number, const SentMessage& message) const noexcept {
    return !is_told_of(number) || told_ > message.after + disorder_;
  }
  /// Nothing new was sent for two round trips, or longer than a reply takes where nothing queues up.
  bool may_probe(double now) const noexcept;
  /// What was sent long ago, and perhaps given up since, may still come: it is in a queue.
  bool is_jammed(double now) const noexcept;
  Messages::iterator erase(Messages::iterator message);
  /// Forgets all but when it was sent.
  void give_up(Messages::iterator message);
  void note_sent(std::uint64_t number, SentMessage& message, double now);
  void measure(const Sent& message, double heard_before, double now) noexcept;
  void notice_late(const Receipt& receipt);

  Messages on_the_way_;
  std::map<std::uint64_t, Sent> given_up_{};  ///< sent once, taken for lost; above told_
  std::deque<std::uint64_t> unsent_{};        ///< numbers, ascending
  double flight_ = 0;                         ///< bytes of these
  Congestion congestion_{};
  std::uint64_t last_ = 0;                ///< the last number that was used
  std::uint64_t sent_ = 0;                ///< the highest number that was sent
  double sent_at_ = 0;                    ///< when a message was last sent for the first time, seconds
  std::uint64_t told_ = 0;                ///< the highest number that the receiver has told of
  std::vector<std::uint64_t> missing_{};  ///< as the receiver told last
  std::uint64_t disorder_ = 0;            ///< by how many numbers a message that seemed lost came late
  unsigned overdue_ = 0;                  ///< how often replies were overdue since one came
  double overdue_since_ = 0;              ///< when they were last, seconds
  double heard_ = 0;
  double late_ = 0;                     ///< when what came last was late, seconds
  double works_since_ = 0;              ///< the last silence, seconds
  std::optional<double> round_trip_{};  ///< smoothed, seconds
  double variation_ = 0;                ///< of it
};

}  // namespace deltamesh
