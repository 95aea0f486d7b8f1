// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What reading needs of zstd. A small decoder leaves it to another module (web/wasm).
#pragma once

#include <cstddef>
#include <span>

namespace deltamesh {

/// Expands `frame` into all of `expanded`. False where it is not one frame of zstd's [RFC 8878] of just that
/// content size.
bool expand_frame(std::span<const std::byte> frame, std::span<std::byte> expanded) noexcept;

}  // namespace deltamesh
