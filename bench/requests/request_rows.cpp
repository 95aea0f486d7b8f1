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
         !(request.max_error && quality.max_error > *request.max_error);
}

/// Least processor time of five runs, nanoseconds. Errors: of the first run that fails.
template <class Work>
Result<double> least_time(Work work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    if (const Result<void> done = work(); !done) return done.error();
    least = std::min(least, 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
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
  const auto peer = make_draco_peer(7, 12);
  const auto draco = measure(*peer, "", mesh, {.repeats = 5, .seconds = 10});
  if (!draco) return draco.error();
  const EncodeOptions options{.quality = {.lfe = QualityBound{.value = draco->quality.lfe_rms}},
                              .geometry = GeometryCoder::kPredictive,
                              .effort = 0};
  const auto encoded = encode(mesh, options);
  if (!encoded) return encoded.error();
  const auto encoding = least_time([&]() -> Result<void> {
    const auto again = encode(mesh, options);
    return again ? Result<void>() : again.error();
  });
  const auto decoding = least_time([&]() -> Result<void> {
    const auto decoded = decode(encoded->bytes);
    return decoded ? Result<void>() : decoded.error();
  });
  if (!encoding) return encoding.error();
  if (!decoding) return decoding.error();
  const auto vertices = static_cast<double>(mesh.vertex_count());
  return TimeRow{.decode_ns = *decoding / vertices,
                 .draco_decode_ns = 1e9 * draco->decode_seconds / vertices,
                 .encode_ns = *encoding / vertices,
                 .draco_encode_ns = 1e9 * draco->encode_seconds / vertices};
}

}  // namespace deltamesh::bench
