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
#include <vector>

#include "attributes/skin/joint_guesses.h"
#include "base/numbers/zigzag.h"
#include "entropy/coder/number_model.h"
#include "entropy/coder/symbol_models.h"
#include "positions/surroundings.h"

namespace deltamesh {

/// Joints by how lately they were coded so; new ones by their difference to the one before.
template <class Coder>
class RecentJoints {
 public:
  explicit RecentJoints(Coder& coder) : coder_(coder) {}

  /// A joint, which a reader gets; any value where the stream is invalid.
  std::int64_t code(std::int32_t joint) {
    const auto found =
        static_cast<std::uint32_t>(std::find(recent_.begin(), recent_.end(), joint) - recent_.begin());
    const std::uint32_t place = coder_.number(found, places_);
    if (place < recent_.size()) {
      const auto at = recent_.begin() + place;
      std::rotate(recent_.begin(), at, at + 1);
      return recent_.front();
    }
    const std::int32_t step = unzigzag(coder_.number(zigzag(joint - last_new_), news_));
    const std::int64_t result = std::int64_t{last_new_} + step;
    if (result < 0 || result > 0xffff) return -1;
    last_new_ = static_cast<std::int32_t>(result);
    if (recent_.size() == kKept) recent_.pop_back();
    recent_.insert(recent_.begin(), last_new_);
    return result;
  }

 private:
  static constexpr std::size_t kKept = 256;

  Coder& coder_;
  std::vector<std::int32_t> recent_;
  std::int32_t last_new_ = 0;
  NumberModel places_;
  NumberModel news_;
};

template <class Coder>
class JointCoder {
 public:
  /// `most`: what a joint may be.
  JointCoder(Coder& coder, const KnownFaces& faces, std::uint32_t most)
      : coder_(coder), faces_(faces), most_(most), recent_(coder) {}

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
      const std::int64_t joint = recent_.code(row[slot]);
      if (joint < 0 || joint > std::int64_t{most_}) return false;
      row[slot] = static_cast<std::int32_t>(joint);
    }
    return true;
  }

  Coder& coder_;
  const KnownFaces& faces_;
  std::uint32_t most_;
  RecentJoints<Coder> recent_;
  std::array<SymbolModels, 2> row_models_{SymbolModels(kRowContexts * 5, kFreshRow),
                                          SymbolModels(kRowContexts * 7, kFreshRow)};
  std::array<SymbolModels, 2> slot_models_{SymbolModels(kInfluences * 16, kFreshSlot),
                                           SymbolModels(kInfluences * 16, kFreshSlot)};
  MixWeights row_weights_;
  MixWeights slot_weights_;
};

}  // namespace deltamesh
