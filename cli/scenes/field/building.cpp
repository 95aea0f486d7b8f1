// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "field/building.h"

#include <algorithm>
#include <cmath>

#include "field/noise.h"

namespace deltamesh::scenes {
namespace {

constexpr Rgb kCeilingColor{232, 232, 226};

double box_distance(const Point& q) noexcept {
  const Point outside{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

double wall_distance(double to_wall, double along, double z, const Door& door) noexcept {
  const double solid = to_wall - kWallThickness / 2;
  if (door.width == 0) return solid;
  const double opening = std::max(std::fabs(along - door.along) - door.width / 2, z - kDoorHeight);
  return std::max(solid, -opening);
}

bool is_free(const Room& room, const Point& p, double clearance) noexcept {
  return shell_distance(room, p) > clearance &&
         std::all_of(room.items.begin(), room.items.end(),
                     [&](const Item& item) { return distance(item, p) > clearance; });
}

std::size_t cell_of(const std::vector<double>& cuts, double x) noexcept {
  const auto above = std::upper_bound(cuts.begin() + 1, cuts.end() - 1, x);
  return static_cast<std::size_t>(above - cuts.begin()) - 1;
}

}  // namespace

double distance(const Item& item, const Point& p) noexcept {
  const Point d = p - item.centre;
  switch (item.shape) {
    case Item::Shape::kBox:
      return box_distance(
          {std::fabs(d.x) - item.half.x, std::fabs(d.y) - item.half.y, std::fabs(d.z) - item.half.z});
    case Item::Shape::kCylinder:
      return box_distance(
          {std::sqrt(d.x * d.x + d.y * d.y) - item.half.x, -1e9, std::fabs(d.z) - item.half.z});
    case Item::Shape::kSphere:
      break;
  }
  return length(d) - item.half.x;
}

double shell_distance(const Room& room, const Point& p) noexcept {
  return std::min({p.z - room.low.z, room.high.z - p.z,
                   wall_distance(p.x - room.low.x, p.y, p.z, room.doors[0]),
                   wall_distance(room.high.x - p.x, p.y, p.z, room.doors[1]),
                   wall_distance(p.y - room.low.y, p.x, p.z, room.doors[2]),
                   wall_distance(room.high.y - p.y, p.x, p.z, room.doors[3])});
}

Building::Building(std::uint32_t room_count, double fragment_radius, std::uint64_t seed) : random_(seed) {
  const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(room_count))));
  cut(x_cuts_, columns);
  cut(y_cuts_, (room_count + columns - 1) / columns);
  for (std::size_t j = 0; j + 1 < y_cuts_.size(); ++j) {
    for (std::size_t i = 0; i + 1 < x_cuts_.size(); ++i) {
      Room room;
      room.low = {x_cuts_[i], y_cuts_[j], 0};
      room.high = {x_cuts_[i + 1], y_cuts_[j + 1], height_};
      rooms_.push_back(room);
    }
  }
  place_doors();
  for (Room& room : rooms_) furnish(room, fragment_radius);
}

void Building::cut(std::vector<double>& cuts, std::uint32_t count) {
  cuts.push_back(0);
  for (std::uint32_t i = 0; i < count; ++i) cuts.push_back(cuts.back() + random_.between(3.6, 6.2));
}

void Building::place_doors() {
  const std::size_t columns = x_cuts_.size() - 1;
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    Room& room = rooms_[i];
    if (i % columns + 1 < columns && random_.chance(0.75)) {
      const double middle = (room.low.y + room.high.y) / 2;
      room.doors[1] = rooms_[i + 1].doors[0] = {middle + random_.between(-1, 1), random_.between(0.85, 1.4)};
    }
    if (i + columns < rooms_.size() && random_.chance(0.75)) {
      const double middle = (room.low.x + room.high.x) / 2;
      room.doors[3] =
          rooms_[i + columns].doors[2] = {middle + random_.between(-1, 1), random_.between(0.85, 1.4)};
    }
  }
}

Rgb Building::random_color() {
  const std::uint32_t base = 40 + random_.below(130);
  Rgb color{};
  for (auto& c : color) c = static_cast<std::uint8_t>(base + random_.below(80));
  return color;
}

void Building::add_box(Room& room, const Point& centre, const Point& half, const Rgb& color) {
  room.items.push_back({Item::Shape::kBox, centre, half, color});
}

void Building::add_table(Room& room, const Point& place) {
  const Rgb color = random_color();
  const Point half{random_.between(0.4, 0.9), random_.between(0.35, 0.5), 0.025};
  add_box(room, place + Point{0, 0, 0.72}, half, color);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      add_box(room, place + Point{x * (half.x - 0.05), y * (half.y - 0.05), 0.35}, {0.035, 0.035, 0.35},
              color);
  room.items.push_back(
      {Item::Shape::kCylinder, place + Point{0.1, 0.05, 0.87}, {0.06, 0, 0.12}, random_color()});
}

void Building::add_furniture(Room& room, const Point& place) {
  const Rgb color = random_color();
  switch (random_.below(5)) {
    case 0:
      add_table(room, place);
      break;
    case 1: {  // wardrobe
      const double half_height = random_.between(0.4, 1);
      add_box(room, place + Point{0, 0, half_height}, {random_.between(0.3, 0.7), 0.28, half_height}, color);
      break;
    }
    case 2:  // sofa
      add_box(room, place + Point{0, 0, 0.22}, {0.8, 0.4, 0.22}, color);
      add_box(room, place + Point{0, 0.32, 0.42}, {0.8, 0.1, 0.42}, color);
      break;
    case 3:  // bin or pillar
      room.items.push_back({Item::Shape::kCylinder,
                            place,
                            {random_.between(0.15, 0.3), 0, random_.chance(0.3) ? height_ : 0.5},
                            color});
      break;
    default:  // ball on the floor
      room.items.push_back({Item::Shape::kSphere, place + Point{0, 0, 0.25}, {0.28, 0, 0}, color});
  }
}

void Building::furnish(Room& room, double fragment_radius) {
  room.wall_color = random_color();
  room.floor_color = random_color();
  const auto inside = [&](double margin) {
    return Point{random_.between(room.low.x + margin, room.high.x - margin),
                 random_.between(room.low.y + margin, room.high.y - margin), 0};
  };
  const std::uint32_t count = 4 + random_.below(5);
  for (std::uint32_t i = 0; i < count; ++i) add_furniture(room, inside(0.6));
  // A lamp, and what a depth camera leaves in the air.
  room.items.push_back({Item::Shape::kSphere, inside(1.2) + Point{0, 0, 2.2}, {0.18, 0, 0}, {250, 240, 200}});
  for (int i = 0; i < 6; ++i) {
    Point place = inside(0.4);
    place.z = random_.between(0.6, 2.2);
    const double radius = fragment_radius * random_.between(0.6, 1.4);
    room.items.push_back({Item::Shape::kSphere, place, {radius, 0, 0}, random_color()});
  }
  place_viewpoints(room);
}

void Building::place_viewpoints(Room& room) {
  constexpr int kTries = 40;
  for (int i = 0; i < kTries && room.viewpoints.size() < 3; ++i) {
    const Point p{random_.between(room.low.x, room.high.x), random_.between(room.low.y, room.high.y),
                  random_.between(1, 1.7)};
    if (is_free(room, p, 0.25)) room.viewpoints.push_back(p);
  }
}

const Room& Building::room_at(const Point& p) const noexcept {
  return rooms_[cell_of(y_cuts_, p.y) * (x_cuts_.size() - 1) + cell_of(x_cuts_, p.x)];
}

Rgb Building::color_at(const Point& p, std::uint64_t noise_seed) const noexcept {
  const Room& room = room_at(p);
  double nearest = shell_distance(room, p);
  Rgb color = room.wall_color;
  if (p.z - room.low.z <= nearest) color = room.floor_color;
  if (room.high.z - p.z <= nearest) color = kCeilingColor;
  for (const Item& item : room.items) {
    const double d = distance(item, p);
    if (d >= nearest) continue;
    nearest = d;
    color = item.color;
  }
  // Light and dirt alike on all channels.
  const double shade =
      1 + 0.15 * smooth_noise(2.5 * p, noise_seed) + 0.06 * smooth_noise(19 * p, noise_seed + 1);
  for (auto& c : color) c = static_cast<std::uint8_t>(std::clamp(c * shade, 0.0, 255.0));
  return color;
}

}  // namespace deltamesh::scenes
