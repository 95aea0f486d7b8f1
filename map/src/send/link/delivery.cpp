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
constexpr double kLeastSlack = 0.05;
constexpr double kSilence = 5;
constexpr std::uint64_t kMostDisorder = 32;

}  // namespace

void Delivery::add(SentMessage message) {
  message.after = last_;
  if (message.is_whole)
    for (auto& [number, earlier] : on_the_way_)
      if (earlier.key == message.key) earlier.is_superseded = true;
  on_the_way_.emplace(last_, std::move(message));
}

const SentMessage& Delivery::send_again(std::uint64_t number, double now) {
  SentMessage& message = on_the_way_.at(number);
  message.time = now;
  message.after = last_;
  ++message.times;
  return message;
}

void Delivery::skip(std::uint64_t number) {
  const SentMessage skipped = std::move(on_the_way_.at(number));
  on_the_way_.erase(number);
  for (auto& [later, message] : on_the_way_)
    if (message.key == skipped.key && message.before && message.before->number == number)
      message.before = skipped.before;
}

void Delivery::hear(const Receipt& receipt, double now) {
  heard_ = now;
  if (receipt.highest < told_) return;
  // The number of a message tells a round trip only if it was sent once (Karn's rule).
  if (const auto newest = on_the_way_.find(receipt.highest);
      newest != on_the_way_.end() && newest->second.times == 1)
    measure(now - newest->second.time);
  notice_late(receipt);
  told_ = receipt.highest;
  last_ = std::max(last_, told_);
  auto missing = receipt.missing.begin();
  for (auto it = on_the_way_.begin(); it != on_the_way_.end() && it->first <= receipt.highest;) {
    const std::uint64_t number = it->first;
    while (missing != receipt.missing.end() && *missing < number) ++missing;
    const bool is_missing = missing != receipt.missing.end() && *missing == number;
    if (is_missing || !is_told_of(number)) {
      ++it;
      continue;
    }
    it = on_the_way_.erase(it);
  }
  missing_ = receipt.missing;
}

/// What was missing and has come without being sent again.
void Delivery::notice_late(const Receipt& receipt) {
  for (const std::uint64_t number : missing_) {
    const auto sent = on_the_way_.find(number);
    if ((sent != on_the_way_.end() && sent->second.times > 1) || receipt.highest - number > kReceiptNumbers ||
        std::ranges::binary_search(receipt.missing, number))
      continue;
    disorder_ = std::min(std::max(disorder_, told_ - number), kMostDisorder);
  }
}

void Delivery::measure(double round_trip) noexcept {
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

bool Delivery::is_silent(double now) const noexcept {
  return !on_the_way_.empty() && now - heard_ > std::max(kSilence, 2 * timeout());
}

bool Delivery::is_lost(std::uint64_t number, const SentMessage& message, double now) const noexcept {
  if (!is_told_of(number)) return true;
  if (told_ > message.after + disorder_) return true;
  const double patience = timeout() * static_cast<double>(1U << std::min(message.times - 1, 5U));
  return now - message.time > std::min(patience, kMostTimeout);
}

std::vector<std::uint64_t> Delivery::lost(double now) const {
  std::vector<std::uint64_t> numbers;
  for (const auto& [number, message] : on_the_way_)
    if (is_lost(number, message, now)) numbers.push_back(number);
  return numbers;
}

}  // namespace deltamesh
