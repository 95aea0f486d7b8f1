// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Walks a text file token by token and knows its line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "deltamesh/result.h"
#include "io/io_error.h"

namespace deltamesh {

/// The bytes as text; they must outlive the view.
inline std::string_view as_text(std::span<const std::byte> bytes) noexcept {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Tokens are separated by blanks and line ends (LF, CR LF or CR). With `hash_comments` a '#' hides the rest
/// of its line. Never reads past the end; every call is linear in what it passes over.
class TextScanner {
 public:
  TextScanner(std::string_view text, bool hash_comments, std::uint64_t first_line = 1) noexcept
      : text_(text), line_(first_line), hash_comments_(hash_comments) {}

  /// The next token on any line; empty at the end of the text.
  std::string_view next_token() noexcept;
  /// The next token on this line; empty at its end.
  std::string_view next_token_on_line() noexcept;
  /// To the end of this line.
  void skip_line() noexcept;

  /// The next token as a number. Errors: kInvalidFile: end of the text, not a number.
  Result<double> read_number() noexcept;
  /// The next token as an integer from 0 to `max`. Errors: kInvalidFile.
  Result<std::uint64_t> read_count(std::uint64_t max) noexcept;

  std::size_t remaining() const noexcept { return text_.size() - position_; }
  std::uint64_t line() const noexcept { return line_; }
  Error error(const char* message) const noexcept { return invalid_line(message, line_); }

 private:
  void skip_blanks(bool across_lines) noexcept;
  std::string_view take_token() noexcept;

  std::string_view text_;
  std::size_t position_ = 0;
  std::uint64_t line_ = 1;
  bool hash_comments_ = false;
};

}  // namespace deltamesh
