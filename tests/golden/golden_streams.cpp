// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "golden_streams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/numbers/vec3.h"
#include "scenes.h"
#include "support/meshes.h"

namespace deltamesh::test {
namespace {

template <class T>
Attribute attribute_of(AttributeKind kind, ComponentType type, int components, const char* name,
                       const std::vector<T>& numbers) {
  Attribute attribute{
      .kind = kind, .type = type, .components = static_cast<std::uint8_t>(components), .name = name};
  const auto bytes = std::as_bytes(std::span(numbers));
  attribute.values.assign(bytes.begin(), bytes.end());
  attribute.linear = kind == AttributeKind::kColor;  // named as in glTF
  return attribute;
}

/// One of every kind of attribute that assets have, and two groups of faces.
Mesh asset() {
  Mesh mesh = bumpy_grid(20, 15);
  std::vector<float> normals;
  std::vector<float> tangents;
  std::vector<float> uvs;
  std::vector<std::uint8_t> colors;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  std::vector<float> moves;
  std::vector<std::uint32_t> labels;
  for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
    const float x = mesh.positions[3 * i];
    const float y = mesh.positions[3 * i + 1];
    const float slope = 0.25F * static_cast<float>(i % 7) - 0.5F;
    const float size = std::sqrt(1 + slope * slope);
    normals.insert(normals.end(), {slope / size, 0, 1 / size});
    tangents.insert(tangents.end(), {1 / size, 0, -slope / size, i % 50 == 0 ? -1.0F : 1.0F});
    uvs.insert(uvs.end(), {x / 20 + 0.001F * static_cast<float>(i % 5), y / 15});
    colors.insert(colors.end(), {static_cast<std::uint8_t>(9 * x), static_cast<std::uint8_t>(11 * y),
                                 static_cast<std::uint8_t>(i * 37), static_cast<std::uint8_t>(255 - i % 3)});
    const auto bone = static_cast<std::uint8_t>(x / 4);
    joints.insert(joints.end(), {bone, static_cast<std::uint8_t>(bone + 1), 0, 0});
    const float share = static_cast<float>(i % 9) / 8;
    weights.insert(weights.end(), {share, 1 - share, 0, 0});
    moves.insert(moves.end(), {0, y > 7 ? 0.125F * slope : 0, 0});
    labels.push_back(i % 60 < 40 ? 70000 : 12);
  }
  using enum AttributeKind;
  using enum ComponentType;
  mesh.attributes = {attribute_of(kTangent, kF32, 4, "TANGENT", tangents),
                     attribute_of(kNormal, kF32, 3, "NORMAL", normals),
                     attribute_of(kUv, kF32, 2, "TEXCOORD_0", uvs),
                     attribute_of(kColor, kU8, 4, "COLOR_0", colors),
                     attribute_of(kJoints, kU8, 4, "JOINTS_0", joints),
                     attribute_of(kWeights, kF32, 4, "WEIGHTS_0", weights),
                     attribute_of(kGeneric, kF32, 3, "move", moves),
                     attribute_of(kGeneric, kU32, 1, "label", labels)};
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) mesh.face_groups.push_back(f < 200 ? 0 : 3);
  return mesh;
}

/// The asset cut along y = 7. Its copies there have other texture coordinates; every fourth one has another
/// normal and other joints as well.
Mesh cut_asset() {
  constexpr std::uint32_t kColumns = 21;
  constexpr std::uint32_t kFirst = 7 * kColumns;
  Mesh mesh = asset();
  const auto n = static_cast<std::uint32_t>(mesh.vertex_count());
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    const auto corners = std::span(mesh.triangles).subspan(3 * f, 3);
    const auto is_below = [](std::uint32_t v) { return v < kFirst; };
    if (std::any_of(corners.begin(), corners.end(), is_below)) continue;
    for (std::uint32_t& v : corners)
      if (v < kFirst + kColumns) v += n - kFirst;
  }
  mesh.positions.insert(mesh.positions.end(), mesh.positions.begin() + 3 * kFirst,
                        mesh.positions.begin() + 3 * (kFirst + kColumns));
  for (Attribute& attribute : mesh.attributes) {
    const std::size_t row = attribute.values.size() / n;
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      const bool is_joint = attribute.kind == AttributeKind::kJoints;
      const bool differs = attribute.kind == AttributeKind::kUv ||
                           (i % 4 == 0 && (is_joint || attribute.kind == AttributeKind::kNormal));
      const std::uint32_t source = kFirst + i + (differs ? 2 * kColumns + (is_joint ? 5 : 0) : 0);
      for (std::size_t k = 0; k < row; ++k) attribute.values.push_back(attribute.values[source * row + k]);
    }
  }
  return mesh;
}

/// With its colours alone, and an alpha of 1.
Mesh opaque(Mesh mesh) {
  std::erase_if(mesh.attributes, [](const Attribute& a) { return a.kind != AttributeKind::kColor; });
  for (Attribute& colors : mesh.attributes)
    for (std::size_t i = 3; i < colors.values.size(); i += 4) colors.values[i] = std::byte{255};
  return mesh;
}

/// Flat patches of 16-bit colours, grey levels as floats, zero normals, noisy heights, and an origin far
/// away.
Mesh painted() {
  Mesh mesh = bumpy_grid(24, 18);
  std::vector<std::uint16_t> patches;
  std::vector<float> tones;
  std::vector<float> normals;
  std::vector<std::uint16_t> heights;
  for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
    const std::uint32_t x = i % 25;
    const std::uint32_t y = i / 25;
    const std::uint32_t patch = (x / 6 + 3 * (y / 5)) % 5;
    patches.insert(patches.end(), {static_cast<std::uint16_t>(257 * (40 * patch)),
                                   static_cast<std::uint16_t>(257 * (200 - 30 * patch)),
                                   static_cast<std::uint16_t>(257 * 40 * patch), std::uint16_t{65535}});
    const float tone = static_cast<float>((x * x + y * y + (i * 7) % 5) % 256) / 255;
    tones.insert(tones.end(), {tone, tone, 0.5F});
    normals.insert(normals.end(), {0, 0, i % 40 == 0 ? 0.0F : 1.0F});
    heights.push_back(static_cast<std::uint16_t>(40 * x + 3 * x * y + (i * 2654435761U >> 20) % 2048));
  }
  using enum AttributeKind;
  using enum ComponentType;
  mesh.attributes = {
      attribute_of(kColor, kU16, 4, "COLOR_0", patches), attribute_of(kColor, kF32, 3, "COLOR_1", tones),
      attribute_of(kNormal, kF32, 3, "NORMAL", normals), attribute_of(kGeneric, kU16, 1, "height", heights)};
  mesh.origin = {500000, 5100000, 120.5};
  return mesh;
}

/// With what a sensor says of each vertex: floats, one of which is missing, and whole numbers.
Mesh sensed() {
  Mesh mesh = painted();
  std::vector<float> intensities;
  std::vector<std::uint16_t> counts;
  for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
    const std::uint32_t x = i % 25;
    const std::uint32_t y = i / 25;
    const std::uint32_t grain = (i * 2654435761U) >> 27;
    intensities.push_back(static_cast<float>(100 + 3 * x + y * y + grain) / 512);
    counts.push_back(static_cast<std::uint16_t>(60 * x + 7 * x * y + 10 * grain));
  }
  intensities[77] = std::numeric_limits<float>::quiet_NaN();
  using enum AttributeKind;
  using enum ComponentType;
  mesh.attributes = {attribute_of(kGeneric, kF32, 1, "intensity", intensities),
                     attribute_of(kGeneric, kU16, 1, "count", counts)};
  return mesh;
}

/// Numbers that look like noise, alike on every machine.
class Noise {
 public:
  std::uint32_t next() noexcept { return (state_ = state_ * 1664525 + 1013904223) >> 16; }
  /// -1 to 1.
  float signed_part() noexcept { return static_cast<float>(next()) / 32768 - 1; }

 private:
  std::uint32_t state_ = 1;
};

std::vector<float> normals_all_around(std::size_t count) {
  Noise noise;
  std::vector<float> normals;
  while (normals.size() < 3 * count) {
    const std::array<float, 3> n{noise.signed_part(), noise.signed_part(), noise.signed_part()};
    const float square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (square < 0.1F) continue;
    for (const float x : n) normals.push_back(x / std::sqrt(square));
  }
  return normals;
}

/// The normals of faces, weighted by their angles.
std::vector<float> normals_by_angles(const Mesh& mesh) {
  std::vector<Vec3> sums(mesh.vertex_count());
  const auto at = [&mesh](std::uint32_t v) {
    return Vec3{mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
  };
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i) { return mesh.triangles[3 * f + (k + i) % 3]; };
      const Vec3 a = at(corner(1)) - at(corner(0));
      const Vec3 b = at(corner(2)) - at(corner(0));
      const Vec3 normal = cross(a, b);
      sums[corner(0)] = sums[corner(0)] + std::atan2(length(normal), dot(a, b)) / length(normal) * normal;
    }
  }
  std::vector<float> normals;
  for (const Vec3& sum : sums)
    for (const double x : sum) normals.push_back(static_cast<float>(length(sum) > 0 ? x / length(sum) : 0));
  return normals;
}

/// What the other meshes lack: two rows of vertices whose copies have most in common, a face far from its
/// shortest edge, vertices of no face, normals all around, some that are none, floats of no lattice, few that
/// move.
Mesh odd_asset() {
  constexpr std::uint32_t kColumns = 9;
  constexpr std::uint32_t kFirst = 3 * kColumns;
  Mesh mesh = bumpy_grid(kColumns - 1, 6);
  const auto grid = static_cast<std::uint32_t>(mesh.vertex_count());
  for (std::size_t f = mesh.triangle_count() / 2; f < mesh.triangle_count(); ++f)
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
      if (mesh.triangles[c] < kFirst + kColumns) mesh.triangles[c] += grid - kFirst;
  for (std::uint32_t i = 0; i < 3 * kColumns; ++i)
    mesh.positions.push_back(mesh.positions[std::size_t{3} * kFirst + i]);
  const auto last = static_cast<std::uint32_t>(mesh.vertex_count());
  mesh.positions.insert(mesh.positions.end(), {9, 0, 0, 9.001F, 0, 0, 60, 0, 0, 9, 9, 9, 9, 8, 9});
  mesh.triangles.insert(mesh.triangles.end(), {last, last + 1, last + 2});
  const std::size_t n = mesh.vertex_count();
  std::vector<float> uvs;
  std::vector<float> floats;
  std::vector<float> moves;
  std::vector<std::uint8_t> sides;
  for (std::size_t i = 0; i < n; ++i) {
    uvs.insert(uvs.end(), {mesh.positions[3 * i] / 8, mesh.positions[3 * i + 1] / 6});
    const float x = mesh.positions[3 * i];
    const float y = mesh.positions[3 * i + 1];
    floats.push_back(std::ldexp(std::sqrt(2 + x + y / 16), 4 * static_cast<int>(std::min(x, 8.0F))));
    moves.insert(moves.end(), {0, y > 4 && y < 7 ? (x - 4) * (x - 4) / 3 : 0, 0});
    sides.push_back(i < grid ? 1 : 2);
  }
  std::vector<float> angles = normals_by_angles(mesh);
  angles[std::size_t{3} * 20] = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t v : {30U, 31U, 32U})
    for (std::size_t k = 0; k < 3; ++k) angles[3 * v + k] = std::numeric_limits<float>::infinity();
  using enum AttributeKind;
  using enum ComponentType;
  mesh.attributes = {attribute_of(kUv, kF32, 2, "TEXCOORD_0", uvs),
                     attribute_of(kNormal, kF32, 3, "NORMAL", normals_all_around(n)),
                     attribute_of(kNormal, kF32, 3, "angles", angles),
                     attribute_of(kGeneric, kF32, 1, "floats", floats),
                     attribute_of(kGeneric, kF32, 3, "move", moves),
                     attribute_of(kGeneric, kU8, 1, "side", sides)};
  return mesh;
}

/// Normals all around and numbers of 64 bits.
Mesh wide_grid() {
  Mesh mesh = bumpy_grid(4, 3);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) numbers.push_back(0.1 * static_cast<double>(i));
  mesh.attributes = {attribute_of(AttributeKind::kNormal, ComponentType::kF32, 3, "NORMAL",
                                  normals_all_around(mesh.vertex_count())),
                     attribute_of(AttributeKind::kGeneric, ComponentType::kF64, 1, "wide", numbers)};
  return mesh;
}

/// Tangents alone.
Mesh brushed_grid() {
  Mesh mesh = bumpy_grid(4, 3);
  std::vector<float> tangents;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const float x = static_cast<float>(i % 4) / 5;
    tangents.insert(tangents.end(), {std::sqrt(1 - x * x), x, 0, 1});
  }
  mesh.attributes = {attribute_of(AttributeKind::kTangent, ComponentType::kF32, 4, "TANGENT", tangents)};
  return mesh;
}

/// A strip, long enough for three levels; and an island of eight vertices, of which each has edges to all
/// others: one node of the second level.
Mesh strip_and_island() {
  Mesh mesh;
  constexpr std::uint32_t kStrip = 660;
  for (std::uint32_t i = 0; i < kStrip; ++i) {
    const float x = static_cast<float>(i) / 2;
    mesh.positions.insert(mesh.positions.end(), {x, static_cast<float>(i % 2), std::abs(x - 160) / 4});
    if (i >= 2) mesh.triangles.insert(mesh.triangles.end(), {i - 2 + i % 2, i - 1 - i % 2, i});
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    const auto x = static_cast<float>(i);
    mesh.positions.insert(mesh.positions.end(), {x, x * x / 8, static_cast<float>(i % 2)});
    for (std::uint32_t j = i + 1; j < 8; ++j)
      mesh.triangles.insert(mesh.triangles.end(), {kStrip + i, kStrip + j, kStrip + (i + j + 1) % 8});
  }
  return mesh;
}

/// Some vertices are off the edges of voxels.
Mesh room_off_voxels() {
  Mesh mesh = *generate_scene(Scene::kRooms, 100, 3);
  mesh.attributes.clear();
  for (std::size_t i = 30; i < mesh.positions.size(); i += 90)
    for (std::size_t a = 0; a < 3; ++a) mesh.positions[i + a] += 0.04F;
  return mesh;
}

/// One face in four has an edge collapsed, so that most faces lie in no cube.
Mesh simplified_room() {
  Mesh mesh = *generate_scene(Scene::kRooms, 600, 3);
  std::vector<std::uint32_t> becomes(mesh.vertex_count());
  for (std::uint32_t v = 0; v < becomes.size(); ++v) becomes[v] = v;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 12)
    becomes[mesh.triangles[i]] = mesh.triangles[i + 1];
  for (std::uint32_t& v : mesh.triangles) v = becomes[v];
  return mesh;
}

/// Few vertices have to be glued.
Mesh glued_room() {
  Mesh mesh = *generate_scene(Scene::kRooms, 600, 3);
  mesh.attributes.clear();
  for (std::uint32_t v = 0; v < 9; v += 3) mesh.triangles.insert(mesh.triangles.end(), {v, 60 + v, 121});
  return mesh;
}

/// Some faces are flipped, some divided at a vertex inside their cubes, some lie in no cube; a vertex has
/// none.
Mesh odd_room() {
  Mesh mesh = *generate_scene(Scene::kRooms, 600, 3);
  mesh.attributes.clear();
  const std::size_t faces = mesh.triangle_count();
  for (std::size_t f = 0; f < faces; f += 25) std::swap(mesh.triangles[3 * f], mesh.triangles[3 * f + 1]);
  for (std::size_t f = 7; f < faces; f += 40) {
    const std::array<std::uint32_t, 3> face{mesh.triangles[3 * f], mesh.triangles[3 * f + 1],
                                            mesh.triangles[3 * f + 2]};
    const auto middle = static_cast<std::uint32_t>(mesh.vertex_count());
    for (std::size_t a = 0; a < 3; ++a)
      mesh.positions.push_back((mesh.positions[3 * face[0] + a] + mesh.positions[3 * face[1] + a] +
                                mesh.positions[3 * face[2] + a]) /
                               3);
    mesh.triangles[3 * f + 2] = middle;
    mesh.triangles.insert(mesh.triangles.end(), {face[1], face[2], middle, face[2], face[0], middle});
  }
  for (std::uint32_t v = 0; v < 9; v += 3) mesh.triangles.insert(mesh.triangles.end(), {v, 60 + v, 121});
  mesh.positions.insert(mesh.positions.end(), mesh.positions.begin() + 300, mesh.positions.begin() + 303);
  mesh.positions.back() += 0.05F;
  return mesh;
}

/// Two groups of faces, and nothing else but positions.
Mesh grouped_grid() {
  Mesh mesh = bumpy_grid(6, 4);
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) mesh.face_groups.push_back(f < 20 ? 0 : 3);
  return mesh;
}

/// A grid and points beside it, grey.
Mesh grey_points() {
  Mesh mesh = bumpy_grid(9, 8);
  for (std::uint32_t i = 0; i < 21; ++i) {
    const auto x = static_cast<float>(i);
    mesh.positions.insert(mesh.positions.end(), {x / 2, 9 + x / 8, x * x / 64});
  }
  std::vector<std::uint8_t> colors;
  for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i)
    colors.insert(colors.end(), 3, static_cast<std::uint8_t>(90 + 5 * (i % 10) + 3 * (i / 10) + i * i % 7));
  mesh.attributes = {attribute_of(AttributeKind::kColor, ComponentType::kU8, 3, "red", colors)};
  return mesh;
}

/// At most one vertex, with a colour.
Mesh grey_point(std::uint32_t count) {
  Mesh mesh;
  mesh.positions.assign(std::size_t{3} * count, 0.0F);
  mesh.attributes = {attribute_of(AttributeKind::kColor, ComponentType::kU8, 3, "red",
                                  std::vector<std::uint8_t>(std::size_t{3} * count, 77))};
  return mesh;
}

/// On a lattice but for a few numbers.
Mesh almost_on_a_lattice() {
  Mesh mesh = bumpy_grid(12, 10);
  for (const std::size_t i : {std::size_t{4}, std::size_t{50}, std::size_t{131}})
    mesh.positions[i] += 0.001234F;
  return mesh;
}

}  // namespace

std::vector<Golden> golden_streams() {
  std::vector<Golden> list;
  list.push_back({"tetrahedron.default", tetrahedron(), {}});
  list.push_back({"grid.bits6", bumpy_grid(12, 10), {.bits = 6, .anchors = 4}});
  list.push_back({"grid.zstd", bumpy_grid(12, 10), {.bits = 6, .anchors = 4, .profile = Profile::kZstd}});
  list.push_back({"attributes.compact", rough_grid(), {.bits = 8, .attributes = {.color_error = 0}}});
  list.push_back({"attributes.zstd",
                  attributed_grid(6, 5),
                  {.bits = 10, .profile = Profile::kZstd, .keep_order = true}});
  list.push_back({"painted.exact", painted(), {.bits = 8, .keep_order = true}});
  list.push_back(
      {"painted.zstd",
       painted(),
       {.bits = 8, .attributes = {.normal_error = 2, .color_error = 4}, .profile = Profile::kZstd}});
  list.push_back({"almost.lossless", almost_on_a_lattice(), {.lossless = true}});
  list.push_back({"grid.predictive",
                  rough_grid(),
                  {.geometry = GeometryCoder::kPredictive, .bits = 11, .attributes = {.color_error = 0}}});
  list.push_back({"asset.bounded", asset(), {.attributes = {.color_error = 3, .named = {{"move", 0.01}}}}});
  list.push_back({"asset.lossless", asset(), {.lossless = true}});
  list.push_back({"cut.bounded", cut_asset(), {.attributes = {.named = {{"move", 0.01}}}}});
  list.push_back({"cut.lossless", cut_asset(), {.lossless = true}});
  list.push_back({"groups.zstd",
                  grouped_grid(),
                  {.geometry = GeometryCoder::kPredictive, .bits = 8, .profile = Profile::kZstd}});
  Mesh floats = bumpy_grid(12, 10);  // of no lattice
  for (std::size_t i = 0; i < floats.positions.size(); ++i)
    floats.positions[i] = std::ldexp(floats.positions[i] + 1.1F, -static_cast<int>(i % 31));
  list.push_back({"floats.lossless", floats, {.lossless = true}});
  list.push_back({"floats.zstd", floats, {.lossless = true, .profile = Profile::kZstd}});
  EncodeOptions walked{.geometry = GeometryCoder::kPredictive, .effort = 2};
  walked.bits = 12;
  list.push_back({"sphere.walked", *generate_scene(Scene::kSphere, 500, 1), walked});
  // Planned cycles on four levels, and on a coarsest level that takes iterations.
  list.push_back({"terrain.levels",
                  *generate_scene(Scene::kTerrain, 2400, 1),
                  {.geometry = GeometryCoder::kHighpass, .bits = 4}});
  list.push_back({"sphere.anchors",
                  *generate_scene(Scene::kSphere, 1200, 1),
                  {.geometry = GeometryCoder::kHighpass, .bits = 3, .anchors = 240}});
  list.push_back({"grid.lossless", bumpy_grid(12, 10), {.lossless = true}});
  list.push_back({"room.voxels",
                  *generate_scene(Scene::kRooms, 600, 3),
                  {.quality = {.max_error = QualityBound{0.02}}, .geometry = GeometryCoder::kPredictive}});
  list.push_back({"room.simplified",
                  simplified_room(),
                  {.quality = {.max_error = QualityBound{0.02}}, .geometry = GeometryCoder::kPredictive}});
  list.push_back({"room.odd",
                  odd_room(),
                  {.quality = {.max_error = QualityBound{0.003}},
                   .geometry = GeometryCoder::kPredictive,
                   .keep_unreferenced = true}});
  list.push_back({"room.glued", glued_room(), {.step = 0.02}});
  for (const auto& named : awkward_meshes()) {
    if (named.name == "seam") list.push_back({"seam.step", named.mesh, {.step = 0.01}});
    if (named.name == "seam")
      list.push_back({"seam.zstd", named.mesh, {.step = 0.01, .profile = Profile::kZstd}});
    if (named.name == "three faces on an edge") list.push_back({"nonmanifold.default", named.mesh, {}});
    if (named.name == "isolated vertices")
      list.push_back({"isolated.all", named.mesh, {.keep_unreferenced = true}});
  }
  list.push_back({"empty.lossless", {}, {.lossless = true}});
  list.push_back({"odd.bounded",
                  odd_asset(),
                  {.geometry = GeometryCoder::kPredictive,
                   .attributes = {.normal_error = 2, .uv_error = 0.01, .named = {{"move", 0.01}}},
                   .keep_order = true,
                   .keep_unreferenced = true}});
  list.push_back(
      {"wide.zstd", wide_grid(), {.bits = 8, .attributes = {.normal_error = 2}, .profile = Profile::kZstd}});
  list.push_back({"brushed.bits6", brushed_grid(), {.bits = 6, .attributes = {.tangent_error = 2}}});
  list.push_back(
      {"strip.levels", strip_and_island(), {.geometry = GeometryCoder::kHighpass, .bits = 4, .anchors = 4}});
  list.push_back({"asset.mean", asset(), {.attributes = {.color_rms = 4, .named = {{"move", 0.01}}}}});
  list.push_back({"opaque.mean",
                  opaque(asset()),
                  {.geometry = GeometryCoder::kHighpass, .attributes = {.color_rms = 16}}});
  list.push_back({"painted.mean", painted(), {.bits = 8, .attributes = {.color_rms = 2}}});
  list.push_back({"points.mean", grey_points(), {.attributes = {.color_rms = 2}, .keep_unreferenced = true}});
  list.push_back({"sensed.mean",
                  sensed(),
                  {.bits = 8, .attributes = {.named = {{"intensity", 0.02, true}, {"count", 90, true}}}}});
  for (const std::uint32_t count : {0U, 1U})
    list.push_back({count == 0 ? "none.mean" : "one.mean",
                    grey_point(count),
                    {.attributes = {.color_rms = 2}, .keep_unreferenced = true}});
  list.push_back({"room.off",
                  room_off_voxels(),
                  {.quality = {.max_error = QualityBound{0.02}}, .geometry = GeometryCoder::kPredictive}});
  return list;
}

/// A rough surface with smooth colours: no repetition for zstd, neighbourhoods for the compact coder.
Mesh rough_grid() {
  Mesh mesh = attributed_grid(40, 30);
  std::uint32_t state = 1;
  const auto noise = [&state] { return (state = state * 1664525 + 1013904223) >> 28; };
  for (float& x : mesh.positions) x += static_cast<float>(noise()) / 64;
  for (const std::size_t a : {std::size_t{1}, std::size_t{3}}) {
    Attribute& attribute = mesh.attributes[a];
    const std::size_t row = attribute.values.size() / mesh.vertex_count();
    for (std::size_t i = 0; i < attribute.values.size(); ++i) {
      const std::size_t v = i / row;
      attribute.values[i] = static_cast<std::byte>((v % 41) * (v / 41) / 5 + noise() / 4);
    }
  }
  return mesh;
}

}  // namespace deltamesh::test
