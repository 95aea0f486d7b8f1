// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// URIs that packed assets give their buffers. Reading them is the importer's: io/gltf_uri.h.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace deltamesh::gltf {

/// "data:application/octet-stream;base64,..." (RFC 4648, with padding).
std::string data_uri_of(std::span<const std::byte> bytes);

/// A relative URI for the file name `name`.
std::string uri_of_name(std::string_view name);

}  // namespace deltamesh::gltf
