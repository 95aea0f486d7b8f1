// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/delta_symbols.h"

#include <cstdlib>

#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "format/tags.h"
#include "geometry/delta_context.h"

namespace deltamesh {
namespace {

constexpr unsigned kEscape = 15;
constexpr std::int64_t kReach = 7;  ///< symbols 0 to 14 stand for -7 to 7
constexpr unsigned kLongTail = 7;   ///< bit lengths from here on are written out
constexpr SymbolModel kFreshDelta({1, 2, 3, 4, 8, 14, 24, 40, 24, 14, 8, 4, 3, 2, 1, 3});
constexpr SymbolModel kFreshTail({12, 8, 10, 7, 8, 5, 6, 4, 4, 3, 3, 2, 2, 1, 1, 1});

/// Writes or reads the deltas, in coding order; the order of the calls is the stream's [CMPD-5, CMPD-6].
template <class Coder>
class DeltaCoder {
 public:
  explicit DeltaCoder(Coder& coder) : coder_(coder) {
    for (std::size_t i = 0; i < models_.size(); ++i) models_[i].assign(kDeltaContexts[i], kFreshDelta);
    tails_.assign(kTailContexts, kFreshTail);
  }

  /// `q` is ignored by readers. Returns the delta, of any size where the stream lies.
  std::int64_t code(std::int64_t q, const DeltaForecast& f) {
    const std::int64_t swapped = f.negative ? -q : q;
    std::int64_t high = (swapped >> f.shift) - f.center;
    const auto low = static_cast<std::uint32_t>(swapped & ((std::int64_t{1} << f.shift) - 1));
    const bool far = high < -kReach || high > kReach;
    const unsigned symbol = coder_.symbol(far ? kEscape : static_cast<unsigned>(high + kReach),
                                          Mixture<4>{{&models_[0][f.contexts[0]], &models_[1][f.contexts[1]],
                                                      &models_[2][f.contexts[2]], &models_[3][f.contexts[3]]},
                                                     &weights_[f.weight_set]});
    high = symbol == kEscape ? code_tail(high, f) : static_cast<std::int64_t>(symbol) - kReach;
    const std::int64_t result = ((high + f.center) << f.shift) | code_low(low, f.shift, symbol);
    return f.negative ? -result : result;
  }

 private:
  /// Beyond the symbols: sign and bit length of the excess, then its bits [CMPD-6].
  std::int64_t code_tail(std::int64_t high, const DeltaForecast& f) {
    const auto excess = static_cast<std::uint32_t>(std::llabs(high) - (kReach + 1));
    auto length = static_cast<unsigned>(std::bit_width(excess));
    const unsigned symbol = coder_.symbol(std::min(length, kLongTail) * 2 + (high < 0 ? 1 : 0),
                                          Mixture<1>{{&tails_[f.tail_context]}, &tail_weights_});
    const bool negative = symbol % 2 != 0;
    length = symbol / 2;
    if (length == kLongTail)
      length += coder_.bits(static_cast<unsigned>(std::bit_width(excess)) - kLongTail, 5);
    length = std::min(length, 32U);
    const std::uint32_t coded =
        length == 0 ? 0 : code_mantissa(coder_, excess, length, tail_second_[length], tail_third_[length]);
    const std::int64_t size = std::int64_t{coded} + kReach + 1;
    return negative ? -size : size;
  }

  /// The highest of the low bits by a model, the others as they are [CMPD-5].
  std::int64_t code_low(std::uint32_t low, unsigned shift, unsigned symbol) {
    if (shift == 0) return 0;
    const bool top = coder_.bit((low >> (shift - 1)) != 0, low_models_[symbol]);
    const std::uint32_t rest = coder_.bits(low & ((1U << (shift - 1)) - 1), shift - 1);
    return static_cast<std::int64_t>(top ? 1U << (shift - 1) | rest : rest);
  }

  Coder& coder_;
  std::array<std::vector<SymbolModel>, 4> models_;
  std::array<MixWeights<4>, kDeltaWeightSets> weights_;
  std::vector<SymbolModel> tails_;
  MixWeights<1> tail_weights_;
  std::array<BitModel, 33> tail_second_;
  std::array<std::array<BitModel, 2>, 33> tail_third_;
  std::array<BitModel, kSymbols> low_models_;
};

/// `deltas` are read by a writer and written by a reader. False where a delta is out of range or `stop`.
template <class Coder, class Stop>
bool code_deltas(Coder& coder, std::span<std::int32_t> deltas, const Adjacency& graph, Stop stop) {
  const std::size_t n = graph.vertex_count();
  DeltaCoder<Coder> delta_coder(coder);
  DeltaHistory history(graph);
  DeltaPredictor predictor;
  for (std::uint32_t v = 0; v < n; ++v) {
    const DeltaNeighborhood around = history.around(v);
    predictor.begin(around);
    std::array<std::int32_t, 3> q{};
    for (unsigned axis = 0; axis < 3; ++axis) {
      const DeltaForecast forecast = predictor.forecast(axis);
      const std::int64_t coded = delta_coder.code(deltas[axis * n + v], forecast);
      if (coded < -kLargestDelta || coded > kLargestDelta) return false;
      q[axis] = static_cast<std::int32_t>(coded);
      deltas[axis * n + v] = q[axis];
      predictor.learn(axis, q[axis], forecast);
    }
    history.remember(v, q, around);
    if (stop()) return false;
  }
  return true;
}

}  // namespace

std::vector<std::byte> write_compact_deltas(std::span<const std::int32_t> deltas, const Adjacency& graph) {
  CompactWriter writer;
  std::vector<std::int32_t> copy(deltas.begin(), deltas.end());
  code_deltas(writer, copy, graph, [] { return false; });
  return writer.finish();
}

Result<std::vector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph) {
  CompactReader reader(payload);
  std::vector<std::int32_t> deltas(3 * graph.vertex_count());
  if (!code_deltas(reader, deltas, graph, [&] { return reader.failed(); }) && !reader.failed())
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "a delta beyond 2^30 steps",
                 .rule = "CMPD-1",
                 .chunk_tag = kTagDeltas};
  if (const auto finished = reader.finish(kTagDeltas); !finished) return finished.error();
  return deltas;
}

}  // namespace deltamesh
