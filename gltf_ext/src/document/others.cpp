// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/others.h"

#include <set>
#include <string>
#include <string_view>

#include "base/checked.h"
#include "document/references.h"
#include "io/gltf/accessor.h"

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

}  // namespace

OtherBytes count_others(const Document& document) {
  OtherBytes bytes;
  std::set<std::size_t> accessors;
  for_each_sampled_accessor(document.json,
                            [&](const Json& accessor) { accessors.insert(accessor.get<std::size_t>()); });
  for (const std::size_t accessor : accessors)
    if (const auto stored = stored_bytes(document, accessor))
      bytes.animations = saturating_add(bytes.animations, *stored);
  const Json* images = find(document.json, "images");
  std::set<std::uint64_t> views;
  for (std::size_t i = 0; images && i < images->size(); ++i) {
    const Json& image = (*images)[i];
    bytes.images += embedded_bytes(image);
    const Json* view = find(image, "bufferView");
    if (view && view->is_number_unsigned()) views.insert(view->get<std::uint64_t>());
  }
  for (const std::uint64_t view : views)
    bytes.images = saturating_add(bytes.images, view_length(document.json, view));
  return bytes;
}

}  // namespace deltamesh::gltf
