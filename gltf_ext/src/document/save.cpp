// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/save.h"

#include <set>
#include <string>
#include <string_view>

#include "base/checked.h"
#include "base/try.h"
#include "document/references.h"
#include "io/gltf/accessor.h"
#include "io/gltf/uri.h"

namespace deltamesh::gltf {
namespace {

/// Of an image whose data is in the JSON, base64; nothing where it is a file.
std::uint64_t embedded_bytes(const Json& image) {
  constexpr std::string_view kEmbedded = "data:";
  const Json* uri = find(image, "uri");
  if (!uri || !uri->is_string()) return 0;
  const auto& text = uri->get_ref<const std::string&>();
  return std::string_view(text).substr(0, kEmbedded.size()) == kEmbedded ? text.size() : 0;
}

std::uint64_t view_length(const Json& json, std::uint64_t view) {
  if (view >= array_size(json, "bufferViews")) return 0;
  const Json* length = find(json["bufferViews"][static_cast<std::size_t>(view)], "byteLength");
  return length && length->is_number_unsigned() ? length->get<std::uint64_t>() : 0;
}

/// Bytes of the asset that no mesh has: of animations, the accessors of their samplers; of images those
/// within the asset. Data that several have in common counts once, and what is malformed not at all.
void count_others(const Document& document, GltfReport& report) {
  std::set<std::size_t> accessors;
  for_each_sampled_accessor(document.json,
                            [&](const Json& accessor) { accessors.insert(accessor.get<std::size_t>()); });
  for (const std::size_t accessor : accessors)
    if (const auto stored = stored_bytes(document, accessor))
      report.animation_bytes = saturating_add(report.animation_bytes, *stored);
  const Json* images = find(document.json, "images");
  std::set<std::uint64_t> views;
  for (std::size_t i = 0; images && i < images->size(); ++i) {
    const Json& image = (*images)[i];
    report.image_bytes += embedded_bytes(image);
    const Json* view = find(image, "bufferView");
    if (view && view->is_number_unsigned()) views.insert(view->get<std::uint64_t>());
  }
  for (const std::uint64_t view : views)
    report.image_bytes = saturating_add(report.image_bytes, view_length(document.json, view));
}

}  // namespace

Result<GltfOutput> save_document(Document document, const GltfIo& io, const GltfReport& report) {
  GltfOutput output;
  output.report = report;
  output.uris = relative_uris(document.json);
  count_others(document, output.report);
  std::span<const std::byte> data;
  if (!document.buffers.empty() && !document.buffers[0].opaque) {
    data = document.buffers[0].bytes;
    if (io.container == GltfContainer::kGltf)
      document.json["buffers"][0]["uri"] = io.buffer_uri.empty() ? data_uri_of(data) : io.buffer_uri;
  }
  if (io.container == GltfContainer::kGlb) {
    DELTAMESH_TRY(output.asset, write_glb(document.json.dump(), data, document.glb_chunks));
  } else {
    const std::string text = document.json.dump(2) + "\n";
    const auto bytes = std::as_bytes(std::span(text));
    output.asset.assign(bytes.begin(), bytes.end());
    if (!io.buffer_uri.empty()) output.buffer.assign(data.begin(), data.end());
  }
  output.report.input_bytes = document.input_bytes;
  output.report.output_bytes = output.asset.size() + output.buffer.size();
  return output;
}

}  // namespace deltamesh::gltf
