// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Hands an OBJ file to a stream reader one line at a time, so that a callback knows which line it stands in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <streambuf>
#include <string>
#include <string_view>

namespace deltamesh {

/// A stream buffer whose get area is always exactly one logical line, ended by LF: lines that end in a
/// backslash are joined with the next. A reader that asks for the next line only when it is done with this
/// one sees line() and text() of the line it is working on.
class ObjLines : public std::streambuf {
 public:
  explicit ObjLines(std::string_view text) noexcept : rest_(text) {}

  /// Number of the present line (the last of joined ones), from 1.
  std::uint64_t line() const noexcept { return line_; }
  /// Without its end.
  std::string_view text() const noexcept { return std::string_view(buffer_).substr(0, buffer_.size() - 1); }
  /// Lines and points met so far ("l ...", "p ...").
  std::uint64_t other_primitives() const noexcept { return other_primitives_; }

 protected:
  int_type underflow() override;

 private:
  /// Appends the next physical line to the buffer, without its end.
  void append_line();

  std::string_view rest_;
  std::string buffer_{"\n"};
  std::uint64_t line_ = 0;
  std::uint64_t other_primitives_ = 0;
};

}  // namespace deltamesh
