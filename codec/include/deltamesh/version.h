// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Two version numbers: the library's (semantic) and the stream format's.
#pragma once

#include <cstdint>

namespace deltamesh {

inline constexpr int kLibraryVersionMajor = 0;
inline constexpr int kLibraryVersionMinor = 1;
inline constexpr int kLibraryVersionPatch = 0;
inline constexpr const char* kLibraryVersion = "0.1.0";

inline constexpr std::uint8_t kFormatMajor = 1;
inline constexpr std::uint8_t kFormatMinor = 0;
/// Revision of the unreleased format; a decoder reads its own draft only. 0 once version 1.0 is declared
/// [HDR-3].
inline constexpr std::uint16_t kFormatDraft = 26;

}  // namespace deltamesh
