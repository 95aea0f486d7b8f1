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

/// Builds the value that a text stands for. Json::parse() tells errors by exceptions, which WebAssembly does
/// not have.
class Builder final : public nlohmann::json_sax<Json> {
 public:
  Json root;
  Error error;

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // no text has any
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool key(string_t& name) override {
    member_ = &(*open_.back())[name];
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& cause) override {
    constexpr int kNumberTooLarge = 406;
    const bool too_large = cause.id == kNumberTooLarge;
    error = text_error(ErrorCode::kInvalidFile,
                       too_large ? "a number in the JSON is too large" : "not valid JSON", position);
    return false;
  }

 private:
  Json& place() {
    if (open_.empty()) return root;
    return open_.back()->is_array() ? open_.back()->emplace_back() : *member_;
  }
  bool add(Json value) {
    place() = std::move(value);
    return true;
  }
  bool open(Json value) {
    Json& there = place();
    there = std::move(value);
    open_.push_back(&there);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<Json*>
      open_;                ///< objects and arrays around; they get no more elements while one inside is open
  Json* member_ = nullptr;  ///< of the innermost object
};

}  // namespace

Result<Json> parse_json(std::span<const std::byte> text) {
  if (auto checked = check_limits(text); !checked) return checked.error();
  const char* begin = reinterpret_cast<const char*>(text.data());
  Builder builder;
  if (!Json::sax_parse(begin, begin + text.size(), &builder)) return builder.error;
  return std::move(builder.root);
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
