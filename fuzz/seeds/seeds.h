// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// For programs that write seeds.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
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

/// Bytes that choose what a target does; each is cut to eight bits.
inline Bytes bytes_of(std::initializer_list<std::size_t> numbers) {
  Bytes bytes;
  for (const std::size_t number : numbers) bytes.push_back(static_cast<std::byte>(number));
  return bytes;
}

inline Bytes operator+(Bytes before, std::span<const std::byte> after) {
  before.insert(before.end(), after.begin(), after.end());
  return before;
}

/// The corpora of chunk targets. What they get here begins with "made_": scripts/update-golden makes it anew.
class Corpora {
 public:
  explicit Corpora(std::filesystem::path folder) : folder_(std::move(folder)) {}
  void add(const std::string& target, const std::string& name, std::span<const std::byte> seed) const {
    std::filesystem::create_directories(folder_ / target);
    write(folder_ / target / ("made_" + name), seed);
  }

 private:
  std::filesystem::path folder_;
};

void make_topology(const Corpora& corpora);
void make_geometry(const Corpora& corpora);
void make_attributes(const Corpora& corpora);
void make_surface_attributes(const Corpora& corpora);

}  // namespace deltamesh::fuzz
