// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "grid/bricks.h"

#include <algorithm>
#include <cstring>

namespace deltamesh::grid {
namespace {

Bricks::Place way_to(unsigned near) noexcept {
  return {static_cast<std::int32_t>(near % 3) - 1, static_cast<std::int32_t>(near / 3 % 3) - 1,
          static_cast<std::int32_t>(near / 9) - 1};
}

Bricks::Place sum(const Bricks::Place& a, const Bricks::Place& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Of the coordinates 0 to 15 in a brick at `way` on an axis: those in the margin of this brick.
struct Range {
  int first;
  int end;
};
Range in_margin(int way) noexcept {
  if (way < 0) return {kSide - kMargin, kSide};
  return {0, way > 0 ? kMargin : kSide};
}

/// What `from`, at `way` from `to`, has itself and `to` has in its margin.
void copy_margin(const Brick& from, const Bricks::Place& way, Brick& to) noexcept {
  constexpr std::uint64_t kOwn = 0x0003'fffc'0003'fffcULL;
  constexpr std::uint64_t kFirstTwo = 0x0000'000c'0000'000cULL;
  constexpr std::uint64_t kLastTwo = 0x0003'0000'0003'0000ULL;
  const Range ys = in_margin(way[1]);
  const Range zs = in_margin(way[2]);
  for (int z = zs.first; z < zs.end; ++z) {
    for (int y = ys.first; y < ys.end; ++y) {
      std::uint64_t row = from.rows[Brick::row_at(y, z)] & kOwn;
      if (way[0] > 0) row = (row & kFirstTwo) << kSide;
      if (way[0] < 0) row = (row & kLastTwo) >> kSide;
      to.rows[Brick::row_at(y + kSide * way[1], z + kSide * way[2])] |= row;
    }
  }
}

}  // namespace

std::size_t Bricks::slot_of(const Place& at) const noexcept {
  std::uint64_t hash = 0;
  for (const std::int32_t a : at) {
    hash = (hash ^ static_cast<std::uint32_t>(a)) * 0xff51'afd7'ed55'8ccdULL;
    hash ^= hash >> 32;
  }
  std::size_t slot = hash & (table_.size() - 1);
  while (table_[slot] != 0 && bricks_[table_[slot] - 1]->at != at) slot = (slot + 1) & (table_.size() - 1);
  return slot;
}

Brick* Bricks::find(const Place& at) const noexcept {
  if (table_.empty()) return nullptr;
  const std::uint32_t found = table_[slot_of(at)];
  return found == 0 ? nullptr : bricks_[found - 1];
}

void Bricks::make_room() {
  if (2 * (bricks_.size() + 1) > table_.size()) {
    std::size_t size = 64;
    while (size < 4 * (bricks_.size() + 1)) size *= 2;
    table_.assign(size, 0);
    for (std::uint32_t i = 0; i < bricks_.size(); ++i) table_[slot_of(bricks_[i]->at)] = i + 1;
  }
  if (left_ == 0) {
    constexpr std::size_t kMostAtOnce = 128;
    left_ = std::clamp<std::size_t>(bricks_.size(), 8, kMostAtOnce);
    memory_.emplace_back(left_);
  }
}

Brick& Bricks::get(const Place& at) {
  if (Brick* const found = find(at)) return *found;
  make_room();
  Brick& brick = memory_.back()[memory_.back().size() - left_--];
  brick.at = at;
  brick.number = count();
  brick.rows.fill(0);
  brick.cubes.fill(0);
  for (auto& cut : brick.cut) cut.fill(0);
  brick.known_nodes = 0;
  table_[slot_of(at)] = brick.number + 1;
  bricks_.push_back(&brick);
  for (unsigned way = 0; way < brick.near.size(); ++way) {
    Brick* const other = way == 13 ? &brick : find(sum(at, way_to(way)));
    brick.near[way] = other;
    if (other == nullptr || way == 13) continue;
    other->near[26 - way] = &brick;
    copy_margin(*other, way_to(way), brick);
  }
  return brick;
}

Brick& Bricks::get_near(Brick& brick, unsigned way) { return get(sum(brick.at, way_to(way))); }

void Bricks::set_outer_node(Brick& brick, Spot spot, bool is_outside) {
  Brick& own = ((spot[0] | spot[1] | spot[2]) & kSide) != 0 ? home(brick, spot) : brick;
  give_rank(own, place_of(spot));
  // Elsewhere it is in a margin: in bricks on the low side if it is one of the first, and so on.
  struct Copy {
    int near;
    int row;
    int x;
  };
  static constexpr std::array<Copy, 3> kSteps = {{{1, 0, -kSide}, {3, -kSide, 0}, {9, -kSide * kReach, 0}}};
  std::array<Copy, 8> copies;
  copies[0] = {13, static_cast<int>(Brick::row_at(spot[1], spot[2])), spot[0]};
  unsigned count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int side = spot[axis] < kMargin ? -1 : 1;
    if (spot[axis] >= kMargin && spot[axis] < kSide - kMargin) continue;
    const Copy& step = kSteps[axis];
    for (unsigned i = 0; i < count; ++i)
      copies[count + i] = {copies[i].near + side * step.near, copies[i].row + side * step.row,
                           copies[i].x + side * step.x};
    count *= 2;
  }
  for (unsigned i = 0; i < count; ++i)
    if (Brick* const other = own.near[static_cast<std::size_t>(copies[i].near)])
      other->rows[static_cast<std::size_t>(copies[i].row)] |= node_bit(copies[i].x, is_outside);
}

void Bricks::add_group(Brick& brick, unsigned rank) {
  if (vertices_.size() - vertex_end_ < kGroup) vertices_.resize(2 * vertices_.size() + 16 * kGroup);
  brick.groups[rank / kGroup] = vertex_end_;
  static_assert(kNoVertex == 0xffffffff);
  std::memset(&vertices_[vertex_end_], 0xff, kGroup * sizeof(vertices_[0]));
  vertex_end_ += kGroup;
}

std::vector<Brick*> Bricks::in_order() const {
  std::vector<Brick*> order = bricks_;
  std::sort(order.begin(), order.end(), [](const Brick* a, const Brick* b) {
    return std::array{a->at[2], a->at[1], a->at[0]} < std::array{b->at[2], b->at[1], b->at[0]};
  });
  return order;
}

}  // namespace deltamesh::grid
