// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether a vertex has the colour of one around it, and which [ATTR-50].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "attributes/colors/memory.h"
#include "attributes/colors/prediction.h"
#include "entropy/coder/symbol_models.h"

namespace deltamesh {

struct ColorCopyModels {
  static constexpr std::size_t kContextsOfKind = 192;  ///< without a former colour, and with one
  static constexpr std::array<std::size_t, 2> kContexts = {2 * kContextsOfKind, 2 * kContextsOfKind};
  static constexpr SymbolModel kFresh{{16, 6, 3, 30, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  std::array<SymbolModels, 2> symbols{SymbolModels(kContexts[0], kFresh), SymbolModels(kContexts[1], kFresh)};
  static constexpr std::size_t kWeightsOfKind = 6;
  std::array<MixWeights, 2 * kWeightsOfKind> weights;
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class ColorCopies {
 public:
  /// `former_bound`: the largest error of a former colour that is copied; writers only.
  explicit ColorCopies(const ColorShape& shape, ColorCopyModels start = {}, float former_bound = 0)
      : shape_(shape),
        former_bound_(former_bound),
        one_over_step_(1 / static_cast<float>(std::max(shape.step(), shape.top / 255))),
        models_(std::move(start)) {}

  const ColorCopyModels& models() const noexcept { return models_; }

  /// Codes whether `levels` are those of a vertex near, or its former ones, within the bound, and then sets
  /// them so. `former`: null where there is none.
  [[gnu::always_inline]] CopyOutcome code(Coder& coder, const ColorPlace& place, const FourFloats* colors,
                                          const ColorMemory* memories, const FourFloats* former,
                                          ColorLevels& levels) {
    if (!find_candidates(place, colors, former)) return CopyOutcome::kNothingToCopy;
    const Contexts contexts = contexts_of(memories, former != nullptr);
    const Mixture<2> mixture{
        {&models_.symbols[0][contexts.models[0]], &models_.symbols[1][contexts.models[1]]},
        &models_.weights[contexts.weights]};
    const unsigned choice =
        coder.symbol(Coder::kWrites ? first_within_bound(levels, former != nullptr) : kNotCopied, mixture);
    if (choice >= count_) return CopyOutcome::kNone;
    levels = levels_of(candidates_[choice].color);
    return choice == 0 ? CopyOutcome::kFirst : CopyOutcome::kOther;
  }

 private:
  static constexpr unsigned kMost = 3;
  static constexpr unsigned kNotCopied = 3;
  static constexpr std::uint32_t kNoVertex = ~std::uint32_t{0};
  struct Candidate {
    std::uint32_t vertex;  ///< whose outcome counts, or kNoVertex
    FourFloats color;
  };

  struct Contexts {
    std::array<std::size_t, 2> models;
    std::size_t weights;
  };

  [[gnu::always_inline]] Contexts contexts_of(const ColorMemory* memories, bool has_former) const noexcept {
    const std::size_t few = count_ - 1;
    float differ = 0;
    for (unsigned i = 1; i < count_; ++i)
      differ = std::max(differ, distance(candidates_[i].color, candidates_[0].color));
    const std::size_t differ_class = class_of(differ, 7);
    const auto share = std::min<std::size_t>(static_cast<std::size_t>(share_of_first_ * 8), 7);
    const auto outcome = [&](unsigned i) {
      const bool has_one = i < count_ && candidates_[i].vertex != kNoVertex;
      return static_cast<std::size_t>(has_one ? memories[candidates_[i].vertex].outcome
                                              : CopyOutcome::kNothingToCopy);
    };
    const std::size_t kind = has_former ? 1 : 0;
    const std::size_t of_kind = kind * ColorCopyModels::kContextsOfKind;
    return {.models = {of_kind + (few * 8 + share) * 8 + differ_class,
                       of_kind + ((outcome(0) * 4 + outcome(1)) * 4 + outcome(2)) * 3 + few},
            .weights = kind * ColorCopyModels::kWeightsOfKind + few * 2 + (outcome(0) == 0 ? 1 : 0)};
  }

  unsigned first_within_bound(const ColorLevels& levels, bool has_former) const noexcept {
    for (unsigned i = 0; i < count_; ++i) {
      const float bound = i == 0 && has_former ? former_bound_ : static_cast<float>(shape_.bound);
      const FourFloats d = sizes_of(candidates_[i].color - floats_of(levels));
      if (std::max(std::max(d[0], d[1]), std::max(d[2], d[3])) <= bound) return i;
    }
    return kNotCopied;
  }

  static bool equal(FourFloats a, FourFloats b) noexcept {
    const FourInts differ = a != b;
    return (differ[0] | differ[1] | differ[2] | differ[3]) == 0;
  }
  static float distance(FourFloats a, FourFloats b) noexcept {
    const FourFloats d = sizes_of(a - b);
    return (d[0] + d[1]) + (d[2] + d[3]);
  }
  std::size_t class_of(float distance, int most) const noexcept {
    return static_cast<std::size_t>(std::min(
        static_cast<int>(std::bit_width(static_cast<std::uint32_t>(distance * one_over_step_))), most));
  }

  /// The former colour, with the nearest vertex' outcome; then the nearest vertex, the nearest of another
  /// colour, and the nearest of a third one, as far as there are.
  [[gnu::always_inline]] bool find_candidates(const ColorPlace& place, const FourFloats* colors,
                                              const FourFloats* former) noexcept {
    count_ = 0;
    share_of_first_ = 0;
    if (former != nullptr) [[unlikely]]
      candidates_[count_++] = {nearest_of(place), *former};
    while (count_ < kMost) {
      float most = 0;
      for (std::size_t k = 0; k < place.vertices.size(); ++k) {
        const std::uint32_t vertex = place.vertices[k];
        const float share = place.shares[k];
        bool is_new = share > most;
        for (unsigned i = 0; i < count_; ++i) is_new = is_new && !equal(colors[vertex], candidates_[i].color);
        if (!is_new) continue;
        most = share;
        candidates_[count_].vertex = vertex;
      }
      if (most == 0) break;
      candidates_[count_].color = colors[candidates_[count_].vertex];
      ++count_;
    }
    for (std::size_t k = 0; k < place.vertices.size(); ++k)
      share_of_first_ += equal(colors[place.vertices[k]], candidates_[0].color) ? place.shares[k] : 0;
    return count_ > 0;
  }

  static std::uint32_t nearest_of(const ColorPlace& place) noexcept {
    if (place.vertices.empty()) return kNoVertex;
    const auto largest = std::max_element(place.shares.begin(), place.shares.end());
    return place.vertices[static_cast<std::size_t>(largest - place.shares.begin())];
  }

  ColorShape shape_;
  float former_bound_;
  float one_over_step_;
  ColorCopyModels models_;
  // For the next vertex:
  unsigned count_ = 0;
  std::array<Candidate, kMost> candidates_{};
  float share_of_first_ = 0;  ///< of all with its colour
};

}  // namespace deltamesh
