// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/layout.h"

#include <span>
#include <utility>

#include "split/octree.h"
#include "support/content_hash.h"

namespace deltamesh {
namespace {

std::uint64_t hash_of_part(const LaidPart& part) {
  static_assert(sizeof(BorderPosition) == 28);  // nothing between members that has no value
  ContentHash hash;
  for (const StoredBlock* block : part.blocks) hash.add(std::span(&block->hash, 1));
  hash.add(std::span<const BorderPosition>(part.border));
  return hash.digest();
}

}  // namespace

Layout lay_out(const StoredBlocks& blocks, const MapDescription& description, const SplitOptions& options) {
  BlockLists lists;
  for (const auto& [cell, key] :
       parts_of_cells(triangle_counts(blocks), options.most_triangles, options.most_level))
    lists[key].push_back(&blocks.at(cell));
  return lay_out(lists, description);
}

Layout lay_out(const BlockLists& lists, const MapDescription& description) {
  Layout layout;
  BorderTable table(description.lattice);
  for (const auto& [key, list] : lists) {
    const auto number = static_cast<std::uint32_t>(layout.parts.size());
    for (const StoredBlock* block : list) table.add(block->mesh, number);
    layout.parts.push_back({key, list, {}, 0});
  }
  layout.uses = table.finish();
  auto borders = borders_of_parts(layout.uses, layout.parts.size());
  for (std::size_t i = 0; i < layout.parts.size(); ++i) {
    layout.parts[i].border = std::move(borders[i]);
    layout.parts[i].hash = hash_of_part(layout.parts[i]);
  }
  return layout;
}

}  // namespace deltamesh
