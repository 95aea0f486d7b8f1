// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// KHR_mesh_quantization: whether an asset still needs it.
#pragma once

#include "io/gltf/document.h"

namespace deltamesh::gltf {

/// Removes the name KHR_mesh_quantization from the lists of extensions where all attributes of primitives
/// have types that core glTF allows.
void drop_needless_quantization(Document& document);

}  // namespace deltamesh::gltf
