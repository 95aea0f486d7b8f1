// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "receive/arrivals.h"

#include <algorithm>
#include <utility>

namespace deltamesh {
namespace {

constexpr double kViewPeriod = 1;  // seconds, all of these
constexpr double kSoon = 0.25;
constexpr double kNoAnswer = 3;          // after which a link may be dead, and keep what is said for later
constexpr double kReceiptPeriod = 0.05;  // as receipts can be lost, what comes is told of twice
constexpr int kReceipts = 2;
constexpr double kShare = 0.25;  // of the bytes that come
constexpr double kBytesPerSecond = 250;

}  // namespace

bool Arrivals::add(std::uint64_t number) {
  if (number <= highest_) {
    missing_.erase(number);
    return false;
  }
  const std::uint64_t first = std::max(highest_ + 1, number - std::min(number - 1, kReceiptNumbers));
  for (std::uint64_t between = first; between < number; ++between) missing_.insert(missing_.end(), between);
  highest_ = number;
  std::erase_if(missing_, [&](std::uint64_t old) { return highest_ - old > kReceiptNumbers; });
  return first < number;
}

void Talk::earn(std::size_t bytes) noexcept {
  credit_ = std::min(credit_ + kShare * static_cast<double>(bytes), kMostCredit);
  has_come_ = true;
}

void Talk::came(bool is_gap) noexcept {
  wants_receipt_ = wants_receipt_ || is_gap;
  receipts_ = kReceipts;
}

Talk::Turn Talk::turn(double now, bool has_parts) noexcept {
  credit_ = std::min(credit_ + kBytesPerSecond * (now - counted_), kMostCredit);
  counted_ = now;
  if (std::exchange(has_come_, false)) heard_ = now;
  if (wants_view_) return Turn::kView;
  if (credit_ > 0) {
    const bool is_soon = views_ > 0 || (!has_parts && now - heard_ < kNoAnswer);
    if (now - view_ >= (is_soon ? kSoon : kViewPeriod)) return Turn::kView;
    if (wants_receipt_ || (receipts_ > 0 && now - receipt_ >= kReceiptPeriod)) return Turn::kReceipt;
  }
  return now - receipt_ >= kViewPeriod ? Turn::kReceipt : Turn::kNothing;  // it is still there
}

void Talk::said(Turn turn, std::size_t bytes, double now) noexcept {
  credit_ -= static_cast<double>(bytes);
  receipt_ = now;
  wants_receipt_ = false;
  receipts_ = std::max(receipts_ - 1, 0);
  if (turn != Turn::kView) return;
  view_ = now;
  wants_view_ = false;
  views_ = std::max(views_ - 1, 0);
}

}  // namespace deltamesh
