// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One direction of a link, in simulated time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <random>
#include <utility>
#include <vector>

namespace deltamesh::bench {

struct LinkSettings {
  double loss = 0;                ///< share of messages, each by itself
  double delay = 0;               ///< seconds, one way
  double bytes_per_second = 0;    ///< above 0
  std::size_t header_bytes = 28;  ///< of IPv4 and UDP, with every message
};

/// Messages one after another at the link's rate, in order.
class Link {
 public:
  Link(const LinkSettings& settings, std::uint32_t seed) : settings_(settings), random_(seed) {}

  void send(std::vector<std::byte> message, double now) {
    const auto size = static_cast<double>(message.size() + settings_.header_bytes);
    bytes_ += message.size();
    free_ = std::max(free_, now) + size / settings_.bytes_per_second;
    if (std::uniform_real_distribution<>(0, 1)(random_) >= settings_.loss)
      letters_.emplace_back(free_ + settings_.delay, std::move(message));
  }

  /// What has arrived by now.
  std::vector<std::vector<std::byte>> take(double now) {
    std::vector<std::vector<std::byte>> messages;
    for (; !letters_.empty() && letters_.front().first <= now; letters_.pop_front())
      messages.push_back(std::move(letters_.front().second));
    return messages;
  }

  std::uint64_t bytes() const noexcept { return bytes_; }  ///< sent, without headers

 private:
  LinkSettings settings_;
  std::mt19937 random_;
  std::deque<std::pair<double, std::vector<std::byte>>> letters_;
  double free_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace deltamesh::bench
