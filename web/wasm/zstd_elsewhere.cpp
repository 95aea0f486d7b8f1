// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Frames of zstd's for `core`: the module `zstd` expands them.
#include "entropy/zstd_frame.h"
#include "parts.h"

namespace deltamesh {

bool expand_frame(std::span<const std::byte> frame, std::span<std::byte> expanded) noexcept {
  const web::ZstdCall call{.expanded_bytes = static_cast<std::uint32_t>(expanded.size()),
                           .frame = web::hand_over(web::Part::kZstd, frame)};
  const auto returned = web::call_part(web::Part::kZstd, call);
  if (!returned || returned->count == 0) return false;
  take(web::Part::kZstd, expanded.data(), returned->arrays[0].address, expanded.size());
  return true;
}

}  // namespace deltamesh
