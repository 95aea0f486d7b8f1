// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The same 32-bit random numbers on every platform.
#pragma once

#include <cstdint>
#include <random>

namespace deltamesh::test {

class RandomBits {
 public:
  explicit RandomBits(std::uint32_t seed) : engine_(seed) {}
  std::uint32_t operator()() { return static_cast<std::uint32_t>(engine_()); }

 private:
  std::mt19937 engine_;
};

}  // namespace deltamesh::test
