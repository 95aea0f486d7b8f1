// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Writes a document as the caller wants it stored.
#pragma once

#include "deltamesh/gltf.h"
#include "io/gltf/document.h"

namespace deltamesh::gltf {

inline constexpr const char* kNoMemory = "the asset does not fit into memory";

/// Writes the asset and completes `report` with the sizes before and after. Preconditions: compact_document()
/// ran, check_other_accessors(). Errors: kLimitExceeded.
Result<GltfOutput> save_document(Document document, const GltfIo& io, const GltfReport& report);

}  // namespace deltamesh::gltf
