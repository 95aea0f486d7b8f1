// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/uri.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace deltamesh::gltf {
namespace {

/// 0 to 63, or -1.
int base64_value(char c) noexcept {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

int hex_value(char c) noexcept {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// A percent sign that begins no escape stands for itself, as viewers read it.
std::string percent_decoded(std::string_view uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape =
        uri[i] == '%' && i + 2 < uri.size() && hex_value(uri[i + 1]) >= 0 && hex_value(uri[i + 2]) >= 0;
    decoded += escape ? static_cast<char>(hex_value(uri[i + 1]) * 16 + hex_value(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return decoded;
}

}  // namespace

std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri) {
  constexpr std::string_view kMarker = ";base64,";
  const std::size_t marker = uri.substr(0, 256).find(kMarker);
  if (!uri.starts_with("data:") || marker == uri.npos) return std::nullopt;
  std::string_view text = uri.substr(marker + kMarker.size());
  std::string decoded;  // RFC 2397: the data may have escapes, such as %3D
  if (text.find('%') != text.npos) text = decoded = percent_decoded(text);
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int value = base64_value(c);
    if (value < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffff;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> held & 0xff));
  }
  return bytes;
}

std::optional<std::string> relative_path_of(std::string_view uri) {
  if (uri.find(':') != uri.npos) return std::nullopt;  // a scheme; as part of a name it would be %3A
  std::string path = percent_decoded(uri);
  if (path.empty() || path.front() == '/') return std::nullopt;
  for (const char c : path)
    if (c == '\\' || static_cast<unsigned char>(c) < ' ') return std::nullopt;
  for (std::size_t begin = 0; begin <= path.size();) {
    std::size_t end = path.find('/', begin);
    if (end == path.npos) end = path.size();
    if (std::string_view(path).substr(begin, end - begin) == "..") return std::nullopt;
    begin = end + 1;
  }
  return path;
}

std::string data_uri_of(std::span<const std::byte> bytes) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:application/octet-stream;base64,";
  text.reserve(text.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kAlphabet[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
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

std::vector<std::string> relative_uris(const Json& json) {
  std::vector<std::string> uris;
  for_each_object(json, [&](const Json& object, std::string_view) {
    const Json* uri = find(object, "uri");
    if (!uri || !uri->is_string()) return;
    const auto& text = uri->get_ref<const std::string&>();
    if (text.find(':') == text.npos) uris.push_back(text);
  });
  return uris;
}

std::vector<std::string> named_files(const Json& json) {
  std::vector<std::string> files;
  for (const std::string& uri : relative_uris(json))
    if (auto path = relative_path_of(uri)) files.push_back(*std::move(path));
  return files;
}

}  // namespace deltamesh::gltf
