// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Leaves only what an asset uses: drops unused buffer views and bytes, and makes one buffer of all.
#pragma once

#include "deltamesh/result.h"
#include "io/gltf/document.h"

namespace deltamesh::gltf {

/// Afterwards buffers[0] holds every byte that a used view (or an extension's object with a member "buffer")
/// covers, in one copy, at the same address modulo 8 as before; opaque buffers follow. Views are renumbered
/// where they are named by a member "bufferView"; those that an unknown extension may mean otherwise keep
/// number and content. Errors: kInvalidFile.
Result<void> compact_document(Document& document);

}  // namespace deltamesh::gltf
