// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OFF with the prefixes ST, C and N: x y z, then normal, colour and texture coordinates where the prefixes
// promise them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/faces.h"
#include "io/formats.h"
#include "io/origin.h"
#include "io/text/numbers.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

struct OffHeader {
  bool uv = false;
  bool color = false;
  bool normal = false;
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
};

Result<OffHeader> read_header(TextScanner& scanner) {
  OffHeader header;
  std::string_view word = scanner.next_token();
  const auto take = [&word](std::string_view prefix) {
    if (!word.starts_with(prefix)) return false;
    word.remove_prefix(prefix.size());
    return true;
  };
  header.uv = take("ST");
  header.color = take("C");
  header.normal = take("N");
  if (word != "OFF")
    return scanner.error("OFF: the file begins with none of OFF, COFF, NOFF, STOFF and the like");
  constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();
  const auto vertices = scanner.read_count(kMax);
  if (!vertices) return scanner.error("OFF: no vertex count follows (binary OFF is not supported)");
  header.vertices = *vertices;
  DELTAMESH_TRY(header.faces, scanner.read_count(kMax));
  scanner.skip_line();  // the number of edges
  // Fewest characters: "0 0 0" and a blank for a vertex, "0" and a blank for a face; the last blank may be
  // missing.
  if (header.vertices * 6 + header.faces * 2 > scanner.remaining() + std::uint64_t{1})
    return scanner.error("OFF: the file is too short for the number of vertices and faces it states");
  return header;
}

/// The vertices of a file as they are met; colours are judged when all are known.
class OffVertices {
 public:
  explicit OffVertices(const OffHeader& header) : header_(header) {}

  Result<void> read(TextScanner& scanner) {
    coordinates_.reserve(header_.vertices * 3);
    for (std::uint64_t v = 0; v < header_.vertices; ++v) {
      for (int k = 0; k < 3; ++k) {
        DELTAMESH_TRY(const double value, scanner.read_number());
        coordinates_.push_back(value);
      }
      DELTAMESH_CHECK(read_extras(scanner));
      scanner.skip_line();
    }
    return {};
  }

  Mesh to_mesh() const {
    Mesh mesh = place_origin(coordinates_);
    if (header_.normal) add(mesh, AttributeKind::kNormal, ComponentType::kF32, 3, "normal", normals_);
    if (header_.color && header_.vertices > 0) add_colors(mesh);
    if (header_.uv) add(mesh, AttributeKind::kUv, ComponentType::kF32, 2, "uv", uvs_);
    return mesh;
  }

 private:
  /// What the rest of a vertex line promises.
  Result<void> read_extras(TextScanner& scanner) {
    if (!header_.normal && !header_.color && !header_.uv) return {};
    std::array<double, 9> values{};
    std::array<bool, 9> fraction{};
    std::size_t count = 0;
    for (; count < values.size(); ++count) {
      const std::string_view token = scanner.next_token_on_line();
      if (token.empty()) break;
      const auto value = parse_number(token);
      if (!value) return scanner.error("OFF: not a number, or one that does not fit a double");
      values[count] = *value;
      fraction[count] = token.find('.') != token.npos;
    }
    const std::size_t others = normal_size() + uv_size();
    const std::size_t color_size = header_.color && count > others ? count - others : 0;
    if (color_components_ == 0) color_components_ = color_size;
    if (count < others || color_size != color_components_ ||
        (header_.color && (color_size < 3 || color_size > 4)))
      return scanner.error("OFF: a vertex line has not the numbers that the file's first word promises");
    const double* next = values.data();
    normals_.insert(normals_.end(), next, next + normal_size());
    next += normal_size();
    colors_.insert(colors_.end(), next, next + color_size);
    for (std::size_t c = 0; c < color_size; ++c) fractions_ = fractions_ || fraction[normal_size() + c];
    next += color_size;
    uvs_.insert(uvs_.end(), next, next + uv_size());
    return {};
  }

  std::size_t normal_size() const noexcept { return header_.normal ? 3 : 0; }
  std::size_t uv_size() const noexcept { return header_.uv ? 2 : 0; }

  /// Whole numbers from 0 to 255 are bytes; anything else are real numbers.
  void add_colors(Mesh& mesh) const {
    const bool bytes = !fractions_ && std::all_of(colors_.begin(), colors_.end(), [](double c) {
      return c >= 0 && c <= 255 && c == std::floor(c);
    });
    const bool in_range =
        std::all_of(colors_.begin(), colors_.end(), [](double c) { return c >= 0 && c <= 1; });
    const ComponentType type = bytes ? ComponentType::kU8 : ComponentType::kF32;
    const AttributeKind kind = bytes || in_range ? AttributeKind::kColor : AttributeKind::kGeneric;
    add(mesh, kind, type, static_cast<std::uint8_t>(color_components_), "color", colors_);
  }

  void add(Mesh& mesh, AttributeKind kind, ComponentType type, std::uint8_t components, const char* name,
           std::span<const double> values) const {
    Attribute attribute = make_attribute(kind, type, components, name, header_.vertices);
    for (std::size_t i = 0; i < values.size(); ++i)
      store_component(type, values[i], attribute.values.data() + i * component_size(type));
    mesh.attributes.push_back(std::move(attribute));
  }

  OffHeader header_;
  std::vector<double> coordinates_, normals_, colors_, uvs_;
  std::size_t color_components_ = 0;
  bool fractions_ = false;
};

/// A face may span lines; what follows its corners on the last one is its colour, which is ignored.
Result<void> read_faces(TextScanner& scanner, const OffHeader& header, FaceCollector& faces) {
  std::vector<std::uint32_t> corners;
  for (std::uint64_t f = 0; f < header.faces; ++f) {
    DELTAMESH_TRY(const std::uint64_t count, scanner.read_count(std::numeric_limits<std::uint32_t>::max()));
    corners.clear();
    for (std::uint64_t c = 0; c < count; ++c) {
      const auto corner = scanner.read_count(std::numeric_limits<std::uint32_t>::max());
      if (!corner) return corner.error();
      if (*corner >= header.vertices) return scanner.error("OFF: a face names a vertex that does not exist");
      corners.push_back(static_cast<std::uint32_t>(*corner));
    }
    scanner.skip_line();
    faces.add(corners);
  }
  return {};
}

}  // namespace

Result<Imported> read_off(std::span<const std::byte> bytes) {
  TextScanner scanner(as_text(bytes), true);
  DELTAMESH_TRY(const OffHeader header, read_header(scanner));
  OffVertices vertices(header);
  DELTAMESH_CHECK(vertices.read(scanner));
  FaceCollector faces;
  DELTAMESH_CHECK(read_faces(scanner, header, faces));
  Imported imported{.mesh = vertices.to_mesh(), .notes = {}};
  faces.move_into(imported);
  return imported;
}

}  // namespace deltamesh
