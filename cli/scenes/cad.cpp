// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Drilled blocks and cylinders as a CAD kernel tessellates them: every face has vertices of its own, which
// share their positions with those of the next face but neither normal nor texture coordinate.
#include <algorithm>
#include <vector>

#include "generators.h"
#include "random.h"

namespace deltamesh::scenes {
namespace {

constexpr double kPitch = 120;  ///< millimetres between parts

/// Where a part stands: turned about z, then moved.
struct Pose {
  CirclePoint turn;
  Point place;
  Point direction(const Point& p) const noexcept {
    return {turn.cos * p.x - turn.sin * p.y, turn.sin * p.x + turn.cos * p.y, p.z};
  }
};

class CadMaker {
 public:
  explicit CadMaker(std::uint64_t seed) : random_(seed) {}

  Mesh make(std::uint64_t target) {
    const auto row = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(target) / 170) + 1);
    for (std::uint64_t part = 0;; ++part) {
      const std::uint64_t left = target - mesh_.vertex_count();
      pose_.turn = circle(random_.chance(0.5) ? 0.25 * random_.below(4) : random_.between(0, 1));
      pose_.place = {kPitch * static_cast<double>(part % row), kPitch * static_cast<double>(part / row), 0};
      const std::uint32_t segments = 4 * (2 + random_.below(15));
      if (block_vertices(segments) + cylinder_vertices(3) > left) {
        add_cylinder(std::max<std::uint64_t>(3, (left - 2) / 4));
        break;
      }
      random_.chance(0.75) ? add_block(segments) : add_cylinder(segments);
    }
    add_attribute<float>(mesh_, AttributeKind::kNormal, ComponentType::kF32, 3, "NORMAL", normals_);
    add_attribute<float>(mesh_, AttributeKind::kUv, ComponentType::kF32, 2, "TEXCOORD_0", uvs_);
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint64_t block_vertices(std::uint64_t segments) { return 26 + 4 * segments; }
  static constexpr std::uint64_t cylinder_vertices(std::uint64_t segments) { return 2 + 4 * segments; }

  std::uint32_t add(const Point& p, const Point& normal, double u, double v) {
    const Point n = pose_.direction(normal);
    for (const double x : {n.x, n.y, n.z}) normals_.push_back(static_cast<float>(x));
    for (const double x : {u, v}) uvs_.push_back(static_cast<float>(x));
    return add_vertex(mesh_, pose_.place + pose_.direction(p));
  }

  /// A vertex of a horizontal face; texture coordinates are its place in the part.
  std::uint32_t add_level(const Point& p, double up) {
    return add(p, {0, 0, up}, 0.5 + p.x / kPitch, 0.5 + p.y / kPitch);
  }

  /// A quad with corners a, b at the bottom, left to right seen from outside.
  void add_side(const Point& a, const Point& b, const Point& normal, double height, double u0, double u1) {
    const Point up{0, 0, height};
    const std::uint32_t first = add(a, normal, u0, 0);
    add(b, normal, u1, 0);
    add(b + up, normal, u1, 1);
    add(a + up, normal, u0, 1);
    add_quad(mesh_, first, first + 1, first + 2, first + 3);
  }

  /// The wall of a round hole (`outward` -1) or of a cylinder (1), smooth, unrolled, its first column twice.
  void add_wall(double radius, double bottom, double height, std::uint64_t segments, double outward) {
    std::uint32_t last = 0;
    for (std::uint64_t i = 0; i <= segments; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(segments);
      const CirclePoint c = circle(share);
      const Point p{radius * c.cos, radius * c.sin, bottom};
      const Point normal{outward * c.cos, outward * c.sin, 0};
      const std::uint32_t low = add(p, normal, share, 0);
      add({p.x, p.y, bottom + height}, normal, share, 1);
      if (i != 0 && outward > 0) add_quad(mesh_, last, low, low + 1, last + 1);
      if (i != 0 && outward < 0) add_quad(mesh_, low, last, last + 1, low + 1);
      last = low;
    }
  }

  /// A horizontal face with a round hole: every corner is joined to its quarter of the circle, so that no
  /// triangle crosses the hole. `segments`: a multiple of 4.
  void add_drilled_face(const std::array<Point, 4>& corners, double z, double radius, std::uint32_t segments,
                        double up) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    for (const Point& corner : corners) add_level({corner.x, corner.y, z}, up);
    for (std::uint32_t i = 0; i < segments; ++i) {
      const CirclePoint c = circle(static_cast<double>(i) / segments);
      add_level({radius * c.cos, radius * c.sin, z}, up);
    }
    const auto on_circle = [&](std::uint32_t i) { return first + 4 + i % segments; };
    const auto add_facing = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      up > 0 ? add_triangle(mesh_, a, b, c) : add_triangle(mesh_, a, c, b);
    };
    const std::uint32_t quarter = segments / 4;
    for (std::uint32_t k = 0; k < 4; ++k) {
      for (std::uint32_t i = k * quarter; i < (k + 1) * quarter; ++i)
        add_facing(first + k, on_circle(i + 1), on_circle(i));
      add_facing(first + k, first + (k + 1) % 4, on_circle((k + 1) * quarter));
    }
  }

  void add_block(std::uint32_t segments) {
    const double a = random_.between(20, 50);
    const double b = random_.between(12, 40);
    const double height = random_.between(4, 60);
    const double radius = std::min(a, b) * random_.between(0.3, 0.9);
    const std::array<Point, 4> corners{{{a, b, 0}, {-a, b, 0}, {-a, -b, 0}, {a, -b, 0}}};
    const std::array<Point, 4> normals{{{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}}};
    add_drilled_face(corners, height, radius, segments, 1);
    add_drilled_face(corners, 0, radius, segments, -1);
    for (std::size_t k = 0; k < 4; ++k)
      add_side(corners[k], corners[(k + 1) % 4], normals[k], height, 0.25 * static_cast<double>(k),
               0.25 * static_cast<double>(k + 1));
    add_wall(radius, 0, height, segments, -1);
  }

  void add_cylinder(std::uint64_t segments) {
    const double radius = random_.between(8, 40);
    const double height = random_.between(10, 80);
    add_wall(radius, 0, height, segments, 1);
    for (const double up : {-1.0, 1.0}) {
      const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
      for (std::uint64_t i = 0; i < segments; ++i) {
        const CirclePoint c = circle(static_cast<double>(i) / static_cast<double>(segments));
        const std::uint32_t v = add_level({radius * c.cos, radius * c.sin, up > 0 ? height : 0}, up);
        if (i < 2) continue;
        up > 0 ? add_triangle(mesh_, first, v - 1, v) : add_triangle(mesh_, first, v, v - 1);
      }
    }
  }

  Random random_;
  Pose pose_;
  Mesh mesh_;
  std::vector<float> normals_;
  std::vector<float> uvs_;
};

}  // namespace

Mesh make_cad(std::uint64_t target, std::uint64_t seed) { return CadMaker(seed).make(target); }

}  // namespace deltamesh::scenes
