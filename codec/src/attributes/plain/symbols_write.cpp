// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <array>
#include <cstddef>

#include "attributes/plain/symbols.h"
#include "base/numbers/portable_math.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

std::vector<std::uint64_t> residuals(std::span<const std::uint64_t> symbols,
                                     std::span<const std::uint64_t> before, unsigned width, unsigned choice) {
  std::vector<std::uint64_t> result(symbols.begin(), symbols.end());
  if (choice == 0) return result;
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if ((choice & kPredictComponent) != 0) result[i] -= before[i];
    const std::uint64_t current = result[i];
    if ((choice & kPredictVertex) != 0) result[i] -= last;
    last = current;
    result[i] = fold_difference(result[i], width);
  }
  return result;
}

/// Order-0 entropy of the byte planes together, in bits.
double entropy(std::span<const std::uint64_t> symbols, unsigned width) {
  const auto log = [](std::size_t n) { return portable_log2(static_cast<double>(n)); };
  double total = 0;
  for (unsigned shift = 0; shift < width; shift += 8) {
    std::array<std::size_t, 256> counts{};
    for (const std::uint64_t symbol : symbols) ++counts[(symbol >> shift) & 0xff];
    for (const std::size_t count : counts)
      if (count > 0) total += static_cast<double>(count) * (log(symbols.size()) - log(count));
  }
  return total;
}

void write_words(ByteWriter& out, std::span<const std::uint64_t> symbols, unsigned shift) {
  std::vector<std::uint32_t> words;
  words.reserve(symbols.size());
  for (const std::uint64_t symbol : symbols) words.push_back(static_cast<std::uint32_t>(symbol >> shift));
  write_planes(out, words);
}

}  // namespace

void write_symbols(ByteWriter& out, std::span<const std::uint64_t> symbols,
                   std::span<const std::uint64_t> before, unsigned width) {
  unsigned best = 0;
  double best_entropy = entropy(symbols, width);
  const unsigned choices = before.empty() ? kPredictComponent : kPredictions;
  for (unsigned choice = 1; choice < choices; ++choice) {
    const double cost = entropy(residuals(symbols, before, width, choice), width);
    if (cost >= best_entropy) continue;
    best = choice;
    best_entropy = cost;
  }
  out.write(static_cast<std::uint8_t>(best));
  const auto coded = residuals(symbols, before, width, best);
  write_words(out, coded, 0);
  if (width > 32) write_words(out, coded, 32);
}

}  // namespace deltamesh
