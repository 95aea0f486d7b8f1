// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "requests/request_rows.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <limits>
#include <vector>

#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/peer.h"
#include "run/measure.h"

namespace deltamesh::bench {
namespace {

constexpr double kRounding = 1 + 1e-6;  ///< of figures stored as floats

bool is_kept(const QualityRequest& request, const Quality& quality) {
  return !(request.lfe && quality.lfe_rms > request.lfe->value * kRounding) &&
         !(request.vde && quality.vde_rms > request.vde->value * kRounding) &&
         !(request.max_error && quality.max_error > request.max_error->value);
}

/// Adds a run to the least processor time, nanoseconds. Errors: of the run.
template <class Work>
Result<void> time_run(double& least, Work work) {
  const std::clock_t start = std::clock();
  const auto done = work();
  const double ns = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!done) return done.error();
  least = std::min(least, ns);
  return {};
}

std::size_t zstd_bytes(const Mesh& mesh) {
  std::vector<std::byte> raw;
  const auto add = [&raw](const auto& values) {
    const auto bytes = std::as_bytes(std::span(values));
    raw.insert(raw.end(), bytes.begin(), bytes.end());
  };
  add(mesh.positions);
  add(mesh.triangles);
  std::vector<std::byte> packed(ZSTD_compressBound(raw.size()));
  return ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), 19);
}

}  // namespace

Result<RequestRow> compare_request(const Mesh& mesh, const QualityRequest& request, int effort,
                                   const std::shared_ptr<AnchorContainers>& containers) {
  const auto encoded = encode(mesh, {.quality = request, .effort = effort, .anchor_containers = containers});
  if (!encoded) return encoded.error();
  const auto decoded = decode(encoded->bytes);
  if (!decoded) return decoded.error();
  const auto comparison = compare(mesh, *decoded, encoded->order);
  if (!comparison) return comparison.error();
  const auto quick = encode(mesh, {.quality = request, .effort = 0});
  if (!quick) return quick.error();
  const StreamInfo& stream = encoded->report.stream;
  return RequestRow{.bytes = stream.bytes,
                    .quick_bytes = quick->report.stream.bytes,
                    .geometry = stream.geometry,
                    .agrees_at_effort_0 = quick->report.stream.geometry == stream.geometry,
                    .kept = is_kept(request, comparison->quality)};
}

Result<LosslessRow> compare_lossless(const Mesh& mesh) {
  const auto encoded = encode(mesh, {.lossless = true});
  if (!encoded) return encoded.error();
  const auto ordered = encode(mesh, {.lossless = true, .keep_order = true});
  if (!ordered) return ordered.error();
  const auto decoded = decode(ordered->bytes);
  if (!decoded) return decoded.error();
  const bool same = decoded->positions.size() == mesh.positions.size() &&
                    std::memcmp(decoded->positions.data(), mesh.positions.data(),
                                mesh.positions.size() * sizeof(float)) == 0;
  return LosslessRow{
      .ratio = static_cast<double>(encoded->bytes.size()) / static_cast<double>(zstd_bytes(mesh)),
      .exact = same && decoded->triangles == mesh.triangles};
}

Result<TimeRow> compare_times(const Mesh& mesh) {
  constexpr int kRuns = 5;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto peer = make_draco_peer(7, 12);
  const auto draco = measure(*peer, "", mesh, {.repeats = 1, .seconds = 0});
  if (!draco) return draco.error();
  const EncodeOptions options{.quality = {.lfe = QualityBound{.value = draco->quality.lfe_rms}},
                              .geometry = GeometryCoder::kPredictive,
                              .effort = 0};
  const auto encoded = encode(mesh, options);
  const auto peer_encoded = peer->encode();
  if (!encoded) return encoded.error();
  if (!peer_encoded) return peer_encoded.error();
  TimeRow row{.effort = options.effort,
              .decode_ns = kNever,
              .draco_decode_ns = kNever,
              .encode_ns = kNever,
              .draco_encode_ns = kNever};
  for (int i = 0; i < kRuns; ++i) {
    for (const auto& done : {time_run(row.encode_ns, [&] { return encode(mesh, options); }),
                             time_run(row.draco_encode_ns, [&] { return peer->encode(); }),
                             time_run(row.decode_ns, [&] { return decode(encoded->bytes); }),
                             time_run(row.draco_decode_ns, [&] { return peer->decode(*peer_encoded); })})
      if (!done) return done.error();
  }
  const auto vertices = static_cast<double>(mesh.vertex_count());
  for (double* ns : {&row.encode_ns, &row.draco_encode_ns, &row.decode_ns, &row.draco_decode_ns})
    *ns /= vertices;
  row.bytes_per_vertex = static_cast<double>(encoded->bytes.size()) / vertices;
  row.draco_bytes_per_vertex = static_cast<double>(draco->bytes) / vertices;
  return row;
}

}  // namespace deltamesh::bench
