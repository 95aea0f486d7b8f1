// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Messages that came before what they are made from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "deltamesh/map/part_key.h"

namespace deltamesh {

/// A patch, or an entry of octets that have not come.
struct EarlyMessage {
  PartKey base{};                         ///< the part whose octets have not come
  std::optional<std::uint64_t> octets{};  ///< xxh3-64 of these; of a patch its checksum tells them
  std::vector<std::byte> bytes{};
};

class EarlyMessages {
 public:
  /// Keeps a message, in place of the earliest where they become too many.
  void keep(std::uint64_t number, EarlyMessage&& message);
  /// Takes out the earliest that can be applied now; null if there is none.
  std::optional<std::vector<std::byte>> take(const std::function<bool(const EarlyMessage&)>& can_be);
  /// Whether a message needs octets of this part.
  bool need(const PartKey& key) const;
  void clear();

 private:
  std::map<std::uint64_t, EarlyMessage> messages_;  ///< by number
  std::size_t octets_ = 0;
};

}  // namespace deltamesh
