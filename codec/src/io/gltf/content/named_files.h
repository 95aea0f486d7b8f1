// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Other files that an asset names: buffers, images and the like.
#pragma once

#include <string>
#include <vector>

#include "io/gltf/json.h"

namespace deltamesh::gltf {

/// The relative URIs of an asset, as they stand there.
std::vector<std::string> relative_uris(const Json& json);

/// The paths that they stand for, in the asset's folder.
std::vector<std::string> named_files(const Json& json);

}  // namespace deltamesh::gltf
