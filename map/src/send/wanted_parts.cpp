// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/wanted_parts.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "base/try.h"
#include "part/view_cells.h"

namespace deltamesh {
namespace {

constexpr std::uint64_t kTrianglesAtOnce = std::uint64_t{1} << 16;  // that a call simplifies

class Wants {
 public:
  Wants(const Viewer& viewer, const SourceMap& map, const MapDescription& description, const SeenCells& cells)
      : first_sight_(map.first_sight()), waits_(viewer.waits_for_copies), cells_(cells) {
    for (const auto& [key, part] : map.parts()) {
      if (!is_in_view(key, viewer.view, description)) continue;
      (cells.is_seen(key) ? in_view_ : beside_).insert(key);
    }
  }

  WantedParts run() {
    // From the finest on, each is found by what is nearest above it.
    for (const PartKey& key : in_view_) inside_[holder_of(key)].push_back(key);
    WantedParts parts;
    parts.others = beside_;
    parts.wanted = cover(waits_);
    // What is seen first fits together, so that all of it comes before any of it goes.
    if (first_sight_ > 0 && !waits_ &&
        std::ranges::any_of(parts.wanted, [&](const PartKey& key) { return is_new(key); }))
      parts.wanted = cover(true);
    for (const PartKey& key : in_view_)
      if (!parts.wanted.contains(key)) parts.others.insert(key);
    return parts;
  }

 private:
  static constexpr PartKey kNone{kMostPartLevel + 1, 0, 0, 0};

  int highest() const noexcept { return in_view_.empty() ? -1 : in_view_.rbegin()->level; }

  PartKey holder_of(const PartKey& key) const {
    for (int level = key.level + 1; level <= highest(); ++level)
      if (const PartKey above = ancestor(key, static_cast<std::uint8_t>(level)); in_view_.contains(above))
        return above;
    return kNone;
  }

  /// What is seen first where it is: a copy, or a part where there is none.
  bool is_new(const PartKey& key) const { return key.level <= first_sight_ && !cells_.is_begun(key); }

  /// A copy that is to be seen before what is inside.
  bool is_new_copy(const PartKey& key) const { return inside_.contains(key) && is_new(key); }

  std::set<PartKey> cover(bool keeps_copies) const {
    std::set<PartKey> wanted;
    const auto top = inside_.find(kNone);
    std::vector<PartKey> open = top == inside_.end() ? std::vector<PartKey>() : top->second;
    while (!open.empty()) {
      const PartKey key = open.back();
      open.pop_back();
      const auto inside = inside_.find(key);
      const bool stays = keeps_copies && key.level <= first_sight_ && cells_.has(key);
      if (inside != inside_.end() && !stays && !is_new_copy(key)) {
        open.insert(open.end(), inside->second.begin(), inside->second.end());
      } else if (!is_to_come_later(key)) {
        wanted.insert(key);
      }
    }
    return wanted;
  }

  /// A copy of it that is still to be made is to come first.
  bool is_to_come_later(const PartKey& key) const {
    return waits_ && key.level < first_sight_ && !cells_.is_begun(ancestor(key, first_sight_));
  }

  std::uint8_t first_sight_;
  bool waits_;
  const SeenCells& cells_;
  std::set<PartKey> in_view_;
  std::set<PartKey> beside_;  ///< copies that touch the view, of parts that do not
  std::map<PartKey, std::vector<PartKey>> inside_;
};

/// Those of `cells` that have waited longest first, then the nearest.
std::vector<PartKey> in_order(const std::set<PartKey>& cells, const Viewer& viewer, const SourceMap& map,
                              const MapDescription& description) {
  std::vector<std::tuple<std::uint64_t, double, PartKey>> order;
  order.reserve(cells.size());
  for (const PartKey& cell : cells)
    order.emplace_back(map.outdated_since(cell), way_to(cell, viewer.view, description), cell);
  std::ranges::sort(order);
  std::vector<PartKey> keys;
  keys.reserve(order.size());
  for (const auto& [since, way, cell] : order) keys.push_back(cell);
  return keys;
}

}  // namespace

WantedParts wanted_parts(const Viewer& viewer, const SourceMap& map, const MapDescription& description,
                         const SeenCells& seen) {
  return Wants(viewer, map, description, seen).run();
}

Result<bool> make_copies_for(const Viewer& viewer, SourceMap& map, const MapDescription& description,
                             const SeenCells& seen) {
  // From the level of the first sight on: where a copy has too many triangles to be a part, a view of copies
  // gets those below it. For a first sight alone they would take more bytes than they save.
  const int lowest = std::max<int>(viewer.view.level > 0 ? viewer.view.level : map.first_sight(), 1);
  for (int level = std::max(map.first_sight(), viewer.view.level); level >= lowest; --level) {
    std::set<PartKey> cells;
    for (const auto& [key, part] : map.parts()) {
      if (key.level >= level || map.is_copy(key)) continue;
      const PartKey cell = ancestor(key, static_cast<std::uint8_t>(level));
      if (!seen.is_seen(cell)) continue;
      // Where a copy on the view's level has too many triangles to be a part, one above it is needed.
      const PartKey shown =
          viewer.view.level > 0 ? ancestor(key, std::max(key.level, viewer.view.level)) : cell;
      bool is_covered = level > viewer.view.level && seen.is_begun(shown);
      for (int above = level + 1; above <= map.first_sight() && level > viewer.view.level; ++above)
        is_covered = is_covered || map.find(ancestor(cell, static_cast<std::uint8_t>(above))) != nullptr;
      if (!is_covered && map.find(cell) == nullptr) cells.insert(cell);
    }
    if (cells.empty()) continue;
    DELTAMESH_TRY(const bool is_complete,
                  map.make_copies(in_order(cells, viewer, map, description), kTrianglesAtOnce));
    if (!is_complete) return false;
  }
  return true;
}

}  // namespace deltamesh
