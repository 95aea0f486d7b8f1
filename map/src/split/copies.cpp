// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/copies.h"

#include <algorithm>
#include <array>
#include <cmath>
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

static_assert(sizeof(BorderPosition) == 28);  // nothing between members that has no value

struct Sources {
  std::vector<const StoredBlock*> blocks;
  ContentHash hash;
};

/// What a copy is made from: the copies and the parts one level below.
Sources sources_of(const PartKey& cell, const Layout& layout, const Copies& copies) {
  Sources sources;
  const auto add = [&](const StoredBlock& block) {
    sources.blocks.push_back(&block);
    sources.hash.add(std::span(&block.hash, 1));
  };
  const std::array<PartKey, 8> below = children_of(cell);
  for (const PartKey& key : below)
    if (const auto copy = copies.find(key); copy != copies.end()) add(copy->second.block);
  for (const PartKey& key : below)
    if (layout.parts().contains(key))
      for (const StoredBlock* block : layout.blocks_in(key)) add(*block);
  return sources;
}

Copy make_copy(const PartKey& key, const Sources& sources, std::vector<BorderPosition> border,
               const MapDescription& description, const SplitOptions& options) {
  const double error = simplification_error(key, description);
  const MapPart whole = assemble(key, sources.blocks, border);
  MapPart coarse;
  for (int i = 0; i <= kMostDoublings; ++i) {
    coarse = simplify(whole, std::ldexp(error, i));
    if (coarse.mesh.triangle_count() <= options.most_triangles) break;
  }
  Copy copy{.border = std::move(border)};
  const std::size_t triangles = coarse.mesh.triangle_count();
  copy.is_part = triangles > 0 && triangles <= options.most_triangles;
  copy.block = store_block(std::move(coarse.mesh));
  return copy;
}

}  // namespace

double simplification_error(const PartKey& cell, const MapDescription& description) noexcept {
  return kErrorOfEdge * std::ldexp(description.cell_steps * description.lattice.step(), cell.level);
}

OutdatedCopies outdate_copies(const std::set<PartKey>& touched, const Layout& layout, Copies& copies) {
  OutdatedCopies outdated;
  std::set<PartKey> cells;
  if (!copies.empty())
    for (const PartKey& key : touched)
      for (int level = std::max<int>(key.level, 1); level <= copies.rbegin()->first.level; ++level)
        cells.insert(ancestor(key, static_cast<std::uint8_t>(level)));
  for (const PartKey& cell : cells) {
    const auto known = copies.find(cell);
    if (known == copies.end()) continue;
    Copy& copy = known->second;
    if (!layout.is_above_parts(cell)) {
      if (copy.is_part) outdated.removed.push_back(cell);
      copies.erase(known);
      continue;
    }
    if (copy.is_told) outdated.outdated.push_back(cell);
    copy.is_newest = copy.is_told = false;
  }
  return outdated;
}

Copy* CopyMaker::make(const PartKey& cell) {
  const auto known = copies_.find(cell);
  if (known != copies_.end() && known->second.is_newest) return &known->second;
  if (cell.level > 1)
    for (const PartKey& below : children_of(cell))
      if (layout_.is_above_parts(below) && make(below) == nullptr) return nullptr;
  if (seen_ > 0 && seen_ >= most_triangles_) return nullptr;
  Sources sources = sources_of(cell, layout_, copies_);
  std::vector<BorderPosition> border = layout_.border_of(cell);
  sources.hash.add(std::span<const BorderPosition>(border));
  const std::uint64_t hash = sources.hash.digest();
  if (known != copies_.end() && known->second.hash == hash) {
    known->second.is_newest = true;
    return &known->second;
  }
  for (const StoredBlock* block : sources.blocks) seen_ += block->mesh.triangle_count();
  Copy copy = make_copy(cell, sources, std::move(border), description_, options_);
  copy.hash = hash;
  copy.revision = revision_;
  return &copies_.insert_or_assign(cell, std::move(copy)).first->second;
}

MapPart part_of(const PartKey& key, const Copy& copy) {
  const StoredBlock* block = &copy.block;
  return assemble(key, std::span(&block, 1), copy.border);
}

}  // namespace deltamesh
