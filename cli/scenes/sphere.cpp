// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Rings of latitude, each with as many vertices as its length asks for, stitched to the next: closed, and of
// irregular valence without an adjacency structure.
#include <algorithm>

#include "field/noise.h"
#include "generators.h"

namespace deltamesh::scenes {
namespace {

struct Ring {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  double phase = 0;  ///< turns
};

class SphereMaker {
 public:
  SphereMaker(std::uint64_t target, std::uint64_t seed) : random_(seed), shape_seed_(random_.bits()) {
    // Square cells: R half-circle steps of pi / R give rings of 2 R sin(theta) vertices, 4 R^2 / pi in all.
    steps_ = std::max(2.0, std::floor(std::sqrt(kPi / 4 * static_cast<double>(target)) + 0.5));
    double sines = 0;
    for (double i = 1; i < steps_; ++i) sines += circle(i / steps_ / 2).sin;
    around_ = static_cast<double>(target - 2) / sines;
  }

  Mesh make() {
    const std::uint32_t north = add(0, 0);
    Ring ring = add_ring(1);
    for (std::uint32_t i = 0; i < ring.count; ++i)
      add_triangle(mesh_, north, ring.first + i, ring.first + (i + 1) % ring.count);
    for (double i = 2; i < steps_; ++i) {
      const Ring next = add_ring(i);
      stitch(ring, next);
      ring = next;
    }
    const std::uint32_t south = add(0.5, 0);
    for (std::uint32_t i = 0; i < ring.count; ++i)
      add_triangle(mesh_, ring.first + (i + 1) % ring.count, ring.first + i, south);
    return std::move(mesh_);
  }

 private:
  /// `polar`: turns from the north pole, 0 to 1/2; `azimuth`: turns.
  std::uint32_t add(double polar, double azimuth) {
    const CirclePoint p = circle(polar);
    const CirclePoint a = circle(azimuth);
    const Point direction{p.sin * a.cos, p.sin * a.sin, p.cos};
    return add_vertex(mesh_, (1 + 0.12 * fractal_noise(2.5 * direction, 5, shape_seed_)) * direction);
  }

  Ring add_ring(double i) {
    Ring ring;
    ring.count =
        std::max(3U, static_cast<std::uint32_t>(std::floor(around_ * circle(i / steps_ / 2).sin + 0.5)));
    ring.phase = random_.between(0, 1);
    ring.first = static_cast<std::uint32_t>(mesh_.vertex_count());
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const double polar = (i + random_.between(-0.2, 0.2)) / steps_ / 2;
      const double azimuth = ring.phase + (k + random_.between(-0.2, 0.2)) / ring.count;
      add(polar, azimuth);
    }
    return ring;
  }

  /// Walks both rings once around, at each step forward on the ring that is behind.
  void stitch(const Ring& upper, const Ring& lower) {
    // The lower ring's vertex nearest behind the upper's first.
    const double offset = (upper.phase - lower.phase) * lower.count;
    const auto start = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(offset)) +
                                                  2 * static_cast<std::int64_t>(lower.count));
    const double ahead = (std::floor(offset) - offset) / lower.count;
    std::uint32_t u = 0;
    std::uint32_t l = 0;
    while (u < upper.count || l < lower.count) {
      const double upper_next = (u + 1.0) / upper.count;
      const double lower_next = ahead + (l + 1.0) / lower.count;
      const std::uint32_t a = upper.first + u % upper.count;
      const std::uint32_t b = lower.first + (start + l) % lower.count;
      if (l == lower.count || (u < upper.count && upper_next < lower_next)) {
        add_triangle(mesh_, a, b, upper.first + ++u % upper.count);
      } else {
        add_triangle(mesh_, a, b, lower.first + (start + ++l) % lower.count);
      }
    }
  }

  Random random_;
  std::uint64_t shape_seed_;
  double steps_ = 0;   ///< latitude steps from pole to pole
  double around_ = 0;  ///< vertices of the equator
  Mesh mesh_;
};

}  // namespace

Mesh make_sphere(std::uint64_t target, std::uint64_t seed) { return SphereMaker(target, seed).make(); }

}  // namespace deltamesh::scenes
