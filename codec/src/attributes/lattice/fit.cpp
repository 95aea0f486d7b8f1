// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/lattice/fit.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace deltamesh {
namespace {

constexpr double kLargestWhole = static_cast<double>(kLargestLatticeBase);

/// Denominators of floats that were decimals or normalised integers, coarsest first.
constexpr std::array<float, 17> kDenominators = {1,    10,   100,   1e3F,  1e4F,  1e5F, 1e6F, 127, 255,
                                                 1023, 4095, 16383, 32767, 65535, 1e7F, 1e8F, 1e9F};

/// One component of a source, but for most values that come again: these make no difference to a lattice.
struct Column {
  ComponentType type = ComponentType::kF32;
  std::size_t count = 0;            ///< values, with those left out
  std::vector<std::uint64_t> bits;  ///< of the others
  std::vector<double> numbers;      ///< likewise

  void add(std::uint64_t value) {
    ++count;
    if (!bits.empty() && (value == bits.front() || value == bits.back())) return;
    bits.push_back(value);
    numbers.push_back(number_of_bits(type, value));
  }
};

double largest_size(std::span<const double> numbers) noexcept {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::fabs(x));
  return largest;
}

/// What rounding a number of at most this size to the type may add to an error.
double rounding_error(ComponentType type, double size) noexcept {
  return std::ldexp(size, type == ComponentType::kF32 ? -24 : -52);
}

/// The largest float that is at most `x`, 0 or above.
float round_down(double x) noexcept {
  const auto nearest = static_cast<float>(x);
  return double{nearest} <= x ? nearest : std::nextafter(nearest, 0.0F);
}

/// Of values that are to be on a lattice, but for the sign of zero.
constexpr double kEqual = 1e-300;

/// Whether the lattice with this step keeps `bound` (0: the same bits); then its base and cells are set.
bool settle(const Column& column, double bound, ComponentLattice& lattice) noexcept {
  lattice.kind = LatticeKind::kPoints;
  lattice.base = 0;
  std::int64_t least = 0;
  std::int64_t most = 0;
  for (std::size_t i = 0; i < column.numbers.size(); ++i) {
    const double x = column.numbers[i];
    if (!(std::fabs(x) * static_cast<double>(lattice.over) <
          kLargestWhole * static_cast<double>(lattice.times)))
      return false;
    const std::int64_t q = lattice.nearest(x);
    const std::uint64_t bits = bits_of_number(column.type, lattice.at(q));
    if (bits != column.bits[i] && !(bound > 0 && std::fabs(number_of_bits(column.type, bits) - x) <= bound))
      return false;
    least = i == 0 ? q : std::min(least, q);
    most = i == 0 ? q : std::max(most, q);
    if (most - least > std::int64_t{kMostLatticeCells}) return false;
  }
  lattice.base = least;
  lattice.cells = static_cast<std::uint32_t>(most - least);
  return true;
}

/// The greatest common divisor of the points' numbers, as a float; at least 1.
float common_divisor(const Column& column, const ComponentLattice& lattice) noexcept {
  std::int64_t common = 0;
  for (const double x : column.numbers) {
    common = std::gcd(common, lattice.nearest(x));
    if (common == 1) return 1;
  }
  return common > 0 && common < (1 << 24) ? static_cast<float>(common) : 1.0F;
}

/// 2^e, the largest power of two that all numbers are multiples of; 0 where it is no float.
float power_of_two(const Column& column) noexcept {
  int least = 1000;
  for (const double x : column.numbers) {
    if (x == 0) continue;
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
    least = std::min(least, exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa)));
  }
  return least < -149 || least > 100 ? 0.0F : std::ldexp(1.0F, least);
}

/// The coarsest lattice whose points are the source's values; zeros need their signs where `bound` is 0.
std::optional<ComponentLattice> fit_exactly(const Column& column, double bound) {
  const double exactly = std::min(bound, kEqual);
  const auto coarsen = [&](ComponentLattice lattice) -> std::optional<ComponentLattice> {
    lattice.base = 0;
    const float common = common_divisor(column, lattice);
    ComponentLattice coarse = lattice;
    coarse.times *= common;
    if (common > 1 && std::isfinite(coarse.times) && settle(column, exactly, coarse)) return coarse;
    if (settle(column, exactly, lattice)) return lattice;
    return std::nullopt;
  };
  if (!is_float(column.type)) return coarsen({});
  std::optional<ComponentLattice> best;
  const auto consider = [&](const ComponentLattice& lattice) {
    const auto candidate = coarsen(lattice);
    if (candidate && (!best || candidate->cells < best->cells)) best = candidate;
  };
  for (const float over : kDenominators) {
    ComponentLattice lattice;
    lattice.over = over;
    if (!settle(column, exactly, lattice)) continue;
    consider(lattice);
    break;
  }
  ComponentLattice binary;
  binary.times = power_of_two(column);
  if (binary.times > 0 && settle(column, exactly, binary)) consider(binary);
  return best;
}

/// The step that keeps `bound`, whatever a component's values; 0 where there is none.
float step_within(double bound, ComponentType type, double largest) noexcept {
  if (!is_float(type)) return round_down(std::min(2 * std::floor(bound) + 1, 16777215.0));
  const double spared = rounding_error(type, largest + bound);
  return bound > 2 * spared ? round_down(std::min(2 * (bound - spared), 1e37)) : 0;
}

std::optional<ComponentLattice> fit_points(const Column& column, double bound, float step) {
  if (!std::all_of(column.numbers.begin(), column.numbers.end(), [](double x) { return std::isfinite(x); }))
    return std::nullopt;
  auto exact = fit_exactly(column, bound);
  if (exact && double{exact->times} >= double{step} * double{exact->over}) return exact;
  ComponentLattice within{.kind = LatticeKind::kPoints, .times = step};
  return step > 0 && settle(column, bound, within) ? within : exact;
}

/// The different values, ascending (those that are not numbers last), or empty where there are too many.
std::vector<std::uint64_t> list_values(const Column& column) {
  std::vector<std::uint64_t> values;
  for (const std::uint64_t bits : column.bits) {
    const auto place = std::lower_bound(values.begin(), values.end(), bits);
    if (place != values.end() && *place == bits) continue;
    if (values.size() == kMostListed) return {};
    values.insert(place, bits);
  }
  std::stable_sort(values.begin(), values.end(), [&](std::uint64_t a, std::uint64_t b) {
    const double x = number_of_bits(column.type, a);
    const double y = number_of_bits(column.type, b);
    return std::isnan(y) ? !std::isnan(x) : x < y;
  });
  return values;
}

/// Whether a list of `values`, which is exact, is better than `points`, if there are any.
bool list_pays(const Column& column, std::span<const std::uint64_t> values,
               const std::optional<ComponentLattice>& points) noexcept {
  constexpr std::size_t kSparse = 8;              // points for each value
  const double bits_per_vertex = points ? 1 : 8;  // that the list may save
  if (values.empty() || (points && points->cells < kSparse * values.size())) return false;
  const double list_bits = 8.0 * static_cast<double>(component_size(column.type) * values.size());
  return list_bits < bits_per_vertex * static_cast<double>(column.count);
}

std::optional<ComponentLattice> fit_component(const Column& column, double bound, float step) {
  if (column.bits.size() < 2) return ComponentLattice{.values = {column.bits.empty() ? 0 : column.bits[0]}};
  auto points = fit_points(column, bound, step);
  // Within a bound numbers that are not finite are better exceptions than reasons to keep all others exact.
  std::vector<std::uint64_t> values;
  if (bound == 0) values = list_values(column);
  if (list_pays(column, values, points)) {
    const auto cells = static_cast<std::uint32_t>(values.size() - 1);
    return ComponentLattice{.kind = LatticeKind::kListed, .values = std::move(values), .cells = cells};
  }
  if (points || column.type != ComponentType::kF32) return points;
  std::uint64_t largest = 0;
  for (const std::uint64_t bits : column.bits) largest = std::max(largest, (bits >> 23) & 0xff);
  if (largest == 0xff) return std::nullopt;
  return ComponentLattice{.kind = LatticeKind::kFloats, .exponent = static_cast<std::uint8_t>(largest)};
}

}  // namespace

std::optional<std::vector<ComponentLattice>> fit_lattices(const AttributeView& attribute,
                                                          const AttributeRows& rows, double bound) {
  std::vector<Column> columns(attribute.components);
  double largest = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    columns[c].type = attribute.type;
    rows.for_each(c, [&](std::size_t, std::uint64_t bits) { columns[c].add(bits); });
    largest = std::max(largest, largest_size(columns[c].numbers));
  }
  const float step = bound > 0 ? step_within(bound, attribute.type, largest) : 0;
  std::vector<ComponentLattice> lattices;
  for (const Column& column : columns) {
    const auto lattice = fit_component(column, bound, step);
    if (!lattice) return std::nullopt;
    lattices.push_back(*lattice);
  }
  return lattices;
}

}  // namespace deltamesh
