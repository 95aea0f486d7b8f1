// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>
#include <numeric>

#include "attributes/lattice/component_lattice.h"
#include "attributes/skin/rows.h"
#include "attributes/skin/skin.h"
#include "base/byte_writer.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

/// Weights of a source, as parts of 1.
using Shares = std::array<double, kInfluences>;

double share_of(ComponentType type, std::uint64_t bits) noexcept {
  return number_of_bits(type, bits) / top_of(type);
}

/// Empty where some are not 0 to 1, or do not add up to 1.
std::vector<Shares> read_shares(const AttributeView& attribute, const AttributeRows& rows) {
  constexpr double kTolerance = 1e-3;
  std::vector<Shares> result(rows.count());
  for (std::size_t i = 0; i < result.size(); ++i) {
    double sum = 0;
    for (std::size_t slot = 0; slot < kInfluences; ++slot) {
      const double share = share_of(attribute.type, rows.bits(i, slot));
      if (!(share >= 0 && share <= 1)) return {};
      result[i][slot] = share;
      sum += share;
    }
    if (!(std::fabs(sum - 1) <= kTolerance)) return {};
  }
  return result;
}

/// Whole numbers that add up to `sum`, each at most 1 off: those with the largest fractions are rounded up.
WeightRow round_to_sum(const Shares& shares, std::uint32_t sum) noexcept {
  WeightRow row{};
  Shares fractions{};
  std::int64_t left = sum;
  for (std::size_t slot = 0; slot < kInfluences; ++slot) {
    const double exact = shares[slot] * sum;
    row[slot] = static_cast<std::int32_t>(std::floor(exact));
    fractions[slot] = exact - row[slot];
    left -= row[slot];
  }
  // A source whose sum is a little off may leave more than a step for each, or take some back.
  for (int turn = 0; left != 0 && turn < 1024; ++turn) {
    std::size_t best = kInfluences;
    for (std::size_t slot = 0; slot < kInfluences; ++slot) {
      if (shares[slot] == 0 || (left < 0 && row[slot] == 0)) continue;
      if (best == kInfluences ||
          (left > 0 ? fractions[slot] > fractions[best] : fractions[slot] < fractions[best]))
        best = slot;
    }
    if (best == kInfluences) break;
    const int step = left > 0 ? 1 : -1;
    row[best] += step;
    fractions[best] -= step;
    left -= step;
  }
  return row;
}

/// The rows with this sum; empty where a weight would be off by more than `bound`, or, of 0, by any bit.
std::vector<WeightRow> round_all(const AttributeView& attribute, const AttributeRows& rows,
                                 std::span<const Shares> shares, std::uint32_t sum, double bound) {
  std::vector<WeightRow> result;
  result.reserve(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const WeightRow row = round_to_sum(shares[i], sum);
    if (std::accumulate(row.begin(), row.end(), std::int64_t{0}) != std::int64_t{sum}) return {};
    for (std::size_t slot = 0; slot < kInfluences; ++slot) {
      const std::uint64_t bits = weight_bits(row[slot], sum, attribute.type);
      if (bits == rows.bits(i, slot)) continue;
      if (!(bound > 0 && std::fabs(share_of(attribute.type, bits) - shares[i][slot]) <= bound)) return {};
    }
    result.push_back(row);
  }
  return result;
}

struct RoundedWeights {
  std::uint32_t sum = 0;
  std::vector<WeightRow> rows;
};

/// The smallest sum that keeps the bound: for floats those from 1 / (2 bound) on, about 3 % apart, before
/// them those that sources often have, which may be exact; for integers the divisors of their top.
std::optional<RoundedWeights> round_weights(const AttributeView& attribute, const AttributeRows& rows,
                                            double bound) {
  const std::vector<Shares> shares = read_shares(attribute, rows);
  if (shares.size() != rows.count()) return std::nullopt;
  std::optional<RoundedWeights> best;
  const auto consider = [&](std::uint32_t sum, double within) {
    if (best && best->sum <= sum) return;
    auto rounded = round_all(attribute, rows, shares, sum, within);
    if (rounded.size() == shares.size()) best = RoundedWeights{sum, std::move(rounded)};
  };
  const std::uint32_t top = top_of(attribute.type);
  if (top > 1) {
    for (std::uint32_t divisor = top; divisor > 0; --divisor)
      if (top % divisor == 0) consider(top / divisor, bound);
    return best;
  }
  for (const std::uint32_t sum : {1U, 4U, 16U, 20U, 64U, 100U, 255U, 256U, 1000U, 10000U, 65535U, 65536U})
    consider(sum, 0);
  if (bound > 0) {
    for (double sum = std::max(std::floor(0.5 / bound), 1.0); sum <= kMostWeightSum;
         sum = std::floor(1.03 * sum) + 1) {
      consider(static_cast<std::uint32_t>(sum), bound);
      if (best) break;
    }
  }
  return best;
}

}  // namespace

CodedValues<std::byte> write_joints(const AttributeView& attribute, const AttributeRows& rows,
                                    const AttributeSurface& surface) {
  std::vector<std::byte> values = rows.gather();
  std::vector<JointRow> joints = joint_rows(values, attribute.type);
  const bool joined = copies_agree(surface.geometric(), std::span<const JointRow>(joints));
  CompactWriter writer;
  writer.bits(joined ? 1 : 0, 1);
  code_joints(writer, FieldFaces(surface, joined), top_of(attribute.type), joints);
  return {.bytes = writer.finish(), .values = std::move(values)};
}

std::optional<CodedValues<std::byte>> write_weights(const AttributeView& attribute, const AttributeRows& rows,
                                                    double bound, const AttributeSurface& surface,
                                                    std::span<const Attribute> others) {
  auto rounded = round_weights(attribute, rows, bound);
  if (!rounded) return std::nullopt;
  const std::vector<JointRow> joints = joints_of_weights(others, rows.count());
  const bool joined = copies_agree(surface.geometric(), std::span<const WeightRow>(rounded->rows));
  const FieldFaces over(surface, joined);
  std::vector<std::byte> smallest;
  for (std::uint32_t blend = 0; blend < kWeightBlends.size(); ++blend) {
    CompactWriter writer;
    writer.bits(joined ? 1 : 0, 1);
    writer.bits(blend, 2);
    code_weights(writer, over, joints, rounded->sum, blend, rounded->rows);
    auto bytes = writer.finish();
    if (smallest.empty() || bytes.size() < smallest.size()) smallest = std::move(bytes);
  }
  ByteWriter out;
  out.write_varint(rounded->sum);
  out.write_bytes(smallest);
  return CodedValues<std::byte>{.bytes = out.take(),
                                .values = weight_values(rounded->rows, rounded->sum, attribute.type)};
}

}  // namespace deltamesh
