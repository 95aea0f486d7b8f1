// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OFF with the prefixes ST, C and N: x y z, then normal, colour and texture coordinates where the prefixes
// promise them; colours of faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/try.h"
#include "io/components.h"
#include "io/formats.h"
#include "io/polygons/mesh.h"
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

/// The first word; a count may follow at once, as in ModelNet's files. Leaves the count in `word`.
bool take_magic(std::string_view& word, OffHeader& header) noexcept {
  const auto take = [&word](std::string_view prefix, bool& flag) {
    if (flag || !word.starts_with(prefix)) return false;
    word.remove_prefix(prefix.size());
    return flag = true;
  };
  while (take("ST", header.uv) || take("C", header.color) || take("N", header.normal)) {
  }
  bool magic = false;
  return take("OFF", magic);
}

Result<OffHeader> read_header(TextScanner& scanner) {
  OffHeader header;
  std::string_view word = scanner.next_token();
  if (!take_magic(word, header))
    return scanner.error("OFF: the file begins with none of OFF, COFF, NOFF, STOFF and the like", word);
  if (word.empty()) word = scanner.next_token();
  constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();
  const auto vertices = parse_integer(word);
  if (!vertices || *vertices < 0 || static_cast<std::uint64_t>(*vertices) > kMax)
    return scanner.error("OFF: no vertex count follows (binary OFF is not supported)", word);
  header.vertices = static_cast<std::uint64_t>(*vertices);
  DELTAMESH_TRY(header.faces, scanner.read_count(kMax));
  const std::string_view edges = scanner.next_token_on_line();  // their number is often wrong, or missing
  if (!edges.empty() && !parse_integer(edges)) return scanner.error("OFF: not a number of edges", edges);
  DELTAMESH_CHECK(scanner.end_line("OFF: more counts than three"));
  // Fewest characters: "0 0 0" and a blank for a vertex, "0" and a blank for a face; the last blank may be
  // missing.
  if (header.vertices * 6 + header.faces * 2 > scanner.remaining() + std::uint64_t{1})
    return scanner.error("OFF: the file is too short for the number of vertices and faces it states");
  return header;
}

/// The numbers behind the position of a vertex or the corners of a face.
struct LineEnd {
  std::array<double, 9> values{};
  std::array<bool, 9> fraction{};
  std::size_t count = 0;
};

Result<LineEnd> read_line_end(TextScanner& scanner) {
  LineEnd line;
  for (std::string_view token = scanner.next_token_on_line(); !token.empty();
       token = scanner.next_token_on_line()) {
    const auto value = parse_number(token);
    if (!value) return scanner.error("OFF: not a number, or one that does not fit a double", token);
    if (line.count == line.values.size())
      return scanner.error("OFF: more numbers than a line may have", token);
    line.fraction[line.count] = token.find('.') != token.npos;
    line.values[line.count++] = *value;
  }
  return line;
}

Attribute to_attribute(AttributeKind kind, ComponentType type, std::size_t components, const char* name,
                       std::span<const double> values) {
  Attribute attribute =
      make_attribute(kind, type, static_cast<std::uint8_t>(components), name, values.size() / components);
  for (std::size_t i = 0; i < values.size(); ++i)
    store_component(type, values[i], attribute.values.data() + i * component_size(type));
  return attribute;
}

/// Colours, judged when all are known: whole numbers from 0 to 255 are bytes; anything else are real numbers.
/// If none exceeds 1 they are real numbers, too: bytes would be black, and programs write 0 and 1 for 0.0 and
/// 1.0.
struct Colors {
  std::vector<double> values{};
  std::size_t components = 0;
  bool fraction = false;

  /// `components` numbers of a line, from `first` on.
  void add(const LineEnd& line, std::size_t first) {
    for (std::size_t c = first; c < first + components; ++c) {
      values.push_back(line.values[c]);
      fraction = fraction || line.fraction[c];
    }
  }

  Attribute to_attribute(ReadReport& report) const {
    bool bytes = !fraction && std::all_of(values.begin(), values.end(),
                                          [](double c) { return c >= 0 && c <= 255 && c == std::floor(c); });
    if (bytes && !values.empty() && *std::max_element(values.begin(), values.end()) == 1) {
      report.leave_out(LeftOutKind::kGuesses, "1 as the brightest of colours", values.size() / components);
      bytes = false;
    }
    return deltamesh::to_attribute(AttributeKind::kColor, bytes ? ComponentType::kU8 : ComponentType::kF32,
                                   components, "color", values);
  }
};

class OffReader {
 public:
  explicit OffReader(std::string_view text) : scanner_(text, {.hash_comments = true}) {}

  Result<Imported> read() {
    DELTAMESH_TRY(header_, read_header(scanner_));
    DELTAMESH_CHECK(read_vertices());
    DELTAMESH_CHECK(read_faces());
    const std::string_view behind = scanner_.next_token();
    if (!behind.empty())
      return scanner_.error("OFF: the file goes on behind the faces that it states", behind);
    if (header_.normal) add(AttributeKind::kNormal, 3, "normal", normals_);
    if (header_.color && header_.vertices > 0) mesh_.attributes.push_back(colors_.to_attribute(report_));
    if (header_.uv) add(AttributeKind::kUv, 2, "uv", uvs_);
    add_face_colors();
    return to_triangles(std::move(mesh_), std::move(report_));
  }

 private:
  void add(AttributeKind kind, std::size_t components, const char* name, std::span<const double> values) {
    mesh_.attributes.push_back(to_attribute(kind, ComponentType::kF32, components, name, values));
  }

  Result<void> read_vertices() {
    mesh_.coordinates.reserve(header_.vertices * 3);
    for (std::uint64_t v = 0; v < header_.vertices; ++v) {
      for (int k = 0; k < 3; ++k) {
        DELTAMESH_TRY(const double value, scanner_.read_number());
        mesh_.coordinates.push_back(value);
      }
      DELTAMESH_TRY(const LineEnd line, read_line_end(scanner_));
      DELTAMESH_CHECK(add_vertex(line));
    }
    return {};
  }

  /// What the rest of a vertex line promises.
  Result<void> add_vertex(const LineEnd& line) {
    const std::size_t normal = header_.normal ? 3 : 0;
    const std::size_t uv = header_.uv ? 2 : 0;
    if (normal + uv == 0 && !header_.color) {
      if (line.count > 0)
        report_.leave_out(LeftOutKind::kVertexValues, "numbers that the file's first word does not promise");
      return {};
    }
    const std::size_t color = header_.color && line.count > normal + uv ? line.count - normal - uv : 0;
    if (colors_.components == 0) colors_.components = color;
    if (line.count != normal + color + uv || color != colors_.components ||
        (header_.color && (color < 3 || color > 4)))
      return scanner_.error("OFF: a vertex line has not the numbers that the file's first word promises");
    const double* next = line.values.data();
    normals_.insert(normals_.end(), next, next + normal);
    colors_.add(line, normal);
    next += normal + color;
    uvs_.insert(uvs_.end(), next, next + uv);
    return {};
  }

  /// A face may span lines; what follows its corners on the last one is its colour.
  Result<void> read_faces() {
    std::vector<std::uint32_t> corners;
    for (std::uint64_t f = 0; f < header_.faces; ++f) {
      DELTAMESH_TRY(const std::uint64_t count,
                    scanner_.read_count(std::numeric_limits<std::uint32_t>::max()));
      corners.clear();
      for (std::uint64_t c = 0; c < count; ++c) {
        DELTAMESH_TRY(const std::uint64_t corner,
                      scanner_.read_count(std::numeric_limits<std::uint32_t>::max()));
        if (corner >= header_.vertices)
          return scanner_.error("OFF: a face names a vertex that does not exist");
        corners.push_back(static_cast<std::uint32_t>(corner));
      }
      DELTAMESH_TRY(const LineEnd line, read_line_end(scanner_));
      if (line.count > 4 || line.count == 2)
        return scanner_.error("OFF: a face with numbers behind it that are no colour");
      if (mesh_.faces.add(corners)) add_face_color(line, corners.size());
    }
    return {};
  }

  void add_face_color(const LineEnd& line, std::size_t corners) {
    if (line.count == 1) report_.leave_out(LeftOutKind::kFaceValues, "numbers of colours of a palette");
    if (line.count < 3) return;
    if (face_colors_.components == 0) face_colors_.components = line.count;
    ++colored_faces_;
    alike_ = alike_ && line.count == face_colors_.components;
    face_colors_.add(line, 0);
    color_owners_.insert(color_owners_.end(), corners, static_cast<std::uint32_t>(colored_faces_ - 1));
  }

  void add_face_colors() {
    if (colored_faces_ == 0) return;
    const bool all = alike_ && colored_faces_ == mesh_.faces.count();
    if (!all || header_.color)
      return report_.leave_out(
          LeftOutKind::kFaceValues,
          header_.color ? "colours, for the vertices have some" : "colours, not the same of all faces",
          colored_faces_);
    mesh_.corner_values.push_back(index_values(face_colors_.to_attribute(report_), color_owners_));
  }

  TextScanner scanner_;
  OffHeader header_;
  PolygonMesh mesh_;
  ReadReport report_;
  std::vector<double> normals_, uvs_;
  Colors colors_;
  Colors face_colors_;
  std::vector<std::uint32_t> color_owners_;  // of every corner
  std::uint64_t colored_faces_ = 0;
  bool alike_ = true;
};

}  // namespace

Result<Imported> read_off(std::span<const std::byte> bytes) { return OffReader(as_text(bytes)).read(); }

}  // namespace deltamesh
