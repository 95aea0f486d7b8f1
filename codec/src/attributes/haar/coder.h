// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A weighted Haar transform over the levels of a mesh, whose coefficients are predicted from the values
// around [HAAR-7 .. HAAR-13]. One template for both directions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "attributes/haar/models.h"
#include "attributes/haar/steps.h"
#include "attributes/haar/surroundings.h"
#include "base/memory/large_vector.h"
#include "base/small_code.h"
#include "entropy/coder/held_coder.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader. `Source`, of writers, has what is to be coded: see write.cpp.
template <class Coder, unsigned kAxes, class Source>
class HaarCoder {
 public:
  /// `levels` and `source` must outlive the coder. `start`: null for fresh models.
  HaarCoder(Coder& coder, std::span<const HaarLevel> levels, std::uint32_t step, const Source& source,
            const HaarModels* start)
      : coder_(coder),
        levels_(levels),
        steps_(step),
        source_(source),
        models_(start != nullptr ? *start : HaarModels()),
        numbers_(coder, models_.numbers) {}

  HaarModels models() const {
    HaarModels models = models_;
    models.numbers = numbers_.models();
    return models;
  }

  /// The vertices' records, with their values as readers have them. May be called once; there is a vertex. A
  /// reader that fails stops soon; what it returns is of no use then. `done(l)` is called when nodes
  /// and neighbours of level l have served.
  template <class Done>
  LargeVector<HaarRecord> run(const Done& done) {
    LargeVector<HaarRecord> records(1);
    records[0] = root();
    for (std::size_t l = levels_.size() - 1; l > 0; --l) {
      if (coder_.failed()) break;
      LargeVector<HaarRecord> finer(levels_[l - 1].nodes.size());
      hand_down(levels_[l].children, records, finer);
      split(l, records, finer);
      records.swap(finer);
      done(l - 1);
    }
    return records;
  }

 private:
  HaarRecord root() {
    HaarRecord record{.lanes = {}, .node = levels_.back().nodes[0]};
    for (std::size_t t = 0; t < kAxes; ++t) {
      std::uint32_t bits = 0;
      if constexpr (Coder::kWrites) bits = static_cast<std::uint32_t>(source_.root(t) - kLeastHaarValue);
      record.lanes[t] = clamp_haar_value(std::int64_t{coder_.bits(bits, 15)} + kLeastHaarValue);
    }
    return record;
  }

  static void hand_down(const LargeVector<HaarChildren>& children, const LargeVector<HaarRecord>& parents,
                        LargeVector<HaarRecord>& records) noexcept {
    for (std::size_t i = 0; i < children.size(); ++i) {
      records[children[i].first] = parents[i];
      if (children[i].second != HaarChildren::kNone) records[children[i].second] = parents[i];
    }
  }

  void split(std::size_t l, const LargeVector<HaarRecord>& parents, LargeVector<HaarRecord>& records) {
    const HaarLevel& fine = levels_[l - 1];
    const HaarNeighborhood neighborhood(fine, records.data());
    const LargeVector<HaarChildren>& children = levels_[l].children;
    in_turns(static_cast<std::uint32_t>(children.size()), [&](std::uint32_t begin, std::uint32_t end) {
      Held<Coder> held = coder_;
      for (std::uint32_t i = begin; i < end; ++i) {
        const HaarChildren& pair = children[i];
        if (pair.second == HaarChildren::kNone) continue;
        if (held.failed()) break;
        const HaarSurroundings around = neighborhood.template look<kAxes>(pair, parents[i]);
        HaarRecord& first = records[pair.first];
        HaarRecord& second = records[pair.second];
        split_pair(held, around, parents[i], {l, i}, pair, first, second);
      }
      write_back<Coder>(held, coder_);
    });
  }

  struct NodeId {
    std::size_t level;
    std::uint32_t node;
  };

  [[gnu::always_inline]] void split_pair(Coder& held, const HaarSurroundings& around,
                                         const HaarRecord& parent, NodeId id, const HaarChildren& pair,
                                         HaarRecord& first, HaarRecord& second) {
    const HaarLevel& fine = levels_[id.level - 1];
    const std::uint32_t a = fine.nodes[pair.first].weight;
    const std::uint32_t b = fine.nodes[pair.second].weight;
    const HaarStep step = steps_.of(a, b);
    const std::uint64_t weight = std::uint64_t{a} + b;
    const std::size_t weight_class = weight <= 2 ? 0 : (weight <= 8 ? 1 : 2);
    std::uint32_t coded = 0;
    // Stored at once, as both are soon read.
    HaarLanes of_first;
    HaarLanes of_second;
    for (std::size_t t = 0; t < kAxes; ++t) {
      // 16ths of a step.
      const std::uint32_t spread =
          static_cast<std::uint32_t>((std::uint64_t{around.spread[t]} * step.per_value) >> 16);
      const std::uint32_t size =
          (166 * around.sizes[t] + 90 * static_cast<std::uint32_t>(parent.size(t))) >> 8;
      const std::uint32_t expected = (133 * size + 58 * spread + 30 * coded) >> 8;
      const HaarContext context(expected, spread, coded, weight_class, t);
      const Mixture<2> mixture{
          {&models_.symbols[0][context.models[0]], &models_.symbols[1][context.models[1]]},
          &models_.weights[context.weights]};
      std::int64_t number = 0;
      if constexpr (Coder::kWrites)
        number =
            source_.choose(id.level, id.node, t, around.difference[t], step.size, context.shift, mixture);
      number = std::clamp<std::int64_t>(numbers_.code(held, number, context.shift, mixture), -kMost, kMost);
      const auto whole = static_cast<std::uint32_t>(number < 0 ? -number : number);
      const std::int64_t difference =
          std::clamp<std::int64_t>(around.difference[t] + number * step.size, -kMost, kMost);
      const std::int64_t low = parent.value(t) - ((difference * pair.share_of_first) >> 16);
      const std::uint32_t size_now = 16 * std::min(whole, kMostSize);
      const auto size_here = static_cast<std::int16_t>((5 * size_now + 3 * size) >> 3);
      of_first.set(t, clamp_haar_value(low + difference), size_here);
      of_second.set(t, clamp_haar_value(low), size_here);
      coded = t == 0 ? size_now : (coded + size_now) >> 1;
    }
    first = {.lanes = of_first.lanes(), .node = fine.nodes[pair.first]};
    second = {.lanes = of_second.lanes(), .node = fine.nodes[pair.second]};
  }

  static constexpr std::int64_t kMost = 1 << 16;
  static constexpr std::uint32_t kMostSize = 2047;

  Coder& coder_;
  std::span<const HaarLevel> levels_;
  HaarSteps steps_;
  const Source& source_;
  HaarModels models_;
  SplitNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
