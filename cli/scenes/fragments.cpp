// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Small components of every awkward kind.
#include <algorithm>

#include "generators.h"
#include "random.h"

namespace deltamesh::scenes {
namespace {

class FragmentMaker {
 public:
  FragmentMaker(std::uint64_t target, std::uint64_t seed)
      : random_(seed), target_(target), side_(3 * std::sqrt(static_cast<double>(target))) {}

  Mesh make() {
    while (left() != 0) {
      centre_ = {random_.between(0, side_), random_.between(0, side_), random_.between(0, 12)};
      add_component();
    }
    return std::move(mesh_);
  }

 private:
  std::uint64_t left() const noexcept { return target_ - mesh_.vertex_count(); }

  void add_component() {
    switch (random_.below(20)) {
      case 0:
        add(1);
        break;
      case 1:
        if (left() >= 5) return add_book();
        break;
      case 2:
        if (left() >= 7) return add_bow_tie();
        break;
      case 3:
        if (left() >= 4) return add_tetrahedron(add(4));
        break;
      case 4:
      case 5:
      case 6:
        if (left() >= 3) return add_doubled_triangle();
        break;
      default:
        if (left() >= 3) return random_.chance(0.5) ? add_fan() : add_strip();
        add(1);
    }
  }

  /// `count` vertices scattered about the centre; returns the first.
  std::uint32_t add(std::uint32_t count) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    for (std::uint32_t i = 0; i < count; ++i)
      add_vertex(mesh_,
                 centre_ + Point{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)});
    return first;
  }

  std::uint32_t component_size() {
    const std::uint32_t size = 3 + random_.below(random_.chance(0.3) ? 48 : 8);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(size, left()));
  }

  /// Triangles around the first vertex; the circle is not closed.
  void add_fan() {
    const std::uint32_t size = component_size();
    const auto first = add_vertex(mesh_, centre_);
    for (std::uint32_t i = 1; i < size; ++i) {
      const CirclePoint c = circle(0.9 * i / size);
      const std::uint32_t v = add_vertex(mesh_, centre_ + Point{c.cos, c.sin, random_.between(-0.2, 0.2)});
      if (i > 1) add_triangle(mesh_, first, v - 1, v);
    }
  }

  /// A bent strip; now and then a triangle is turned over.
  void add_strip() {
    const std::uint32_t size = component_size();
    for (std::uint32_t i = 0; i < size; ++i) {
      const double along = 0.15 * i;
      const std::uint32_t v =
          add_vertex(mesh_, centre_ + Point{along, 0.3 * (i % 2) + random_.between(0, 0.05),
                                            0.1 * along * along + random_.between(0, 0.05)});
      if (i < 2) continue;
      (i % 2 == 0) != random_.chance(0.02) ? add_triangle(mesh_, v - 2, v - 1, v)
                                           : add_triangle(mesh_, v - 1, v - 2, v);
    }
  }

  void add_tetrahedron(std::uint32_t v) {
    add_triangle(mesh_, v, v + 1, v + 2);
    add_triangle(mesh_, v, v + 2, v + 3);
    add_triangle(mesh_, v, v + 3, v + 1);
    add_triangle(mesh_, v + 1, v + 3, v + 2);
  }

  /// Three triangles on one edge.
  void add_book() {
    const std::uint32_t v = add(5);
    for (std::uint32_t page = 2; page < 5; ++page) add_triangle(mesh_, v, v + 1, v + page);
  }

  /// Two tetrahedra with one vertex in common.
  void add_bow_tie() {
    const std::uint32_t v = add(7);
    add_tetrahedron(v);
    add_tetrahedron(v + 3);
  }

  /// The same face twice, or once from each side.
  void add_doubled_triangle() {
    const std::uint32_t v = add(3);
    add_triangle(mesh_, v, v + 1, v + 2);
    random_.chance(0.5) ? add_triangle(mesh_, v, v + 1, v + 2) : add_triangle(mesh_, v + 2, v + 1, v);
  }

  Random random_;
  std::uint64_t target_;
  double side_;
  Point centre_;
  Mesh mesh_;
};

}  // namespace

Mesh make_fragments(std::uint64_t target, std::uint64_t seed) { return FragmentMaker(target, seed).make(); }

}  // namespace deltamesh::scenes
