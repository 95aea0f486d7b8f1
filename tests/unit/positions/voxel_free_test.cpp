// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices on no edge among vertices on edges: a stream read by the letter of the rules.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "base/numbers/zigzag.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"
#include "positions/grid/faces.h"
#include "positions/lattice/coder.h"
#include "positions/positions.h"
#include "positions/residual_coder.h"

namespace deltamesh::voxel_free_test {
namespace {

using Numbers = std::array<std::int64_t, 3>;

/// What [POSN-5] keeps of a vertex, or the mean of some.
struct Kept {
  Numbers residual{};
  Numbers magnitude{};
};

std::int64_t quarter_octaves_by_the_letter(std::int64_t y) {
  const auto log = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(y))) - 1;
  return 4 * log + (log >= 2 ? y >> (log - 2) : y << (2 - log)) % 4;
}

/// [POSN-5, POSN-6], of axis `a`. `coded`: as there.
ResidualPrediction prediction_by_the_letter(std::int64_t place, std::int64_t spread, const Kept& mean,
                                            std::uint32_t sources, std::size_t a, std::int64_t coded) {
  const Numbers& g = mean.magnitude;
  std::int64_t scale = (5 * g[a] + 3 * ((g[0] + g[1] + g[2]) / 3)) >> 3;
  if (sources > 2) scale = (scale + spread) >> 1;
  if (sources < 2) scale = std::max(scale, spread);
  ++scale;
  const auto bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(scale)));
  const int shift = std::max(bits - 6, 0);
  const std::int64_t off = place - 16 * ((place + 8) >> 4) - (mean.residual[a] >> 2);
  std::int64_t sure = 0;
  if (shift == 0) sure = std::min(std::abs(off), std::int64_t{8}) / 2;
  if (shift > 0 && a > 0) sure = (4 * coded < scale ? 1 : 0) + (coded >= 2 * scale ? 2 : 0);
  const std::int64_t w = quarter_octaves_by_the_letter(scale);
  const std::int64_t s = shift == 0 ? std::max(w >> 1, w - 4) : w - 4 * shift;
  std::int64_t t = 0;
  if (spread > 0) {
    t = quarter_octaves_by_the_letter(spread) - 4 * shift;
    t = std::clamp<std::int64_t>(std::max((t + 2) >> 1, t - 3), 0, 23);
  }
  ResidualPrediction prediction;
  prediction.whole = (place + 8) >> 4;
  prediction.shift = static_cast<unsigned>(shift);
  prediction.sign = off < 0 ? -1 : 0;
  prediction.contexts = {static_cast<std::uint32_t>((s * 5 + sources) * 5 + sure),
                         static_cast<std::uint32_t>((t * 5 + sources) * 3 + static_cast<std::int64_t>(a))};
  prediction.weight_set = static_cast<std::uint32_t>(a) * 5 + sources;
  return prediction;
}

/// [VOX-1, VOX-5] without cubes, and [POSN-12], with one level.
class LetterReader {
 public:
  LetterReader(CompactReader& reader, const VoxelFaces& faces)
      : cells(faces.vertex_count()),
        reader_(reader),
        faces_(faces),
        residuals_(reader),
        kept_(cells.size()) {}

  void read(std::uint32_t v) {
    const Surroundings around = faces_.around(v);
    const Expectation expected =
        expect_place(around, v == faces_.second_sequence() ? 0 : v, cells, kUsualBlends);
    const unsigned start = reader_.symbol(0, Mixture<1>{{&start_}});
    if (start == 3) return read_free(v, around, expected);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto below = (expected.place()[a] >> 4) / 2;
      cells[v][a] = 2 * static_cast<std::int32_t>(below + unzigzag(reader_.number(0, nodes_[a])));
    }
    ++cells[v][start];
  }

  std::vector<Cell> cells;
  std::vector<std::uint32_t> sources;  ///< of the free vertices

 private:
  void read_free(std::uint32_t v, const Surroundings& around, const Expectation& expected) {
    Kept mean;
    const unsigned known = std::min(around.known_count, 2U);
    for (unsigned i = 0; i < known; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const std::uint32_t u : {around.known[i].a, around.known[i].b}) {
          mean.residual[axis] += kept_[u].residual[axis];  // 0 of those on edges
          mean.magnitude[axis] += kept_[u].magnitude[axis];
        }
      }
    }
    for (unsigned halves = 0; halves < known; ++halves)
      for (Numbers* numbers : {&mean.residual, &mean.magnitude})
        for (std::int64_t& number : *numbers) number >>= 1;
    const std::uint32_t count = around.parallelogram_count;
    sources.push_back(count > 0 ? std::min(count, 3U) + 1 : (known > 0 ? 1 : 0));
    std::int64_t coded = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t place = expected.place()[a];
      const ResidualPrediction prediction = prediction_by_the_letter(
          place, expected.spread[static_cast<int>(a)], mean, sources.back(), a, coded);
      const std::int64_t x = residuals_.code(0, prediction);
      cells[v][a] = static_cast<std::int32_t>(prediction.whole + x);
      coded = a == 0 ? 16 * std::abs(x) : (coded + 16 * std::abs(x)) >> 1;
      const std::int64_t e = 16 * cells[v][a] - place;
      kept_[v].residual[a] = e;
      kept_[v].magnitude[a] =
          sources.back() == 0 ? std::abs(e) : (5 * std::abs(e) + 3 * mean.magnitude[a]) >> 3;
    }
  }

  CompactReader& reader_;
  const VoxelFaces& faces_;
  SymbolModel start_{{8, 8, 8, 8, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
  std::array<NumberModel, 3> nodes_;
  ResidualCoder<CompactReader> residuals_;
  std::vector<Kept> kept_;
};

TEST(Voxels, VOX1POSN5FreeVerticesAmongVerticesOnEdgesAreAsWritten) {
  // 3, 4, 5 and 9 are free. All around 3 are on edges, with a parallelogram; around 5 without one.
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 2, 1, 3, 3, 2, 4, 0, 1, 5};
  const FaceList list{triangles, 12};
  std::vector<Cell> cells;
  for (std::int32_t v = 0; v < 12; ++v) {
    cells.push_back({20 * (v % 6) + 1, 2 * (v * v % 7), 100 + 2 * (3 * v % 5)});
    if (v == 3 || v == 4 || v == 5 || v == 9) cells.back()[1] += 31;
  }
  const PredictiveParameters parameters{
      .kind = PositionKind::kVoxel, .lattice = {.cells = {4096, 4096, 4096}}, .levels = 1};
  const auto bytes = write_positions(list, cells, parameters);

  CompactReader reader(bytes);
  CodingOrder coding_order{};
  ASSERT_TRUE(code_coding_order(reader, coding_order));
  const VoxelFaces faces(list);
  LetterReader letter(reader, faces);
  for (std::uint32_t step = 0; step < 6; ++step) {
    letter.read(step);
    letter.read(step + 6);
  }
  EXPECT_TRUE(reader.finish(kTagPositions));
  EXPECT_EQ(letter.cells, cells);
  // In the order of steps; 9 has no faces.
  EXPECT_EQ(letter.sources, (std::vector<std::uint32_t>{2, 0, 2, 1}));
}

}  // namespace
}  // namespace deltamesh::voxel_free_test
