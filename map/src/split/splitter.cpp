// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/guard.h"
#include "base/try.h"
#include "base/union_find.h"
#include "deltamesh/map/split.h"
#include "split/copies.h"
#include "split/layout.h"
#include "split/options.h"
#include "split/stored_block.h"
#include "support/at_block.h"

namespace deltamesh {

struct Splitter::State {
  State(MapDescription d, const SplitOptions& o)
      : description(std::move(d)), options(o), layout(description, o) {}

  MapDescription description;
  SplitOptions options;
  Layout layout;
  Copies copies{};
  std::uint64_t revision = 0;
  std::uint64_t next_group = 0;
  bool is_broken = false;  ///< an update ended for want of memory
};

namespace {

/// By cell; those without triangles are to go.
Result<StoredBlocks> checked(std::span<const MapBlock> update, const MapDescription& description) {
  StoredBlocks blocks;
  for (const MapBlock& block : update) {
    const auto [place, is_new] = blocks.try_emplace(block.cell);
    if (!is_new)
      return at_block({.code = ErrorCode::kInvalidArgument, .message = "an update has a cell twice"}, block);
    if (block.mesh.triangles.empty()) continue;
    auto mesh = to_map(block.mesh, description);
    if (!mesh) return at_block(mesh.error(), block);
    place->second = store_block(*std::move(mesh));
  }
  return blocks;
}

/// Pairs of parts, the lower key first.
using PartPairs = std::set<std::pair<PartKey, PartKey>>;

struct GroupNumbers {
  std::map<PartKey, std::uint64_t> numbers;  ///< of all parts that changed or went
  std::uint64_t next = 0;
};
/// Two parts of those that changed or went are in one group where their common border is not as before
/// (`pairs`), or where the cell of one that went overlaps the other's. Groups are numbered from `next` on, by
/// their first keys.
GroupNumbers group_changes(const std::set<PartKey>& changed, const std::set<PartKey>& removed,
                           const PartPairs& pairs, std::uint64_t next) {
  std::vector<PartKey> keys;
  std::ranges::set_union(changed, removed, std::back_inserter(keys));
  UnionFind sets(keys.size());
  const auto place = [&](const PartKey& key) {
    const auto found = std::ranges::lower_bound(keys, key);
    return found != keys.end() && *found == key ? static_cast<std::size_t>(found - keys.begin())
                                                : keys.size();
  };
  for (const auto& [first, second] : pairs) {
    const std::size_t a = place(first);
    const std::size_t b = place(second);
    if (a < keys.size() && b < keys.size()) sets.unite(a, b);
  }
  for (const PartKey& key : removed)
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (overlap(key, keys[i])) sets.unite(place(key), i);

  GroupNumbers groups{.numbers = {}, .next = next};
  std::map<std::size_t, std::uint64_t> numbers;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto [number, is_new] = numbers.try_emplace(sets.find(i), groups.next);
    if (is_new) ++groups.next;
    groups.numbers[keys[i]] = number->second;
  }
  return groups;
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
    return Splitter(std::make_unique<State>(std::move(description), options));
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
    if (state.is_broken)
      return Error{.code = ErrorCode::kOutOfMemory,
                   .message = "an earlier update ran out of memory: make a new splitter"};
    DELTAMESH_TRY(StoredBlocks blocks, checked(update, state.description));
    state.is_broken = true;
    const LayoutChange laid = state.layout.update(std::move(blocks));
    const OutdatedCopies copies = outdate_copies(laid.touched, state.layout, state.copies);
    std::set<PartKey> removed = laid.removed;
    removed.insert(copies.removed.begin(), copies.removed.end());
    for (const PartKey& key : laid.changed) removed.erase(key);  // copies become parts
    const GroupNumbers groups = group_changes(laid.changed, removed, laid.pairs, state.next_group);

    MapChange change;
    const std::uint64_t revision = ++state.revision;
    for (const PartKey& key : laid.changed)
      change.changed.push_back({revision, groups.numbers.at(key), state.layout.part(key)});
    for (const PartKey& key : removed) change.removed.push_back({key, revision, groups.numbers.at(key)});
    change.outdated = copies.outdated;
    state.next_group = groups.next;
    state.is_broken = false;
    return change;
  });
}

Result<MadeCopies> Splitter::make_copies(std::span<const PartKey> cells,
                                         std::uint64_t most_triangles) noexcept {
  return guarded([&]() -> Result<MadeCopies> {
    State& state = *state_;
    CopyMaker maker(state.layout, state.description, state.options, state.revision, most_triangles,
                    state.copies);
    MadeCopies made;
    for (const PartKey& cell : cells) {
      const bool has_one = cell.level <= state.options.copy_level && state.layout.is_above_parts(cell);
      Copy* const copy = has_one ? maker.make(cell) : nullptr;
      if (has_one && copy == nullptr) break;
      ++made.done;
      if (!has_one || !copy->is_part || copy->is_told) continue;
      made.copies.push_back({copy->revision, state.next_group++, part_of(cell, *copy)});
      copy->is_told = true;
    }
    return made;
  });
}

}  // namespace deltamesh
