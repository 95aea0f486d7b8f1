// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours vertex by vertex: one of those around, or differences to what these let expect [ATTR-46 ..
// ATTR-52]. One template for both directions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "attributes/attribute.h"
#include "attributes/colors/copies.h"
#include "attributes/colors/fields.h"
#include "attributes/colors/numbers.h"
#include "attributes/colors/prediction.h"
#include "attributes/surface.h"
#include "attributes/values.h"
#include "base/memory/large_vector.h"

namespace deltamesh {

struct ColorModels {
  ColorCopyModels copies;
  ColorNumberModels numbers;

  void limit_counts(std::uint8_t most) noexcept {
    for (auto* const models : {&copies.symbols, &numbers.symbols})
      for (SymbolModels& symbols : *models) symbols.limit_counts(most);
    numbers.numbers.limit_counts(most);
  }
};

/// A colour that a vertex had in a version that a reader has, as levels by axis [MAP-30].
struct FormerColor {
  FourFloats levels{};
  bool is_there = false;
};

/// n; empty where nothing is known. `attribute`: of the known mesh, of the same shape, or null.
inline LargeVector<FormerColor> former_colors(const AttributeSurface& surface, const Attribute* attribute,
                                              const ColorFields& fields, const ColorAxes& axes) {
  LargeVector<FormerColor> former;
  if (attribute == nullptr || !surface.has_known()) return former;
  const std::size_t size = component_size(attribute->type);
  former.resize(surface.vertex_count(), FormerColor{});
  for (std::uint32_t v = 0; v < former.size(); ++v) {
    const std::uint32_t known = surface.known_of(v);
    if (known == kNoKnownVertex) continue;
    former[v].is_there = true;
    const std::byte* const row = attribute->values.data() + std::size_t{known} * fields.components * size;
    for (unsigned a = 0; a < axes.count; ++a) {
      const auto bits = static_cast<std::uint32_t>(load_component(row + axes.components[a] * size, size));
      former[v].levels[static_cast<int>(a)] =
          static_cast<float>(nearest_color_level(attribute->type, fields.bits, bits).value_or(0));
    }
  }
  return former;
}

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class ColorCoder {
 public:
  /// `surface` must outlive the coder. `copies`: whether colours may be copied; ignored by readers. `start`:
  /// null for fresh models. `former`: of all vertices, or empty. `former_bound`: the largest error of
  /// one that is copied; writers only.
  ColorCoder(Coder& coder, const AttributeSurface& surface, const ColorShape& shape, bool copies,
             const ColorModels* start = nullptr, LargeVector<FormerColor> former = {}, float former_bound = 0)
      : has_copies_(coder.bits(copies ? 1 : 0, 1) != 0),
        prediction_(surface),
        shape_(shape),
        copies_(shape, start != nullptr ? start->copies : ColorCopyModels(), former_bound),
        numbers_(coder, shape, start != nullptr ? start->numbers : ColorNumberModels()),
        former_(std::move(former)),
        colors_(surface.vertex_count()),
        memories_(surface.vertex_count()) {}

  ColorModels models() const { return {copies_.models(), numbers_.models()}; }

  /// For every vertex once, in order. `coder`: that of the making, or a reader's copy that goes on in its
  /// place, and that a compiler can keep in registers. Writers give the levels and get those of the reader,
  /// which differ by the bound at most; unused axes are 0. What may be copied is: a price for each way saves
  /// less than 2 %.
  [[gnu::always_inline]] void code_vertex(Coder& coder, std::uint32_t vertex, ColorLevels& levels) {
    const ColorPlace place = prediction_.look(vertex);
    const ColorAround around = look_around(place, vertex);
    ColorMemory& memory = memories_[vertex];
    memory.outcome = code_copy(coder, place, vertex, levels);
    numbers_.code(coder, around, memory, levels);
    colors_[vertex] = floats_of(levels);
    if (!former_.empty() && !former_[vertex].is_there) former_[vertex].levels = colors_[vertex];
  }

 private:
  static constexpr float kFormerShare = 0.6875F;  ///< of what vertices differed by from those around

  [[gnu::always_inline]] CopyOutcome code_copy(Coder& coder, const ColorPlace& place, std::uint32_t vertex,
                                               ColorLevels& levels) {
    if (!has_copies_) return CopyOutcome::kNone;
    const FormerColor* const former = former_of(vertex);
    return copies_.code(coder, place, colors_.data(), memories_.data(),
                        former != nullptr ? &former->levels : nullptr, levels);
  }

  /// Null where there is none.
  const FormerColor* former_of(std::uint32_t vertex) const noexcept {
    const bool has_one = !former_.empty() && former_[vertex].is_there;
    return has_one ? &former_[vertex] : nullptr;
  }

  [[gnu::always_inline]] ColorAround look_around(const ColorPlace& place,
                                                 std::uint32_t vertex) const noexcept {
    ColorAround around;
    FourFloats expected{};
    for (std::size_t i = 0; i < place.vertices.size(); ++i)
      expected += colors_[place.vertices[i]] * place.shares[i];
    around.is_first = place.vertices.empty();
    if (around.is_first && vertex > 0) expected = colors_[vertex - 1];
    if (const FormerColor* const former = former_of(vertex); former != nullptr) [[unlikely]] {
      FourFloats mean{};
      for (std::size_t i = 0; i < place.vertices.size(); ++i)
        mean += former_[place.vertices[i]].levels * place.shares[i];
      expected = around.is_first ? former->levels : expected + (former->levels - mean) * kFormerShare;
    }
    around.expected = clamped(expected, shape_.top);
    for (std::size_t i = 0; i < place.vertices.size(); ++i) {
      const std::uint32_t other = place.vertices[i];
      const float share = place.shares[i];
      const ColorMemory& memory = memories_[other];
      around.spread += sizes_of(tied(colors_[other] - around.expected)) * share;
      around.sizes += memory.sizes * share;
    }
    return around;
  }

  bool has_copies_;
  ColorPrediction prediction_;
  ColorShape shape_;
  ColorCopies<Coder> copies_;
  ColorNumbers<Coder> numbers_;
  LargeVector<FormerColor> former_;  ///< those without one: what was decoded; or empty
  LargeVector<FourFloats> colors_;   ///< levels, 4 of every vertex
  LargeVector<ColorMemory> memories_;
};

}  // namespace deltamesh
