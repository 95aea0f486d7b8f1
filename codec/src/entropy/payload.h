// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A chunk's bytes as its reader gets them, and whether they are in the compact form.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace deltamesh {

/// Bytes are plain (raw or out of zstd) unless said otherwise. Does not own them.
struct Payload {
  Payload() = default;
  Payload(std::span<const std::byte> plain)  // NOLINT(google-explicit-constructor): plain is the rule
      : bytes(plain) {}
  Payload(const std::vector<std::byte>& plain)  // NOLINT(google-explicit-constructor)
      : bytes(plain) {}
  static Payload compact(std::span<const std::byte> bytes) {
    Payload payload(bytes);
    payload.is_compact = true;
    return payload;
  }

  std::span<const std::byte> bytes;
  bool is_compact = false;
};

}  // namespace deltamesh
