// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Frames of zstd's for `core`: the module `zstd` expands them.
#include "entropy/zstd_frame.h"
#include "part.h"

namespace deltamesh {
namespace web {

DELTAMESH_OF_PART(zstd, expand_frame)
bool expand_frame_there(std::span<const std::byte> frame, std::span<std::byte> expanded);

}  // namespace web

bool expand_frame(std::span<const std::byte> frame, std::span<std::byte> expanded) noexcept {
  return web::expand_frame_there(frame, expanded);
}

}  // namespace deltamesh
