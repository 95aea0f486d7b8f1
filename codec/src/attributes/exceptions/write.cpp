// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>
#include <cstring>
#include <map>
#include <string_view>

#include "attributes/error.h"
#include "attributes/exceptions/exceptions.h"
#include "attributes/lattice/component_lattice.h"
#include "attributes/payload.h"
#include "attributes/skin/shares.h"
#include "base/component.h"

namespace deltamesh {
namespace {

/// The list may take one byte in so many of the raw values.
constexpr std::size_t kLeastGain = 4;

/// Texture coordinates beyond as many bounds have three bits left of a float32's 24 beside the bound.
constexpr double kMostUvBounds = 1U << 20;

/// Tells which rows of an attribute are exceptions.
class ExceptionTest {
 public:
  ExceptionTest(const AttributeView& attribute, const AttributeRows& rows, double bound)
      : attribute_(attribute), rows_(rows), most_uv_(kMostUvBounds * bound) {}

  bool operator()(std::size_t row) const noexcept {
    if (is_float(attribute_.type) && !is_finite(row)) return true;
    switch (attribute_.kind) {
      case AttributeKind::kTangent:
        return attribute_.type == ComponentType::kF32 && attribute_.components == 4 &&
               !is_tangent(rows_.vector(row), rows_.number(row, 3));
      case AttributeKind::kWeights:
        return coding_fits(AttributeCoding::kWeights, attribute_.kind, attribute_.type,
                           attribute_.components) &&
               !are_shares(shares_at(attribute_.type, rows_, row));
      case AttributeKind::kColor:
        return attribute_.type == ComponentType::kF32 && !is_within(row, 0, 1);
      case AttributeKind::kUv:
        return attribute_.type == ComponentType::kF32 && most_uv_ > 0 && !is_within(row, -most_uv_, most_uv_);
      default:
        return false;
    }
  }

 private:
  double component(std::size_t row, std::size_t c) const noexcept {
    return number_of_bits(attribute_.type, rows_.bits(row, c));
  }
  bool is_finite(std::size_t row) const noexcept {
    for (std::size_t c = 0; c < rows_.components(); ++c)
      if (!std::isfinite(component(row, c))) return false;
    return true;
  }
  bool is_within(std::size_t row, double least, double most) const noexcept {
    for (std::size_t c = 0; c < rows_.components(); ++c)
      if (!(component(row, c) >= least && component(row, c) <= most)) return false;
    return true;
  }

  const AttributeView& attribute_;
  const AttributeRows& rows_;
  double most_uv_;
};

}  // namespace

void write_exceptions(ByteWriter& out, const Exceptions& exceptions, std::size_t row_size) {
  const std::size_t values = exceptions.rows.size() / row_size;
  out.write_varint(values);
  out.write_bytes(exceptions.rows);
  out.write_varint(exceptions.runs.size());
  std::uint32_t end = 0;
  for (const ExceptionRun& run : exceptions.runs) {
    out.write_varint(run.begin - end);
    out.write_varint(run.length - 1);
    if (values > 1) out.write_varint(run.row);
    end = run.begin + run.length;
  }
}

Exceptions find_exceptions(const AttributeView& attribute, const AttributeRows& rows, double bound) {
  const std::size_t row_size = attribute.components * component_size(attribute.type);
  const ExceptionTest is_exception(attribute, rows, bound);
  Exceptions exceptions;
  std::map<std::string_view, std::uint32_t> known;
  for (std::uint32_t v = 0; v < rows.count(); ++v) {
    if (!is_exception(v)) continue;
    const std::string_view value(reinterpret_cast<const char*>(rows.row(v)), row_size);
    const auto [place, is_new] = known.emplace(value, static_cast<std::uint32_t>(known.size()));
    if (is_new) exceptions.rows.insert(exceptions.rows.end(), rows.row(v), rows.row(v) + row_size);
    const bool goes_on = !exceptions.empty() && exceptions.runs.back().row == place->second &&
                         exceptions.runs.back().begin + exceptions.runs.back().length == v;
    if (goes_on) {
      ++exceptions.runs.back().length;
    } else {
      exceptions.runs.push_back({.begin = v, .length = 1, .row = place->second});
    }
    const std::size_t bytes = exceptions.rows.size() + 3 * exceptions.runs.size();
    if (bytes * kLeastGain > rows.count() * row_size) return {};
  }
  const bool is_all = exceptions.runs.size() == 1 && exceptions.runs[0].length == rows.count();
  return is_all ? Exceptions{} : exceptions;
}

std::vector<std::byte> without_exceptions(const AttributeRows& rows, std::size_t row_size,
                                          const Exceptions& exceptions) {
  std::vector<std::byte> values = rows.gather();
  std::size_t known = 0;  // a vertex that is none
  for (const ExceptionRun& run : exceptions.runs) known += run.begin == known ? run.length : 0;
  for (const ExceptionRun& run : exceptions.runs) {
    if (run.begin > 0) known = run.begin - 1;
    for (std::size_t v = run.begin; v < std::size_t{run.begin} + run.length; ++v)
      std::memcpy(values.data() + v * row_size, values.data() + known * row_size, row_size);
  }
  return values;
}

}  // namespace deltamesh
