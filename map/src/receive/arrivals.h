// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which numbered messages have come, and when a receiver should speak [MAP-21].
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

#include "deltamesh/map/messages.h"

namespace deltamesh {

class Arrivals {
 public:
  /// A message with this number has come; 0: one without. Whether others before it have not, as is seen now.
  bool add(std::uint64_t number);

  bool has_any() const noexcept { return highest_ != 0; }
  Receipt receipt() const { return {highest_, {missing_.begin(), missing_.end()}}; }

 private:
  std::uint64_t highest_ = 0;
  std::set<std::uint64_t> missing_;
};

/// What to say when. All of it takes about a quarter of the bytes that come, and 250 bytes a second: the way
/// back may be as narrow as the other. What has changed is said at once.
class Talk {
 public:
  enum class Turn : std::uint8_t { kNothing, kReceipt, kView };

  /// The view or what the receiver accepts has changed.
  void want_view() noexcept {
    wants_view_ = true;
    views_ = kViews;
  }
  /// So many bytes have come.
  void earn(std::size_t bytes) noexcept;
  /// A message has come; `is_gap`: others before it have not.
  void came(bool is_gap) noexcept;
  /// `has_parts`: messages about parts have come.
  Turn turn(double now, bool has_parts) noexcept;
  void said(Turn turn, std::size_t bytes, double now) noexcept;

 private:
  static constexpr int kViews = 2;  // after a change, as one may be lost
  static constexpr double kMostCredit = 1000;

  bool wants_view_ = true;       ///< at once
  int views_ = kViews;           ///< that are still to be sent soon
  bool wants_receipt_ = false;   ///< at once
  int receipts_ = 0;             ///< that are still to be sent, one by one
  bool has_come_ = false;        ///< something, since the last turn
  double heard_ = 0;             ///< when it came, seconds
  double view_ = 0;              ///< when the last one was sent, seconds
  double receipt_ = 0;           ///< or a view
  double credit_ = kMostCredit;  ///< bytes that may be sent; below 0: debts
  double counted_ = 0;           ///< seconds until which the credit has grown
};

}  // namespace deltamesh
