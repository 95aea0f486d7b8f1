// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/split.h"
#include "split/assemble.h"
#include "split/border_groups.h"
#include "split/copies.h"
#include "split/layout.h"
#include "split/options.h"
#include "split/stored_block.h"

namespace deltamesh {

struct Splitter::State {
  MapDescription description;
  SplitOptions options;
  StoredBlocks blocks;
  std::vector<KnownPart> parts;  ///< as they were told last
  Copies copies;
  SharedBorders borders;  ///< of these
  std::uint64_t revision = 0;
  std::uint64_t next_group = 0;
};

namespace {

/// Names the block: "block x y z", as far as there is room.
Error at_block(Error error, const MapBlock& block) {
  (void)std::snprintf(error.found.data(), error.found.size(), "block %d %d %d", block.cell[0], block.cell[1],
                      block.cell[2]);
  return error;
}

/// `blocks` after the update.
Result<StoredBlocks> updated(StoredBlocks blocks, std::span<const MapBlock> update,
                             const MapDescription& description) {
  std::set<Cell0> seen;
  for (const MapBlock& block : update) {
    if (!seen.insert(block.cell).second)
      return at_block({.code = ErrorCode::kInvalidArgument, .message = "an update has a cell twice"}, block);
    if (block.mesh.triangles.empty()) {
      blocks.erase(block.cell);
      continue;
    }
    auto mesh = to_map(block.mesh, description);
    if (!mesh) return at_block(mesh.error(), block);
    blocks[block.cell] = store_block(*std::move(mesh));
  }
  return blocks;
}

}  // namespace

Splitter::Splitter(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
Splitter::Splitter(Splitter&&) noexcept = default;
Splitter& Splitter::operator=(Splitter&&) noexcept = default;
Splitter::~Splitter() = default;

Result<Splitter> Splitter::make(MapDescription description, const SplitOptions& options) noexcept {
  return guarded([&]() -> Result<Splitter> {
    DELTAMESH_CHECK(validate(description));
    DELTAMESH_CHECK(check_options(options));
    auto state = std::make_unique<State>();
    state->description = std::move(description);
    state->options = options;
    return Splitter(std::move(state));
  });
}

void Splitter::resume(std::uint64_t revision, std::uint64_t group) noexcept {
  state_->revision = revision;
  state_->next_group = group;
}

std::uint64_t Splitter::revision() const noexcept { return state_->revision; }

Result<MapChange> Splitter::update(std::span<const MapBlock> update) noexcept {
  return guarded([&]() -> Result<MapChange> {
    State& state = *state_;
    DELTAMESH_TRY(StoredBlocks blocks, updated(state.blocks, update, state.description));
    const Layout layout = lay_out(blocks, state.description, state.options);
    Copies copies = make_copies(layout, state.description, state.options, state.copies);
    std::vector<KnownPart> parts;
    for (const LaidPart& part : layout.parts) parts.push_back({part.key, part.hash});
    for (const auto& [key, copy] : copies)
      if (copy.is_part) parts.push_back({key, copy.hash});
    std::ranges::sort(parts, {}, &KnownPart::key);
    SharedBorders borders = shared_borders(layout);
    const PartDifference difference = compare_parts(state.parts, parts);
    const GroupNumbers groups = group_changes(difference, state.borders, borders, state.next_group);

    MapChange change;
    const std::uint64_t revision = state.revision + 1;
    for (const LaidPart& part : layout.parts)
      if (const auto group = groups.numbers.find(part.key); difference.changed.contains(part.key))
        change.changed.push_back({revision, group->second, assemble(part.key, part.blocks, part.border)});
    for (const auto& [key, copy] : copies)
      if (copy.is_part && difference.changed.contains(key))
        change.changed.push_back({revision, groups.numbers.at(key), part_of(key, copy)});
    std::ranges::sort(change.changed, {}, [](const ChangedPart& changed) { return changed.part.key; });
    for (const PartKey& key : difference.removed)
      change.removed.push_back({key, revision, groups.numbers.at(key)});
    state.blocks = std::move(blocks);
    state.parts = std::move(parts);
    state.copies = std::move(copies);
    state.borders = std::move(borders);
    state.revision = revision;
    state.next_group = groups.next;
    return change;
  });
}

}  // namespace deltamesh
