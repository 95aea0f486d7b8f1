// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// URIs of external and embedded buffers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace deltamesh::gltf {

bool is_data_uri(std::string_view uri) noexcept;

/// The bytes of a base64 data URI; nothing where it is another kind or malformed.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri);

/// The path that a relative URI names, percent-decoded; nothing where it is absolute, has a scheme, steps
/// upwards or is malformed.
std::optional<std::string> path_of_uri(std::string_view uri);

/// A relative URI for the file name `name`.
std::string uri_of_name(std::string_view name);

}  // namespace deltamesh::gltf
