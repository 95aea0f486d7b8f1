// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Adaptive models of the coder of border ops [CONN-12].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "connectivity/faces/border.h"
#include "entropy/coder/number_model.h"
#include "entropy/coder/symbol_models.h"

namespace deltamesh {

struct OpModels {
  /// A run is up to 6 ops C and the op that closes it, or 7 ops C before another run. Its symbol is the
  /// number of ops C where R closes it, 7 more where another op does, which follows, or 14.
  static constexpr unsigned kLongestRun = 7;
  static constexpr unsigned kClosedByRare = kLongestRun;
  static constexpr unsigned kGoesOn = 2 * kLongestRun;

  static constexpr std::size_t kRunContexts = kMostFaces * 128;
  static constexpr std::size_t kRareNears = 4 * 16;  ///< what both of a rare op's contexts have

  OpModels() {
    constexpr std::size_t kOfFaces = kRunContexts / kMostFaces;
    for (std::uint32_t faces = 1; faces <= kMostFaces; ++faces) {
      const SymbolModel fresh = fresh_run(faces);
      for (auto* const models : {&first_runs, &second_runs})
        models->fill((faces - 1) * kOfFaces, kOfFaces, fresh);
    }
  }

  /// The fewer faces a vertex has, the more are still to come, up to six.
  static SymbolModel fresh_run(std::uint32_t faces) noexcept {
    std::array<std::uint8_t, kSymbols> weights{};
    weights.fill(1);
    const std::uint32_t likely = faces < 5 ? 5 - faces : 0;
    for (std::uint32_t k = 0; k < kLongestRun; ++k) {
      const std::uint32_t off = std::max(k, likely) - std::min(k, likely);
      if (off <= 2) weights[k] = static_cast<std::uint8_t>(32 >> (2 * off));
    }
    weights[kClosedByRare] = 6;
    weights[kClosedByRare + 1] = 2;
    return SymbolModel(weights);
  }

  /// The first quarter is of step 1 [CONN-6].
  static SymbolModels fresh_rares(std::size_t contexts_of_near) {
    constexpr SymbolModel kFirstStep{{0, 8, 0, 8, 1, 6, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
    constexpr SymbolModel kSecondStep{{8, 1, 1, 0, 1, 8, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
    const std::size_t count = kRareNears * contexts_of_near;
    SymbolModels models(count, kSecondStep);
    models.fill(0, count / 4, kFirstStep);
    return models;
  }

  void limit_counts(std::uint8_t most) noexcept {
    for (auto* const models : {&first_runs, &second_runs, &first_rares, &second_rares})
      models->limit_counts(most);
    references.length.limit_count(most);
  }

  SymbolModels first_runs{kRunContexts};
  SymbolModels second_runs{kRunContexts};
  std::array<MixWeights, kMostFaces * 4> run_weights;
  SymbolModels first_rares = fresh_rares(16);
  SymbolModels second_rares = fresh_rares(8);
  std::array<MixWeights, kRareNears> rare_weights;
  NumberModel references;
};

}  // namespace deltamesh
