// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// JSON files that the program reads, with every value checked: what is wrong is told with the value's name
// and what is allowed there.
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace deltamesh::cli {

/// Thrown by JsonValue, for read_json() alone.
class WrongJson : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A value of a file. All members throw WrongJson where the value is another one than asked for. The file's
/// JSON must outlive it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& json, std::string name) : json_(&json), name_(std::move(name)) {}

  /// Of an object.
  JsonValue member(const char* key) const;
  std::optional<JsonValue> optional_member(const char* key) const;
  /// Of an array.
  std::vector<JsonValue> items() const;
  /// Of an array with so many items.
  std::vector<JsonValue> items(std::size_t count) const;

  template <std::integral Number>
  Number whole(Number least = std::numeric_limits<Number>::min(),
               Number most = std::numeric_limits<Number>::max()) const;
  /// From 0 to `most`.
  double number(double most = std::numeric_limits<double>::max()) const;
  std::string text() const;
  bool flag() const;

  /// Throws. `allowed`: "a number above 0".
  [[noreturn]] void refuse(const std::string& allowed) const;

 private:
  const nlohmann::json* json_;
  std::string name_;  ///< such as "tiles[3].cell"; empty: the whole file
};

template <std::integral Number>
Number JsonValue::whole(Number least, Number most) const {
  const bool is_negative = json_->is_number_integer() && !json_->is_number_unsigned();
  const bool fits =
      json_->is_number_integer() && (is_negative ? std::in_range<Number>(json_->get<std::int64_t>())
                                                 : std::in_range<Number>(json_->get<std::uint64_t>()));
  if (fits && json_->get<Number>() >= least && json_->get<Number>() <= most) return json_->get<Number>();
  refuse("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

/// Whether JSON can hold the text: it is UTF-8.
bool fits_json(const std::string& text);

/// Reads the file at `path` and calls `read` with what it holds. Returns what is wrong, of the file or of
/// what `read` found; empty where nothing is.
std::string read_json(const std::string& path, const std::function<void(const JsonValue&)>& read);

}  // namespace deltamesh::cli
