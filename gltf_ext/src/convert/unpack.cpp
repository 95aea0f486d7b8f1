// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/gltf.h"
#include "document/column.h"
#include "document/compact.h"
#include "document/extension.h"
#include "document/references.h"
#include "document/save.h"
#include "io/gltf/accessor.h"
#include "io/gltf/structure.h"

namespace deltamesh {
namespace gltf {
namespace {

/// An array of one stream: positions, an attribute, or the indices of a group in one type.
struct Role {
  enum class Kind : std::uint8_t { kPosition, kAttribute, kIndices };
  Kind kind = Kind::kPosition;
  std::uint64_t number = 0;  ///< of the attribute or the group
  ComponentType type = ComponentType::kF32;
  auto operator<=>(const Role&) const = default;
};

/// For the buffer view of each stream the primitives that use it.
using PrimitivesOfView = std::map<std::uint64_t, std::vector<PackedPrimitive>>;

/// Takes what a stream holds off what the caller still allows.
void spend(DecodeLimits& limits, const Mesh& mesh) noexcept {
  limits.vertices -= std::min<std::uint64_t>(limits.vertices, mesh.vertex_count());
  limits.triangles -= std::min<std::uint64_t>(limits.triangles, mesh.triangle_count());
  for (const Attribute& attribute : mesh.attributes)
    limits.attribute_bytes -= std::min<std::uint64_t>(limits.attribute_bytes, attribute.values.size());
}

/// Writes the arrays of decoded streams into accessors. Every array is made and stored once, however many
/// accessors show it, so that result and time are bounded by what the streams hold.
class Unpacker {
 public:
  explicit Unpacker(Document& document) : document_(document) {}

  Result<void> unpack(std::uint64_t stream, const Mesh& mesh,
                      const std::vector<PackedPrimitive>& primitives) {
    stream_ = stream;
    views_.clear();
    bounds_.clear();
    indices_.clear();
    largest_.clear();
    corners_ = corners_by_group(mesh);
    for (const auto& corners : corners_)
      largest_.push_back(corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end()));
    for (const PackedPrimitive& primitive : primitives) DELTAMESH_CHECK(unpack_primitive(mesh, primitive));
    return {};
  }

 private:
  Result<void> unpack_primitive(const Mesh& mesh, const PackedPrimitive& primitive) {
    const PrimitiveNumber& number = primitive.number;
    DELTAMESH_CHECK(put(primitive.position, {}, position_column(mesh), number));
    for (const AttributeUse& use : primitive.attributes) {
      if (use.id >= mesh.attributes.size())
        return rule_error("the extension names an attribute that the stream does not have", "GLTF-4", number);
      const Attribute& attribute = mesh.attributes[static_cast<std::size_t>(use.id)];
      const Role role{.kind = Role::Kind::kAttribute, .number = use.id};
      DELTAMESH_CHECK(put(use.accessor, role, attribute_column(mesh, attribute), number));
    }
    if (primitive.group >= corners_.size() || corners_[static_cast<std::size_t>(primitive.group)].empty())
      return rule_error("no triangle of the stream is in the primitive's group", "GLTF-11", number);
    return put_indices(primitive.indices, primitive.group, number);
  }

  Result<void> put_indices(std::size_t accessor, std::uint64_t group, const PrimitiveNumber& number) {
    const Error bad =
        rule_error("the accessor of the indices cannot hold the stream's vertex numbers", "GLTF-5", number);
    DELTAMESH_TRY(const auto shape, accessor_shape(document_, accessor));
    if (!shape) return bad;
    const ComponentType type = shape->type;
    // The largest value of a type may mean a restart, so it is no vertex.
    const std::uint64_t bits = 8 * component_size(type);
    if (!is_index_shape(*shape) ||
        largest_[static_cast<std::size_t>(group)] >= (std::uint64_t{1} << bits) - 1)
      return bad;
    const Role role{.kind = Role::Kind::kIndices, .number = group, .type = type};
    const auto [indices, is_new] = indices_.try_emplace(role);
    if (is_new) indices->second = index_bytes(corners_[static_cast<std::size_t>(group)], type);
    return put(accessor, role, index_column(type, indices->second), number);
  }

  Result<void> put(std::size_t accessor, const Role& role, const Column& column,
                   const PrimitiveNumber& number) {
    DELTAMESH_TRY(const auto shape, accessor_shape(document_, accessor));
    if (!shape || shape->type != column.shape.type || shape->components != column.shape.components ||
        shape->count != column.shape.count)
      return rule_error("an accessor's type or count is not that of the stream's array", "GLTF-5", number);
    const auto [owner, is_new] = owners_.try_emplace(accessor, std::pair(stream_, role));
    if (owner->second != std::pair(stream_, role))
      return rule_error("one accessor stands for two different arrays", "GLTF-6", number);
    if (!is_new) return {};
    const auto [view, is_new_view] = views_.try_emplace(role, 0);
    if (is_new_view) view->second = append_column(document_, column);
    Json& json = document_.json["accessors"][accessor];
    describe(json, role, column);
    json["bufferView"] = view->second;
    return {};
  }

  void describe(Json& json, const Role& role, const Column& column) {
    const bool has_bounds =
        role.kind == Role::Kind::kPosition || json.contains("min") || json.contains("max");
    for (const char* key : {"min", "max"}) json.erase(key);
    describe_column(json, column, false);
    if (!has_bounds) return;
    const auto [bounds, is_new] = bounds_.try_emplace(role, Json::object());
    if (is_new) describe_column(bounds->second, column, true);
    for (const char* key : {"min", "max"})
      if (bounds->second.contains(key)) json[key] = bounds->second[key];
  }

  Document& document_;
  std::map<std::size_t, std::pair<std::uint64_t, Role>> owners_;  ///< the array behind every written accessor
  std::uint64_t stream_ = 0;
  std::vector<std::vector<std::uint32_t>> corners_;  ///< of the current stream's groups
  std::vector<std::uint32_t> largest_;               ///< of these
  // Of the current stream's arrays:
  std::map<Role, std::size_t> views_;               ///< buffer views
  std::map<Role, Json> bounds_;                     ///< min and max, where an accessor has them
  std::map<Role, std::vector<std::byte>> indices_;  ///< of groups
};

Result<Mesh> decode_stream(const Document& document, std::uint64_t view, const PrimitiveNumber& number,
                           const DecodeOptions& options) {
  DELTAMESH_TRY(const auto stream, view_bytes(document, view));
  if (!stream || document.json["bufferViews"][view].contains("extensions"))
    return rule_error("the stream's buffer view is not plain", "GLTF-1", number);
  DELTAMESH_TRY(Mesh mesh, decode(stream->bytes, options));
  if (mesh.vertex_count() == 0 || mesh.triangle_count() == 0)
    return rule_error("a stream without vertices or triangles", "GLTF-1", number);
  if (mesh.origin != std::array<double, 3>{})
    return rule_error("a stream with an origin other than zero", "GLTF-7", number);
  return mesh;
}

void remove_extensions(Json& json) {
  for_each_primitive(json, [](Json& primitive, const PrimitiveNumber&) { remove_extension(primitive); });
  remove_extension_name(json, kExtensionName);
}

/// The primitives that have the extension, by stream; counts all primitives.
Result<PrimitivesOfView> find_packed(const Json& json, GltfReport& report) {
  PrimitivesOfView streams;
  Result<void> result;
  for_each_primitive(json, [&](const Json& primitive, const PrimitiveNumber& number) {
    ++report.primitives;
    if (!result) return;
    auto packed = read_extension(primitive, number);
    if (!packed) {
      result = packed.error();
    } else if (*packed) {
      auto& of_view = streams[(*packed)->view];
      of_view.push_back(**std::move(packed));
    }
  });
  if (!result) return result.error();
  return streams;
}

Result<GltfOutput> unpack(std::span<const std::byte> asset, const DecodeOptions& options, const GltfIo& io) {
  DELTAMESH_TRY(Document document, load_document(asset, io.resolve));
  DELTAMESH_CHECK(check_other_accessors(document.json));
  GltfReport report;
  DELTAMESH_TRY(const PrimitivesOfView streams, find_packed(document.json, report));

  Unpacker unpacker(document);
  DecodeOptions remaining = options;
  for (const auto& [view, primitives] : streams) {
    if (options.progress) {
      remaining.progress = [&](double share) {
        options.progress((static_cast<double>(report.streams) + share) / static_cast<double>(streams.size()));
      };
    }
    DELTAMESH_TRY(const Mesh mesh, decode_stream(document, view, primitives.front().number, remaining));
    spend(remaining.limits, mesh);
    DELTAMESH_CHECK(unpacker.unpack(view, mesh, primitives));
    report.converted += primitives.size();
    ++report.streams;
    report.vertices += mesh.vertex_count();
    report.triangles += mesh.triangle_count();
    DELTAMESH_TRY(const auto stream, view_bytes(document, view));
    report.stream_bytes += stream->bytes.size();
  }
  remove_extensions(document.json);
  DELTAMESH_CHECK(compact_document(document));
  return save_document(std::move(document), io, report);
}

}  // namespace
}  // namespace gltf

Result<GltfOutput> unpack_gltf(std::span<const std::byte> asset, const DecodeOptions& options,
                               const GltfIo& io) noexcept {
  return guarded([&] { return gltf::unpack(asset, options, io); }, gltf::kNoMemory);
}

}  // namespace deltamesh
