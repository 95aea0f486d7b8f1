// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stored/json_value.h"

#include "deltamesh/files.h"
#include "report/console.h"

namespace deltamesh::cli {
namespace {

/// The start of a scalar; of arrays and objects, which may be nested to any depth, what they are.
std::string shown(const nlohmann::json& json) {
  if (json.is_array()) return "an array of " + std::to_string(json.size());
  if (json.is_object()) return "an object";
  constexpr std::size_t kMostShown = 40;
  const std::string text = json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return text.size() > kMostShown ? text.substr(0, kMostShown) + "..." : text;
}

}  // namespace

JsonValue JsonValue::member(const char* key) const {
  if (auto found = optional_member(key)) return *std::move(found);
  throw WrongJson((name_.empty() ? "" : name_ + '.') + key + " is missing");
}

std::optional<JsonValue> JsonValue::optional_member(const char* key) const {
  if (!json_->is_object()) refuse("an object");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return JsonValue(*found, (name_.empty() ? "" : name_ + '.') + key);
}

std::vector<JsonValue> JsonValue::items() const {
  if (!json_->is_array()) refuse("an array");
  std::vector<JsonValue> items;
  for (const auto& item : *json_) items.emplace_back(item, name_ + '[' + std::to_string(items.size()) + ']');
  return items;
}

std::vector<JsonValue> JsonValue::items(std::size_t count) const {
  if (!json_->is_array() || json_->size() != count) refuse("an array of " + std::to_string(count));
  return items();
}

double JsonValue::number(double most) const {
  const double value = json_->is_number() ? json_->get<double>() : -1;
  if (value >= 0 && value <= most) return value;
  refuse(most < std::numeric_limits<double>::max() ? "a number from 0 to " + brief(most)
                                                   : "a finite number of at least 0");
}

std::string JsonValue::text() const {
  if (!json_->is_string()) refuse("a text");
  return json_->get<std::string>();
}

bool JsonValue::flag() const {
  if (!json_->is_boolean()) refuse("true or false");
  return json_->get<bool>();
}

void JsonValue::refuse(const std::string& allowed) const {
  throw WrongJson((name_.empty() ? "the file" : name_) + " is " + shown(*json_) + "; allowed is " + allowed);
}

bool fits_json(const std::string& text) try {
  static_cast<void>(nlohmann::json(text).dump());
  return true;
} catch (const nlohmann::json::type_error&) {
  return false;
}

std::string read_json(const std::string& path, const std::function<void(const JsonValue&)>& read) try {
  const auto bytes = read_file(path);
  if (!bytes) return describe(bytes.error());
  const auto* const first = reinterpret_cast<const char*>(bytes->data());
  const auto json = nlohmann::json::parse(first, first + bytes->size(), nullptr, false);
  if (json.is_discarded()) return "not JSON, or not all of it";
  read(JsonValue(json, {}));
  return {};
} catch (const WrongJson& wrong) {
  return wrong.what();
}

}  // namespace deltamesh::cli
