// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/borders.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace deltamesh {
namespace {

std::vector<PositionBits> positions_of(const Mesh& mesh) {
  std::vector<PositionBits> positions;
  positions.reserve(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) positions.push_back(bits_of(mesh, v));
  std::ranges::sort(positions);
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

bool is_inside(const PartKey& part, const PartKey& cell) noexcept {
  return part.level <= cell.level && ancestor(part, cell.level) == cell;
}

using Uses = std::span<const BorderUse>;

/// The uses of the first point.
Uses first_point(Uses uses) {
  const auto end =
      std::ranges::find_if(uses, [&](const BorderUse& use) { return use.point != uses[0].point; });
  return uses.first(static_cast<std::size_t>(end - uses.begin()));
}

/// Two parts that have a position.
using Common = std::tuple<PositionBits, std::uint32_t, PartKey, PartKey>;
std::vector<Common> commons_of(Uses uses) {
  std::vector<Common> commons;
  for (std::size_t a = 0; a < uses.size(); ++a)
    for (std::size_t b = a + 1; b < uses.size() && uses[b].position == uses[a].position; ++b)
      commons.emplace_back(uses[a].position, uses[a].twin, uses[a].part, uses[b].part);
  return commons;
}

/// Border positions that parts lose and gain.
struct Moves {
  std::map<PartKey, std::vector<BorderPosition>> lost;
  std::map<PartKey, std::vector<BorderPosition>> gained;
};

/// At one point.
void compare(Uses before, Uses after, BorderChange& change, Moves& moves) {
  if (std::ranges::equal(before, after)) return;
  for (const Uses uses : {before, after})
    for (const BorderUse& use : uses) change.touched.insert(use.part);
  const auto move = [&](Uses from, Uses to, auto& parts) {
    for (const BorderUse& use : from) {
      if (std::ranges::binary_search(to, use)) continue;
      change.changed.insert(use.part);
      parts[use.part].push_back({use.position, use.point, use.twin});
    }
  };
  move(before, after, moves.lost);
  move(after, before, moves.gained);
  const std::vector<Common> old = commons_of(before);
  const std::vector<Common> now = commons_of(after);
  std::vector<Common> different;
  std::ranges::set_symmetric_difference(old, now, std::back_inserter(different));
  for (const auto& [position, twin, a, b] : different) change.pairs.emplace(a, b);
}

}  // namespace

std::vector<LatticePoint> points_of(std::span<const Mesh* const> meshes, const MapLattice& lattice) {
  std::vector<LatticePoint> points;
  for (const Mesh* mesh : meshes)
    for (std::size_t v = 0; v < mesh->vertex_count(); ++v)
      points.push_back(point_of(bits_of(*mesh, v), lattice));
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void Borders::add(const PlacedBlock& block) {
  for (const PositionBits& position : positions_of(block.block.mesh)) {
    const PlacedBlock* other = nullptr;
    std::size_t others = 0;
    positions_.for_each_at(position, [&](const PlacedBlock& user) {
      other = &user;
      ++others;
    });
    if (others == 1) share(position, *other);
    if (others > 0) share(position, block);
    positions_.add(position, block);
  }
}

void Borders::remove(const PlacedBlock& block) {
  for (const PositionBits& position : positions_of(block.block.mesh)) {
    positions_.remove(position, block);
    const PlacedBlock* other = nullptr;
    std::size_t others = 0;
    positions_.for_each_at(position, [&](const PlacedBlock& user) {
      other = &user;
      ++others;
    });
    if (others > 0) unshare(position, block);
    if (others == 1) unshare(position, *other);
  }
}

void Borders::share(const PositionBits& position, const PlacedBlock& block) {
  shared_[point_of(position, lattice_)].emplace_back(position, &block);
}

void Borders::unshare(const PositionBits& position, const PlacedBlock& block) {
  const auto users = shared_.find(point_of(position, lattice_));
  std::erase(users->second, std::pair(position, &block));
  if (users->second.empty()) shared_.erase(users);
}

/// Positions are numbered as twins in ascending order.
void Borders::uses_at(const LatticePoint& point, std::vector<BorderUse>& uses) const {
  const auto users = shared_.find(point);
  if (users == shared_.end()) return;
  std::vector<std::pair<PositionBits, PartKey>> all;
  for (const auto& [position, block] : users->second) all.emplace_back(position, block->part);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::uint32_t twins = 0;
  for (auto first = all.begin(); first != all.end();) {
    const auto last =
        std::find_if(first, all.end(), [&](const auto& user) { return user.first != first->first; });
    if (last - first > 1) {
      for (auto user = first; user != last; ++user) uses.push_back({point, user->first, twins, user->second});
      ++twins;
    }
    first = last;
  }
}

std::vector<BorderUse> Borders::at(std::span<const LatticePoint> points) const {
  std::vector<BorderUse> uses;
  for (const LatticePoint& point : points) uses_at(point, uses);
  return uses;
}

BorderChange Borders::change(const std::vector<BorderUse>& before, const std::vector<BorderUse>& after) {
  BorderChange change;
  Moves moves;
  for (Uses old(before), now(after); !old.empty() || !now.empty();) {
    const bool has_old = now.empty() || (!old.empty() && old[0].point <= now[0].point);
    const bool has_now = old.empty() || (!now.empty() && now[0].point <= old[0].point);
    const Uses a = has_old ? first_point(old) : Uses();
    const Uses b = has_now ? first_point(now) : Uses();
    compare(a, b, change, moves);
    old = old.subspan(a.size());
    now = now.subspan(b.size());
  }
  for (const PartKey& key : change.changed) {
    std::vector<BorderPosition>& border = borders_[key];
    std::vector<BorderPosition>& lost = moves.lost[key];
    std::vector<BorderPosition>& gained = moves.gained[key];
    std::ranges::sort(lost);
    std::ranges::sort(gained);
    std::vector<BorderPosition> kept;
    std::vector<BorderPosition> all;
    std::ranges::set_difference(border, lost, std::back_inserter(kept));
    std::ranges::set_union(kept, gained, std::back_inserter(all));
    border = std::move(all);
    if (border.empty()) borders_.erase(key);
  }
  return change;
}

const std::vector<BorderPosition>& Borders::of(const PartKey& part) const {
  static const std::vector<BorderPosition> none;
  const auto found = borders_.find(part);
  return found == borders_.end() ? none : found->second;
}

std::vector<BorderPosition> Borders::outside(const PartKey& part, const PartKey& cell) const {
  std::vector<BorderPosition> border;
  std::vector<BorderUse> uses;
  for (const BorderPosition& position : of(part)) {
    uses.clear();
    uses_at(position.point, uses);
    if (std::ranges::any_of(uses, [&](const BorderUse& use) {
          return use.position == position.position && !is_inside(use.part, cell);
        }))
      border.push_back(position);
  }
  return border;
}

}  // namespace deltamesh
