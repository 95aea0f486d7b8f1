// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// For programs that write seeds.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh::fuzz {

using Bytes = std::vector<std::byte>;

template <class T>
T check(Result<T> result) {
  if (!result) std::abort();
  return *std::move(result);
}

template <class T>
T check(std::optional<T> result) {
  if (!result) std::abort();
  return *std::move(result);
}

inline void write(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) std::abort();
}

}  // namespace deltamesh::fuzz
