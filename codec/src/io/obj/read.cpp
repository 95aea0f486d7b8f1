// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OBJ through tinyobjloader's callbacks. They are called once per record, while the stream buffer (ObjLines)
// stands at the record's line; that gives errors their line, and lets positions be parsed here: tinyobjloader
// turns "nan" into 0, rounds the last digits and passes no vertex colours.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <istream>
#include <limits>
#include <optional>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/faces.h"
#include "io/formats.h"
#include "io/obj/corners.h"
#include "io/obj/lines.h"
#include "io/origin.h"
#include "io/text/numbers.h"
#include "io/text/scanner.h"

namespace deltamesh {
namespace {

constexpr std::uint64_t kMaxCount = std::numeric_limits<std::uint32_t>::max();

/// The greatest index a face used, and where: checked once all records are known.
struct Reach {
  std::int64_t greatest = -1;
  std::uint64_t line = 0;
};

class ObjRecords {
 public:
  explicit ObjRecords(std::string_view text) : lines_(text) {}

  Result<Imported> read() {
    std::istream stream(&lines_);
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, double, double, double, double) { from(self).add_position(); };
    callbacks.normal_cb = [](void* self, double x, double y, double z) {
      from(self).normals_.insert(from(self).normals_.end(), {to_float(x), to_float(y), to_float(z)});
    };
    callbacks.texcoord_cb = [](void* self, double u, double v, double) {
      from(self).uvs_.insert(from(self).uvs_.end(), {to_float(u), to_float(v)});
    };
    callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
      from(self).add_face(std::span(indices, static_cast<std::size_t>(std::max(count, 0))));
    };
    tinyobj::LoadObjWithCallback(stream, callbacks, this);
    if (error_) return *error_;
    DELTAMESH_CHECK(check_reach());
    return build();
  }

 private:
  static ObjRecords& from(void* self) noexcept { return *static_cast<ObjRecords*>(self); }

  /// Keeps the first problem.
  void fail(const char* message) noexcept {
    if (!error_) error_ = invalid_line(message, lines_.line());
  }

  /// "v x y z [w]" or "v x y z r g b ...".
  void add_position() {
    TextScanner scanner(lines_.text(), true);
    scanner.next_token_on_line();
    std::array<double, 6> values{};
    std::size_t count = 0;
    for (std::string_view token = scanner.next_token_on_line(); !token.empty() && count < values.size();
         token = scanner.next_token_on_line()) {
      const auto value = parse_number(token);
      if (!value) return fail("OBJ: not a number, or one that does not fit a double");
      values[count++] = *value;
    }
    if (count < 3) return fail("OBJ: a vertex with fewer than three coordinates");
    coordinates_.insert(coordinates_.end(), values.begin(), values.begin() + 3);
    if (count == values.size())
      for (std::size_t k = 3; k < 6; ++k) colors_.push_back(to_float(values[k]));
  }

  /// From 0. Zero counts as not given; a negative index counts back from the records so far.
  static std::int64_t resolve(int index, std::size_t records) noexcept {
    if (index > 0) return std::int64_t{index} - 1;
    if (index == 0) return ObjCorner::kNone;
    const std::int64_t back = static_cast<std::int64_t>(records) + index;
    return back < 0 ? std::numeric_limits<std::int64_t>::max() : back;
  }

  void extend(Reach& reach, std::int64_t index) noexcept {
    if (index > reach.greatest) reach = {index, lines_.line()};
  }

  /// tinyobjloader wraps indices that do not fit an int.
  bool has_long_number() const noexcept {
    std::size_t digits = 0;
    for (const char c : lines_.text()) {
      digits = c >= '0' && c <= '9' ? digits + 1 : 0;
      if (digits > 9) return true;
    }
    return false;
  }

  void add_face(std::span<const tinyobj::index_t> indices) {
    if (has_long_number()) return fail("OBJ: an index of more than nine digits");
    for (const tinyobj::index_t& index : indices) {
      const ObjCorner corner{resolve(index.vertex_index, coordinates_.size() / 3),
                             resolve(index.texcoord_index, uvs_.size() / 2),
                             resolve(index.normal_index, normals_.size() / 3)};
      if (corner.position == ObjCorner::kNone) return fail("OBJ: a face corner without a vertex index");
      extend(position_reach_, corner.position);
      extend(uv_reach_, corner.uv);
      extend(normal_reach_, corner.normal);
      corners_.push_back(corner);
    }
    face_ends_.push_back(corners_.size());
  }

  Result<void> check_reach() const noexcept {
    const auto beyond = [](const Reach& reach, std::size_t records) {
      return reach.greatest >= static_cast<std::int64_t>(records);
    };
    constexpr const char* kMissing =
        "OBJ: a face names a vertex, texture coordinate or normal that does not exist";
    if (beyond(position_reach_, coordinates_.size() / 3)) return invalid_line(kMissing, position_reach_.line);
    if (beyond(uv_reach_, uvs_.size() / 2)) return invalid_line(kMissing, uv_reach_.line);
    if (beyond(normal_reach_, normals_.size() / 3)) return invalid_line(kMissing, normal_reach_.line);
    if (coordinates_.size() / 3 + corners_.size() > kMaxCount)
      return invalid_file("OBJ: more corners than a 32-bit index can name");
    return {};
  }

  Result<Imported> build() {
    const ObjVertices split = split_obj_corners(corners_, coordinates_.size() / 3);
    std::vector<double> coordinates;
    coordinates.reserve(split.vertices.size() * 3);
    for (const ObjCorner& vertex : split.vertices)
      for (std::int64_t k = 0; k < 3; ++k) coordinates.push_back(coordinates_[3 * vertex.position + k]);
    Imported imported{.mesh = place_origin(coordinates), .notes = {}};
    FaceCollector faces;
    std::size_t begin = 0;
    for (const std::size_t end : face_ends_) {
      faces.add(std::span(split.corners).subspan(begin, end - begin));
      begin = end;
    }
    faces.move_into(imported);
    imported.notes.other_primitives = lines_.other_primitives();
    add_attributes(split.vertices, imported.mesh);
    return imported;
  }

  void add_attributes(std::span<const ObjCorner> vertices, Mesh& mesh) const {
    if (normal_reach_.greatest >= 0) {
      // Corners without a normal, beside others that have one, get the z axis: a normal has unit length.
      constexpr std::array<float, 3> kDefault{0, 0, 1};
      mesh.attributes.push_back(
          gather<3>(AttributeKind::kNormal, "vn", normals_, kDefault, vertices, &ObjCorner::normal));
    }
    if (uv_reach_.greatest >= 0) {
      constexpr std::array<float, 2> kDefault{0, 0};
      mesh.attributes.push_back(
          gather<2>(AttributeKind::kUv, "vt", uvs_, kDefault, vertices, &ObjCorner::uv));
    }
    if (colors_.empty() || colors_.size() != coordinates_.size()) return;
    // Six numbers on every vertex line; colours only where all lie in [0, 1].
    const bool in_range =
        std::all_of(colors_.begin(), colors_.end(), [](float c) { return c >= 0 && c <= 1; });
    constexpr std::array<float, 3> kDefault{1, 1, 1};
    mesh.attributes.push_back(gather<3>(in_range ? AttributeKind::kColor : AttributeKind::kGeneric, "rgb",
                                        colors_, kDefault, vertices, &ObjCorner::position));
  }

  /// One attribute: the record that `index` names of every vertex, or `missing`.
  template <std::size_t N>
  static Attribute gather(AttributeKind kind, const char* name, std::span<const float> records,
                          const std::array<float, N>& missing, std::span<const ObjCorner> vertices,
                          std::int64_t ObjCorner::*index) {
    Attribute attribute = make_attribute(kind, ComponentType::kF32, N, name, vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const std::int64_t record = vertices[v].*index;
      const float* const from = record == ObjCorner::kNone ? missing.data() : &records[N * record];
      std::memcpy(&attribute.values[v * N * sizeof(float)], from, N * sizeof(float));
    }
    return attribute;
  }

  ObjLines lines_;
  std::vector<double> coordinates_;  // 3 per "v"
  std::vector<float> colors_;        // 3 per "v" that has them
  std::vector<float> uvs_;           // 2 per "vt"
  std::vector<float> normals_;       // 3 per "vn"
  std::vector<ObjCorner> corners_;
  std::vector<std::size_t> face_ends_;  // one past the last corner of every face
  Reach position_reach_, uv_reach_, normal_reach_;
  std::optional<Error> error_;
};

}  // namespace

Result<Imported> read_obj(std::span<const std::byte> bytes) { return ObjRecords(as_text(bytes)).read(); }

}  // namespace deltamesh
