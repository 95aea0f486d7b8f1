// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// URIs of glTF buffers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace deltamesh {

/// The bytes of "data:...;base64,...". Nothing where `uri` is no such thing or its base64 is malformed.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri);

/// The relative path that `uri` stands for, percent-decoded. Nothing where it might lead out of the folder:
/// absolute paths, schemes, ".." components, backslashes, control characters.
std::optional<std::string> relative_path_of(std::string_view uri);

}  // namespace deltamesh
