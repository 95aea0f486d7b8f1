// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/obj/lines.h"

namespace deltamesh {

void ObjLines::append_line() {
  const std::size_t end = rest_.find_first_of("\r\n");
  buffer_.append(rest_.substr(0, end));
  const bool pair = end != rest_.npos && rest_.substr(end, 2) == "\r\n";
  rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + (pair ? 2 : 1));
  ++line_;
}

ObjLines::int_type ObjLines::underflow() {
  if (gptr() != nullptr && gptr() < egptr()) return traits_type::to_int_type(*gptr());
  if (rest_.empty()) return traits_type::eof();
  buffer_.clear();
  append_line();
  while (buffer_.ends_with('\\') && !rest_.empty()) {
    buffer_.back() = ' ';
    append_line();
  }
  const std::size_t start = buffer_.find_first_not_of(" \t");
  const std::string_view word = start == buffer_.npos ? "" : std::string_view(buffer_).substr(start, 2);
  if (word == "l " || word == "l\t" || word == "p " || word == "p\t") ++other_primitives_;
  buffer_ += '\n';
  setg(buffer_.data(), buffer_.data(), buffer_.data() + buffer_.size());
  return traits_type::to_int_type(*gptr());
}

}  // namespace deltamesh
