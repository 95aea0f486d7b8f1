// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/position_forms.h"

#include <utility>

namespace deltamesh {
namespace {

constexpr int kAnyGainEffort = 8;        ///< from here on any gain pays for an order of its own
constexpr double kOrderWorth = 0.97;     ///< of the bytes without one, at most
constexpr double kDeepHopeless = 0.985;  ///< of the bytes without one: orders hardly matter to this mesh

class FormSearch {
 public:
  FormSearch(const WritePositions& write, const PositionForm& first)
      : write_(write), form_(first), bytes_(write(first)) {}

  const PositionForm& form() const noexcept { return form_; }
  std::size_t size() const noexcept { return bytes_.size(); }

  /// Takes `form` where it needs at most `most` bytes and fewer than the best so far. Returns its bytes.
  std::size_t consider(const PositionForm& form, double most) {
    auto bytes = write_(form);
    const std::size_t size = bytes.size();
    if (size < bytes_.size() && static_cast<double>(size) <= most) {
      bytes_ = std::move(bytes);
      form_ = form;
    }
    return size;
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  const WritePositions& write_;
  PositionForm form_;
  std::vector<std::byte> bytes_;
};

PositionForm with_order(PositionForm form, CodingOrder coding_order) noexcept {
  form.coding_order = coding_order;
  return form;
}

PositionForm with_guesses(PositionForm form, bool guesses) noexcept {
  form.guesses = guesses ? Guessing::kAlways : Guessing::kNever;
  return form;
}

PositionForm with_fit(PositionForm form, BlendFit fit) noexcept {
  form.fit = fit;
  return form;
}

}  // namespace

std::vector<std::byte> write_smallest(const WritePositions& write, PositionKind kind, int effort) {
  const bool may_guess = kind == PositionKind::kLattice;
  if (effort == 0)
    return write({.fit = BlendFit::kSample, .guesses = may_guess ? Guessing::kForecast : Guessing::kNever});
  FormSearch search(write, {});
  if (search.size() == 0) return search.take();
  const auto any = static_cast<double>(search.size());
  if (may_guess) search.consider(with_guesses(search.form(), true), any);
  const auto still = static_cast<double>(search.size());
  const double most = effort >= kAnyGainEffort ? still : kOrderWorth * still;
  const std::size_t broad = search.consider(with_order(search.form(), CodingOrder::kBroad), most);
  if (static_cast<double>(broad) < kDeepHopeless * still)
    search.consider(with_order(search.form(), CodingOrder::kDeep), most);
  if (may_guess && search.form().coding_order != CodingOrder::kAsDecoded)
    search.consider(with_guesses(search.form(), search.form().guesses == Guessing::kNever), any);
  const bool has_blends = kind != PositionKind::kVoxel;
  if (has_blends) search.consider(with_fit(search.form(), BlendFit::kBits), any);
  return search.take();
}

}  // namespace deltamesh
