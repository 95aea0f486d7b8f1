// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/source.h"

#include <utility>

#include "base/try.h"
#include "deltamesh/decode.h"
#include "document/references.h"
#include "io/gltf/content/texture_transform.h"
#include "io/gltf/structure.h"

namespace deltamesh::gltf {
namespace {

constexpr std::size_t kMaxAttributes = DecodeLimits{}.attributes;

bool has_extension(const Json& primitive, const char* name) noexcept {
  const Json* extensions = find(primitive, "extensions");
  return extensions && extensions->contains(name);
}

bool has_unknown_extension(const Json& object) {
  const Json* extensions = find(object, "extensions");
  if (!extensions || !extensions->is_object()) return false;
  for (auto item = extensions->begin(); item != extensions->end(); ++item)
    if (!is_harmless_extension(item.key())) return true;
  return false;
}

class SourceFinder {
 public:
  SourceFinder(const Document& document, AccessorStore& store, GltfReport& report)
      : document_(document), store_(store), report_(report) {}

  /// Nothing, and a count in the report, where the primitive is left as it is.
  Result<std::optional<PrimitiveSource>> find_source(const Json& primitive, const PrimitiveNumber& number) {
    DELTAMESH_TRY(const auto triangles, triangle_primitive(primitive, number));
    if (!triangles) return leave(report_.not_triangles);
    if (has_extension(primitive, kExtensionName) || has_extension(primitive, "KHR_draco_mesh_compression"))
      return leave(report_.otherwise_compressed);

    PrimitiveSource source{*triangles};
    DELTAMESH_TRY(const auto shape, accessor_shape(document_, source.position));
    if (!shape || !is_position_shape(*shape)) return leave(report_.not_float_positions);
    DELTAMESH_TRY(const AccessorRows* rows, store_.read(source.position));
    if (!rows) return leave(report_.otherwise_compressed);
    std::uint64_t corners = shape->count;
    if (source.indices) {
      DELTAMESH_TRY(const AccessorRows* index_rows, store_.read(*source.indices));
      if (!index_rows) return leave(report_.otherwise_compressed);
      if (!is_index_shape(index_rows->shape()))
        return primitive_error("the primitive's indices are not unsigned integers", number);
      corners = index_rows->shape().count;
    }
    const bool is_whole = source.mode != TriangleMode::kList || corners % 3 == 0;
    if (corners < 3 || !is_whole) return leave(report_.not_triangles);
    source.exact_order = has_unknown_extension(primitive);
    source.uv_scale = uv_scale_of(document_.json, primitive);
    DELTAMESH_TRY(const bool readable, add_attributes(primitive, shape->count, source));
    if (!readable) return leave(report_.otherwise_compressed);
    return std::optional(std::move(source));
  }

 private:
  static std::optional<PrimitiveSource> leave(std::uint64_t& reason) noexcept {
    ++reason;
    return std::nullopt;
  }

  /// False where another extension holds the data of an attribute.
  Result<bool> add_attributes(const Json& primitive, std::uint64_t vertices, PrimitiveSource& source) {
    DELTAMESH_TRY(bool readable, add_map(primitive["attributes"], kBase, vertices, source));
    const Json* targets = find(primitive, "targets");
    for (std::size_t i = 0; targets && i < targets->size(); ++i) {
      DELTAMESH_TRY(const bool is_plain, add_map((*targets)[i], static_cast<int>(i), vertices, source));
      readable = readable && is_plain;
    }
    return readable;
  }

  Result<bool> add_map(const Json& map, int target, std::uint64_t vertices, PrimitiveSource& source) {
    for (auto item = map.begin(); item != map.end(); ++item) {
      if (target == kBase && item.key() == "POSITION") continue;
      const auto accessor = item->get<std::size_t>();
      DELTAMESH_TRY(const auto shape, accessor_shape(document_, accessor));
      if (!shape || source.attributes.size() == kMaxAttributes) {
        source.exact_order = true;
        continue;
      }
      DELTAMESH_TRY(const AccessorRows* rows, store_.read(accessor, vertices));
      if (shape->count != vertices) {
        Error error =
            primitive_error("the attributes of a primitive differ in their number of values", source.number);
        error.where_kind = WhereKind::kAccessor;
        error.where = accessor;
        return error;
      }
      if (!rows) return false;
      source.attributes.push_back({{item.key(), target}, accessor});
    }
    return true;
  }

  const Document& document_;
  AccessorStore& store_;
  GltfReport& report_;
};

}  // namespace

Result<std::vector<PrimitiveSource>> find_sources(const Document& document, AccessorStore& store,
                                                  GltfReport& report) {
  std::vector<PrimitiveSource> sources;
  SourceFinder finder(document, store, report);
  Result<void> result;
  for_each_primitive(document.json, [&](const Json& primitive, const PrimitiveNumber& number) {
    if (!result) return;
    ++report.primitives;
    auto source = finder.find_source(primitive, number);
    if (!source)
      result = source.error();
    else if (*source)
      sources.push_back(**std::move(source));
  });
  DELTAMESH_CHECK(result);
  report.converted = sources.size();
  return sources;
}

}  // namespace deltamesh::gltf
