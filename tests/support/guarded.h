// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Damage that a reader of bytes must notice, or survive.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace deltamesh::test {

using Bytes = std::vector<std::byte>;

/// Every prefix and extension fails; with any byte flipped `read` returns (and checks what it gets).
inline void expect_guarded(const Bytes& bytes, const std::function<bool(const Bytes&)>& read,
                           const std::string& name) {
  ASSERT_TRUE(read(bytes)) << name;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))))
        << name << size;
  Bytes longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(read(longer)) << name;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const std::byte flip : {std::byte{1}, std::byte{0x10}, std::byte{0xff}}) {
      Bytes changed = bytes;
      changed[i] ^= flip;
      read(changed);
    }
  }
}

}  // namespace deltamesh::test
