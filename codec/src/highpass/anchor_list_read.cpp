// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"
#include "highpass/anchor_list.h"

namespace deltamesh {
Result<AnchorList> read_anchors(std::span<const std::byte> payload, std::uint32_t count) {
  CompactReader reader(payload);
  AnchorList list{.gaps = std::vector<std::uint32_t>(count),
                  .steps = std::vector<std::uint32_t>(3 * std::size_t{count})};
  code_anchors(reader, list);
  DELTAMESH_CHECK(reader.finish(kTagAnchors));
  return list;
}

}  // namespace deltamesh
