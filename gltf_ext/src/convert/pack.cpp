// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "base/guard.h"
#include "base/try.h"
#include "convert/budget.h"
#include "convert/packer.h"
#include "deltamesh/gltf.h"
#include "document/compact.h"
#include "document/edits.h"
#include "document/references.h"
#include "document/save.h"
#include "document/semantics.h"
#include "io/gltf/structure.h"

namespace deltamesh {
namespace gltf {
namespace {

/// Accessors that something else than a packed primitive's stream needs as they are.
std::set<std::uint64_t> kept_accessors(Document& document, const std::vector<PrimitiveSource>& sources) {
  std::map<std::size_t, std::set<std::uint64_t>> coded;  // by primitive
  for (const PrimitiveSource& source : sources) {
    std::set<std::uint64_t>& accessors = coded[source.number.number];
    accessors.insert(source.position);
    if (source.indices) accessors.insert(*source.indices);
    for (const SourceAttribute& attribute : source.attributes) accessors.insert(attribute.accessor);
  }
  std::set<std::uint64_t> kept = numbers_in_unknown_extensions(document.json);
  for_each_other_accessor(document.json,
                          [&](const Json& accessor) { kept.insert(accessor.get<std::uint64_t>()); });
  for_each_primitive(document.json, [&](const Json& primitive, const PrimitiveNumber& place) {
    const auto keep = [&](const Json& accessor) {
      const auto own = coded.find(place.number);
      if (own == coded.end() || own->second.count(accessor.get<std::uint64_t>()) == 0)
        kept.insert(accessor.get<std::uint64_t>());
    };
    for (const Json& accessor : primitive["attributes"]) keep(accessor);
    if (const Json* targets = find(primitive, "targets"))
      for (const Json& target : *targets)
        for (const Json& accessor : target) keep(accessor);
    if (const Json* indices = find(primitive, "indices")) keep(*indices);
  });
  return kept;
}

/// What to do about an asset of which nothing can be packed because another extension has packed it. None of
/// the names: no error.
Result<void> check_not_compressed(const Json& json, const GltfReport& report) {
  if (report.converted != 0 || report.otherwise_compressed == 0) return {};
  const auto uses = [&](const char* extension) {
    const Json* names = find(json, "extensionsUsed");
    return names && std::find(names->begin(), names->end(), extension) != names->end();
  };
  Error error{.code = ErrorCode::kInvalidFile};
  if (uses("KHR_draco_mesh_compression"))
    error.message =
        "the meshes are compressed with Draco already; decompress them first, for example with "
        "glTF-Transform: gltf-transform cp IN.glb PLAIN.glb";
  else if (uses("EXT_meshopt_compression") || uses("KHR_meshopt_compression"))
    error.message =
        "the meshes are compressed with meshoptimizer already; decompress them first, for example with "
        "glTF-Transform: gltf-transform cp IN.glb PLAIN.glb";
  else
    return {};
  return error;
}

bool is_core_map(const Document& document, const Json& map, int target) {
  for (auto item = map.begin(); item != map.end(); ++item) {
    const auto shape = accessor_shape(document, item->get<std::size_t>());
    if (shape && *shape && !is_core_shape({item.key(), target}, **shape)) return false;
  }
  return true;
}

/// Removes the name KHR_mesh_quantization from the lists of extensions where all attributes of primitives
/// have types that core glTF allows.
void drop_needless_quantization(Document& document) {
  bool needed = false;
  for_each_primitive(document.json, [&](const Json& primitive, const PrimitiveNumber&) {
    needed |= !is_core_map(document, primitive["attributes"], kBase);
    if (const Json* targets = find(primitive, "targets"))
      for (std::size_t i = 0; i < targets->size(); ++i)
        needed |= !is_core_map(document, (*targets)[i], static_cast<int>(i));
  });
  if (!needed) remove_extension_name(document.json, "KHR_mesh_quantization");
}

void write_primitives(Json& json, const std::vector<PackedPrimitive>& packed) {
  std::map<std::size_t, const PackedPrimitive*> by_number;
  for (const PackedPrimitive& primitive : packed) by_number[primitive.number.number] = &primitive;
  for_each_primitive(json, [&](Json& primitive, const PrimitiveNumber& place) {
    if (const auto found = by_number.find(place.number); found != by_number.end())
      write_extension(primitive, *found->second);
  });
}

Result<GltfOutput> pack(std::span<const std::byte> asset, const GltfPackOptions& options, const GltfIo& io) {
  DELTAMESH_CHECK(validate(options.encode));
  DELTAMESH_TRY(Document document, load_document(asset, io.resolve));
  DELTAMESH_CHECK(check_other_accessors(document.json));
  GltfReport report;
  std::vector<PackedPrimitive> packed;
  const std::set<std::uint64_t> named = named_accessors(document.json);
  {
    AccessorStore store(document);
    DELTAMESH_TRY(const auto sources, find_sources(document, store, report));
    DELTAMESH_CHECK(check_not_compressed(document.json, report));
    DELTAMESH_TRY(const auto plans, plan_streams(store, sources));
    StreamPacker packer(document, store, sources, options, kept_accessors(document, sources));
    DELTAMESH_TRY(packed, pack_streams(packer, plans, options.encode, report));
    packer.write_accessors();
  }
  if (!packed.empty()) {
    write_primitives(document.json, packed);
    drop_unnamed_accessors(document.json, named);
    drop_needless_quantization(document);
    add_extension_name(document.json, "extensionsUsed", kExtensionName);
    if (!options.fallback) add_extension_name(document.json, "extensionsRequired", kExtensionName);
  }
  DELTAMESH_CHECK(compact_document(document));
  return save_document(std::move(document), io, report);
}

}  // namespace
}  // namespace gltf

Result<GltfOutput> pack_gltf(std::span<const std::byte> asset, const GltfPackOptions& options,
                             const GltfIo& io) noexcept {
  return guarded([&] { return gltf::pack(asset, options, io); }, gltf::kNoMemory);
}

}  // namespace deltamesh
