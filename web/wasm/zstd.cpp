// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `zstd`, for what zstd coded.
#include "entropy/zstd_frame.h"
#include "part.h"

namespace deltamesh::web {

DELTAMESH_EXPORT(expand_frame)
bool expand_frame_here(std::span<const std::byte> frame, std::span<std::byte> expanded) {
  return expand_frame(frame, expanded);
}

}  // namespace deltamesh::web
