// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Base64 of RFC 4648, as data URIs use it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace deltamesh::gltf {

/// Nothing where `text` holds another character, or a length that no bytes have. Padding may be absent.
std::optional<std::vector<std::byte>> decode_base64(std::string_view text);

/// With padding.
std::string encode_base64(std::span<const std::byte> bytes);

}  // namespace deltamesh::gltf
