// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/checked.h"
#include "base/try.h"
#include "io/components.h"
#include "io/faces.h"
#include "io/formats.h"
#include "io/origin.h"
#include "io/ply/header.h"
#include "io/text/numbers.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

class PlyBody {
 public:
  /// `bytes`: the whole file.
  PlyBody(std::span<const std::byte> bytes, const PlyHeader& header) noexcept
      : bytes_(bytes),
        position_(header.data_offset),
        text_(as_text(bytes.subspan(header.data_offset)), false, header.data_line),
        encoding_(header.encoding) {}

  /// `take(property, value)` for every value of a row of `element`, exact; it returns what is wrong with the
  /// value, or null. Errors: kInvalidFile: the bytes end, a text is not a number that its type holds.
  template <class Take>
  Result<void> read_row(const PlyElement& element, Take take) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      double length = 1;
      if (property.is_list && !next(property.count_type, length)) return at(problem_);
      if (length < 0) return at("PLY: a list of negative length");
      // Every entry takes bytes, so the loop ends with them.
      for (double i = 0; i < length; ++i) {
        double value = 0;
        if (!next(property.type, value)) return at(problem_);
        if (const char* const wrong = take(p, value)) return at(wrong);
      }
    }
    return {};
  }

  /// Whether `element.count` rows can be in the bytes that are left: the check before anything is allocated.
  bool may_hold(const PlyElement& element) const noexcept {
    const bool text = encoding_ == PlyEncoding::kAscii;
    std::uint64_t row = 0;  // fewest bytes of a row; in a text a value takes a digit and a blank
    for (const PlyProperty& property : element.properties)
      row += text ? 2 : component_size(property.is_list ? property.count_type : property.type);
    // The last blank of a text may be missing.
    const std::uint64_t present = text ? text_.remaining() + std::uint64_t{1} : bytes_.size() - position_;
    return saturating_mul(row, element.count) <= present;
  }

  /// `message` at the present place: the line in a text, else the byte.
  Error at(const char* message) const noexcept {
    if (encoding_ == PlyEncoding::kAscii) return text_.error(message);
    return invalid_byte(message, position_);
  }

 private:
  /// The next value. False where there is none: problem_ tells why.
  bool next(ComponentType type, double& value) noexcept {
    return encoding_ == PlyEncoding::kAscii ? next_text(type, value) : next_binary(type, value);
  }

  bool next_text(ComponentType type, double& value) noexcept {
    const std::string_view token = text_.next_token();
    if (token.empty()) {
      problem_ = kShort;
      return false;
    }
    const std::optional<double> number = parse_number(token);
    std::byte fits[sizeof(double)];
    if (!number || !store_component(type, *number, fits)) {
      problem_ = "PLY: not a number, or one that its type does not hold";
      return false;
    }
    value = *number;
    return true;
  }

  bool next_binary(ComponentType type, double& value) noexcept {
    const std::size_t size = component_size(type);
    if (bytes_.size() - position_ < size) {
      problem_ = kShort;
      return false;
    }
    const auto bytes = bytes_.subspan(position_, size);
    position_ += size;
    if (encoding_ == PlyEncoding::kLittleEndian) {
      value = load_component(type, bytes.data());
    } else {
      std::array<std::byte, sizeof(double)> swapped;
      std::reverse_copy(bytes.begin(), bytes.end(), swapped.begin());
      value = load_component(type, swapped.data());
    }
    return true;
  }

  static constexpr const char* kShort = "PLY: the file ends before its last value";

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;  // binary encodings
  TextScanner text_;          // kAscii
  PlyEncoding encoding_;
  const char* problem_ = "";
};

Result<void> read_vertices(PlyBody& body, const PlyElement& vertex, Imported& imported) {
  if (vertex.count > std::numeric_limits<std::uint32_t>::max()) return body.at("PLY: too many vertices");
  PlyVertexLayout layout = layout_ply_vertex(vertex);
  if (!layout.has_position) return body.at("PLY: the vertices have no x, y, z");
  imported.notes.dropped_attributes = layout.unnamed;
  for (Attribute& attribute : layout.attributes)
    attribute.values.resize(vertex.count * attribute.components * component_size(attribute.type));
  std::vector<double> coordinates(vertex.count * 3);

  std::size_t v = 0;
  const auto take = [&](std::size_t property, double value) -> const char* {
    const PlyTarget& target = layout.targets[property];
    if (target.kind == PlyTarget::Kind::kPosition) {
      coordinates[3 * v + target.component] = value;
    } else if (target.kind == PlyTarget::Kind::kAttribute) {
      Attribute& attribute = layout.attributes[target.attribute];
      const std::size_t at = (v * attribute.components + target.component) * component_size(attribute.type);
      store_component(attribute.type, value, attribute.values.data() + at);
    }
    return nullptr;
  };
  for (; v < vertex.count; ++v) DELTAMESH_CHECK(body.read_row(vertex, take));
  imported.mesh = place_origin(coordinates);
  imported.mesh.attributes = std::move(layout.attributes);
  return {};
}

/// The property that lists the corners of a face.
std::optional<std::size_t> corner_list(const PlyElement& face) noexcept {
  for (std::size_t i = 0; i < face.properties.size(); ++i) {
    const PlyProperty& property = face.properties[i];
    if (property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index")) return i;
  }
  return std::nullopt;
}

Result<void> read_faces(PlyBody& body, const PlyElement& face, std::uint64_t vertices, FaceCollector& faces) {
  const auto corner_property = corner_list(face);
  if (!corner_property) return body.at("PLY: the faces have no list vertex_indices");
  std::vector<std::uint32_t> corners;
  const auto take = [&](std::size_t property, double value) -> const char* {
    if (property != *corner_property) return nullptr;
    if (!(value >= 0 && value < static_cast<double>(vertices)))
      return "PLY: a face names a vertex that does not exist";
    corners.push_back(static_cast<std::uint32_t>(value));
    return nullptr;
  };
  for (std::uint64_t f = 0; f < face.count; ++f) {
    corners.clear();
    DELTAMESH_CHECK(body.read_row(face, take));
    faces.add(corners);
  }
  return {};
}

const PlyElement* find_element(const PlyHeader& header, std::string_view name) noexcept {
  const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                  [name](const PlyElement& element) { return element.name == name; });
  return found == header.elements.end() ? nullptr : &*found;
}

}  // namespace

Result<Imported> read_ply(std::span<const std::byte> bytes) {
  DELTAMESH_TRY(const PlyHeader header, read_ply_header(bytes));
  PlyBody body(bytes, header);
  const PlyElement* const vertex = find_element(header, "vertex");
  const PlyElement* const face = find_element(header, "face");
  if (vertex == nullptr) return body.at("PLY: the file has no vertices");
  const PlyElement* const strips = find_element(header, "tristrips");
  if (strips != nullptr && strips->count > 0 && (face == nullptr || face->count == 0))
    return body.at("PLY: triangle strips are not supported; save the mesh with faces");

  Imported imported;
  FaceCollector faces;
  for (const PlyElement& element : header.elements) {
    if (!body.may_hold(element))
      return body.at("PLY: the file is too short for the number of elements it states");
    if (&element == vertex) {
      DELTAMESH_CHECK(read_vertices(body, element, imported));
    } else if (&element == face) {
      DELTAMESH_CHECK(read_faces(body, element, vertex->count, faces));
    } else if (!element.properties.empty()) {
      for (std::uint64_t row = 0; row < element.count; ++row)
        DELTAMESH_CHECK(body.read_row(element, [](std::size_t, double) -> const char* { return nullptr; }));
      if (element.name == "edge") imported.notes.other_primitives += element.count;
    }
  }
  faces.move_into(imported);
  return imported;
}

}  // namespace deltamesh
