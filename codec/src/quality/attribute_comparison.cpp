// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "quality/attribute_comparison.h"

#include <algorithm>
#include <cmath>

#include "quality/attribute_values.h"

namespace deltamesh {
namespace {

bool comparable(const AttributeView& a, const AttributeView& b) noexcept {
  return a.kind == b.kind && a.components == b.components && a.normalized == b.normalized;
}

/// A difference that is clearly visible or otherwise large, in the kind's unit.
double large_difference(AttributeKind kind) noexcept {
  switch (kind) {
    case AttributeKind::kNormal:
    case AttributeKind::kTangent:
      return 30;
    case AttributeKind::kColor:
      return 64;
    case AttributeKind::kUv:
    case AttributeKind::kWeights:
      return 0.1;
    case AttributeKind::kGeneric:
    case AttributeKind::kJoints:
      break;
  }
  return 1;
}

bool stand_for_each_other(const AttributeView& a, const AttributeView& b, bool by_name) noexcept {
  if (by_name) return a.name == b.name && !a.name.empty();
  return a.kind == b.kind && a.kind != AttributeKind::kGeneric;
}

AttributeComparison without_errors(const AttributeView& attribute, AttributeMatch match) {
  return {.name = std::string(attribute.name), .kind = attribute.kind, .match = match};
}

}  // namespace

Result<void> check_attributes(const MeshView& mesh) {
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    const AttributeView& attribute = mesh.attributes[i];
    const bool sound = attribute.components >= 1 && attribute.components <= kMaxValueComponents &&
                       attribute.values.size() == mesh.vertex_count() * value_size(attribute);
    if (!sound)
      return Error{.code = ErrorCode::kInvalidMesh,
                   .message = "an attribute does not hold one value for every vertex",
                   .where_kind = WhereKind::kAttribute,
                   .where = i};
  }
  return {};
}

AttributeComparer::AttributeComparer(const MeshView& a, const MeshView& b) {
  std::vector<const AttributeView*> partner(a.attributes.size());
  std::vector<bool> taken(b.attributes.size());
  for (const bool by_name : {true, false})
    for (std::size_t i = 0; i < partner.size(); ++i)
      for (std::size_t j = 0; j < taken.size() && partner[i] == nullptr; ++j) {
        if (taken[j] || !stand_for_each_other(a.attributes[i], b.attributes[j], by_name)) continue;
        partner[i] = &b.attributes[j];
        taken[j] = true;
      }
  for (std::size_t i = 0; i < partner.size(); ++i) {
    const AttributeView& of_a = a.attributes[i];
    if (partner[i] == nullptr)
      pairs_.push_back({of_a, {}, without_errors(of_a, AttributeMatch::kMissingInB)});
    else
      pairs_.push_back({of_a, *partner[i],
                        without_errors(of_a, comparable(of_a, *partner[i]) ? AttributeMatch::kCompared
                                                                           : AttributeMatch::kOtherType)});
  }
  for (std::size_t j = 0; j < taken.size(); ++j)
    if (!taken[j])
      pairs_.push_back({{}, b.attributes[j], without_errors(b.attributes[j], AttributeMatch::kOnlyInB)});
}

double AttributeComparer::difference(std::uint32_t a, std::uint32_t b) const {
  double sum = 0;
  for (const Pair& pair : pairs_) {
    if (pair.result.match != AttributeMatch::kCompared) continue;
    const double apart = value_error(pair.a, a, pair.b, b);
    const double large = large_difference(pair.a.kind);
    sum += std::isfinite(apart) ? apart / (apart + large) : 1;
  }
  return sum;
}

std::vector<AttributeComparison> AttributeComparer::compare(std::span<const VertexPair> vertices) const {
  std::vector<AttributeComparison> results;
  for (const Pair& pair : pairs_) {
    AttributeComparison result = pair.result;
    if (result.match == AttributeMatch::kCompared && !vertices.empty()) {
      double sum = 0;
      double squares = 0;
      for (const VertexPair& vertex : vertices) {
        const double error = value_error(pair.a, vertex.a, pair.b, vertex.b);
        result.max_error = std::max(result.max_error, error);
        sum += error;
        squares += error * error;
      }
      result.measured = vertices.size();
      const auto count = static_cast<double>(vertices.size());
      result.mean = sum / count;
      result.rms = std::sqrt(squares / count);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace deltamesh
