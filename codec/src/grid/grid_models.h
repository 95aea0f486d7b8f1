// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The models with which a stream of a grid may begin, as another one left them [CMP-16].
#pragma once

#include <cstdint>
#include <memory>

#include "grid/models.h"
#include "grid/places.h"

namespace deltamesh {

/// Some 100 kB.
struct GridModels {
  /// `start`: null for fresh models. Those of levels are fresh where it had others.
  static std::unique_ptr<GridModels> begin(std::uint32_t levels, const GridModels* start) {
    if (start == nullptr) return std::make_unique<GridModels>(levels);
    auto models = std::make_unique<GridModels>(*start);
    models->growth.forget_seeds();
    if (models->levels != levels) models->places = grid::PlaceModels(levels);
    models->levels = levels;
    return models;
  }
  explicit GridModels(std::uint32_t of_levels) : levels(of_levels), places(of_levels) {}

  void limit_counts(std::uint8_t most) noexcept {
    growth.limit_counts(most);
    places.limit_counts(most);
  }

  std::uint32_t levels;
  grid::GrowthModels growth;
  grid::PlaceModels places;
};

}  // namespace deltamesh
