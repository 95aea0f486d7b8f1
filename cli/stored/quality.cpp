// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stored/quality.h"

#include <algorithm>

#include "option_numbers.h"

namespace deltamesh::cli {
namespace {

using Json = nlohmann::json;

constexpr double kHalfTurn = 180;  // degrees
constexpr double kMostColor = 255;

double above_zero(const JsonValue& json, double most) {
  const double number = json.number(most);
  if (!(number > 0)) json.refuse("a number above 0");
  return number;
}

NamedBound named_bound_of(const JsonValue& json) {
  const auto items = json.items(3);
  const bool is_mean = items[2].flag();
  constexpr double kAny = std::numeric_limits<double>::max();
  if (items[0].text().empty()) items[0].refuse("a name");
  return {.name = items[0].text(),
          .error = is_mean ? above_zero(items[1], kAny) : items[1].number(),
          .is_mean = is_mean};
}

}  // namespace

Json json_of(const QualityRequest& request) {
  Json json = Json::object();
  for (const PositionBound& member : kPositionBounds)
    if (const auto& bound = request.*member.bound) json[member.key] = text_of(*bound);
  return json;
}

QualityRequest bounds_of(const JsonValue& json, bool percent) {
  QualityRequest request;
  for (const PositionBound& member : kPositionBounds) {
    const auto value = json.optional_member(member.key);
    if (!value) continue;
    const auto bound = parse_bound(value->text());
    if (!bound || !(bound->value > 0) || (bound->unit == QualityUnit::kDiagonal && !percent))
      value->refuse(std::string("a text with a number above 0") + (percent ? ", perhaps with a %" : ""));
    request.*member.bound = bound;
  }
  const auto is_none = [](const auto& bound) { return bound && bound->value == kNoBound.value; };
  for (const PositionBound& member : kPositionBounds)
    if (is_none(request.*member.bound) &&
        (member.bound != &QualityRequest::max_error || !(request.vde || request.lfe)))
      json.member(member.key).refuse("a number above 0; \"none\" is for max_error beside vde or lfe");
  return request;
}

Json json_of(const AttributeQuality& quality) {
  Json json;
  json["normal_error"] = quality.normal_error;
  if (quality.tangent_error) json["tangent_error"] = *quality.tangent_error;
  json["uv_error"] = quality.uv_error;
  if (quality.color_error) json["color_error"] = *quality.color_error;
  if (quality.color_rms) json["color_rms"] = *quality.color_rms;
  json["weight_error"] = quality.weight_error;
  json["named"] = Json::array();
  for (const NamedBound& bound : quality.named)
    json["named"].push_back({bound.name, bound.error, bound.is_mean});
  return json;
}

AttributeQuality attributes_of(const JsonValue& json) {
  AttributeQuality quality;
  quality.normal_error = json.member("normal_error").number(kHalfTurn);
  if (const auto value = json.optional_member("tangent_error"))
    quality.tangent_error = value->number(kHalfTurn);
  quality.uv_error = json.member("uv_error").number();
  if (const auto value = json.optional_member("color_error")) quality.color_error = value->number(kMostColor);
  if (const auto value = json.optional_member("color_rms")) {
    if (quality.color_error) value->refuse("nothing, as there is a color_error");
    quality.color_rms = above_zero(*value, kMostColor);
  }
  quality.weight_error = json.member("weight_error").number();
  for (const JsonValue& json_bound : json.member("named").items()) {
    const NamedBound bound = named_bound_of(json_bound);
    const auto same_name = [&](const NamedBound& other) { return other.name == bound.name; };
    if (std::ranges::any_of(quality.named, same_name))
      json_bound.items().front().refuse("a name that no other bound has");
    quality.named.push_back(bound);
  }
  return quality;
}

}  // namespace deltamesh::cli
