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
  constexpr int kRight = kMargin - 1;  // of which are right
  if (way < 0) return {kSide - kRight, kSide};
  return {0, way > 0 ? kRight : kSide};
}

/// What `from`, at `way` from `to`, has itself and `to` has in its margin.
void copy_margin(const Brick& from, const Bricks::Place& way, Brick& to) noexcept {
  constexpr std::uint64_t kOwn = 0x0007'fff8'0007'fff8ULL;
  constexpr std::uint64_t kFirstTwo = 0x0000'0018'0000'0018ULL;
  constexpr std::uint64_t kLastTwo = 0x0006'0000'0006'0000ULL;
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

Brick* Bricks::find(const Place& at) const noexcept {
  const auto found = by_place_.find(at);
  return found == by_place_.end() ? nullptr : found->second;
}

Brick& Bricks::get(const Place& at) {
  const auto [place, is_new] = by_place_.try_emplace(at);
  if (!is_new) return *place->second;
  Brick& brick = memory_.take();
  place->second = &brick;
  brick.at = at;
  brick.number = count();
  brick.rows.fill(0);
  brick.cubes = cubes_.take().data();
  std::memset(brick.cubes, 0, kPlaces);
  brick.cut.fill(0);
  brick.blocks.fill(0);
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

void Bricks::get_beyond(Brick& brick, unsigned place) {
  for (unsigned over = beyond(place), corner = over; corner != 0; corner = (corner - 1) & over) {
    const unsigned way = 13 + (corner & 1) + 3 * (corner >> 1 & 1) + 9 * (corner >> 2);
    if (brick.near[way] == nullptr) get_near(brick, way);
  }
}

void Bricks::free_cubes() noexcept {
  for (Brick* const brick : bricks_) brick->cubes = nullptr;
  cubes_.free();
}

void Bricks::add_block(std::uint32_t& block) {
  block = block_count_++;
  const std::size_t first = block * kBlockNodes;
  if (vertices_.size() < first + kBlockNodes) vertices_.resize(2 * first + 16 * kBlockNodes);
  static_assert(kNoVertex == 0xffffffff);
  std::memset(&vertices_[first], 0xff, kBlockNodes * sizeof(vertices_[0]));
}

std::vector<Brick*> Bricks::in_order() const {
  std::vector<Brick*> order = bricks_;
  std::sort(order.begin(), order.end(), [](const Brick* a, const Brick* b) {
    return std::array{a->at[2], a->at[1], a->at[0]} < std::array{b->at[2], b->at[1], b->at[0]};
  });
  return order;
}

}  // namespace deltamesh::grid
