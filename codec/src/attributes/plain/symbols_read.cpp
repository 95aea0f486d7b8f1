// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cstddef>

#include "attributes/plain/symbols.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

Result<std::vector<std::uint64_t>> read_words(ByteReader& in, std::uint64_t count, unsigned width) {
  DELTAMESH_TRY(const auto low, read_planes(in, count));
  std::vector<std::uint64_t> words(low.begin(), low.end());
  if (width > 32) {
    DELTAMESH_TRY(const auto high, read_planes(in, count));
    for (std::size_t i = 0; i < words.size(); ++i) words[i] |= std::uint64_t{high[i]} << 32;
  }
  return words;
}

}  // namespace

Result<std::vector<std::uint64_t>> read_symbols(ByteReader& in, std::uint64_t count,
                                                std::span<const std::uint64_t> before, unsigned width) {
  DELTAMESH_TRY(const auto choice, in.read<std::uint8_t>());
  if (choice >= (before.empty() ? kPredictComponent : kPredictions))
    return in.invalid("unknown prediction", "ATTR-3");
  DELTAMESH_TRY(auto symbols, read_words(in, count, width));
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    std::uint64_t& symbol = symbols[i];
    if (symbol > symbol_mask(width)) return in.invalid("symbol beyond its width", "ATTR-3");
    if (choice == 0) continue;
    symbol = unfold_difference(symbol, width);
    if ((choice & kPredictVertex) != 0) symbol += last;
    last = symbol;
    if ((choice & kPredictComponent) != 0) symbol += before[i];
    symbol &= symbol_mask(width);
  }
  return symbols;
}

}  // namespace deltamesh
