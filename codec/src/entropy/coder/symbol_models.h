// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Models of the same symbol in many contexts. A small stream spends as long on making them as on using them,
// so they are copied in blocks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>

#include "entropy/coder/model.h"

namespace deltamesh {

class SymbolModels {
 public:
  /// `count` models that begin as `fresh`.
  [[gnu::noinline]] SymbolModels(std::size_t count, const SymbolModel& fresh) : SymbolModels(count) {
    fill(0, count, fresh);
  }
  /// `count` models, each of which fill() has to set.
  explicit SymbolModels(std::size_t count) : size_(count), models_(new SymbolModel[count]) {}

  [[gnu::noinline]] SymbolModels(const SymbolModels& other) : SymbolModels(other.size_) {
    std::memcpy(models_.get(), other.models_.get(), size_ * sizeof(SymbolModel));
  }
  SymbolModels& operator=(const SymbolModels& other) { return *this = SymbolModels(other); }
  SymbolModels(SymbolModels&&) noexcept = default;
  SymbolModels& operator=(SymbolModels&&) noexcept = default;
  [[gnu::noinline]] ~SymbolModels() {}  // NOLINT(modernize-use-equals-default)

  void limit_counts(std::uint8_t most) noexcept {
    for (std::size_t i = 0; i < size_; ++i) models_[i].limit_count(most);
  }

  [[gnu::noinline]] void fill(std::size_t first, std::size_t count, const SymbolModel& fresh) noexcept {
    if (count == 0) return;
    SymbolModel* const models = models_.get() + first;
    models[0] = fresh;
    for (std::size_t done = 1; done < count;) {
      const std::size_t block = std::min({done, count - done, kBlock});
      std::memcpy(models + done, models, block * sizeof(SymbolModel));
      done += block;
    }
  }

  [[gnu::always_inline]] SymbolModel& operator[](std::size_t context) noexcept { return models_[context]; }

 private:
  static constexpr std::size_t kBlock = 64;  ///< stays in the nearest cache
  static_assert(std::is_trivially_copyable_v<SymbolModel>);

  std::size_t size_;
  std::unique_ptr<SymbolModel[]> models_;
};

}  // namespace deltamesh
