// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Groups of faces by the compact coder: a face mostly has the group of the faces around it [FGRP-2, FGRP-3].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "connectivity/faces/cut.h"
#include "deltamesh/mesh.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class FaceGroupCoder {
 public:
  /// `triangles`: m x 3 vertices below `vertex_count`.
  FaceGroupCoder(Coder& coder, std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : coder_(coder), triangles_(triangles), group_of_(vertex_count, kNoIndex) {}

  /// Codes `groups`, m numbers, which a writer reads and a reader fills in. Returns nothing, or the rule that
  /// a reader's groups break; the reader's own failure comes first. O(m).
  const char* code(std::span<std::uint32_t> groups) {
    std::uint32_t before = 0;
    for (std::size_t f = 0; f < groups.size(); ++f) {
      const auto corners = triangles_.subspan(3 * f, 3);
      const Prediction prediction = prediction_for(corners, before);
      if (const char* const broken = code_group(groups[f], prediction)) return broken;
      for (const std::uint32_t v : corners) group_of_[v] = groups[f];
      before = groups[f];
    }
    return nullptr;
  }

 private:
  static constexpr std::size_t kMostRecent = 14;  ///< groups that a symbol names
  static constexpr unsigned kNext = 14;           ///< the symbol for one more than the highest group so far
  static constexpr unsigned kNamed = 15;          ///< the symbol before a number

  struct Prediction {
    std::uint32_t group;
    std::size_t context;  ///< number of corners whose vertex was met, twice; plus 1 where these disagree
  };

  Prediction prediction_for(std::span<const std::uint32_t> corners, std::uint32_t before) const noexcept {
    std::uint32_t first = kNoIndex;
    std::size_t met = 0;
    bool disagree = false;
    for (const std::uint32_t v : corners) {
      if (group_of_[v] == kNoIndex) continue;
      ++met;
      if (first == kNoIndex) first = group_of_[v];
      disagree = disagree || group_of_[v] != first;
    }
    return {first == kNoIndex ? before : first, 2 * met + (disagree ? 1 : 0)};
  }

  const char* code_group(std::uint32_t& group, const Prediction& prediction) {
    if (coder_.bit(group == prediction.group, as_prediction_[prediction.context])) {
      group = prediction.group;
    } else if (const char* const broken = code_other(group, prediction.group)) {
      return broken;
    }
    note(group);
    return nullptr;
  }

  /// A group that is not the prediction: one of the recent ones, the next new one, or any by its number.
  const char* code_other(std::uint32_t& group, std::uint32_t prediction) {
    std::array<std::uint32_t, kMostRecent> others;
    const auto end =
        std::copy_if(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(recent_count_),
                     others.begin(), [=](std::uint32_t g) { return g != prediction; });
    const auto place = std::find(others.begin(), end, group);
    unsigned symbol = place != end     ? static_cast<unsigned>(place - others.begin())
                      : group == next_ ? kNext
                                       : kNamed;
    symbol = coder_.symbol(symbol, Mixture<1>{{&choices_}});
    if (symbol < kMostRecent) {
      if (symbol >= static_cast<std::size_t>(end - others.begin())) return "FGRP-3";
      group = others[symbol];
    } else {
      group = symbol == kNext ? next_ : coder_.number(group, names_);
    }
    return group < kMostGroups ? nullptr : "FGRP-1";
  }

  /// Moves `group` to the front of the recent ones.
  void note(std::uint32_t group) noexcept {
    next_ = std::max(next_, group + 1);
    if (recent_count_ > 0 && recent_[0] == group) return;
    const auto end = recent_.begin() + static_cast<std::ptrdiff_t>(recent_count_);
    auto place = std::find(recent_.begin(), end, group);
    if (place == end) {
      if (recent_count_ < kMostRecent) {
        ++recent_count_;
      } else {
        --place;  // the oldest is forgotten
      }
    }
    std::move_backward(recent_.begin(), place, place + 1);
    recent_[0] = group;
  }

  static constexpr SymbolModel kFreshChoice{{8, 4, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 16, 1}};

  Coder& coder_;
  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> group_of_;  ///< of the last face at every vertex, or kNoIndex
  std::uint32_t next_ = 0;               ///< one more than the highest group so far
  std::array<std::uint32_t, kMostRecent> recent_{};
  std::size_t recent_count_ = 0;
  std::array<BitModel, 8> as_prediction_;
  SymbolModel choices_ = kFreshChoice;
  NumberModel names_;
};

}  // namespace deltamesh
