// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/content/named_files.h"

#include <string_view>
#include <utility>

#include "io/gltf/uri.h"

namespace deltamesh::gltf {

std::vector<std::string> relative_uris(const Json& json) {
  std::vector<std::string> uris;
  for_each_object(json, [&](const Json& object, std::string_view) {
    const Json* uri = find(object, "uri");
    if (!uri || !uri->is_string()) return;
    const auto& text = uri->get_ref<const std::string&>();
    if (text.find(':') == text.npos) uris.push_back(text);
  });
  return uris;
}

std::vector<std::string> named_files(const Json& json) {
  std::vector<std::string> files;
  for (const std::string& uri : relative_uris(json))
    if (auto path = relative_path_of(uri)) files.push_back(*std::move(path));
  return files;
}

}  // namespace deltamesh::gltf
