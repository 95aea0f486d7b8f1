// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Four-character chunk tags [DIR-2].
#pragma once

#include <cstdint>

namespace deltamesh {

constexpr std::uint32_t chunk_tag(const char (&text)[5]) noexcept {
  std::uint32_t tag = 0;
  for (unsigned i = 0; i < 4; ++i)
    tag |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) << (8 * i);
  return tag;
}

inline constexpr std::uint32_t kTagConnectivity = chunk_tag("CONN");
inline constexpr std::uint32_t kTagSeams = chunk_tag("SEAM");
inline constexpr std::uint32_t kTagFaceGroups = chunk_tag("FGRP");
inline constexpr std::uint32_t kTagOrder = chunk_tag("ORDR");
inline constexpr std::uint32_t kTagDeltas = chunk_tag("DELT");
inline constexpr std::uint32_t kTagAnchors = chunk_tag("ANCH");
inline constexpr std::uint32_t kTagPositions = chunk_tag("POSN");
inline constexpr std::uint32_t kTagGrid = chunk_tag("GRID");
inline constexpr std::uint32_t kTagAttribute = chunk_tag("ATTR");
inline constexpr std::uint32_t kTagGroupNames = chunk_tag("NAMe");
inline constexpr std::uint32_t kTagExtent = chunk_tag("SIZe");
inline constexpr std::uint32_t kTagFiller = chunk_tag("FILl");

}  // namespace deltamesh
