// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The joints that vertices hang on, from those of the vertices around [ATTR-60, ATTR-61]. One template for
// both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "attributes/skin/joint_guesses.h"
#include "base/numbers/zigzag.h"
#include "entropy/coder/number_model.h"
#include "entropy/coder/symbol_models.h"
#include "positions/surroundings.h"

namespace deltamesh {

template <class Coder>
class JointCoder {
 public:
  /// `most`: what a joint may be.
  JointCoder(Coder& coder, const KnownFaces& faces, std::uint32_t most)
      : coder_(coder), faces_(faces), most_(most) {}

  /// Codes rows[vertex], those before it being coded; a reader fills it in. False where a joint is too large.
  bool code_vertex(std::uint32_t vertex, std::span<JointRow> rows) {
    const Surroundings around = faces_.around(vertex);
    const RowsAround known(around, rows);
    JointRow& row = rows[vertex];
    const auto entries = known.entries();
    const auto listed = static_cast<unsigned>(std::min<std::size_t>(entries.size(), kMostRows));
    if (listed > 0) {
      unsigned symbol = Coder::kWrites ? known.symbol_of(row) : 0;
      if (symbol > listed) symbol = 0;
      const unsigned lead = std::min(entries[0].times - (listed > 1 ? entries[1].times : 0), 4U);
      symbol = coder_.symbol(symbol, Mixture<2>{{&row_models_[0][listed * 5 + lead],
                                                 &row_models_[1][listed * 7 + std::min(around.faces, 6U)]},
                                                &row_weights_});
      if (symbol > 0 && symbol <= listed) {
        row = entries[symbol - 1].row;
        return true;
      }
    }
    return code_slots(known, row);
  }

 private:
  static constexpr std::size_t kMostRows = 7;
  static constexpr std::size_t kRowContexts = kMostRows + 1;
  static constexpr unsigned kOther = 15;
  static constexpr SymbolModel kFreshRow{{6, 12, 4, 3, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
  static constexpr SymbolModel kFreshSlot{{16, 6, 4, 3, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 6}};

  bool code_slots(const RowsAround& known, JointRow& row) {
    unsigned before = 0;
    for (std::size_t slot = 0; slot < kInfluences; ++slot) {
      const SlotGuesses guesses(known, row, slot);
      const auto count = static_cast<unsigned>(guesses.count());
      unsigned symbol = kOther;
      if constexpr (Coder::kWrites) {
        const std::size_t place = guesses.place_of(row[slot]);
        if (place < count) symbol = static_cast<unsigned>(place);
      }
      const auto base = static_cast<unsigned>(16 * slot);
      symbol =
          coder_.symbol(symbol, Mixture<2>{{&slot_models_[0][base + 4 * std::min(count, 3U) + guesses.lead()],
                                            &slot_models_[1][base + before]},
                                           &slot_weights_});
      before = symbol;
      if (symbol < count) {
        row[slot] = guesses.at(symbol);
        continue;
      }
      const std::int64_t joint =
          std::int64_t{last_} + unzigzag(coder_.number(zigzag(row[slot] - last_), steps_));
      if (joint < 0 || joint > std::int64_t{most_}) return false;
      last_ = row[slot] = static_cast<std::int32_t>(joint);
    }
    return true;
  }

  Coder& coder_;
  const KnownFaces& faces_;
  std::uint32_t most_;
  std::int32_t last_ = 0;  ///< the last joint that was no guess
  NumberModel steps_;
  std::array<SymbolModels, 2> row_models_{SymbolModels(kRowContexts * 5, kFreshRow),
                                          SymbolModels(kRowContexts * 7, kFreshRow)};
  std::array<SymbolModels, 2> slot_models_{SymbolModels(kInfluences * 16, kFreshSlot),
                                           SymbolModels(kInfluences * 16, kFreshSlot)};
  MixWeights row_weights_;
  MixWeights slot_weights_;
};

}  // namespace deltamesh
