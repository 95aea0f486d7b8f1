// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes out of their numbers, and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh::test {

/// `numbers`: of `type`, `components` for each vertex.
template <class Numbers>
Attribute attribute_of(AttributeKind kind, ComponentType type, int components, std::string name,
                       const Numbers& numbers, bool normalized = false) {
  Attribute a{kind, type, static_cast<std::uint8_t>(components), normalized, std::move(name)};
  const auto bytes = std::as_bytes(std::span(numbers));
  a.values.assign(bytes.begin(), bytes.end());
  return a;
}

template <class T>
std::vector<T> numbers(const Attribute& a) {
  std::vector<T> result(a.values.size() / sizeof(T));
  if (!result.empty()) std::memcpy(result.data(), a.values.data(), a.values.size());
  return result;
}

}  // namespace deltamesh::test
