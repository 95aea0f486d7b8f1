// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "receive/early_messages.h"

#include <algorithm>
#include <utility>

namespace deltamesh {
namespace {

constexpr std::size_t kMostOctets = std::size_t{1} << 20;
constexpr std::size_t kMostMessages = 256;

}  // namespace

void EarlyMessages::keep(std::uint64_t number, EarlyMessage&& message) {
  const auto [place, is_new] = messages_.try_emplace(number, std::move(message));
  if (!is_new) return;
  octets_ += place->second.bytes.size();
  while (octets_ > kMostOctets || messages_.size() > kMostMessages) {
    const auto oldest = messages_.begin();
    octets_ -= oldest->second.bytes.size();
    messages_.erase(oldest);
  }
}

std::optional<std::vector<std::byte>> EarlyMessages::take(
    const std::function<bool(const EarlyMessage&)>& can_be) {
  const auto found = std::ranges::find_if(messages_, [&](const auto& entry) { return can_be(entry.second); });
  if (found == messages_.end()) return std::nullopt;
  std::vector<std::byte> bytes = std::move(found->second.bytes);
  octets_ -= bytes.size();
  messages_.erase(found);
  return bytes;
}

bool EarlyMessages::need(const PartKey& key) const {
  return std::ranges::any_of(messages_, [&](const auto& entry) { return entry.second.base == key; });
}

void EarlyMessages::clear() {
  messages_.clear();
  octets_ = 0;
}

}  // namespace deltamesh
