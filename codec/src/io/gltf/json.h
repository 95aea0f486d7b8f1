// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// JSON text in and out, and checked access to it. Member order and unknown members survive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh::gltf {

using Json = nlohmann::ordered_json;

/// Deepest nesting and most members of one object that parse_json() takes: bounds recursion in the JSON
/// library, and the cost of its linear member search.
inline constexpr std::size_t kMaxJsonDepth = 128;
inline constexpr std::size_t kMaxJsonMembers = 10000;

/// Errors: kInvalidFile (not JSON, `where`: byte), kLimitExceeded.
Result<Json> parse_json(std::span<const std::byte> text);

/// kInvalidFile at element number `element` of its kind.
constexpr Error element_error(const char* message, std::uint64_t element) noexcept {
  return {.code = ErrorCode::kInvalidFile,
          .message = message,
          .where_kind = WhereKind::kElement,
          .where = element};
}

/// kInvalidFile at an accessor.
constexpr Error accessor_error(const char* message, std::uint64_t accessor) noexcept {
  return {.code = ErrorCode::kInvalidFile,
          .message = message,
          .where_kind = WhereKind::kAccessor,
          .where = accessor};
}

/// The member, or null where `object` is no object or has none of that name.
const Json* find(const Json& object, const char* key) noexcept;
Json* find(Json& object, const char* key) noexcept;

/// Elements of the array `key` of `object`; 0 where it is absent.
std::size_t array_size(const Json& object, const char* key) noexcept;

inline constexpr std::uint64_t kNoLimit = ~std::uint64_t{0};

/// A whole number from 0 to `max`. Errors: `otherwise`.
Result<std::uint64_t> to_unsigned(const Json& value, std::uint64_t max, const Error& otherwise) noexcept;

/// The same for a member, `fallback` where it is absent.
Result<std::uint64_t> unsigned_member(const Json& object, const char* key, std::uint64_t fallback,
                                      std::uint64_t max, const Error& otherwise) noexcept;

/// Calls `visit(object, key)` for every object inside `root`, root included, but for those below a member
/// "extras", which is the application's. `key` is the member that the object is, or is in the array of; empty
/// for root. No recursion; `visit` may change members, not add or remove objects below.
template <class JsonType, class Visit>
void for_each_object(JsonType& root, Visit&& visit) {
  std::vector<std::pair<JsonType*, std::string_view>> pending{{&root, {}}};
  while (!pending.empty()) {
    const auto [value, key] = pending.back();
    pending.pop_back();
    if (value->is_object()) visit(*value, key);
    for (auto item = value->begin(); item != value->end(); ++item) {
      const std::string_view own = value->is_object() ? std::string_view(item.key()) : key;
      if (item->is_structured() && !(value->is_object() && own == "extras")) pending.push_back({&*item, own});
    }
  }
}

}  // namespace deltamesh::gltf
