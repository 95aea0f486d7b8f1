// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A made-up floor of a building: rooms with doors and furniture, as a signed distance field. Metres.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "point.h"
#include "random.h"

namespace deltamesh::scenes {

using Rgb = std::array<std::uint8_t, 3>;

struct Item {
  enum class Shape : std::uint8_t { kBox, kCylinder, kSphere };
  Shape shape = Shape::kBox;
  Point centre;
  Point half;  ///< half sizes; cylinder (upright): radius in x, half height in z; sphere: radius in x
  Rgb color{};
};

/// Negative inside.
double distance(const Item& item, const Point& p) noexcept;

/// An opening in a wall, centred at `along` on the wall's own axis, from the floor up. Width 0: none.
struct Door {
  double along = 0;
  double width = 0;
};

struct Room {
  Point low;                  ///< corner at the floor; walls are half as thick as kWallThickness on this side
  Point high;                 ///< corner at the ceiling
  std::array<Door, 4> doors;  ///< in the walls at low x, high x, low y, high y
  std::vector<Item> items;
  std::vector<Point> viewpoints;  ///< where the robot looked around
  Rgb wall_color{};
  Rgb floor_color{};
};

inline constexpr double kWallThickness = 0.16;
inline constexpr double kDoorHeight = 2.05;

/// Distance to floor, ceiling and walls: a lower bound of its size, of the right sign.
double shell_distance(const Room& room, const Point& p) noexcept;

class Building {
 public:
  /// `room_count` rooms or a few more, in a grid. `fragment_radius`: of the ghosts that hang in the air.
  Building(std::uint32_t room_count, double fragment_radius, std::uint64_t seed);

  Point size() const noexcept { return {x_cuts_.back(), y_cuts_.back(), height_}; }

  std::span<const Room> rooms() const noexcept { return rooms_; }

  /// The room whose cell of the floor plan `p` is in; the nearest where it is in none.
  const Room& room_at(const Point& p) const noexcept;

  Rgb color_at(const Point& p, std::uint64_t noise_seed) const noexcept;

 private:
  void cut(std::vector<double>& cuts, std::uint32_t count);
  void place_doors();
  void furnish(Room& room, double fragment_radius);
  void add_box(Room& room, const Point& centre, const Point& half, const Rgb& color);
  void add_table(Room& room, const Point& place);
  void add_furniture(Room& room, const Point& place);
  void place_viewpoints(Room& room);
  Rgb random_color();

  Random random_;
  double height_ = 2.7;
  std::vector<double> x_cuts_;  ///< walls' centre lines, ascending
  std::vector<double> y_cuts_;
  std::vector<Room> rooms_;  ///< x fastest
};

}  // namespace deltamesh::scenes
