// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/json.h"

#include <array>

namespace deltamesh::gltf {
namespace {

Error text_error(ErrorCode code, const char* message, std::size_t byte) noexcept {
  return {.code = code, .message = message, .where_kind = WhereKind::kByte, .where = byte};
}

/// Checks the two limits on the bare text, before anything is built from it.
Result<void> check_limits(std::span<const std::byte> text) noexcept {
  std::array<std::size_t, kMaxJsonDepth> members{};
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = static_cast<char>(text[i]);
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (depth == kMaxJsonDepth)
        return text_error(ErrorCode::kLimitExceeded, "JSON is nested too deeply", i);
      members[depth++] = 0;
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    } else if (c == ':' && depth > 0 && ++members[depth - 1] > kMaxJsonMembers) {
      return text_error(ErrorCode::kLimitExceeded, "a JSON object has too many members", i);
    }
  }
  return {};
}

}  // namespace

Result<Json> parse_json(std::span<const std::byte> text) {
  if (auto checked = check_limits(text); !checked) return checked.error();
  const char* begin = reinterpret_cast<const char*>(text.data());
  try {
    return Json::parse(begin, begin + text.size());
  } catch (const Json::parse_error& error) {
    return text_error(ErrorCode::kInvalidFile, "not valid JSON", error.byte);
  } catch (const Json::out_of_range&) {
    return text_error(ErrorCode::kInvalidFile, "a number in the JSON is too large", 0);
  }
}

const Json* find(const Json& object, const char* key) noexcept {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

Json* find(Json& object, const char* key) noexcept {
  return const_cast<Json*>(find(static_cast<const Json&>(object), key));
}

std::size_t array_size(const Json& object, const char* key) noexcept {
  const Json* array = find(object, key);
  return array && array->is_array() ? array->size() : 0;
}

Result<std::uint64_t> to_unsigned(const Json& value, std::uint64_t max, const Error& otherwise) noexcept {
  if (!value.is_number_integer()) return otherwise;
  if (!value.is_number_unsigned() && value.get<std::int64_t>() < 0) return otherwise;
  const auto number = value.get<std::uint64_t>();
  if (number > max) return otherwise;
  return number;
}

Result<std::uint64_t> unsigned_member(const Json& object, const char* key, std::uint64_t fallback,
                                      std::uint64_t max, const Error& otherwise) noexcept {
  const Json* value = find(object, key);
  if (!value) return fallback;
  return to_unsigned(*value, max, otherwise);
}

}  // namespace deltamesh::gltf
