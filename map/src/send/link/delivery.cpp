// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/link/delivery.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltamesh {
namespace {

constexpr double kFirstTimeout = 1;  // seconds, all of these; as RFC 6298
constexpr double kLeastTimeout = 0.1;
constexpr double kMostTimeout = 4;
constexpr double kMostPatience = 30;
constexpr double kHeardPatience = 1;
constexpr unsigned kMostOverdue = 8;
constexpr double kLeastSlack = 0.05;
constexpr double kSilence = 5;
constexpr double kPause = 0.04;
constexpr double kMostRoundTrip = 60;  // what takes longer is a clock that was set
constexpr std::uint64_t kMostDisorder = 32;

}  // namespace

void Delivery::add(SentMessage message) {
  if (message.is_whole)
    for (auto& [number, earlier] : on_the_way_)
      if (earlier.key == message.key) earlier.is_superseded = true;
  on_the_way_.emplace(last_, std::move(message));
  unsent_.push_back(last_);
}

const SentMessage& Delivery::send_next(double now) {
  const std::uint64_t number = unsent_.front();
  unsent_.pop_front();
  SentMessage& message = on_the_way_.at(number);
  flight_ += static_cast<double>(message.bytes.size());
  message.flight = flight_;
  note_sent(number, message, now);
  return message;
}

void Delivery::note_sent(std::uint64_t number, SentMessage& message, double now) {
  sent_ = std::max(sent_, number);
  if (message.times == 0) sent_at_ = now;
  if (!message.since) message.since = now;
  message.after = sent_;
  message.time = now;
  ++message.times;
}

const SentMessage& Delivery::send_again(std::uint64_t number, double now) {
  SentMessage& message = on_the_way_.at(number);
  note_sent(number, message, now);
  return message;
}

void Delivery::skip(std::uint64_t number) {
  const auto found = on_the_way_.find(number);
  const PartKey key = found->second.key;
  const std::optional<Believed> before = found->second.before;
  give_up(found);
  for (auto& [later, message] : on_the_way_)
    if (message.key == key && message.before && message.before->number == number) message.before = before;
}

void Delivery::give_up(Messages::iterator message) {
  const auto& [number, sent] = *message;
  if (sent.times == 1 && number > told_) given_up_[number] = {sent.time, sent.flight};
  erase(message);
}

Delivery::Messages::iterator Delivery::erase(Messages::iterator message) {
  if (message->second.times > 0) flight_ -= static_cast<double>(message->second.bytes.size());
  return on_the_way_.erase(message);
}

void Delivery::hear(const Receipt& receipt, double now) {
  const bool was_silent = is_silent(now);
  if (was_silent) {  // the link works again
    overdue_ = 0;
    works_since_ = now;
  }
  const double heard_before = std::exchange(heard_, now);
  if (receipt.highest < told_) return;
  const double patience = timeout();
  const auto newest = on_the_way_.find(receipt.highest);
  const auto given_up = given_up_.find(receipt.highest);
  // The number of a message tells a round trip only if it was sent once (Karn's rule).
  if (newest != on_the_way_.end() && newest->second.times == 1) {
    measure({newest->second.time, newest->second.flight}, heard_before, now);
  } else if (given_up != given_up_.end()) {
    measure(given_up->second, heard_before, now);
  }
  const double took = newest == on_the_way_.end() ? kMostRoundTrip : now - newest->second.time;
  const bool is_late = took > patience || congestion_.is_too_long(took);
  if (receipt.highest > told_ && is_late && !was_silent) late_ = now;
  notice_late(receipt);
  told_ = receipt.highest;
  last_ = std::max(last_, told_);
  sent_ = std::max(sent_, told_);
  given_up_.erase(given_up_.begin(), given_up_.upper_bound(told_));
  auto missing = receipt.missing.begin();
  for (auto it = on_the_way_.begin(); it != on_the_way_.end() && it->first <= receipt.highest;) {
    const std::uint64_t number = it->first;
    while (missing != receipt.missing.end() && *missing < number) ++missing;
    const bool is_missing = missing != receipt.missing.end() && *missing == number;
    if (is_missing || !is_told_of(number) || it->second.times == 0) {
      ++it;
      continue;
    }
    it = erase(it);
  }
  missing_ = receipt.missing;
}

/// What was missing and has come without being sent again.
void Delivery::notice_late(const Receipt& receipt) {
  for (const std::uint64_t number : missing_) {
    const auto sent = on_the_way_.find(number);
    if ((sent != on_the_way_.end() && (sent->second.times != 1 || sent->second.after > number)) ||
        receipt.highest - number > kReceiptNumbers || std::ranges::binary_search(receipt.missing, number))
      continue;
    disorder_ = std::min(std::max(disorder_, told_ - number), kMostDisorder);
  }
}

void Delivery::measure(const Sent& message, double heard_before, double now) noexcept {
  const double round_trip = now - message.time;
  if (round_trip > kMostRoundTrip || message.time < works_since_) return;
  const double at_least = round_trip - (now - heard_before);  // receipts between may be lost
  if (round_trip_ && round_trip > timeout() && at_least < timeout() && now - heard_before > timeout()) return;
  overdue_ = 0;
  congestion_.measure(message.time, round_trip, at_least, message.flight, now);
  if (!round_trip_) {
    round_trip_ = round_trip;
    variation_ = round_trip / 2;
    return;
  }
  variation_ += (std::abs(round_trip - *round_trip_) - variation_) / 4;
  *round_trip_ += (round_trip - *round_trip_) / 8;
}

double Delivery::timeout() const noexcept {
  if (!round_trip_) return kFirstTimeout;
  return std::clamp(*round_trip_ + std::max(4 * variation_, kLeastSlack), kLeastTimeout, kMostTimeout);
}

double Delivery::room(double now) const noexcept {
  return std::max(is_jammed(now) ? 0 : congestion_.limit() - flight_, may_probe(now) ? 1.0 : 0.0);
}

bool Delivery::may_probe(double now) const noexcept {
  return now - sent_at_ > (round_trip_ ? std::min(2 * *round_trip_, congestion_.longest()) : kFirstTimeout);
}

std::optional<std::uint64_t> Delivery::probe(double now) const {
  if (on_the_way_.empty() || !may_probe(now)) return std::nullopt;
  const auto& [number, message] = *on_the_way_.rbegin();
  const bool is_due = message.times == 1 || (message.times > 1 && now - message.time > congestion_.longest());
  return number > told_ && is_due ? std::optional(number) : std::nullopt;
}

bool Delivery::is_end_unseen(double now) const noexcept {
  if (on_the_way_.empty() || !is_slow() || now - sent_at_ < kPause) return false;
  const auto& [number, message] = *on_the_way_.rbegin();
  return number == last_ && number > told_ && message.times == 1 && !message.is_superseded;
}

bool Delivery::is_jammed(double now) const noexcept {
  double sent = now;
  if (const auto next = on_the_way_.upper_bound(told_); next != on_the_way_.end() && next->second.times > 0)
    sent = next->second.time;
  if (!given_up_.empty()) sent = std::min(sent, given_up_.begin()->second.time);
  return congestion_.is_too_long(now - sent);
}

bool Delivery::is_silent(double now) const noexcept {
  return !on_the_way_.empty() && now - heard_ > std::max(kSilence, 2 * timeout());
}

std::vector<std::uint64_t> Delivery::take_lost(double now) {
  const double patience = std::min(std::ldexp(timeout(), static_cast<int>(overdue_)), kMostPatience);
  std::vector<std::uint64_t> numbers;
  bool is_overdue = false;
  for (const auto& [number, message] : on_the_way_) {
    if (message.times == 0) continue;
    const bool has_passed = is_passed(number, message);
    const double waits_since = std::max(message.time, late_);  // behind what has come it may be in a queue
    const bool is_heard = heard_ - waits_since > timeout();    // a reply would have come with that
    const double waits = is_heard ? std::min(patience, kHeardPatience) : patience;
    if (!has_passed && now - waits_since <= std::max(waits, timeout())) continue;
    numbers.push_back(number);
    is_overdue = is_overdue || (!has_passed && message.time >= overdue_since_);
  }
  if (is_overdue) {
    overdue_ = std::min(overdue_ + 1, kMostOverdue);
    overdue_since_ = now;
  }
  return numbers;
}

}  // namespace deltamesh
