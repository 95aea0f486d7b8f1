// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/source_map.h"

#include <algorithm>
#include <array>

#include "base/try.h"
#include "lattice/borders_of_links.h"
#include "support/limits.h"
#include "support/overlapping.h"

namespace deltamesh {
namespace {

/// Above all revisions of messages that were sent after the last update that was saved.
constexpr std::uint64_t kRevisionsBetweenStarts = std::uint64_t{1} << 20;

}  // namespace

void SourceMap::resume(std::uint64_t revision, std::uint64_t group) noexcept {
  splitter_.resume(revision + kRevisionsBetweenStarts, group);
  next_group_ = group;
}

const SourcePart* SourceMap::find(const PartKey& key) const noexcept {
  const auto found = parts_.find(key);
  return found == parts_.end() ? nullptr : &found->second;
}

void SourceMap::put(ChangedPart part, std::uint64_t revision, std::set<PartKey>& known_before) {
  const PartKey key = part.part.key;
  table_.put(part.part);
  const auto [place, is_new] = parts_.try_emplace(key);
  if (!is_new) known_before.insert(key);
  place->second.part = std::move(part.part);
  place->second.content_revision = part.revision;
  place->second.revision = revision;
  place->second.is_copy = false;
}

void SourceMap::take_out(const PartKey& key) {
  table_.remove(key);
  parts_.erase(key);
  copies_.erase(key);
}

Result<std::vector<PartKey>> SourceMap::update(std::span<const MapBlock> blocks) {
  DELTAMESH_TRY(MapChange change, splitter_.update(blocks));
  std::set<PartKey> known_before;
  std::set<PartKey> changed;
  std::vector<PartKey> gone;
  for (const RemovedPart& removed : change.removed) {
    gone.push_back(removed.key);
    known_before.insert(removed.key);
    outdated_.erase(removed.key);
    take_out(removed.key);
  }
  for (const PartKey& key : change.outdated) {
    take_out(key);
    outdated_[key] = revision();
  }
  for (ChangedPart& part : change.changed) {
    const PartKey key = part.part.key;
    changed.insert(key);
    copies_.erase(key);
    outdated_.erase(key);
    put(std::move(part), revision(), known_before);
  }
  const std::set<PartKey> touched = table_.take_touched();
  for (const PartKey& key : touched)
    if (parts_.contains(key) && !changed.contains(key)) known_before.insert(key);
  relink(touched, changed, known_before);
  if (copy_level_ > 0) choose_first_sight();
  return gone;
}

Result<bool> SourceMap::make_copies(std::span<const PartKey> cells, std::uint64_t most_triangles) {
  std::vector<PartKey> missing;
  for (const PartKey& key : cells)
    if (!parts_.contains(key)) missing.push_back(key);
  DELTAMESH_TRY(MadeCopies made, splitter_.make_copies(missing, most_triangles));
  for (std::size_t i = 0; i < made.done; ++i) outdated_.erase(missing[i]);
  std::set<PartKey> known_before;
  std::set<PartKey> changed;
  for (ChangedPart& part : made.copies) {
    const PartKey key = part.part.key;
    changed.insert(key);
    copies_.insert(key);
    put(std::move(part), revision(), known_before);
    parts_.at(key).is_copy = true;
  }
  // Its neighbours' borders are as they were: what fits to parts in its cell fits to it.
  relink(table_.take_touched(), changed, {});
  return made.done == missing.size();
}

/// The lowest level whose copies take few bytes beside the map: a copy has about a quarter of the triangles
/// below it, each with four times the bytes, and all vertices of its border. Chosen again as the map grows.
void SourceMap::choose_first_sight() {
  constexpr double kPays = 0.08;
  constexpr double kTriangle = 4;      // bytes, of a triangle's of a part
  constexpr double kBorderVertex = 4;  // so too
  constexpr double kGrown = 1.25;
  std::array<double, kMostPartLevel + 1> triangles{};
  double all = 0;
  for (const auto& [key, part] : parts_) {
    if (part.is_copy) continue;
    const auto count = static_cast<double>(part.part.mesh.triangle_count());
    triangles[key.level] += count;
    all += count;
  }
  if (all < kGrown * chosen_for_ && chosen_for_ < kGrown * all) return;
  chosen_for_ = all;
  first_sight_ = 0;
  double in_copies = 0;
  double above = all;
  for (std::uint8_t level = 0; level <= copy_level_; ++level) {
    in_copies = in_copies / 4 + triangles[level];
    above -= triangles[level];
    if (level == 0 || kTriangle * in_copies + above > kPays * all) continue;
    const auto border = static_cast<double>(table_.count_between_cells(level, copies_));
    if (kTriangle * in_copies + kBorderVertex * border + above > kPays * all) continue;
    first_sight_ = level;
    return;
  }
}

/// Gives new links to what was touched, and marks those whose border changed.
void SourceMap::relink(const std::set<PartKey>& touched, const std::set<PartKey>& changed,
                       const std::set<PartKey>& known_before) {
  std::set<PartKey> members = changed;
  Pairs pairs;
  for (const PartKey& key : touched) {
    const auto found = parts_.find(key);
    if (found == parts_.end()) continue;
    SourcePart& part = found->second;
    std::vector<PartLink> links = table_.links_of(key);
    if (!changed.contains(key) && same_borders(links, part.links)) continue;
    part.revision = revision();
    members.insert(key);
    for (PartLink& link : links) {
      const bool is_known = known_before.contains(key) || known_before.contains(link.key);
      link.together = is_known && border_in(part.links, link.key) != link.border;
      if (link.together) pairs.emplace_back(key, link.key);
    }
    for (const PartLink& before : part.links)
      if (border_in(links, before.key) == 0 && parts_.contains(before.key))
        pairs.emplace_back(key, before.key);
    part.links = std::move(links);
  }
  number_groups(members, pairs);
}

/// Members with a changed border get one number.
void SourceMap::number_groups(const std::set<PartKey>& members, const Pairs& pairs) {
  std::map<PartKey, PartKey> parent;
  for (const PartKey& key : members) parent[key] = key;
  const auto find_root = [&](PartKey key) {
    while (parent.at(key) != key) key = parent[key] = parent.at(parent.at(key));
    return key;
  };
  for (const auto& [a, b] : pairs) {
    if (!parent.contains(a) || !parent.contains(b)) continue;
    const PartKey root = find_root(a);
    const PartKey other = find_root(b);
    parent[std::max(root, other)] = std::min(root, other);
  }
  std::map<PartKey, std::uint64_t> numbers;
  for (const PartKey& key : members) {
    const auto [number, is_new] = numbers.try_emplace(find_root(key), next_group_);
    if (is_new) ++next_group_;
    parts_.at(key).group = number->second;
  }
}

std::vector<PartLink> SourceMap::replacements_of(const PartKey& key) const {
  std::vector<PartLink> links;
  for (const PartKey& other : overlapping(parts_, key))
    links.push_back({.key = other, .border = kOthersInPlace, .together = true});
  return links;
}

std::vector<PartLink> SourceMap::copies_in_place_of(const PartKey& key,
                                                    const std::set<PartKey>& wanted) const {
  std::vector<PartLink> links;
  for (const PartKey& other : overlapping(wanted, key))
    links.push_back({.key = other, .border = kCopiesInPlace, .together = true});
  if (!links.empty()) return links;
  const std::vector<PartKey> all = overlapping(parts_, key);
  const auto other = std::ranges::find_if(all, [&](const PartKey& part) { return part != key; });
  // Where there is no other either, that of a cell around it will do [MAP-22].
  const PartKey around = key.level < kMostPartLevel
                             ? ancestor(key, key.level + 1)
                             : PartKey{kMostPartLevel - 1, 2 * key.x, 2 * key.y, 2 * key.z};
  links.push_back({.key = other != all.end() ? *other : around, .border = kCopiesInPlace});
  return links;
}

}  // namespace deltamesh
