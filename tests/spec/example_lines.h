// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers of worked examples, as they stand in the text of the specification.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace deltamesh::test {

/// Numbers of the first line of a file of spec/ that starts with `name`, behind it. Bytes are hexadecimal.
template <class Number>
std::vector<Number> line_of(const std::string& file, const std::string& name) {
  constexpr bool kIsByte = std::is_same_v<Number, std::byte>;
  std::ifstream in(DELTAMESH_SPEC_DIR "/" + file);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string word;
    if (!line.starts_with("    ") || !(words >> word) || word != name + ":") continue;
    if (kIsByte) words >> std::hex;
    std::vector<Number> numbers;
    std::conditional_t<std::is_floating_point_v<Number>, Number, long> number{};
    while (words >> number) numbers.push_back(static_cast<Number>(number));
    return numbers;
  }
  ADD_FAILURE() << file << " has no " << name;
  return {};
}

inline std::vector<std::byte> bytes_of(const std::string& file, const std::string& name) {
  return line_of<std::byte>(file, name);
}

}  // namespace deltamesh::test
