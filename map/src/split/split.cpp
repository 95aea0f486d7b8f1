// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/split.h"

#include <algorithm>
#include <limits>

#include "base/guard.h"
#include "base/try.h"
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
    Layout layout(description, options);
    layout.update(blocks_of(moved, description));
    std::vector<MapPart> parts;
    for (const PartKey& key : layout.parts()) parts.push_back(layout.part(key));
    Copies copies;
    CopyMaker maker(layout, description, options, 0, std::numeric_limits<std::uint64_t>::max(), copies);
    for (const PartKey& key : layout.parts())
      for (int level = key.level + 1; level <= options.copy_level; ++level)
        maker.make(ancestor(key, static_cast<std::uint8_t>(level)));
    for (const auto& [key, copy] : copies)
      if (copy.is_part) parts.push_back(part_of(key, copy));
    std::ranges::sort(parts, {}, &MapPart::key);
    return parts;
  });
}

}  // namespace deltamesh
