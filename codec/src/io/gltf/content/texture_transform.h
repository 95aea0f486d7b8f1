// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What materials do to texture coordinates.
#pragma once

#include "io/gltf/json.h"

namespace deltamesh::gltf {

/// The largest factor by which KHR_texture_transform stretches the primitive's texture coordinates, at least
/// 1: over all textures of the materials that the primitive or an extension of it names. `json`: the asset's.
double uv_scale_of(const Json& json, const Json& primitive);

}  // namespace deltamesh::gltf
