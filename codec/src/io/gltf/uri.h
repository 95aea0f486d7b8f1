// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// URIs of buffers and images: from data and file names, and back; those of an asset.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/json.h"

namespace deltamesh::gltf {

/// The bytes of "data:...;base64,...", percent-decoded before. Nothing where `uri` is no such thing or its
/// base64 is malformed.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri);

/// The relative path that `uri` stands for, percent-decoded. Nothing where it might lead out of the folder:
/// absolute paths, schemes, ".." components, backslashes, control characters.
std::optional<std::string> relative_path_of(std::string_view uri);

/// "data:application/octet-stream;base64,..." (RFC 4648, with padding).
std::string data_uri_of(std::span<const std::byte> bytes);

/// A relative URI for the file name `name`.
std::string uri_of_name(std::string_view name);

/// The relative URIs of an asset, as they stand there.
std::vector<std::string> relative_uris(const Json& json);

/// The paths that they stand for, in the asset's folder.
std::vector<std::string> named_files(const Json& json);

}  // namespace deltamesh::gltf
