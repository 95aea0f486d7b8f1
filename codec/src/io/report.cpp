// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>

#include "deltamesh/io.h"

namespace deltamesh {

std::string_view word_of(LeftOutKind kind) noexcept {
  constexpr std::array<std::string_view, 8> kWords{"vertex_values", "face_values", "faces",     "primitives",
                                                   "elements",      "names",       "precision", "guesses"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string describe(const LeftOut& entry) {
  constexpr std::array<const char*, 8> kPhrases{"vertex values ", "face values ", "faces ",   "", "",
                                                "names of ",      "digits of ",   "guessed: "};
  std::string text = kPhrases[static_cast<std::size_t>(entry.kind)];
  // Names are a file's bytes.
  for (const char c : entry.name) text += static_cast<unsigned char>(c) < ' ' || c == 0x7f ? '?' : c;
  if (entry.count != 1) text += " (" + std::to_string(entry.count) + ')';
  return text;
}

void LossReport::leave_out(LeftOutKind kind, std::string_view name, std::uint64_t count) {
  // Names are a file's: there may be as many as it has lines.
  constexpr std::size_t kMostEntries = 64;
  if (count == 0) return;
  if (left_out.size() >= kMostEntries) name = "others";
  const auto known = std::find_if(left_out.begin(), left_out.end(), [&](const LeftOut& entry) {
    return entry.kind == kind && entry.name == name;
  });
  if (known != left_out.end())
    known->count += count;
  else
    left_out.push_back({kind, std::string(name), count});
}

}  // namespace deltamesh
