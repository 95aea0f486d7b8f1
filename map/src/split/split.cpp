// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/split.h"

#include <algorithm>

#include "base/guard.h"
#include "base/try.h"
#include "split/assemble.h"
#include "split/copies.h"
#include "split/layout.h"
#include "split/options.h"
#include "split/stored_block.h"

namespace deltamesh {

Result<std::vector<MapPart>> split(const MeshView& mesh, const MapDescription& description,
                                   const SplitOptions& options) noexcept {
  return guarded([&]() -> Result<std::vector<MapPart>> {
    DELTAMESH_CHECK(validate(description));
    DELTAMESH_CHECK(check_options(options));
    DELTAMESH_TRY(const Mesh moved, to_map(mesh, description));
    const StoredBlocks blocks = blocks_of(moved, description);
    const Layout layout = lay_out(blocks, description, options);
    std::vector<MapPart> parts;
    for (const LaidPart& part : layout.parts) parts.push_back(assemble(part.key, part.blocks, part.border));
    for (const auto& [key, copy] : make_copies(layout, description, options, {}))
      if (copy.is_part) parts.push_back(part_of(key, copy));
    std::ranges::sort(parts, {}, &MapPart::key);
    return parts;
  });
}

}  // namespace deltamesh
