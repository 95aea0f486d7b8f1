// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices of faces that lie in no cube of a grid: some are the surface's, the others have places of their
// own [GRD-11]. One template for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/zigzag.h"
#include "entropy/coder/counted_bit.h"
#include "entropy/coder/number_model.h"
#include "grid/models.h"
#include "grid/rest/vertex_finder.h"
#include "positions/lattice/coder.h"

namespace deltamesh::grid {

struct RestSize {
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
};

struct RestModels {
  NumberModel vertices;
  NumberModel triangles;
  std::array<CountedBit, 4> is_shared;
  NumberModel number;
  std::array<SymbolModel, VertexPlace::kFree + 1> axis = [] {
    std::array<SymbolModel, VertexPlace::kFree + 1> models{};
    models.fill(even_model(VertexPlace::kInCube + 1));
    return models;
  }();
  std::array<std::array<std::array<NumberModel, 3>, VertexPlace::kInCube + 1>, VertexPlace::kFree + 1> steps;
};

/// The numbers of vertices and faces of the rest.
template <class Coder>
void code_rest_size(Coder& coder, RestSize& size, RestModels& models) {
  size.triangles = coder.number(size.triangles, models.triangles);
  size.vertices = coder.number(size.vertices, models.vertices);
}

/// How places of its own are coded.
struct RestForm {
  BlendTable blends = kUsualBlends;
  bool guesses = false;
};

template <class Coder>
class RestCoder {
 public:
  /// `faces`: of the rest; `finder`: of the surface's vertices; `largest`: the most that a coordinate may be.
  RestCoder(Coder& coder, RestModels& models, const KnownFaces& faces, const VertexFinder& finder,
            const std::array<std::uint32_t, 3>& largest)
      : coder_(coder),
        models_(models),
        faces_(faces),
        finder_(finder),
        largest_(largest),
        places_(faces.vertex_count()) {}

  /// `numbers`: of the rest's vertices, in the whole mesh: those of the surface, then the rest's own;
  /// `cells`: where they are. A writer's are read, a reader's made. Null, or the rule that a stream breaks.
  const char* code(RestForm form, std::span<std::uint32_t> numbers, std::span<Cell> cells) {
    code_blends(coder_, form.blends);
    form.guesses = coder_.bits(form.guesses ? 1 : 0, 1) != 0;
    LatticeCoder<Coder> field(coder_, faces_, largest_, form.blends, form.guesses);
    field.clear_history();
    const auto of_surface = static_cast<std::uint32_t>(finder_.cells().size());
    std::uint32_t next = of_surface;
    for (std::uint32_t v = 0; v < numbers.size(); ++v) {
      const NearCorners near = faces_.near(v);
      const bool is_shared = Coder::kWrites && numbers[v] < of_surface;
      if (coder_.bit(is_shared, models_.is_shared[surrounding(near)])) {
        if (!(near.known_count == 0 ? code_number(numbers[v]) : code_step(places_[near.a[0]], numbers[v])))
          return "GRD-11";
        cells[v] = finder_.cells()[numbers[v]];
        places_[v] = finder_.place_of(numbers[v]);
      } else {
        if (!field.code_vertex(v, 3, cells)) return "POSN-7";
        numbers[v] = next++;
        places_[v] = {finder_.node_of(cells[v]), VertexPlace::kFree};
      }
    }
    return nullptr;
  }

 private:
  /// Of the first known face's corners, which are the surface's: 1 both, 2 one, 3 none; 0 without a face.
  std::size_t surrounding(const NearCorners& near) const noexcept {
    if (near.known_count == 0) return 0;
    const auto is_free = [&](std::uint32_t v) { return places_[v].axis == VertexPlace::kFree ? 1U : 0U; };
    return 1 + is_free(near.a[0]) + is_free(near.b[0]);
  }

  /// As the difference to the last vertex that was coded so.
  bool code_number(std::uint32_t& number) {
    const auto step = static_cast<std::int32_t>(number - last_number_);
    const std::uint32_t code = coder_.number(zigzag(step), models_.number);
    last_number_ += static_cast<std::uint32_t>(unzigzag(code));
    number = last_number_;
    return number < finder_.cells().size();
  }

  /// By its place beside another vertex'.
  bool code_step(const VertexPlace& near, std::uint32_t& number) {
    VertexPlace place;
    if constexpr (Coder::kWrites) place = finder_.place_of(number);
    place.axis = coder_.symbol(place.axis, Mixture<1>{{&models_.axis[near.axis]}});
    if (place.axis > VertexPlace::kInCube) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t code =
          coder_.number(zigzag(place.node[k] - near.node[k]), models_.steps[near.axis][place.axis][k]);
      const std::int64_t node = std::int64_t{near.node[k]} + unzigzag(code);
      if (node < 0 || node > std::int64_t{largest_[k]}) return false;
      place.node[k] = static_cast<std::int32_t>(node);
    }
    number = finder_.find(place);
    return number != kNoVertex;
  }

  Coder& coder_;
  RestModels& models_;
  const KnownFaces& faces_;
  const VertexFinder& finder_;
  std::array<std::uint32_t, 3> largest_;
  std::vector<VertexPlace> places_;  ///< of the vertices so far
  std::uint32_t last_number_ = 0;
};

}  // namespace deltamesh::grid
