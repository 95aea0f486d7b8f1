// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "part/view_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace deltamesh {
namespace {

bool has_bound(AttributeKind kind) noexcept {
  return kind != AttributeKind::kColor && kind != AttributeKind::kJoints;
}

Error refused(const char* message, std::size_t attribute) noexcept {
  return {.code = ErrorCode::kInvalidArgument,
          .message = message,
          .rule = "MAP-15",
          .where_kind = WhereKind::kAttribute,
          .where = attribute};
}

double bound_of(std::size_t attribute, AttributeKind kind, const View& view) {
  if (attribute < view.attribute_errors.size()) return double{view.attribute_errors[attribute]};
  const AttributeQuality otherwise;
  switch (kind) {
    case AttributeKind::kNormal:
    case AttributeKind::kTangent:
      return otherwise.normal_error;
    case AttributeKind::kUv:
      return otherwise.uv_error;
    case AttributeKind::kWeights:
      return otherwise.weight_error;
    default:
      return 0;
  }
}

}  // namespace

Result<void> check_view(const View& view, const MapDescription& description) noexcept {
  const double least = std::sqrt(3.0) / 2 * description.lattice.step();
  if (view.max_error && *view.max_error < least)
    return Error{.code = ErrorCode::kUnmetRequest,
                 .message = "a largest error below half a lattice cell's diagonal",
                 .rule = "MAP-8",
                 .best_value = least};
  for (std::size_t i = 0; i < view.attribute_errors.size(); ++i) {
    if (i >= description.attributes.size())
      return refused("an error of an attribute that the map does not have", i);
    if (view.attribute_errors[i] != 0 && !has_bound(description.attributes[i].kind))
      return refused(
          "an error of an attribute that has none: colours have bounds of their own, joints are exact", i);
  }
  return {};
}

PartQuality part_quality(const View& view, const MapDescription& description) {
  PartQuality quality;
  if (view.vde) quality.bounds.vde = QualityBound{*view.vde};
  if (view.lfe) quality.bounds.lfe = QualityBound{*view.lfe};
  if (view.max_error) quality.bounds.max_error = QualityBound{*view.max_error};
  AttributeQuality& bounds = quality.attributes;
  if (view.color_error) bounds.color_error = double{*view.color_error};
  if (view.color_rms) bounds.color_rms = double{*view.color_rms};
  std::array<std::optional<double>, 7> strictest{};  // of each kind
  for (std::size_t i = 0; i < description.attributes.size(); ++i) {
    const MapAttribute& attribute = description.attributes[i];
    const double bound = bound_of(i, attribute.kind, view);
    auto& least = strictest.at(static_cast<std::size_t>(attribute.kind));
    least = std::min(least.value_or(bound), bound);
    if (attribute.kind == AttributeKind::kGeneric) bounds.named.push_back({attribute.name, bound});
  }
  const auto of = [&](AttributeKind kind, double otherwise) {
    return strictest.at(static_cast<std::size_t>(kind)).value_or(otherwise);
  };
  bounds.normal_error = of(AttributeKind::kNormal, bounds.normal_error);
  bounds.tangent_error = of(AttributeKind::kTangent, bounds.normal_error);
  bounds.uv_error = of(AttributeKind::kUv, bounds.uv_error);
  bounds.weight_error = of(AttributeKind::kWeights, bounds.weight_error);
  return quality;
}

bool keeps_attributes(std::span<const double> errors, const View& view, const MapDescription& description) {
  for (std::size_t i = 0; i < std::min(errors.size(), description.attributes.size()); ++i) {
    const AttributeKind kind = description.attributes[i].kind;
    if (has_bound(kind) && errors[i] > bound_of(i, kind, view)) return false;
  }
  return true;
}

}  // namespace deltamesh
