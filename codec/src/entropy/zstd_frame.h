// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Expands zstd frames. A small decoder leaves this to another module (web/wasm).
#pragma once

#include <cstddef>
#include <span>

namespace deltamesh {

/// Expands `frame` into `expanded`. False unless it is exactly one zstd frame [RFC 8878] whose content fills
/// `expanded`.
bool expand_frame(std::span<const std::byte> frame, std::span<std::byte> expanded) noexcept;

}  // namespace deltamesh
