// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "base/broken_rule.h"
#include "base/byte_reader.h"
#include "base/try.h"
#include "connectivity/groups/groups.h"
#include "connectivity/plain_forms.h"
#include "entropy/planes.h"
#include "format/chunk/tags.h"

namespace deltamesh {

Result<std::vector<std::uint32_t>> read_plain_groups(std::span<const std::byte> bytes,
                                                     std::uint32_t triangle_count) {
  ByteReader in(bytes, kTagFaceGroups);
  DELTAMESH_TRY(std::vector<std::uint32_t> groups, read_planes(in, triangle_count));
  DELTAMESH_CHECK(in.finish());
  if (std::any_of(groups.begin(), groups.end(), [](std::uint32_t g) { return g >= kMostGroups; }))
    return broken_rule("not the number of a group of faces", "FGRP-1", kTagFaceGroups);
  return groups;
}

}  // namespace deltamesh
