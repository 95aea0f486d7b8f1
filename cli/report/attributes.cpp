// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/attributes.h"

#include <array>
#include <cmath>

#include "report/stream.h"

namespace deltamesh::cli {
namespace {

std::string type_text(ComponentType type) {
  constexpr std::array kNames{"i8", "u8", "i16", "u16", "i32", "u32", "f32", "f64"};
  return kNames[static_cast<std::size_t>(type)];
}

const char* match_name(AttributeMatch match) {
  switch (match) {
    case AttributeMatch::kMissingInB:
      return "missing_in_b";
    case AttributeMatch::kOnlyInB:
      return "only_in_b";
    case AttributeMatch::kOtherType:
      return "other_type";
    case AttributeMatch::kCompared:
      break;
  }
  return "compared";
}

double decibels_of(double rms) { return 20 * std::log10(255 / rms); }

/// Of the values of red, green and blue, 255ths.
std::string rms_text(double rms) {
  return "of red, green, blue rms " + brief(rms) + " (" + brief(decibels_of(rms)) + " dB)";
}

std::string attribute_text(const AttributeInfo& attribute, std::uint64_t labels) {
  if (attribute.error == 0 && attribute.kind == AttributeKind::kColor && labels > 0)
    return counted(labels, "label", "labels") + ", exact";
  return kept_text(attribute.kind, attribute.error, attribute.rms);
}

std::string comparison_text(const AttributeComparison& attribute) {
  switch (attribute.match) {
    case AttributeMatch::kMissingInB:
      return "missing in B";
    case AttributeMatch::kOnlyInB:
      return "only in B";
    case AttributeMatch::kOtherType:
      return "of another type in B";
    case AttributeMatch::kCompared:
      break;
  }
  if (attribute.measured == 0) return "not measured";
  if (attribute.max_error == 0) return "exact";
  std::string text = "max error " + error_text(attribute.kind, attribute.max_error) + ", mean " +
                     brief(attribute.mean) + ", rms " + brief(attribute.rms);
  if (attribute.color_rms > 0)
    text += "; " + rms_text(attribute.color_rms) + ", mean CIEDE2000 " + brief(attribute.color_difference);
  return text;
}

/// "normals (nx)", "colours (red)"; generic attributes by their name.
std::string label(AttributeKind kind, const std::string& name) {
  constexpr std::array kPlural{"normals", "colours", "texture coordinates", "", "tangents",
                               "joints",  "weights"};
  const std::string plural = kPlural[static_cast<std::size_t>(kind)];
  if (plural.empty()) return name;
  return plural + " (" + name + ')';
}

}  // namespace

std::string kind_text(AttributeKind kind) {
  constexpr std::array kNames{"normal", "color", "uv", "generic", "tangent", "joints", "weights"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string shape_text(ComponentType type, int components) {
  return std::to_string(components) + " x " + type_text(type);
}

const char* unit_name(AttributeKind kind) {
  switch (kind) {
    case AttributeKind::kNormal:
    case AttributeKind::kTangent:
      return "degrees";
    case AttributeKind::kUv:
      return "uv";
    case AttributeKind::kColor:
      return "255ths";
    case AttributeKind::kGeneric:
    case AttributeKind::kJoints:
    case AttributeKind::kWeights:
      break;
  }
  return "value";
}

std::string error_text(AttributeKind kind, double error) {
  if (error == 0) return "exact";
  std::string text = brief(error);
  if (kind == AttributeKind::kNormal || kind == AttributeKind::kTangent) text += " degrees";
  if (kind == AttributeKind::kColor) text += " of 255";
  return text;
}

std::string kept_text(AttributeKind kind, double error, double rms) {
  if (error == 0) return "exact";
  const std::string most = "max error " + error_text(kind, error);
  if (rms == 0) return most;
  if (kind != AttributeKind::kColor) return "rms error " + brief(rms) + ", " + most;
  return "photographic, " + brief(decibels_of(rms)) + " dB, " + most;
}

void add_attributes(Summary& summary, const StreamInfo& info, std::uint64_t labels) {
  for (const AttributeInfo& attribute : info.attributes)
    summary.add("    " + label(attribute.kind, attribute.name),
                shape_text(attribute.type, attribute.components) + ", " +
                    size_text(attribute.coded_bytes, info) + ", " + attribute_text(attribute, labels));
}

nlohmann::ordered_json attributes_object(const StreamInfo& info) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const AttributeInfo& attribute : info.attributes) {
    nlohmann::ordered_json entry;
    entry["name"] = attribute.name;
    entry["kind"] = kind_text(attribute.kind);
    entry["type"] = shape_text(attribute.type, attribute.components);
    entry["bytes"] = attribute.coded_bytes;
    entry["bits_per_vertex"] = bits_per_vertex(attribute.coded_bytes, info);
    entry["max_error"] = attribute.error;
    if (attribute.rms > 0) {
      entry["rms"] = attribute.rms;
      if (attribute.kind == AttributeKind::kColor) entry["psnr"] = decibels_of(attribute.rms);
    }
    entry["unit"] = unit_name(attribute.kind);
    list.push_back(entry);
  }
  return list;
}

std::string lengths_text(std::uint64_t count) {
  return counted(count, "length of a normal or tangent", "lengths of normals or tangents") +
         " other than 1 (--lossless keeps them)";
}

void add_dropped_lengths(Summary& summary, std::uint64_t count) {
  if (count > 0) summary.add("left out", lengths_text(count));
}

void add_attributes(Summary& summary, const Comparison& result) {
  for (const AttributeComparison& attribute : result.attributes)
    summary.add("  " + label(attribute.kind, attribute.name), comparison_text(attribute));
}

nlohmann::ordered_json attributes_object(const Comparison& result) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const AttributeComparison& attribute : result.attributes) {
    const bool measured = attribute.measured > 0;
    const auto figure = [measured](double value) {
      return measured ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json entry;
    entry["name"] = attribute.name;
    entry["kind"] = kind_text(attribute.kind);
    entry["match"] = match_name(attribute.match);
    entry["measured"] = attribute.measured;
    entry["max_error"] = figure(attribute.max_error);
    entry["mean"] = figure(attribute.mean);
    entry["rms"] = figure(attribute.rms);
    if (attribute.kind == AttributeKind::kColor) {
      entry["color_rms"] = figure(attribute.color_rms);
      entry["ciede2000"] = figure(attribute.color_difference);
    }
    entry["unit"] = unit_name(attribute.kind);
    list.push_back(entry);
  }
  return list;
}

}  // namespace deltamesh::cli
