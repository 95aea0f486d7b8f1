// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "attributes/error.h"
#include "attributes/normals/lattice.h"
#include "attributes/normals/normals.h"
#include "attributes/normals/rule.h"
#include "base/numbers/portable_math.h"
#include "support/grid_triangles.h"

namespace deltamesh::surface_normals_test {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state_ >> 32);
  }
  double symmetric() { return next() / 2147483648.0 - 1; }

 private:
  std::uint64_t state_;
};

struct Model {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> geometric;  ///< empty where each vertex is its own
  std::vector<float> positions;
  std::vector<float> normals;

  std::uint32_t count() const { return static_cast<std::uint32_t>(normals.size() / 3); }
  AttributeSurface surface() const { return {triangles, count(), geometric, positions}; }
  AttributeSurface blind() const { return {triangles, count(), geometric, {}}; }
};

Vec3 at(const std::vector<float>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}
void push(std::vector<float>& values, const Vec3& v) {
  for (const double x : v) values.push_back(static_cast<float>(x));
}
void push_direction(std::vector<float>& values, Vec3 v) {
  const double size = length(v);
  push(values, size > 0 ? (1 / size) * v : v);
}

/// Waves over a square of `side` x `side` vertices, with the normals of `rule`.
Model waves(std::uint32_t side, NormalRule rule) {
  Model model;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      push(model.positions, {0.1 * x, 0.1 * y, 0.3 * std::sin(0.4 * x) * std::cos(0.3 * y)});
  model.triangles = test::grid_triangles(side, side);
  for (const RuleSum& sum : sum_by_rule(rule, model.triangles, model.positions))
    push_direction(model.normals, {sum[0], sum[1], sum[2]});
  return model;
}

/// Every vertex becomes one copy per corner, ordered by geometric vertex. `normal_of(corner)`.
template <class NormalOf>
Model split(const Model& whole, NormalOf normal_of) {
  Model model;
  std::vector<std::uint32_t> corners(whole.triangles.size());
  std::iota(corners.begin(), corners.end(), 0U);
  std::stable_sort(corners.begin(), corners.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return whole.triangles[a] < whole.triangles[b]; });
  model.triangles.resize(corners.size());
  for (std::uint32_t v = 0; v < corners.size(); ++v) {
    model.triangles[corners[v]] = v;
    model.geometric.push_back(whole.triangles[corners[v]]);
    push(model.positions, at(whole.positions, whole.triangles[corners[v]]));
    push_direction(model.normals, normal_of(corners[v]));
  }
  return model;
}

Model flat(const Model& whole) {
  return split(whole, [&](std::uint32_t corner) {
    const std::uint32_t* face = whole.triangles.data() + (corner - corner % 3);
    const Vec3 a = at(whole.positions, face[0]);
    return cross(at(whole.positions, face[1]) - a, at(whole.positions, face[2]) - a);
  });
}
Model smooth_copies(const Model& whole) {
  return split(whole, [&](std::uint32_t corner) { return at(whole.normals, whole.triangles[corner]); });
}

void scatter_normals(Model& model, Random& random, double size) {
  std::vector<float> normals;
  for (std::uint32_t v = 0; v < model.count(); ++v)
    push_direction(normals, at(model.normals, v) +
                                size * Vec3{random.symmetric(), random.symmetric(), random.symmetric()});
  model.normals = normals;
}

double worst_angle(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double worst = 0;
  for (std::size_t i = 0; i < a.size() / 3; ++i)
    worst = std::max(worst, portable_degrees_between(at(a, i), at(b, i)));
  return worst;
}

/// Codes and reads back; returns the bytes.
std::size_t check(const Model& model, const AttributeSurface& surface, double degrees) {
  const auto coded = write_surface_normals(model.normals, degrees, surface);
  EXPECT_TRUE(coded);
  if (!coded) return 0;
  EXPECT_LE(worst_angle(coded->values, model.normals), degrees);
  const auto read = read_surface_normals(coded->bytes, surface);
  EXPECT_TRUE(read) << (read ? "" : describe(read.error()));
  EXPECT_TRUE(read && *read == coded->values);
  const auto again = write_surface_normals(model.normals, degrees, surface);
  EXPECT_TRUE(again && again->bytes == coded->bytes);
  return coded->bytes.size();
}

TEST(SurfaceNormals, KeepsEveryBound) {
  Random random(1);
  for (const double degrees : {kLeastAngle, 0.01, 0.1, 0.5, 2.0, 10.0, 45.0, kMostAngle}) {
    for (const double size : {0.0, 0.01, 0.3, 1e4}) {
      Model model = waves(12, NormalRule::kAngle);
      scatter_normals(model, random, size);
      check(model, model.surface(), degrees);
      check(model, model.blind(), degrees);
    }
    for (const Model& model :
         {flat(waves(7, NormalRule::kPlain)), smooth_copies(waves(7, NormalRule::kArea))}) {
      check(model, model.surface(), degrees);
      check(model, model.blind(), degrees);
    }
  }
}

TEST(SurfaceNormals, OppositeDirectionsKeepTheBound) {
  for (const double degrees : {0.002, 0.37, 5.0, 60.0}) {
    Model model = waves(12, NormalRule::kArea);
    for (std::size_t i = 0; i < model.normals.size(); ++i)
      if (i / 3 % 3 == 0) model.normals[i] = -model.normals[i];
    check(model, model.surface(), degrees);
    for (std::size_t i = 0; i < model.normals.size(); ++i) model.normals[i] = i / 3 % 2 == 0 ? 0.F : -0.F;
    for (std::size_t i = 0; i < model.normals.size(); i += 3) model.normals[i] = i / 3 % 2 == 0 ? 1.F : -1.F;
    check(model, model.blind(), degrees);
  }
}

TEST(SurfaceNormals, ZeroVectorsStayZero) {
  Model model = waves(9, NormalRule::kAngle);
  for (const std::size_t v : {0U, 5U, 40U, 80U})
    for (std::size_t c = 0; c < 3; ++c) model.normals[3 * v + c] = 0;
  check(model, model.surface(), 0.5);
  check(model, model.blind(), 0.5);
  std::fill(model.normals.begin(), model.normals.end(), 0.F);
  check(model, model.surface(), 0.5);
}

TEST(SurfaceNormals, DegenerateFacesAndLoneVertices) {
  Model model;
  model.triangles = {0, 0, 0, 1, 1, 2, 0, 1, 2};
  for (int v = 0; v < 5; ++v) push(model.positions, {1.0 * (v == 2 ? 1 : v), 0, 0});
  Random random(3);
  for (int v = 0; v < 5; ++v)
    push_direction(model.normals, {random.symmetric(), random.symmetric(), random.symmetric()});
  check(model, model.surface(), 0.25);
  Model nothing;
  check(nothing, nothing.surface(), 0.25);
  Model far = waves(5, NormalRule::kAngle);
  for (float& x : far.positions) x *= 1e37F;
  check(far, far.surface(), 0.25);
  for (float& x : far.positions) x *= 1e-42F;
  check(far, far.surface(), 0.25);
}

TEST(Attribute, ATTR20RefusesWhatIsNoDirection) {
  Model model = waves(5, NormalRule::kAngle);
  EXPECT_FALSE(write_surface_normals(model.normals, 0, model.surface()));
  EXPECT_FALSE(write_surface_normals(model.normals, 90, model.surface()));
  EXPECT_FALSE(write_surface_normals(model.normals, std::nan(""), model.surface()));
  model.normals[7] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(write_surface_normals(model.normals, 1, model.surface()));
  model.normals[7] = std::nanf("");
  EXPECT_FALSE(write_surface_normals(model.normals, 1, model.surface()));
}

TEST(Attribute, ATTR20RejectsFieldsOutOfRange) {
  const Model model = waves(5, NormalRule::kAngle);
  const auto coded = write_surface_normals(model.normals, 0.5, model.surface());
  ASSERT_TRUE(coded);
  const auto with = [&](std::size_t place, std::uint8_t value) {
    auto bytes = coded->bytes;
    bytes[place] = std::byte{value};
    const auto read = read_surface_normals(bytes, model.surface());
    ASSERT_FALSE(read);
    EXPECT_STREQ(read.error().rule, "ATTR-20");
  };
  with(0, 6);
  with(0, 0x43);
  with(4, 0x40);
  with(4, 0x00);
  with(4, 0xbf);
  const auto read = read_surface_normals(coded->bytes, model.blind());
  EXPECT_FALSE(read);
}

TEST(Attribute, ATTR21CopiesThatShareANormalCostItOnce) {
  Random random(5);
  Model whole = waves(20, NormalRule::kAngle);
  scatter_normals(whole, random, 0.5);
  const std::size_t one = check(whole, whole.surface(), 0.2);
  const Model copies = smooth_copies(whole);
  EXPECT_GT(copies.count(), 5 * whole.count());
  EXPECT_LT(check(copies, copies.surface(), 0.2), one + one / 10);
  EXPECT_LT(check(copies, copies.blind(), 0.2), one + one / 10);
}

TEST(Attribute, ATTR21ManyCopiesTakeLinearTime) {
  // A fan whose apex has a copy for each face, with the face's normal.
  Model whole;
  constexpr std::uint32_t kFaces = 100000;
  push(whole.positions, {0, 0, 1});
  for (std::uint32_t i = 0; i <= kFaces; ++i) {
    const double angle = 6.2 * i / kFaces;
    push(whole.positions, {std::cos(angle), std::sin(angle), 0.2 * std::sin(9 * angle)});
    if (i > 0) whole.triangles.insert(whole.triangles.end(), {0, i, i + 1});
  }
  const Model model = flat(whole);
  EXPECT_LT(check(model, model.surface(), 0.5), model.count() / 8U);
  EXPECT_LT(check(model, model.blind(), 0.5), std::size_t{model.count()});
}

TEST(Attribute, ATTR22ARuleGivesTheNormals) {
  for (const NormalRule rule : {NormalRule::kPlain, NormalRule::kArea, NormalRule::kAngle,
                                NormalRule::kAreaAngle, NormalRule::kEdges}) {
    const Model model = waves(60, rule);
    EXPECT_LT(check(model, model.surface(), 0.1), 8U + 16U + model.count() * 0.05 / 8);
  }
  const Model facets = flat(waves(40, NormalRule::kAngle));
  EXPECT_LT(check(facets, facets.surface(), 0.1), 8U + 16U + facets.count() * 0.05 / 8);
}

TEST(Attribute, ATTR22AnglesArePortable) {
  const auto angle_of = [](double x, double y) {
    const FourFloats zero{};
    return static_cast<double>(corner_angles(zero + static_cast<float>(x), zero + static_cast<float>(y))[1]);
  };
  for (double angle = 0.001; angle < 3.141; angle += 0.0173)
    EXPECT_NEAR(angle_of(std::cos(angle), std::sin(angle)), angle, 2e-5);
  EXPECT_EQ(angle_of(1, 0), 0);
  EXPECT_NEAR(angle_of(-1, 0), 3.141592653589793, 1e-6);
}

TEST(Attribute, ATTR23NeighboursPredictWhatNoRuleGives) {
  // The normals of another, smooth surface over a rough one.
  Random random(11);
  Model model = waves(40, NormalRule::kAngle);
  const std::size_t exact = check(model, model.surface(), 0.2);
  for (float& x : model.positions) x += static_cast<float>(0.01 * random.symmetric());
  const std::size_t rough = check(model, model.surface(), 0.2);
  EXPECT_GT(rough, 2 * exact);
  EXPECT_LT(rough, check(model, model.blind(), 0.2));
}

TEST(Attribute, ATTR24LatticeCoversTheSphere) {
  Random random(2);
  for (const double radius : {0.003, 0.05, 0.4, 1.0}) {
    const NormalLattice lattice(static_cast<float>(radius));
    for (int i = 0; i < 20000; ++i) {
      Vec3 x{random.symmetric(), random.symmetric(), i % 2 == 0 ? random.symmetric() : -1 + 1e-3 * i / 20000};
      if (!(dot(x, x) > 0)) continue;
      x = (1 / length(x)) * x;
      const NormalFrame frame{.pole = {0, 0, 1, 0}, .first = {1, 0, 0, 0}, .second = {0, 1, 0, 0}};
      const auto p = point_of(frame, x);
      FourFloats back{};
      ASSERT_TRUE(direction_at(frame, {static_cast<float>(p[0]), static_cast<float>(p[1])}, back));
      ASSERT_LT(length(widen(back) - x), 1e-6);
      const auto row = static_cast<std::int32_t>(std::floor(p[0] / lattice.row_distance()));
      double nearest = 4;
      for (std::int32_t r = row - 1; r < row + 3; ++r) {
        const auto place = static_cast<std::int32_t>(std::floor(p[1] / lattice.place_distance()));
        for (std::int32_t k = place - 1; k < place + 3; ++k) {
          FourFloats y{};
          if (direction_at(frame, lattice.at({r, k}), y)) nearest = std::min(nearest, length(widen(y) - x));
        }
      }
      ASSERT_LE(nearest, 2 * radius * (1 + 1e-6) + 1e-6);
    }
  }
}

TEST(Attribute, ATTR24RejectsPointsOffTheSphere) {
  // A coarse lattice in the fields of a stream with large numbers.
  Random random(9);
  Model model = waves(8, NormalRule::kAngle);
  scatter_normals(model, random, 1e3);
  const auto coded = write_surface_normals(model.normals, 0.01, model.surface());
  ASSERT_TRUE(coded);
  auto bytes = coded->bytes;
  const std::array<std::uint8_t, 4> one{0x00, 0x00, 0x80, 0x3f};
  for (std::size_t i = 0; i < 4; ++i) bytes[1 + i] = std::byte{one[i]};
  const auto read = read_surface_normals(bytes, model.surface());
  ASSERT_FALSE(read);
  EXPECT_STREQ(read.error().rule, "ATTR-24");
}

TEST(Attribute, ATTR25RejectsPrefixesAndFlippedBits) {
  Random random(4);
  Model whole = waves(6, NormalRule::kAngle);
  scatter_normals(whole, random, 0.3);
  const Model model = smooth_copies(whole);
  const auto coded = write_surface_normals(model.normals, 0.3, model.surface());
  ASSERT_TRUE(coded);
  for (std::size_t size = 0; size < coded->bytes.size(); ++size)
    EXPECT_FALSE(read_surface_normals(std::span(coded->bytes).first(size), model.surface()));
  for (std::size_t i = 0; i < coded->bytes.size(); ++i) {
    auto bytes = coded->bytes;
    bytes[i] ^= std::byte{static_cast<std::uint8_t>(1U << (i % 8))};
    const auto read = read_surface_normals(bytes, model.surface());
    if (!read) continue;
    for (std::size_t v = 0; v < model.count(); ++v) EXPECT_NEAR(length(at(*read, v)), 1, 1e-6);
  }
  auto longer = coded->bytes;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(read_surface_normals(longer, model.surface()));
}

}  // namespace
}  // namespace deltamesh::surface_normals_test
