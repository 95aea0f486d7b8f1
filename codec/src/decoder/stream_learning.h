// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// With which models the coders of a stream begin, and where they leave what they learn [CMP-16].
#pragma once

#include <cstddef>
#include <memory>

#include "entropy/coder/learning.h"
#include "format/header.h"
#include "states/stream_models.h"

namespace deltamesh {

class StreamLearning {
 public:
  /// Null `start`: fresh models; null `learnt`: what is learnt is not wanted. Owns none of them.
  StreamLearning(const FileHeader& header, const StreamModels* start, StreamModels* learnt)
      : header_(header), start_(start), learnt_(learnt) {
    if (learnt != nullptr) learnt->attributes.resize(header.attributes.size());
  }

  Learning<GridModels> of_grid() const {
    if (learnt_ != nullptr) {
      learnt_->grid = std::make_unique<GridModels>(header_.predictive.levels);
      learnt_->levels = header_.predictive.levels;
    }
    return {start_ != nullptr ? start_->grid.get() : nullptr,
            learnt_ != nullptr ? learnt_->grid.get() : nullptr};
  }
  Learning<OpModels> of_ops() const {
    return {start_ != nullptr ? start_->of_ops() : nullptr,
            learnt_ != nullptr ? &learnt_->ops.emplace() : nullptr};
  }
  Learning<LatticeModels> of_lattice() const {
    const bool learns = learnt_ != nullptr && header_.predictive.kind == PositionKind::kLattice;
    return {start_ != nullptr ? start_->of_lattice() : nullptr,
            learns ? &learnt_->lattice.emplace() : nullptr};
  }
  Learning<AttributeModels> of_attribute(std::size_t attribute) const {
    return {start_ != nullptr ? start_->of_attribute(attribute) : nullptr,
            learnt_ != nullptr ? &learnt_->attributes[attribute] : nullptr};
  }

 private:
  const FileHeader& header_;
  const StreamModels* start_;
  StreamModels* learnt_;
};

}  // namespace deltamesh
