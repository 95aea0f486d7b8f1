// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OBJ: vertices, texture coordinates, normals and polygons; objects, groups and materials as groups of faces.
#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <unordered_set>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/formats.h"
#include "io/polygons/mesh.h"
#include "io/polygons/named_groups.h"
#include "io/text/numbers.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

/// Statements of OBJ that are left out: materials, curves, surfaces, display.
constexpr std::array<std::string_view, 33> kOtherStatements{
    "vp",     "cstype", "deg",  "bmat", "step",       "curv",     "curv2",    "surf",     "parm",
    "trim",   "hole",   "scrv", "sp",   "end",        "con",      "mg",       "bevel",    "lod",
    "maplib", "usemap", "call", "csh",  "ctech",      "stech",    "c_interp", "d_interp", "bsp",
    "bzp",    "cdc",    "cdp",  "res",  "shadow_obj", "trace_obj"};

/// The numbers on the rest of a line.
struct Numbers {
  std::array<double, 8> values{};
  std::size_t count = 0;
};

constexpr const char* kMissing =
    "OBJ: a face names a vertex, texture coordinate or normal that does not exist";

/// The records "v", "vt" or "vn" of a file, and the greatest index of them that a face used.
template <class T>
struct Records {
  std::size_t components;
  std::vector<T> values{};
  std::int64_t greatest = -1;
  std::uint64_t greatest_line = 0;

  std::size_t count() const noexcept { return values.size() / components; }
  Result<void> check() const noexcept {
    if (greatest >= static_cast<std::int64_t>(count())) return invalid_line(kMissing, greatest_line);
    return {};
  }
};

class ObjReader {
 public:
  explicit ObjReader(std::string_view text)
      : text_(text), scanner_(text, {.hash_comments = true, .joined_lines = true}) {}

  Result<Imported> read() {
    leave_out_polypaint();
    for (std::string_view word = scanner_.next_token(); !word.empty(); word = scanner_.next_token())
      DELTAMESH_CHECK(read_statement(word));
    DELTAMESH_CHECK(positions_.check());
    DELTAMESH_CHECK(uvs_.check());
    DELTAMESH_CHECK(normals_.check());
    return build();
  }

 private:
  Result<void> read_statement(std::string_view word) {
    if (word == "v") return read_position();
    if (word == "vt") return read_uv();
    if (word == "vn") return read_normal();
    if (word == "f" || word == "fo") return read_face();
    if (word == "o") return begin(&GroupName::object);
    if (word == "g") return begin(&GroupName::group);
    if (word == "usemtl") return begin(&GroupName::material);
    if (word == "mtllib") return name_library();
    const std::string_view rest = rest_of_statement();
    if (word == "l" || word == "p") {
      report_.leave_out(LeftOutKind::kPrimitives, word == "l" ? "lines" : "points");
    } else if (word == "s") {
      if (rest != "off" && rest != "0") report_.leave_out(LeftOutKind::kElements, "smoothing groups");
    } else if (std::find(kOtherStatements.begin(), kOtherStatements.end(), word) != kOtherStatements.end()) {
      report_.leave_out(LeftOutKind::kElements, word);
    } else {
      return scanner_.error("OBJ: an unknown statement", word);
    }
    return {};
  }

  /// ZBrush writes colours as comments.
  void leave_out_polypaint() {
    if (text_.find("#MRGB ") != text_.npos)
      report_.leave_out(LeftOutKind::kElements, "polypaint, colours in comments (#MRGB)");
  }

  /// The first word behind a statement's, having passed the others.
  std::string_view rest_of_statement() noexcept {
    const std::string_view first = scanner_.next_token_on_line();
    while (!scanner_.next_token_on_line().empty()) {
    }
    return first;
  }

  /// The words behind a statement's, as one name.
  std::string rest_as_name() {
    std::string name;
    for (auto word = scanner_.next_token_on_line(); !word.empty(); word = scanner_.next_token_on_line())
      (name += name.empty() ? "" : " ") += word;
    return name;
  }

  Result<void> begin(std::string GroupName::*level) {
    groups_.begin(level, rest_as_name(), report_);
    return {};
  }

  /// The rest of the line is one name with spaces, or several names: all of these are noted, each once.
  Result<void> name_library() {
    std::string names = rest_as_name();
    std::ranges::replace(names, '\\', '/');
    std::istringstream words(names);
    for (std::string word; words >> word;) add_file(std::move(word));
    add_file(std::move(names));
    report_.leave_out(LeftOutKind::kElements, "mtllib");
    return {};
  }

  void add_file(std::string name) {
    if (known_files_.insert(name).second) report_.files.push_back(std::move(name));
  }

  Result<Numbers> read_numbers(std::size_t least, std::size_t most) {
    Numbers numbers;
    for (auto word = scanner_.next_token_on_line(); !word.empty(); word = scanner_.next_token_on_line()) {
      const auto value = parse_number(word);
      if (!value) return scanner_.error("OBJ: not a number, or one that does not fit a double", word);
      if (numbers.count == most) return scanner_.error("OBJ: more numbers than the statement has", word);
      numbers.values[numbers.count++] = *value;
    }
    if (numbers.count < least) return scanner_.error("OBJ: fewer numbers than the statement needs");
    return numbers;
  }

  /// "v x y z", "v x y z w", "v x y z r g b" or "v x y z r g b a".
  Result<void> read_position() {
    DELTAMESH_TRY(const Numbers numbers, read_numbers(3, 7));
    const auto& values = numbers.values;
    if (numbers.count == 5)
      return scanner_.error("OBJ: five numbers are neither a place nor one with a colour");
    positions_.values.insert(positions_.values.end(), values.begin(), values.begin() + 3);
    if (numbers.count >= 6)
      for (std::size_t k = 3; k < 6; ++k) colors_.push_back(to_float(values[k]));
    if (numbers.count == 4 && values[3] != 1) report_.leave_out(LeftOutKind::kVertexValues, "weights");
    if (numbers.count == 7 && values[6] != 1) report_.leave_out(LeftOutKind::kVertexValues, "alpha");
    return {};
  }

  Result<void> read_uv() {
    DELTAMESH_TRY(const Numbers numbers, read_numbers(1, 3));
    uvs_.values.insert(uvs_.values.end(), {to_float(numbers.values[0]), to_float(numbers.values[1])});
    if (numbers.values[2] != 0) report_.leave_out(LeftOutKind::kFaceValues, "third texture coordinates");
    return {};
  }

  Result<void> read_normal() {
    DELTAMESH_TRY(const Numbers numbers, read_numbers(3, 3));
    for (std::size_t k = 0; k < 3; ++k) normals_.values.push_back(to_float(numbers.values[k]));
    return {};
  }

  /// Takes an index up to the next '/' from `corner`. Negative ones count back from the records so far; an
  /// empty one is kNone.
  template <class T>
  Result<std::uint32_t> take_index(std::string_view& corner, Records<T>& records) {
    const std::size_t slash = std::min(corner.find('/'), corner.size());
    const std::string_view digits = corner.substr(0, slash);
    corner.remove_prefix(std::min(slash + 1, corner.size()));
    if (digits.empty()) return CornerValues::kNone;
    const auto number = parse_integer(digits);
    if (!number || *number == 0 || *number > std::int64_t{CornerValues::kNone})
      return scanner_.error("OBJ: not an index of a vertex, texture coordinate or normal", digits);
    const std::int64_t index =
        *number > 0 ? *number - 1 : static_cast<std::int64_t>(records.count()) + *number;
    if (index < 0) return scanner_.error(kMissing, digits);
    if (index > records.greatest) {
      records.greatest = index;
      records.greatest_line = scanner_.line();
    }
    return static_cast<std::uint32_t>(index);
  }

  /// Corners "v", "v/", "v/t", "v//n", "v/t/n" and the like.
  Result<void> read_face() {
    corners_.clear();
    const std::size_t before = uv_index_.size();
    for (auto word = scanner_.next_token_on_line(); !word.empty(); word = scanner_.next_token_on_line()) {
      std::string_view corner = word;
      DELTAMESH_TRY(const std::uint32_t position, take_index(corner, positions_));
      if (position == CornerValues::kNone)
        return scanner_.error("OBJ: a face corner without a vertex index", word);
      DELTAMESH_TRY(const std::uint32_t uv, take_index(corner, uvs_));
      DELTAMESH_TRY(const std::uint32_t normal, take_index(corner, normals_));
      if (!corner.empty()) return scanner_.error("OBJ: more than three indices of a face corner", word);
      corners_.push_back(position);
      uv_index_.push_back(uv);
      normal_index_.push_back(normal);
    }
    if (faces_.add(corners_)) {
      groups_.add_face();
    } else {
      uv_index_.resize(before);
      normal_index_.resize(before);
    }
    return {};
  }

  /// A list of corners' indices, as values; what is on some corners only is left out, or has zeros on the
  /// others.
  void add_corner_values(PolygonMesh& mesh, AttributeKind kind, const char* name,
                         const Records<float>& records, std::vector<std::uint32_t> index) {
    const auto missing =
        static_cast<std::size_t>(std::count(index.begin(), index.end(), CornerValues::kNone));
    if (missing == index.size()) return;
    if (missing > 0 && kind == AttributeKind::kNormal)
      return report_.leave_out(LeftOutKind::kFaceValues, "normals, which not all corners have",
                               index.size() - missing);
    if (missing > 0)
      report_.leave_out(LeftOutKind::kGuesses, "0 0 as texture coordinates of corners without", missing);
    mesh.corner_values.push_back(
        {attribute(kind, name, records.components, records.values), std::move(index)});
  }

  static Attribute attribute(AttributeKind kind, const char* name, std::size_t components,
                             std::span<const float> values) {
    Attribute made =
        make_attribute(kind, ComponentType::kF32, static_cast<std::uint8_t>(components), name, 0);
    const auto bytes = std::as_bytes(values);
    made.values.assign(bytes.begin(), bytes.end());
    return made;
  }

  void add_colors(PolygonMesh& mesh) {
    if (colors_.size() != positions_.values.size())
      return report_.leave_out(LeftOutKind::kVertexValues, "colours, which not all vertices have",
                               colors_.size() / 3);
    if (colors_.empty()) return;
    mesh.attributes.push_back(attribute(AttributeKind::kColor, "rgb", 3, colors_));
  }

  Result<Imported> build() {
    PolygonMesh mesh;
    add_colors(mesh);
    add_corner_values(mesh, AttributeKind::kNormal, "vn", normals_, std::move(normal_index_));
    add_corner_values(mesh, AttributeKind::kUv, "vt", uvs_, std::move(uv_index_));
    mesh.coordinates = std::move(positions_.values);
    mesh.faces = std::move(faces_);
    groups_.move_into(mesh, report_);
    return to_triangles(std::move(mesh), std::move(report_));
  }

  std::string_view text_;
  TextScanner scanner_;
  Records<double> positions_{.components = 3};
  Records<float> uvs_{.components = 2};
  Records<float> normals_{.components = 3};
  std::vector<float> colors_;  // 3 per "v" that has them
  Faces faces_;
  std::vector<std::uint32_t> uv_index_, normal_index_;  // of every corner of `faces_`
  std::vector<std::uint32_t> corners_;
  NamedGroups groups_;
  ReadReport report_;
  std::unordered_set<std::string> known_files_;  // of `report_`
};

}  // namespace

Result<Imported> read_obj(std::span<const std::byte> bytes) { return ObjReader(as_text(bytes)).read(); }

}  // namespace deltamesh
