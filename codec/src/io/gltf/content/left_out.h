// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a mesh cannot hold of an asset.
#pragma once

#include "deltamesh/io.h"
#include "io/gltf/json.h"

namespace deltamesh::gltf {

/// Tells `report` of materials (their names are kept), textures, skins, animations, cameras, lights and morph
/// targets.
void leave_out_parts(const Json& json, ReadReport& report);

}  // namespace deltamesh::gltf
