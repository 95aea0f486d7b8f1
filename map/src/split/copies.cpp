// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/copies.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "split/assemble.h"
#include "split/simplify.h"
#include "support/content_hash.h"

namespace deltamesh {
namespace {

/// The error of simplification, of a cell's edge: what is a pixel or two where the cell fills a view.
constexpr double kErrorOfEdge = 1.0 / 64;
/// Too many triangles are made fewer with twice the error, so many times.
constexpr int kMostDoublings = 3;

struct Sources {
  std::vector<const StoredBlock*> blocks;
  ContentHash hash;
};

/// The cell of level `level` that a part is in; a part of that level or above is where it is.
PartKey cell_on(const PartKey& part, std::uint8_t level) noexcept {
  return part.level < level ? ancestor(part, level) : part;
}

/// For every cell of `level` that holds parts of lower ones: the positions that faces outside of it have too.
std::map<PartKey, std::vector<BorderPosition>> borders_on(const Layout& layout, std::uint8_t level) {
  std::map<PartKey, std::vector<BorderPosition>> borders;
  std::set<PartKey> cells;
  for (auto first = layout.uses.begin(); first != layout.uses.end();) {
    cells.clear();
    auto use = first;
    for (; use != layout.uses.end() && use->position == first->position; ++use)
      cells.insert(cell_on(layout.parts[use->part].key, level));
    if (cells.size() > 1)
      for (const PartKey& cell : cells) borders[cell].push_back({first->position, first->point, first->twin});
    first = use;
  }
  for (auto& [cell, border] : borders) std::ranges::sort(border);
  return borders;
}

/// What the cells of a level are made from.
std::map<PartKey, Sources> sources_on(std::uint8_t level, const Layout& layout, const Copies& copies) {
  const auto below = static_cast<std::uint8_t>(level - 1);
  std::map<PartKey, Sources> sources;
  for (const auto& [key, copy] : copies) {
    if (key.level != below) continue;
    Sources& cell = sources[ancestor(key, level)];
    cell.blocks.push_back(&copy.block);
    cell.hash.add(std::span(&copy.block.hash, 1));
  }
  for (const LaidPart& part : layout.parts) {
    if (part.key.level != below) continue;
    Sources& cell = sources[ancestor(part.key, level)];
    for (const StoredBlock* block : part.blocks) {
      cell.blocks.push_back(block);
      cell.hash.add(std::span(&block->hash, 1));
    }
  }
  return sources;
}

Copy make_copy(const PartKey& key, const Sources& sources, std::vector<BorderPosition> border,
               const MapDescription& description, const SplitOptions& options) {
  const double edge = std::ldexp(description.cell_steps * description.lattice.step(), key.level);
  const MapPart whole = assemble(key, sources.blocks, border);
  MapPart coarse;
  for (int i = 0; i <= kMostDoublings; ++i) {
    coarse = simplify(whole, std::ldexp(kErrorOfEdge * edge, i));
    if (coarse.mesh.triangle_count() <= options.most_triangles) break;
  }
  Copy copy{.border = std::move(border)};
  const std::size_t triangles = coarse.mesh.triangle_count();
  copy.is_part = triangles > 0 && triangles <= options.most_triangles;
  copy.block = store_block(std::move(coarse.mesh));
  return copy;
}

}  // namespace

Copies make_copies(const Layout& layout, const MapDescription& description, const SplitOptions& options,
                   const Copies& known) {
  Copies copies;
  for (std::uint8_t level = 1; level <= options.copy_level; ++level) {
    auto borders = borders_on(layout, level);
    Copies made;
    for (auto& [key, sources] : sources_on(level, layout, copies)) {
      std::vector<BorderPosition>& border = borders[key];
      sources.hash.add(std::span<const BorderPosition>(border));
      const std::uint64_t hash = sources.hash.digest();
      const auto before = known.find(key);
      Copy& copy = made[key];
      copy = before != known.end() && before->second.hash == hash
                 ? before->second
                 : make_copy(key, sources, std::move(border), description, options);
      copy.hash = hash;
    }
    copies.merge(made);
  }
  return copies;
}

MapPart part_of(const PartKey& key, const Copy& copy) {
  const StoredBlock* block = &copy.block;
  return assemble(key, std::span(&block, 1), copy.border);
}

}  // namespace deltamesh
