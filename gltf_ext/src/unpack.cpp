// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "accessor.h"
#include "base/try.h"
#include "column.h"
#include "compact.h"
#include "deltamesh/gltf.h"
#include "document.h"
#include "guard.h"
#include "structure.h"

namespace deltamesh {
namespace gltf {
namespace {

/// An array of one stream: 0 is the positions, 1 + i attribute i; indices are numbered from the end, by type.
using Role = std::uint64_t;
constexpr Role kPositionRole = 0;
constexpr Role attribute_role(std::uint64_t id) noexcept { return id + 1; }
constexpr Role index_role(ComponentType type) noexcept { return ~Role{0} - static_cast<Role>(type); }

struct AttributeUse {
  std::size_t accessor = 0;
  std::uint64_t id = 0;
};

/// A primitive with the extension, its references checked as far as possible without the stream.
struct PackedPrimitive {
  std::size_t number = 0;
  std::size_t position = 0;
  std::size_t indices = 0;
  std::vector<AttributeUse> attributes;
};

Error rule_error(const char* message, const char* rule, std::size_t number) noexcept {
  Error error = element_error(message, number);
  error.rule = rule;
  return error;
}

/// One stream, and who uses it.
using PrimitivesOfView = std::map<std::uint64_t, std::vector<PackedPrimitive>>;

Result<void> parse_primitive(const Json& primitive, std::size_t number, PrimitivesOfView& streams) {
  const Json* extensions = find(primitive, "extensions");
  const Json* extension = extensions ? find(*extensions, kExtensionName) : nullptr;
  if (!extension) return {};
  const Error bad_view = rule_error("the extension names no buffer view", "GLTF-1", number);
  const Json* view = find(*extension, "bufferView");
  if (!view) return bad_view;
  DELTAMESH_TRY(const auto view_number, to_unsigned(*view, ~std::uint64_t{0}, bad_view));

  const Error bad_mode =
      rule_error("the extension is on a primitive that is not a list of triangles", "GLTF-2", number);
  DELTAMESH_TRY(const auto mode, unsigned_member(primitive, "mode", 4, 6, bad_mode));
  if (mode != 4) return bad_mode;
  PackedPrimitive packed;
  packed.number = number;
  const Json& attributes = primitive["attributes"];
  const Json* position = find(attributes, "POSITION");
  const Json* indices = find(primitive, "indices");
  if (!position || !indices)
    return rule_error("a compressed primitive needs accessors for POSITION and indices", "GLTF-3", number);
  packed.position = position->get<std::size_t>();
  packed.indices = indices->get<std::size_t>();
  if (const Json* ids = find(*extension, "attributes")) {
    const Error bad = rule_error("the extension's attributes do not fit the primitive's", "GLTF-4", number);
    if (!ids->is_object()) return bad;
    for (auto item = ids->begin(); item != ids->end(); ++item) {
      const Json* accessor = find(attributes, item.key().c_str());
      if (!accessor || item.key() == "POSITION") return bad;
      DELTAMESH_TRY(const auto id, to_unsigned(*item, ~std::uint32_t{0}, bad));
      packed.attributes.push_back({accessor->get<std::size_t>(), id});
    }
  }
  streams[view_number].push_back(std::move(packed));
  return {};
}

/// Takes what a stream holds off what the caller still allows.
void spend(DecodeLimits& limits, const Mesh& mesh) noexcept {
  limits.vertices -= std::min<std::uint64_t>(limits.vertices, mesh.vertex_count());
  limits.triangles -= std::min<std::uint64_t>(limits.triangles, mesh.triangle_count());
  for (const Attribute& attribute : mesh.attributes)
    limits.attribute_bytes -= std::min<std::uint64_t>(limits.attribute_bytes, attribute.values.size());
}

/// Writes the arrays of decoded streams into accessors. Every array is stored once, however many accessors
/// show it, so that the result is bounded by what the streams hold.
class Unpacker {
 public:
  explicit Unpacker(Document& document) : document_(document) {}

  Result<void> unpack(std::uint64_t stream, const Mesh& mesh,
                      const std::vector<PackedPrimitive>& primitives) {
    stream_ = stream;
    views_.clear();
    for (const PackedPrimitive& primitive : primitives) DELTAMESH_CHECK(unpack_primitive(mesh, primitive));
    return {};
  }

 private:
  Result<void> unpack_primitive(const Mesh& mesh, const PackedPrimitive& primitive) {
    const std::size_t number = primitive.number;
    DELTAMESH_CHECK(put(primitive.position, kPositionRole, position_column(mesh), number));
    for (const AttributeUse& use : primitive.attributes) {
      if (use.id >= mesh.attributes.size())
        return rule_error("the extension names an attribute that the stream does not have", "GLTF-4", number);
      const Attribute& attribute = mesh.attributes[static_cast<std::size_t>(use.id)];
      DELTAMESH_CHECK(put(use.accessor, attribute_role(use.id), attribute_column(mesh, attribute), number));
    }
    return put_indices(primitive.indices, mesh, number);
  }

  Result<void> put_indices(std::size_t accessor, const Mesh& mesh, std::size_t number) {
    const Error bad =
        rule_error("the accessor of the indices cannot hold the stream's vertex numbers", "GLTF-5", number);
    DELTAMESH_TRY(const auto shape, accessor_shape(document_, accessor));
    if (!shape) return bad;
    // The largest value of a type may mean a restart, so it is no vertex.
    const std::uint64_t bits = 8 * component_size(shape->type);
    const bool is_unsigned = shape->type == ComponentType::kU8 || shape->type == ComponentType::kU16 ||
                             shape->type == ComponentType::kU32;
    if (!is_unsigned || mesh.vertex_count() > (std::uint64_t{1} << bits) - 1) return bad;
    const auto bytes = index_bytes(mesh, shape->type);
    return put(accessor, index_role(shape->type), index_column(mesh, shape->type, bytes), number);
  }

  Result<void> put(std::size_t accessor, Role role, const Column& column, std::size_t number) {
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
    describe_column(json, column, role == kPositionRole);
    json["bufferView"] = view->second;
    return {};
  }

  Document& document_;
  std::uint64_t stream_ = 0;
  std::map<Role, std::size_t> views_;  ///< buffer views of the current stream's arrays
  std::map<std::size_t, std::pair<std::uint64_t, Role>> owners_;  ///< the array behind every written accessor
};

Result<Mesh> decode_stream(Decoder& decoder, const Document& document, std::uint64_t view, std::size_t number,
                           const DecodeOptions& options) {
  DELTAMESH_TRY(const auto stream, view_bytes(document, view));
  if (!stream) return rule_error("the stream's buffer view is not plain", "GLTF-1", number);
  DELTAMESH_TRY(Mesh mesh, decoder.decode(stream->bytes, options));
  if (mesh.vertex_count() == 0 || mesh.triangle_count() == 0)
    return rule_error("a stream without vertices or triangles", "GLTF-1", number);
  if (mesh.origin != std::array<double, 3>{})
    return rule_error("a stream with an origin other than zero", "GLTF-7", number);
  return mesh;
}

void remove_extension(Json& json) {
  for_each_primitive(json, [](Json& primitive, std::size_t) {
    Json* extensions = find(primitive, "extensions");
    if (!extensions || extensions->erase(kExtensionName) == 0) return;
    if (extensions->empty()) primitive.erase("extensions");
  });
  remove_extension_name(json, kExtensionName);
}

Result<GltfOutput> unpack(std::span<const std::byte> asset, const DecodeOptions& options, const GltfIo& io) {
  DELTAMESH_TRY(Document document, load_document(asset, io));
  GltfReport report;
  PrimitivesOfView streams;
  Result<void> parsed;
  for_each_primitive(document.json, [&](const Json& primitive, std::size_t number) {
    ++report.primitives;
    if (parsed) parsed = parse_primitive(primitive, number, streams);
  });
  DELTAMESH_CHECK(parsed);

  Unpacker unpacker(document);
  Decoder decoder;
  DecodeOptions remaining = options;
  for (const auto& [view, primitives] : streams) {
    if (options.progress) {
      remaining.progress = [&](double share) {
        options.progress((static_cast<double>(report.streams) + share) / static_cast<double>(streams.size()));
      };
    }
    DELTAMESH_TRY(const Mesh mesh,
                  decode_stream(decoder, document, view, primitives.front().number, remaining));
    spend(remaining.limits, mesh);
    DELTAMESH_CHECK(unpacker.unpack(view, mesh, primitives));
    report.converted += primitives.size();
    ++report.streams;
    report.vertices += mesh.vertex_count();
    report.triangles += mesh.triangle_count();
    DELTAMESH_TRY(const auto stream, view_bytes(document, view));
    report.stream_bytes += stream->bytes.size();
  }
  remove_extension(document.json);
  DELTAMESH_CHECK(compact_document(document));
  return save_document(std::move(document), io, report);
}

}  // namespace
}  // namespace gltf

Result<GltfOutput> unpack_gltf(std::span<const std::byte> asset, const DecodeOptions& options,
                               const GltfIo& io) noexcept {
  return gltf::guarded([&] { return gltf::unpack(asset, options, io); });
}

}  // namespace deltamesh
