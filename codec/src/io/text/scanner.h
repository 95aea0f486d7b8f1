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

/// UTF-8's byte order mark.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The bytes as text, without the zeros that some programs leave at the end; they must outlive the view.
inline std::string_view as_text(std::span<const std::byte> bytes) noexcept {
  while (!bytes.empty() && bytes.back() == std::byte{0}) bytes = bytes.first(bytes.size() - 1);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Tokens are separated by blanks and line ends (LF, CR LF or CR); a byte order mark in front is no part
/// of the text. Never reads past the end; every call is linear in what it passes over.
class TextScanner {
 public:
  struct Syntax {
    bool hash_comments =
        false;  ///< a '#' in front of a token hides the rest of its line; inside a token it is a letter
    bool joined_lines = false;  ///< a backslash at the end of a line joins it with the next
  };

  TextScanner(std::string_view text, Syntax syntax, std::uint64_t first_line = 1) noexcept;

  /// The next token on any line; empty at the end of the text.
  std::string_view next_token() noexcept;
  /// The next token on this line; empty at its end.
  std::string_view next_token_on_line() noexcept;

  /// The next token as a number. Errors: kInvalidFile: end of the text, not a number.
  Result<double> read_number() noexcept;
  /// The next token as an integer from 0 to `max`. Errors: kInvalidFile.
  Result<std::uint64_t> read_count(std::uint64_t max) noexcept;
  /// Errors: kInvalidFile with `message`: there is another token on this line.
  Result<void> end_line(const char* message) noexcept;

  std::size_t remaining() const noexcept { return text_.size() - position_; }
  std::uint64_t line() const noexcept { return line_; }
  /// An error on this line. `found`: the text at fault.
  Error error(const char* message, std::string_view found = {}) const noexcept;

 private:
  void skip_blanks(bool across_lines) noexcept;
  std::string_view take_token() noexcept;
  bool is_joint() const noexcept;

  std::string_view text_;
  std::size_t position_ = 0;
  std::uint64_t line_ = 1;
  Syntax syntax_;
};

}  // namespace deltamesh
