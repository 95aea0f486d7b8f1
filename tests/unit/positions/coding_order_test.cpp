// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/coding_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "entropy/coder/writer.h"
#include "format/vertex_positions.h"
#include "positions/floats/coder.h"
#include "positions/lattice/lattice.h"
#include "positions/positions.h"
#include "scenes.h"
#include "support/graph_mesh.h"

namespace deltamesh {
namespace {

constexpr CodingOrder kCodingOrders[] = {CodingOrder::kAsDecoded, CodingOrder::kBroad, CodingOrder::kDeep};

FaceList faces_of(const test::GraphMesh& mesh) {
  return {mesh.triangles, static_cast<std::uint32_t>(mesh.positions.size())};
}

std::vector<test::GraphMesh> graph_meshes() {
  return {test::sheet(14, 9), test::fragments(), test::fan(40), test::sheet(1, 1)};
}

std::vector<std::uint32_t> order_of(const FaceList& faces, CodingOrder coding_order) {
  std::vector<std::uint32_t> order;
  known_in_order(faces, coding_order, order);
  return order;
}

/// Parallelograms that end at the vertices.
std::size_t parallelograms(const KnownFaces& faces) {
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < faces.vertex_count(); ++v) count += faces.around(v).parallelogram_count;
  return count;
}

/// [POSN-10] as it is written down.
std::vector<std::uint32_t> order_by_the_letter(const FaceList& faces, bool from_front) {
  std::vector<std::uint32_t> order;
  std::vector<unsigned> known(faces.vertex_count);
  std::vector<bool> placed(faces.vertex_count);
  std::vector<std::uint32_t> lists[3];
  while (order.size() < faces.vertex_count) {
    const auto list =
        std::find_if(std::rbegin(lists), std::rend(lists), [](const auto& l) { return !l.empty(); });
    std::uint32_t v = 0;
    if (list == std::rend(lists)) {
      while (placed[v]) ++v;
    } else {
      const auto place = from_front ? list->begin() : list->end() - 1;
      v = *place;
      list->erase(place);
    }
    if (placed[v]) continue;
    placed[v] = true;
    order.push_back(v);
    for (std::size_t f = 0; f < faces.triangles.size(); f += 3) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (faces.triangles[f + corner] != v) continue;
        const std::uint32_t a = faces.triangles[f + (corner + 1) % 3];
        const std::uint32_t b = faces.triangles[f + (corner + 2) % 3];
        if (placed[a] == placed[b]) continue;
        const std::uint32_t other = placed[a] ? b : a;
        if (++known[other] <= 3) lists[known[other] - 1].push_back(other);
      }
    }
  }
  return order;
}

TEST(CodingOrder, POSN10PlacesAsItIsWritten) {
  for (const test::GraphMesh& mesh : graph_meshes()) {
    const FaceList faces = faces_of(mesh);
    EXPECT_TRUE(order_of(faces, CodingOrder::kAsDecoded).empty());
    EXPECT_EQ(order_of(faces, CodingOrder::kBroad), order_by_the_letter(faces, true));
    EXPECT_EQ(order_of(faces, CodingOrder::kDeep), order_by_the_letter(faces, false));
  }
}

TEST(CodingOrder, CornersThatRepeatAreLeftOut) {
  const std::vector<std::uint32_t> triangles = {0, 0, 1, 2, 2, 2, 1, 0, 1, 3, 1, 4};
  const FaceList faces{triangles, 6};
  EXPECT_EQ(order_of(faces, CodingOrder::kBroad), order_by_the_letter(faces, true));
  EXPECT_EQ(order_of(faces, CodingOrder::kDeep), order_by_the_letter(faces, false));
}

TEST(CodingOrder, FindsMoreParallelograms) {
  const test::GraphMesh sheet = test::sheet(40, 40);
  // From the middle outwards the rows are no help.
  std::vector<std::uint32_t> number(sheet.positions.size());
  std::iota(number.begin(), number.end(), 0U);
  std::uint32_t state = 1;
  for (std::size_t i = number.size(); i > 1; --i)
    std::swap(number[i - 1], number[(state = state * 1664525 + 1013904223) % i]);
  std::vector<std::uint32_t> triangles = sheet.triangles;
  for (std::uint32_t& v : triangles) v = number[v];
  const FaceList faces{triangles, static_cast<std::uint32_t>(number.size())};
  for (const CodingOrder coding_order : {CodingOrder::kBroad, CodingOrder::kDeep}) {
    std::vector<std::uint32_t> order;
    const KnownFaces ordered = known_in_order(faces, coding_order, order);
    EXPECT_GT(parallelograms(ordered), 3 * sheet.positions.size() / 2);
    EXPECT_GT(parallelograms(ordered), parallelograms(KnownFaces(faces)));
  }
}

TEST(CodingOrder, POSN10EveryFormComesBack) {
  for (const test::GraphMesh& mesh : graph_meshes()) {
    const FaceList faces = faces_of(mesh);
    const PredictiveParameters parameters{.lattice = cubic_lattice(mesh.box, 1e-3)};
    const auto cells = to_cells(mesh.positions, parameters.lattice);
    for (const CodingOrder coding_order : kCodingOrders) {
      for (const BlendFit fit : {BlendFit::kSquares, BlendFit::kBits}) {
        const PositionForm form{.coding_order = coding_order, .fit = fit};
        const auto bytes = write_positions(faces, cells, parameters, form);
        const auto back = read_positions(bytes, faces, parameters, mesh.box);
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_EQ(*back, *to_float_rows(to_positions(cells, parameters.lattice)));
        const auto exact = write_floats(faces, to_positions(cells, {}), {{0, 0, 0}, {1e6, 1e6, 1e6}}, form);
        const auto floats = read_positions(exact, faces, {.kind = PositionKind::kFloats, .lattice = {}},
                                           {{0, 0, 0}, {1e6, 1e6, 1e6}});
        ASSERT_TRUE(floats) << floats.error().message;
        EXPECT_EQ(*floats, *to_float_rows(to_positions(cells, {})));
      }
    }
  }
}

TEST(CodingOrder, POSN10RefusesAnUnknownOrder) {
  const test::GraphMesh mesh = test::sheet(5, 5);
  const PredictiveParameters parameters{.lattice = cubic_lattice(mesh.box, 0.1)};
  CompactWriter writer;
  writer.bits(3, 2);
  const auto bytes = writer.finish();
  const auto refused = read_positions(bytes, faces_of(mesh), parameters, mesh.box);
  ASSERT_FALSE(refused);
  EXPECT_STREQ(refused.error().rule, "POSN-10");
}

TEST(CodingOrder, SearchNeverMakesAStreamLonger) {
  for (const Scene scene : {Scene::kCad, Scene::kTerrain, Scene::kRooms}) {
    const Mesh mesh = *generate_scene(scene, 4000, 2);
    std::size_t least = ~std::size_t{0};
    for (const int effort : {0, 1, 2}) {
      EncodeOptions options{.geometry = GeometryCoder::kPredictive, .effort = effort};
      options.bits = 12;
      const auto encoded = encode(mesh, options);
      ASSERT_TRUE(encoded);
      EXPECT_TRUE(decode(encoded->bytes));
      EXPECT_LE(encoded->bytes.size(), least);
      least = encoded->bytes.size();
    }
  }
}

}  // namespace
}  // namespace deltamesh
