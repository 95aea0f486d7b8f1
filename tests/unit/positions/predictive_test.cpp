// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The predictive coder: what it writes comes back, within the bounds, and what it cannot read it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"
#include "format/container.h"
#include "format/vertex_positions.h"
#include "positions/floats/order.h"
#include "positions/guess_trial.h"
#include "positions/lattice/axis_values.h"
#include "positions/lattice/coder.h"
#include "positions/lattice/lattice.h"
#include "positions/positions.h"
#include "scenes.h"
#include "support/graph_mesh.h"
#include "support/meshes.h"

namespace deltamesh::predictive_test {
namespace {

std::vector<test::GraphMesh> graph_meshes() {
  return {test::sheet(14, 9), test::fragments(), test::fan(40), test::sheet(1, 1), test::finish({})};
}

FaceList faces_of(const test::GraphMesh& mesh) {
  return {mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size())};
}

const char* rule_of(const Result<std::vector<float>>& result) { return result ? "" : result.error().rule; }

/// Largest distance of a decoded vertex from its original.
double largest_error(const Mesh& mesh, const Encoded& encoded) {
  const auto decoded = decode(encoded.bytes);
  if (!decoded) return HUGE_VAL;
  double largest = 0;
  for (std::size_t v = 0; v < decoded->vertex_count(); ++v) {
    double squares = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double off = double{decoded->positions[3 * v + axis]} -
                         double{mesh.positions[std::size_t{3} * encoded.order[v] + axis]};
      squares += off * off;
    }
    largest = std::max(largest, std::sqrt(squares));
  }
  return largest;
}

TEST(Predictive, POSN2POSN3POSN4POSN5POSN6POSN8POSN9CellsComeBack) {
  for (const test::GraphMesh& mesh : graph_meshes()) {
    const FaceList faces = faces_of(mesh);
    for (const double step : {2.0, 0.1, 1e-3, 1e-7, 1e-30}) {
      const PositionLattice lattice = cubic_lattice(mesh.box, step);
      const auto cells = to_cells(mesh.positions, lattice);
      const auto bytes = write_positions(faces, cells, {.lattice = lattice});
      const auto back = read_positions(bytes, faces, {.lattice = lattice}, mesh.box);
      ASSERT_TRUE(back) << back.error().message;
      EXPECT_EQ(*back, *to_float_rows(to_positions(cells, lattice)));
      const auto guessed =
          write_positions(faces, cells, {.lattice = lattice}, {.guesses = Guessing::kAlways});
      EXPECT_EQ(*read_positions(guessed, faces, {.lattice = lattice}, mesh.box), *back);
    }
  }
}

TEST(Predictive, VerticesWithoutFacesComeBack) {
  for (const std::size_t lone : {std::size_t{1}, std::size_t{5}, std::size_t{300}}) {
    test::GraphMesh mesh = test::sheet(7, 5);
    for (std::size_t i = 0; i < lone; ++i) mesh.positions.push_back({0.5 * static_cast<double>(i), 3, -2});
    mesh = test::finish(mesh);
    const FaceList faces = faces_of(mesh);
    for (const CodingOrder coding_order :
         {CodingOrder::kAsDecoded, CodingOrder::kBroad, CodingOrder::kDeep}) {
      const PredictiveParameters parameters{.lattice = cubic_lattice(mesh.box, 0.5)};
      const auto cells = to_cells(mesh.positions, parameters.lattice);
      const auto coded = write_positions(faces, cells, parameters, {.coding_order = coding_order});
      const auto decoded = read_positions(coded, faces, parameters, mesh.box);
      ASSERT_TRUE(decoded) << decoded.error().message;
      EXPECT_EQ(*decoded, *to_float_rows(to_positions(cells, parameters.lattice)));
      std::vector<Vec3> floats = mesh.positions;
      for (Vec3& p : floats) p[2] = static_cast<double>(static_cast<float>(p[2]));
      const auto bytes = write_floats(faces, floats, mesh.box, {.coding_order = coding_order});
      const auto back =
          read_positions(bytes, faces, {.kind = PositionKind::kFloats, .lattice = {}}, mesh.box);
      ASSERT_TRUE(back) << back.error().message;
      EXPECT_EQ(*back, *to_float_rows(floats));
    }
  }
}

TEST(Predictive, ParallelogramsPredictAPlaneExactly) {
  test::GraphMesh mesh = test::sheet(60, 60);
  for (Vec3& p : mesh.positions) p[2] = 3 * p[0] + p[1];
  mesh = test::finish(mesh);
  const PositionLattice lattice = cubic_lattice(mesh.box, 1);
  const auto bytes = write_positions(faces_of(mesh), to_cells(mesh.positions, lattice), {.lattice = lattice});
  EXPECT_LT(8 * bytes.size(), mesh.positions.size());
}

TEST(Predictive, POSN1RefusesPayloadsWithoutVertices) {
  const test::GraphMesh mesh = test::sheet(5, 5);
  const PositionLattice lattice = cubic_lattice(mesh.box, 0.1);
  const auto bytes = write_positions(faces_of(mesh), to_cells(mesh.positions, lattice), {.lattice = lattice});
  const FaceList none;
  EXPECT_STREQ(rule_of(read_positions(bytes, none, {.lattice = lattice}, mesh.box)), "POSN-1");
  EXPECT_TRUE(read_positions({}, none, {.lattice = lattice}, mesh.box));
}

TEST(Predictive, POSN7RefusesCoordinatesBeyondTheLattice) {
  const test::GraphMesh mesh = test::sheet(5, 5);
  PositionLattice lattice = cubic_lattice(mesh.box, 0.1);
  const auto bytes = write_positions(faces_of(mesh), to_cells(mesh.positions, lattice), {.lattice = lattice});
  lattice.cells[1] -= 1;
  EXPECT_STREQ(rule_of(read_positions(bytes, faces_of(mesh), {.lattice = lattice}, mesh.box)), "POSN-7");
}

TEST(Predictive, EveryPrefixIsTruncated) {
  const test::GraphMesh mesh = test::sheet(6, 5);
  const PositionLattice lattice = cubic_lattice(mesh.box, 0.01);
  const auto bytes = write_positions(faces_of(mesh), to_cells(mesh.positions, lattice), {.lattice = lattice});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::byte> prefix(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(read_positions(prefix, faces_of(mesh), {.lattice = lattice}, mesh.box)) << size;
  }
}

TEST(Predictive, TheAskedMaximumIsNeverExceeded) {
  for (const auto& named : test::awkward_meshes()) {
    for (const double asked : {0.3, 0.01, 1e-4, 1e-12}) {
      for (const int effort : {0, 1}) {
        const auto encoded = encode(named.mesh, {.quality = {.max_error = QualityBound{asked}},
                                                 .geometry = GeometryCoder::kPredictive,
                                                 .effort = effort});
        ASSERT_TRUE(encoded) << named.name;
        EXPECT_LE(largest_error(named.mesh, *encoded), asked) << named.name;
        EXPECT_EQ(encoded->report.stream.geometry, "predictive");
      }
    }
  }
}

TEST(Predictive, LfeAndVdeLandBelowWhatIsAsked) {
  Mesh mesh = test::bumpy_grid(40, 30);
  std::uint32_t state = 1;
  for (float& x : mesh.positions)
    x += static_cast<float>((state = state * 1664525 + 1013904223) >> 8) * 1e-8F;
  for (const double asked : {0.05, 0.002}) {
    const auto lfe =
        encode(mesh, {.quality = {.lfe = QualityBound{asked}}, .geometry = GeometryCoder::kPredictive});
    const auto vde =
        encode(mesh, {.quality = {.vde = QualityBound{asked}}, .geometry = GeometryCoder::kPredictive});
    ASSERT_TRUE(lfe && vde);
    EXPECT_LE(lfe->report.stream.quality.lfe_rms, asked);
    EXPECT_GE(lfe->report.stream.quality.lfe_rms, 0.9 * asked);
    EXPECT_LE(vde->report.stream.quality.vde_rms, asked);
    EXPECT_GE(vde->report.stream.quality.vde_rms, 0.9 * asked);
  }
}

TEST(Predictive, AxesThatAreGridsKeepTheirSteps) {
  // A terrain of whole metres over a grid of 300 m, far from the origin.
  Mesh mesh = test::bumpy_grid(40, 30);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    mesh.positions[3 * v] = 560000 + 30 * std::round(mesh.positions[3 * v] * 10);
    mesh.positions[3 * v + 1] = 5100000 + 30 * std::round(mesh.positions[3 * v + 1] * 10);
    mesh.positions[3 * v + 2] = static_cast<float>(v * v % 97);
  }
  const auto encoded =
      encode(mesh, {.quality = {.max_error = QualityBound{0.25}}, .geometry = GeometryCoder::kPredictive});
  ASSERT_TRUE(encoded);
  EXPECT_EQ(largest_error(mesh, *encoded), 0);
  EXPECT_NEAR(encoded->report.stream.step, 300, 0.001);
  const auto coarse =
      encode(mesh, {.quality = {.max_error = QualityBound{20}}, .geometry = GeometryCoder::kPredictive});
  ASSERT_TRUE(coarse);
  EXPECT_LE(largest_error(mesh, *coarse), 20);
  EXPECT_LT(coarse->bytes.size(), encoded->bytes.size());
}

TEST(Predictive, QuantisedSourcesNeedNoPlanes) {
  // A lattice of 7845 steps, written with six decimals: few coordinates are equal.
  std::vector<Vec3> positions;
  std::uint32_t state = 1;
  const auto next = [&] {
    const double q = (state = state * 1664525 + 1013904223) >> 19;
    return static_cast<double>(static_cast<float>(std::round(1e6 * (q - 3922) / 7845) / 1e6));
  };
  for (int i = 0; i < 6000; ++i) positions.push_back({next(), next(), next()});
  Box box{positions[0], positions[0]};
  for (const Vec3& p : positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], p[axis]);
      box.max[axis] = std::max(box.max[axis], p[axis]);
    }
  }
  for (const AxisGrid& grid : fit_axes(AxisValues(positions), box)) EXPECT_NEAR(grid.step, 1 / 7845.0, 1e-10);
}

TEST(Predictive, AutoIsTheSmallerOfTheTwo) {
  const Mesh mesh = test::bumpy_grid(50, 40);
  for (const QualityRequest& request :
       {QualityRequest{.vde = QualityBound{0.01}}, QualityRequest{.max_error = QualityBound{0.01}}}) {
    std::uint64_t smallest = ~std::uint64_t{0};
    for (const GeometryCoder coder : {GeometryCoder::kHighpass, GeometryCoder::kPredictive}) {
      const auto encoded = encode(mesh, {.quality = request, .geometry = coder});
      if (encoded) smallest = std::min<std::uint64_t>(smallest, encoded->bytes.size());
    }
    const auto chosen = encode(mesh, {.quality = request});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->bytes.size(), smallest);
  }
}

/// The generated map of a scanned room: marching cubes on a voxel grid.
Mesh room() { return *generate_scene(Scene::kRooms, 6000, 3); }

/// The bits of the decoded mesh are those of the input, vertex by vertex, whatever their order.
void expect_lossless(const Mesh& mesh, bool keep_order) {
  const auto encoded = encode(mesh, {.lossless = true, .keep_order = keep_order, .keep_unreferenced = true});
  ASSERT_TRUE(encoded) << describe(encoded.error());
  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded) << describe(decoded.error());
  ASSERT_EQ(decoded->vertex_count(), mesh.vertex_count());
  for (std::size_t v = 0; v < decoded->vertex_count(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_EQ(std::bit_cast<std::uint32_t>(decoded->positions[3 * v + axis]),
                std::bit_cast<std::uint32_t>(mesh.positions[std::size_t{3} * encoded->order[v] + axis]));
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
    const std::size_t row = mesh.attributes[a].values.size() / mesh.vertex_count();
    for (std::size_t v = 0; v < decoded->vertex_count(); ++v)
      ASSERT_TRUE(std::equal(
          decoded->attributes[a].values.begin() + static_cast<std::ptrdiff_t>(v * row),
          decoded->attributes[a].values.begin() + static_cast<std::ptrdiff_t>((v + 1) * row),
          mesh.attributes[a].values.begin() + static_cast<std::ptrdiff_t>(encoded->order[v] * row)));
  }
  if (keep_order) {
    EXPECT_EQ(decoded->triangles, mesh.triangles);
  }
  EXPECT_EQ(encoded->report.stream.quality.max_error, 0);
}

TEST(Lossless, FLT1FLT2FLT3FLT4EveryBitComesBack) {
  for (const auto& named : test::awkward_meshes()) {
    SCOPED_TRACE(named.name);
    expect_lossless(named.mesh, false);
    expect_lossless(named.mesh, true);
  }
  expect_lossless(test::attributed_grid(9, 8), true);
  expect_lossless(room(), false);
}

TEST(Lossless, FloatsOfEverySizeComeBack) {
  std::uint32_t state = 1;
  const auto random = [&state] { return state = state * 1664525 + 1013904223; };
  Mesh mesh = test::bumpy_grid(12, 12);
  for (float& x : mesh.positions) {
    do x = std::bit_cast<float>(random());
    while (!std::isfinite(x));
  }
  expect_lossless(mesh, true);
  for (float& x : mesh.positions) x = std::bit_cast<float>((random() >> 9 & 7) | (random() & 0x80000000U));
  expect_lossless(mesh, true);  // the smallest of all, and both zeros
}

TEST(Lossless, OrdinalsFollowTheFloats) {
  EXPECT_EQ(ordinal_of(0.0F), 0);
  EXPECT_EQ(ordinal_of(-0.0F), -1);
  for (const float x : {1.0F, 3.1e-42F, 1e-30F, 7.5F, 3.4e38F}) {
    EXPECT_EQ(float_of(ordinal_of(x)), x);
    EXPECT_EQ(float_of(ordinal_of(-x)), -x);
    const int unit = unit_exponent(0, x);
    EXPECT_EQ(float_of(ordinal_of_fixed(fixed_of(ordinal_of(x), unit), unit)), x);
  }
}

TEST(Lossless, FLT1RefusesWhatIsNotFinite) {
  const test::GraphMesh mesh = test::sheet(8, 8);
  std::uint32_t state = 1;
  std::size_t refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<std::byte> bytes(400);
    for (std::byte& b : bytes) b = static_cast<std::byte>((state = state * 1664525 + 1013904223) >> 24);
    bytes[0] = std::byte{0x88};  // two states of 8 bytes
    bytes[8] = bytes[16] = std::byte{0x3f};
    const auto back = read_positions(bytes, faces_of(mesh), {.kind = PositionKind::kFloats, .lattice = {}},
                                     {{0, 0, 0}, {3e38, 3e38, 3e38}});
    if (!back) refused += std::string(back.error().rule) == "FLT-1" ? 1 : 0;
  }
  EXPECT_GT(refused, 0U);
}

TEST(Voxels, EdgesComeBack) {
  const Mesh mesh = room();
  for (const double asked : {0.03, 0.004, 0.0004}) {
    const auto encoded =
        encode(mesh, {.quality = {.max_error = QualityBound{asked}}, .geometry = GeometryCoder::kPredictive});
    ASSERT_TRUE(encoded);
    const auto container = Container::open(encoded->bytes);
    EXPECT_EQ(container->header().predictive.kind, PositionKind::kVoxel);
    EXPECT_LE(largest_error(mesh, *encoded), asked);
  }
}

TEST(Voxels, PartlyGriddedMeshesComeBack) {
  Mesh mesh = room();
  std::uint32_t state = 7;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    state = state * 1664525 + 1013904223;
    if ((state >> 28) > 6) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      mesh.positions[3 * v + axis] += static_cast<float>(state >> 8) * 1e-9F;
  }
  const auto encoded =
      encode(mesh, {.quality = {.max_error = QualityBound{0.004}}, .geometry = GeometryCoder::kPredictive});
  ASSERT_TRUE(encoded);
  EXPECT_LE(largest_error(mesh, *encoded), 0.004);
}

TEST(Predictive, QuickStreamsDeclareWhatADecoderGets) {
  std::size_t compared = 0;
  for (const auto& [name, mesh] : test::awkward_meshes()) {
    for (const bool all : {false, true}) {
      const auto encoded = encode(
          mesh, {.geometry = GeometryCoder::kPredictive, .effort = 0, .bits = 7, .keep_unreferenced = all});
      ASSERT_TRUE(encoded) << name;
      const auto decoded = decode(encoded->bytes);
      ASSERT_TRUE(decoded) << name;
      const auto comparison = compare(mesh, *decoded, encoded->order);
      ASSERT_TRUE(comparison) << name;
      if (!comparison->corresponding) continue;
      ++compared;
      const Quality& declared = encoded->report.stream.quality;
      const Quality& measured = comparison->quality;
      EXPECT_NEAR(declared.vde_rms, measured.vde_rms, 0x1p-15 * measured.vde_rms) << name;
      EXPECT_NEAR(declared.lfe_rms, measured.lfe_rms, 0x1p-15 * measured.lfe_rms) << name;
      EXPECT_GE(declared.max_error, measured.max_error) << name;
    }
  }
  EXPECT_GT(compared, 20U);
}

TEST(Guesses, PayWhereCoordinatesComeAgainFarFromWhatIsExpected) {
  // Columns of a prism at uneven places, and a surface without any equal coordinates.
  std::vector<std::uint32_t> triangles;
  std::vector<Cell> prism;
  std::vector<Cell> rough;
  std::uint32_t state = 3;
  for (std::uint32_t v = 0; v < 4000; ++v) {
    state = state * 1664525 + 1013904223;
    if (v % 2 == 0)
      prism.push_back({static_cast<int>(state >> 20), static_cast<int>((state >> 8) % 4096), 7});
    if (v % 2 == 1) prism.push_back({prism.back()[0], prism.back()[1], 900});
    rough.push_back({static_cast<int>(10 * v + (state >> 28)), static_cast<int>(3 * v + (state >> 8) % 999),
                     static_cast<int>((state >> 12) % 4096)});
    if (v >= 2) triangles.insert(triangles.end(), {v - 2, v - 1, v});
  }
  const KnownFaces faces({triangles, 4000});
  const std::array<std::uint32_t, 3> largest = {1U << 20, 1U << 20, 1U << 20};
  EXPECT_TRUE(guesses_pay(faces, prism, largest, kUsualBlends));
  EXPECT_FALSE(guesses_pay(faces, rough, largest, kUsualBlends));
  EXPECT_FALSE(guesses_pay(KnownFaces(FaceList{}), {}, largest, kUsualBlends));
}

TEST(AxisValues, AscendAsNumbersDo) {
  std::vector<Vec3> positions;
  std::uint32_t state = 5;
  for (int i = 0; i < 5000; ++i) {
    state = state * 1664525 + 1013904223;
    const double x = static_cast<float>(static_cast<std::int32_t>(state)) * (i % 3 == 0 ? 1e-30F : 1e-3F);
    positions.push_back({x, i % 2 == 0 ? 0.0 : -0.0, static_cast<double>(i % 9)});
  }
  const AxisValues all(positions);
  const AxisValues some(positions, 2000);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(all.sorted(axis).size(), 5000U);
    EXPECT_TRUE(std::is_sorted(all.sorted(axis).begin(), all.sorted(axis).end()));
    EXPECT_EQ(some.sorted(axis).size(), 1667U);
    double sum = 0;
    for (const float x : all.sorted(axis)) sum += x;
    for (const Vec3& position : positions) sum -= position[axis];
    EXPECT_NEAR(sum, 0, 1e-2);
  }
  EXPECT_FALSE(all.has_repeats(0));
  EXPECT_TRUE(all.has_repeats(1));
  EXPECT_TRUE(all.has_repeats(2));
  EXPECT_EQ(all.count_distances(2, 0.5, 1.5), 8U);
}

TEST(Predictive, POSN3ManyFacesAtOneEdgeTakeLinearTime) {
  // Pages of a book whose free corners come before the spine, and one triangle many times over: looked across
  // without a limit, every page would visit every other.
  constexpr std::uint32_t kPages = 200'000;
  test::GraphMesh book;
  book.positions.resize(kPages + 2);
  for (std::uint32_t v = 0; v < kPages + 2; ++v) book.positions[v] = {double(v % 97), double(v % 89), 0};
  for (std::uint32_t page = 0; page < kPages; ++page)
    for (const std::uint32_t corner : {page, kPages, kPages + 1}) book.triangles.push_back(corner);
  for (std::uint32_t copy = 0; copy < kPages; ++copy)
    for (const std::uint32_t corner : {0U, 1U, 2U}) book.triangles.push_back(corner);
  const KnownFaces faces(faces_of(book));
  for (const std::uint32_t v : {2U, kPages, kPages + 1}) {
    const Surroundings around = faces.around(v);
    EXPECT_EQ(around.known_count, v == kPages ? 0 : Surroundings::kMostKnown);
    EXPECT_EQ(around.faces, v == 2 ? kPages + 1 : kPages);
  }
}

TEST(Predictive, AStepTooFineForTheLatticeIsRefused) {
  const auto refused =
      encode(test::bumpy_grid(4, 4), {.geometry = GeometryCoder::kPredictive, .step = 1e-12});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
}

TEST(Predictive, BytesToSpareBuyEveryBit) {
  const Mesh rooms = *generate_scene(Scene::kRooms, 3000, 3);
  const Mesh terrain = *generate_scene(Scene::kTerrain, 3000, 3);
  Mesh of_few_decimals = terrain;
  for (float& x : of_few_decimals.positions) x = std::round(x * 10) / 10;
  const Mesh sphere = *generate_scene(Scene::kSphere, 300, 1);
  for (const Mesh& mesh : {rooms, terrain, of_few_decimals, sphere}) {
    const auto exact = encode(mesh, {.geometry = GeometryCoder::kPredictive, .lossless = true});
    ASSERT_TRUE(exact);
    EncodeOptions options{.geometry = GeometryCoder::kPredictive};
    options.quality.target_bytes = exact->bytes.size() + 100;
    const auto fitted = encode(mesh, options);
    ASSERT_TRUE(fitted) << describe(fitted.error());
    EXPECT_EQ(fitted->report.stream.quality.max_error, 0);
    options.quality.target_bytes = exact->bytes.size() * 9 / 10;
    const auto less = encode(mesh, options);
    ASSERT_TRUE(less) << describe(less.error());
    EXPECT_LE(less->bytes.size(), *options.quality.target_bytes);
    EXPECT_GT(less->report.stream.quality.max_error, 0);
  }
}

TEST(Predictive, EveryBudgetAboveTheLeastIsMet) {
  const Mesh mesh = *generate_scene(Scene::kTerrain, 3000, 3);
  EncodeOptions options{.geometry = GeometryCoder::kPredictive};
  options.quality.target_bytes = 1;
  const auto least = encode(mesh, options);
  ASSERT_FALSE(least);
  double last = HUGE_VAL;
  for (const double times : {1.0, 1.02, 1.2, 2.0, 4.0}) {
    options.quality.target_bytes =
        static_cast<std::uint64_t>(times * static_cast<double>(least.error().best_bytes));
    const auto fitted = encode(mesh, options);
    ASSERT_TRUE(fitted) << times << ' ' << describe(fitted.error());
    EXPECT_LE(fitted->bytes.size(), *options.quality.target_bytes);
    // VDE is least where nothing is left of the relief, as in the fewest bytes.
    EXPECT_LE(fitted->report.stream.quality.lfe_rms, last);
    last = fitted->report.stream.quality.lfe_rms;
  }
}

TEST(Predictive, HDR14TheMostBitsAreCoded) {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0.3F, 0.7F, 0.1F};
  mesh.triangles = {0, 1, 2};
  const auto encoded = encode(mesh, {.geometry = GeometryCoder::kPredictive, .bits = 28});
  ASSERT_TRUE(encoded) << describe(encoded.error());
  EXPECT_LE(encoded->report.stream.quality.max_error, 0x1p-28);
  EXPECT_TRUE(decode(encoded->bytes));
}

TEST(Predictive, OptionsThatDoNotFitAreRefused) {
  const GeometryCoder predictive = GeometryCoder::kPredictive;
  EXPECT_TRUE(validate({.geometry = predictive, .bits = 28}));
  EXPECT_FALSE(validate({.geometry = predictive, .bits = 29}));
  EXPECT_FALSE(validate({.geometry = predictive, .anchors = 3}));
  EXPECT_FALSE(validate({.geometry = predictive, .anchor_density = 3}));
  EXPECT_TRUE(validate({.geometry = predictive, .lossless = true, .profile = Profile::kZstd}));
  EXPECT_TRUE(validate({.geometry = predictive, .lossless = true}));
  EXPECT_FALSE(validate({.geometry = GeometryCoder::kHighpass, .lossless = true}));
  EXPECT_FALSE(validate({.quality = {.max_error = QualityBound{1}}, .lossless = true}));
  EXPECT_FALSE(validate({.lossless = true, .bits = 8}));
}

}  // namespace
}  // namespace deltamesh::predictive_test
