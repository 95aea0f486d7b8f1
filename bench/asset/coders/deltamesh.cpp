// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/coders/deltamesh.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "asset/gltf_meshes.h"
#include "base/try.h"
#include "convert/quality.h"
#include "deltamesh/decode.h"
#include "deltamesh/gltf.h"
#include "stream/plan.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr double kLeastError = 1e-30;  ///< a request above 0

/// Adds what the stream says of its bytes.
void count_bytes(const StreamInfo& info, PartBytes& bytes) {
  std::uint64_t rest = info.bytes;
  for (const AttributeInfo& attribute : info.attributes) {
    bytes[index_of(part_of(attribute.kind, attribute.name))] += attribute.coded_bytes;
    rest -= attribute.coded_bytes;
  }
  for (const ChunkInfo& chunk : info.chunks) {
    if (std::string_view(chunk.tag.data()) != "SEAM") continue;
    bytes[index_of(Part::kSeams)] += chunk.coded_bytes;
    rest -= chunk.coded_bytes;
  }
  bytes[index_of(Part::kGeometry)] += rest;
}

/// Measures what `stream` decodes to. Errors: decode()'s; kInternal where `source` gives another stream.
Result<void> measure(const StreamSource& source, const std::vector<std::byte>& stream,
                     const EncodeOptions& options, MeshErrorMeter& meter) {
  DELTAMESH_TRY(const auto again, encode_stream(source, options));
  if (again.bytes != stream) return failure("pack_gltf() makes another stream of a primitive");
  DELTAMESH_TRY(const Mesh decoded, decode(stream));
  return meter.add(source.merged.mesh, decoded, again.order);
}

}  // namespace

EncodeOptions options_for(const MeshError& error, int effort) {
  EncodeOptions options;
  options.effort = effort;
  options.quality.lfe = QualityBound{.value = std::max(error.rms, kLeastError), .unit = QualityUnit::kModel};
  options.attributes.normal_error = error.largest[index_of(Part::kNormals)];
  options.attributes.tangent_error = error.largest[index_of(Part::kTangents)];
  options.attributes.uv_error = error.largest[index_of(Part::kUvs)];
  options.attributes.color_error = error.largest[index_of(Part::kColors)];
  options.attributes.weight_error = error.largest[index_of(Part::kWeights)];
  return options;
}

Result<std::vector<StreamSource>> stream_sources(const AssetMesh& mesh) {
  DELTAMESH_TRY(const gltf::Document document, gltf::load_document(mesh.asset, {}));
  gltf::AccessorStore store(document);
  GltfReport report;
  DELTAMESH_TRY(const auto primitives, gltf::find_sources(document, store, report));
  DELTAMESH_TRY(const auto plans, gltf::plan_streams(store, primitives));
  std::vector<StreamSource> sources;
  for (const gltf::StreamPlan& plan : plans) {
    const gltf::MergeOptions merge = gltf::merge_options({}, plan);
    DELTAMESH_TRY(auto merged, gltf::merge_primitives(store, primitives, plan, merge));
    sources.push_back({.merged = std::move(merged), .exact_order = plan.exact_order});
  }
  return sources;
}

Result<Encoded> encode_stream(const StreamSource& source, const EncodeOptions& options) {
  DELTAMESH_TRY(EncodeOptions own, gltf::stream_options(options, source.merged));
  own.keep_order = source.exact_order;
  own.keep_unreferenced = true;  // merge_primitives() has chosen
  return encode(source.merged.mesh, own);
}

Result<CodedMesh> code_with_deltamesh(const AssetMesh& mesh, const std::vector<StreamSource>& sources,
                                      const EncodeOptions& options) {
  DELTAMESH_TRY(const GltfOutput packed, pack_gltf(mesh.asset, {.encode = options}));
  DELTAMESH_TRY(PackedAsset apart, take_packed_apart(packed.asset));
  if (apart.streams.size() != sources.size()) return failure("pack_gltf() makes another number of streams");
  CodedMesh coded;
  MeshErrorMeter meter;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    DELTAMESH_TRY(const StreamInfo info, inspect(apart.streams[s]));
    count_bytes(info, coded.bytes);
    DELTAMESH_CHECK(measure(sources[s], apart.streams[s], options, meter));
  }
  coded.bytes[index_of(Part::kOther)] += apart.plain_bytes;
  coded.bytes[index_of(Part::kMorph)] += apart.morph_bytes;
  coded.error = meter.error();
  coded.streams = std::move(apart.streams);
  return coded;
}

}  // namespace deltamesh::bench
