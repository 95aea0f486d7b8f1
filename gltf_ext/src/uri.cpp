// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "uri.h"

#include <algorithm>

#include "base64.h"

namespace deltamesh::gltf {
namespace {

int hex_digit(char c) noexcept {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> percent_decode(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text += uri[i];
      continue;
    }
    if (uri.size() - i < 3 || hex_digit(uri[i + 1]) < 0 || hex_digit(uri[i + 2]) < 0) return std::nullopt;
    text += static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2]));
    i += 2;
  }
  return text;
}

/// True where the path stays in the folder it starts from.
bool stays_below(std::string_view path) noexcept {
  if (path.empty() || path.front() == '/') return false;
  if (path.find('\\') != path.npos || path.find('\0') != path.npos) return false;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    if (path.substr(begin, end - begin) == "..") return false;
    begin = end + 1;
  }
  return true;
}

}  // namespace

bool is_data_uri(std::string_view uri) noexcept { return uri.starts_with("data:"); }

std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri) {
  constexpr std::string_view kMarker = ";base64,";
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == uri.npos) return std::nullopt;
  if (!uri.substr(0, comma + 1).ends_with(kMarker)) return std::nullopt;
  return decode_base64(uri.substr(comma + 1));
}

std::optional<std::string> path_of_uri(std::string_view uri) {
  if (uri.substr(0, uri.find('/')).find(':') != uri.npos) return std::nullopt;
  auto path = percent_decode(uri);
  if (!path || !stays_below(*path)) return std::nullopt;
  return path;
}

std::string uri_of_name(std::string_view name) {
  constexpr std::string_view kPlain = "-._~";
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter || kPlain.find(c) != kPlain.npos) {
      uri += c;
    } else {
      uri += '%';
      uri += kHex[byte >> 4];
      uri += kHex[byte & 15];
    }
  }
  return uri;
}

}  // namespace deltamesh::gltf
