// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/save.h"

#include <string>

#include "base/try.h"
#include "document/others.h"
#include "io/gltf/uri.h"

namespace deltamesh::gltf {
Result<GltfOutput> save_document(Document document, const GltfIo& io, const GltfReport& report) {
  GltfOutput output;
  output.report = report;
  output.uris = relative_uris(document.json);
  const OtherBytes others = count_others(document);
  output.report.animation_bytes = others.animations;
  output.report.image_bytes = others.images;
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
