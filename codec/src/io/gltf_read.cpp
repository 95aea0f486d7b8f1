// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF: all triangle primitives of all placed meshes as one mesh. Instances are repeated, so that a small
// file may stand for a large mesh; what may come of it is limited to kFreeElements + kElementsPerByte *
// (bytes read).
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

#include "base/checked.h"
#include "base/try.h"
#include "io/components.h"
#include "io/formats.h"
#include "io/gltf_accessor.h"
#include "io/gltf_attributes.h"
#include "io/gltf_scene.h"
#include "io/gltf_source.h"
#include "io/io_error.h"
#include "io/origin.h"

namespace deltamesh {
namespace {

constexpr std::uint64_t kFreeElements = std::uint64_t{1} << 20;
constexpr std::uint64_t kElementsPerByte = 16;

bool is_triangles(int mode) noexcept {
  return mode >= TINYGLTF_MODE_TRIANGLES && mode <= TINYGLTF_MODE_TRIANGLE_FAN;
}

/// One primitive of a placed mesh.
struct Part {
  const tinygltf::Primitive* primitive = nullptr;
  std::size_t set = 0;
};

class Assembly {
 public:
  Assembly(const GltfDocument& document, const GltfSource& source,
           const std::vector<GltfPlacement>& placements)
      : document_(document),
        buffers_(source.buffers),
        placements_(placements),
        limit_(saturating_add(kFreeElements, saturating_mul(kElementsPerByte, source.total_bytes))) {}

  Result<Imported> build() {
    for (const GltfPlacement& placement : placements_) DELTAMESH_CHECK(collect(placement));
    DELTAMESH_CHECK(read_positions());
    DELTAMESH_TRY(imported_.mesh.attributes,
                  merge_attributes(document_, buffers_, sets_, vertices_, imported_.report));
    for (const Part& part : parts_) DELTAMESH_CHECK(read_triangles(part));
    add_missing_normals(sets_, imported_.mesh);
    return std::move(imported_);
  }

 private:
  /// Lists the parts of a placed mesh; primitives with the same attributes share their vertices.
  Result<void> collect(const GltfPlacement& placement) {
    std::map<std::map<std::string, int>, std::size_t> known;
    for (const tinygltf::Primitive& primitive : document_.model.meshes[placement.mesh].primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (!is_triangles(primitive.mode) || position == primitive.attributes.end()) {
        imported_.report.leave_out(LeftOutKind::kPrimitives, "primitives that are not triangles");
        continue;
      }
      const auto [set, is_new] = known.emplace(primitive.attributes, sets_.size());
      if (is_new) {
        DELTAMESH_TRY(const GltfAccessor* accessor, find_accessor(document_, position->second));
        if (accessor->components != 3) return invalid_file("glTF: POSITION is not a VEC3");
        DELTAMESH_CHECK(reserve(vertices_, accessor->count));
        sets_.push_back(
            {&primitive.attributes, &placement.transform, vertices_ - accessor->count, accessor->count});
      }
      DELTAMESH_TRY(const std::uint64_t corners, corner_count(primitive, sets_[set->second]));
      DELTAMESH_CHECK(reserve(corners_, corners));
      parts_.push_back({&primitive, set->second});
    }
    return {};
  }

  Result<std::uint64_t> corner_count(const tinygltf::Primitive& primitive, const GltfVertexSet& set) const {
    if (primitive.indices == kGltfNone) return set.count;
    DELTAMESH_TRY(const GltfAccessor* accessor, find_accessor(document_, primitive.indices));
    return accessor->count;
  }

  /// Adds to a count that must stay within the limit: before anything is allocated.
  Result<void> reserve(std::uint64_t& total, std::uint64_t more) const {
    total = saturating_add(total, more);
    if (total > limit_ || total > std::numeric_limits<std::uint32_t>::max())
      return invalid_file("glTF: the file states or repeats far more vertices than its size suggests");
    return {};
  }

  Result<void> read_positions() {
    std::vector<double> coordinates(vertices_ * 3);
    for (const GltfVertexSet& set : sets_) {
      DELTAMESH_TRY(const GltfAccessor* accessor, find_accessor(document_, set.semantics->at("POSITION")));
      DELTAMESH_TRY(const std::vector<std::byte> values, read_accessor(document_, buffers_, *accessor));
      const std::size_t size = component_size(accessor->type);
      const bool moved = !set.transform->is_identity();
      for (std::uint64_t v = 0; v < set.count; ++v) {
        Vec3 point{};
        for (std::size_t k = 0; k < 3; ++k)
          point[k] =
              load_normalized(accessor->type, accessor->normalized, values.data() + (3 * v + k) * size);
        if (moved) point = set.transform->point(point);
        std::memcpy(&coordinates[3 * (set.first + v)], point.data(), sizeof point);
      }
    }
    imported_.mesh = place_origin(coordinates);
    return {};
  }

  Result<void> read_triangles(const Part& part) {
    const GltfVertexSet& set = sets_[part.set];
    std::vector<std::uint32_t> corners;
    if (part.primitive->indices == kGltfNone) {
      for (std::uint32_t v = 0; v < set.count; ++v) corners.push_back(v);
    } else {
      DELTAMESH_TRY(const GltfAccessor* accessor, find_accessor(document_, part.primitive->indices));
      DELTAMESH_TRY(corners, read_indices(document_, buffers_, *accessor, set.count));
    }
    const bool mirrored = set.transform->determinant() < 0;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (mirrored) std::swap(b, c);
      for (const std::size_t i : {a, b, c})
        imported_.mesh.triangles.push_back(static_cast<std::uint32_t>(set.first) + corners[i]);
    };
    // Corner orders of glTF 2.0, 3.7.2.1.
    const bool list = part.primitive->mode == TINYGLTF_MODE_TRIANGLES;
    const bool strip = part.primitive->mode == TINYGLTF_MODE_TRIANGLE_STRIP;
    if (list && corners.size() % 3 != 0)
      imported_.report.leave_out(LeftOutKind::kFaces, "of fewer than three corners");
    for (std::size_t i = 0; i + 2 < corners.size(); i += list ? 3 : 1) {
      if (list)
        add(i, i + 1, i + 2);
      else if (strip)
        add(i, i + 1 + i % 2, i + 2 - i % 2);
      else
        add(i + 1, i + 2, 0);
    }
    return {};
  }

  const GltfDocument& document_;
  GltfBuffers buffers_;
  const std::vector<GltfPlacement>& placements_;
  std::uint64_t limit_;
  std::vector<GltfVertexSet> sets_;
  std::vector<Part> parts_;
  std::uint64_t vertices_ = 0;
  std::uint64_t corners_ = 0;
  Imported imported_;
};

}  // namespace

Result<Imported> read_gltf(std::span<const std::byte> bytes, std::string_view folder) {
  DELTAMESH_TRY(const GltfSource source, open_gltf(bytes, folder));
  DELTAMESH_TRY(const GltfDocument document, parse_gltf_document(source.json));
  DELTAMESH_TRY(const std::vector<GltfPlacement> placements, place_meshes(document.model));
  return Assembly(document, source, placements).build();
}

}  // namespace deltamesh
