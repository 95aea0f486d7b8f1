// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/try.h"
#include "column.h"
#include "compact.h"
#include "deltamesh/gltf.h"
#include "document.h"
#include "guard.h"
#include "primitive_plan.h"
#include "references.h"
#include "structure.h"

namespace deltamesh {
namespace gltf {
namespace {

constexpr std::size_t kNotPacked = ~std::size_t{0};

/// The primitives that share one stream.
struct Group {
  StreamSource source;
  std::size_t first_primitive = 0;
};

/// Groups in the order of their first primitives, and the group of every primitive or kNotPacked.
struct Groups {
  std::vector<Group> groups;
  std::vector<std::size_t> of_primitive;
};

Groups group_primitives(const std::vector<PrimitivePlan>& plans, std::size_t primitives) {
  Groups result;
  result.of_primitive.assign(primitives, kNotPacked);
  std::map<StreamSource, std::size_t> known;
  for (const PrimitivePlan& plan : plans) {
    const auto [entry, is_new] = known.try_emplace(plan.source, result.groups.size());
    if (is_new) result.groups.push_back({plan.source, plan.number});
    result.of_primitive[plan.number] = entry->second;
  }
  return result;
}

/// Accessors that something else than a packed primitive's stream needs as they are.
std::set<std::uint64_t> kept_accessors(Document& document, const Groups& groups) {
  std::set<std::uint64_t> kept = numbers_in_unknown_extensions(document.json);
  const auto keep = [&](const Json& accessor) { kept.insert(accessor.get<std::uint64_t>()); };
  for_each_other_accessor(document.json, keep);
  for_each_primitive(document.json, [&](const Json& primitive, std::size_t number) {
    if (const Json* targets = find(primitive, "targets"))
      for (const Json& target : *targets)
        for (const Json& accessor : target) keep(accessor);
    std::set<std::uint64_t> coded;
    if (groups.of_primitive[number] != kNotPacked) {
      const StreamSource& source = groups.groups[groups.of_primitive[number]].source;
      coded.insert(source.position);
      for (const CodedAttribute& attribute : source.attributes) coded.insert(attribute.accessor);
    } else if (const Json* indices = find(primitive, "indices")) {
      keep(*indices);
    }
    for (const Json& accessor : primitive["attributes"])
      if (coded.count(accessor.get<std::uint64_t>()) == 0) keep(accessor);
  });
  return kept;
}

/// Gives every decoded array an accessor of its own: the original's where nobody else has or needs it, else a
/// new one at the end, so that no accessor changes its number. Nothing is written before apply(): until then
/// other groups may still read the originals.
class AccessorEdits {
 public:
  AccessorEdits(Json& json, std::set<std::uint64_t> taken)
      : json_(&json), taken_(std::move(taken)), next_(array_size(json, "accessors")) {}

  const Json& original(std::size_t accessor) const { return (*json_)["accessors"][accessor]; }
  std::size_t replace(std::size_t accessor, Json described) {
    if (!taken_.insert(accessor).second) return append(std::move(described));
    edits_.emplace_back(accessor, std::move(described));
    return accessor;
  }
  std::size_t append(Json described) {
    edits_.emplace_back(next_, std::move(described));
    return next_++;
  }
  void apply() {
    if (edits_.empty()) return;
    Json& accessors = (*json_)["accessors"];
    for (auto& [number, described] : edits_) {
      if (number < accessors.size())
        accessors[number] = std::move(described);
      else
        accessors.push_back(std::move(described));
    }
    edits_.clear();
  }

 private:
  Json* json_;
  std::set<std::uint64_t> taken_;
  std::size_t next_;
  std::vector<std::pair<std::size_t, Json>> edits_;
};

/// What the primitives of a group refer to once it is packed.
struct PackedGroup {
  std::size_t view = 0;  ///< of the stream
  std::size_t position = 0;
  std::size_t indices = 0;
  std::vector<CodedAttribute> attributes;  ///< with their new accessors
};

class Packer {
 public:
  Packer(Document& document, const GltfPackOptions& options, std::set<std::uint64_t> kept)
      : document_(document), options_(options), accessors_(document.json, std::move(kept)) {}

  /// `options` are the group's own. Counts into `report`.
  Result<PackedGroup> pack(const Group& group, const EncodeOptions& encode_options, GltfReport& report) {
    DELTAMESH_TRY(const auto source, build_mesh(document_, group.source, encode_options.keep_unreferenced,
                                                group.first_primitive));
    EncodeOptions complete = encode_options;
    complete.keep_unreferenced = true;  // build_mesh() has chosen
    auto encoded = encode(source.mesh, complete);
    if (!encoded) return primitive_error(encoded.error(), group.first_primitive);
    DELTAMESH_TRY(const Mesh decoded, decode(encoded->bytes));
    DELTAMESH_ENSURE(decoded.attributes.size() == group.source.attributes.size());

    ++report.streams;
    report.stream_bytes += encoded->bytes.size();
    report.vertices += decoded.vertex_count();
    report.triangles += decoded.triangle_count();
    report.unreferenced_vertices += source.unreferenced_vertices;
    PackedGroup packed = describe(group.source, decoded);
    packed.view = append_view(document_, std::move(encoded->bytes));
    return packed;
  }

  /// Writes the accessors of all packed groups.
  void finish() { accessors_.apply(); }

 private:
  /// Mesh errors of the encoder count vertices of the stream, which say nothing to the asset's owner.
  static Error primitive_error(Error error, std::size_t number) noexcept {
    if (error.code != ErrorCode::kInvalidMesh) return error;
    error.where_kind = WhereKind::kElement;
    error.where = number;
    return error;
  }

  PackedGroup describe(const StreamSource& source, const Mesh& decoded) {
    PackedGroup packed;
    packed.position = replace(source.position, position_column(decoded), true);
    for (std::size_t i = 0; i < source.attributes.size(); ++i) {
      const Column column = attribute_column(decoded, decoded.attributes[i]);
      packed.attributes.push_back(
          {source.attributes[i].semantic, replace(source.attributes[i].accessor, column, false)});
    }
    const ComponentType type = index_type(decoded.vertex_count());
    const auto bytes = index_bytes(decoded, type);
    const Column column = index_column(decoded, type, bytes);
    packed.indices = source.indices ? replace(*source.indices, column, false)
                                    : accessors_.append(described(Json::object(), column, false));
    return packed;
  }

  std::size_t replace(std::size_t accessor, const Column& column, bool bounds) {
    return accessors_.replace(accessor, described(accessors_.original(accessor), column, bounds));
  }

  /// The accessor's JSON, made to fit the column; with its data where there is a fallback.
  Json described(Json accessor, const Column& column, bool bounds) {
    describe_column(accessor, column, bounds);
    if (options_.fallback) accessor["bufferView"] = append_column(document_, column);
    return accessor;
  }

  Document& document_;
  const GltfPackOptions& options_;
  AccessorEdits accessors_;
};

void rewrite_primitive(Json& primitive, const PackedGroup& packed) {
  primitive["attributes"]["POSITION"] = packed.position;
  Json ids = Json::object();
  for (std::size_t i = 0; i < packed.attributes.size(); ++i) {
    primitive["attributes"][packed.attributes[i].semantic] = packed.attributes[i].accessor;
    ids[packed.attributes[i].semantic] = i;
  }
  primitive["indices"] = packed.indices;
  Json extension = {{"bufferView", packed.view}};
  if (!ids.empty()) extension["attributes"] = std::move(ids);
  primitive["extensions"][kExtensionName] = std::move(extension);
}

/// The group's share of the whole asset's progress.
std::function<void(double)> partial_progress(const std::function<void(double)>& progress, std::size_t done,
                                             std::size_t total) {
  if (!progress) return {};
  return [&progress, done, total](double share) {
    progress((static_cast<double>(done) + share) / static_cast<double>(total));
  };
}

Result<GltfOutput> pack(std::span<const std::byte> asset, const GltfPackOptions& options, const GltfIo& io) {
  DELTAMESH_CHECK(validate(options.encode));
  DELTAMESH_TRY(Document document, load_document(asset, io));
  GltfReport report;
  DELTAMESH_TRY(const auto plans, plan_primitives(document, report));
  const Groups groups = group_primitives(plans, static_cast<std::size_t>(report.primitives));

  Packer packer(document, options, kept_accessors(document, groups));
  std::vector<PackedGroup> packed;
  for (const Group& group : groups.groups) {
    EncodeOptions encode_options = options.encode;
    encode_options.keep_order |= group.source.exact_order;
    encode_options.keep_unreferenced |= group.source.exact_order;
    encode_options.progress = partial_progress(options.encode.progress, packed.size(), groups.groups.size());
    DELTAMESH_TRY(auto result, packer.pack(group, encode_options, report));
    packed.push_back(std::move(result));
  }
  packer.finish();
  for_each_primitive(document.json, [&](Json& primitive, std::size_t number) {
    if (groups.of_primitive[number] != kNotPacked)
      rewrite_primitive(primitive, packed[groups.of_primitive[number]]);
  });
  if (!packed.empty()) {
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
  return gltf::guarded([&] { return gltf::pack(asset, options, io); });
}

}  // namespace deltamesh
