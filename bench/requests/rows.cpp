// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "requests/rows.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/try.h"
#include "deltamesh/compare.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/measure.h"
#include "peers/zstd_frame.h"
#include "report/text.h"

namespace deltamesh::bench {
namespace {

constexpr double kRounding = 1 + 1e-6;  ///< of figures stored as floats

bool is_kept(const QualityRequest& request, const Quality& quality) {
  return !(request.lfe && quality.lfe_rms > request.lfe->value * kRounding) &&
         !(request.vde && quality.vde_rms > request.vde->value * kRounding) &&
         !(request.max_error && quality.max_error > request.max_error->value);
}

/// Of positions and triangles as they lie in memory.
Result<std::size_t> zstd_bytes(const Mesh& mesh) {
  std::vector<std::byte> raw;
  append(raw, std::span<const float>(mesh.positions));
  append(raw, std::span<const std::uint32_t>(mesh.triangles));
  DELTAMESH_TRY(const auto frame, zstd_frame(raw));
  return frame.size();
}

double nanoseconds(const std::vector<double>& seconds, const Mesh& mesh) {
  return 1e9 * *std::ranges::min_element(seconds) / static_cast<double>(mesh.vertex_count());
}

}  // namespace

Result<RequestRow> compare_request(const Mesh& mesh, const QualityRequest& request, int effort,
                                   const std::shared_ptr<AnchorContainers>& containers) {
  DELTAMESH_TRY(const Encoded encoded,
                encode(mesh, {.quality = request, .effort = effort, .anchor_containers = containers}));
  DELTAMESH_TRY(const Mesh decoded, decode(encoded.bytes));
  DELTAMESH_TRY(const Comparison comparison, compare(mesh, decoded, encoded.order));
  DELTAMESH_TRY(const Encoded quick, encode(mesh, {.quality = request, .effort = 0}));
  const StreamInfo& stream = encoded.report.stream;
  return RequestRow{.bytes = stream.bytes,
                    .quick_bytes = quick.report.stream.bytes,
                    .geometry = stream.geometry,
                    .agrees_at_effort_0 = quick.report.stream.geometry == stream.geometry,
                    .kept = is_kept(request, comparison.quality)};
}

Result<LosslessRow> compare_lossless(const Mesh& mesh) {
  DELTAMESH_TRY(const Encoded encoded, encode(mesh, {.lossless = true}));
  DELTAMESH_TRY(const Encoded ordered, encode(mesh, {.lossless = true, .keep_order = true}));
  DELTAMESH_TRY(const Mesh decoded, decode(ordered.bytes));
  DELTAMESH_TRY(const std::size_t zstd, zstd_bytes(mesh));
  const bool same = decoded.positions.size() == mesh.positions.size() &&
                    std::memcmp(decoded.positions.data(), mesh.positions.data(),
                                mesh.positions.size() * sizeof(float)) == 0;
  return LosslessRow{.ratio = ratio(encoded.bytes.size(), zstd),
                     .exact = same && decoded.triangles == mesh.triangles};
}

Result<TimeRow> compare_times(const Mesh& mesh) {
  const auto peer = make_draco_peer(7, 12);
  DELTAMESH_TRY(const Measurement draco, measure(*peer, "", mesh));
  const EncodeOptions options{.quality = {.lfe = QualityBound{.value = draco.quality.lfe_rms}},
                              .geometry = GeometryCoder::kPredictive,
                              .effort = 0};
  DELTAMESH_TRY(const Encoded ours, encode(mesh, options));
  DELTAMESH_TRY(const auto theirs, peer->encode());
  const auto slow_peer = make_draco_peer(10, 12);
  DELTAMESH_CHECK(slow_peer->load(mesh));
  const EncodeOptions by_vde{.quality = {.vde = QualityBound{.value = draco.quality.vde_rms}}};
  DELTAMESH_TRY(const auto times,
                time_in_turn(
                    {.rounds = 5}, [&] { return encode(mesh, options); }, [&] { return peer->encode(); },
                    [&] { return decode(ours.bytes); }, [&] { return peer->decode(theirs); }));
  DELTAMESH_TRY(const auto slow_times,
                time_in_turn(
                    {.rounds = 3}, [&] { return encode(mesh, {}); }, [&] { return encode(mesh, by_vde); },
                    [&] { return slow_peer->encode(); }));
  const auto vertices = static_cast<double>(mesh.vertex_count());
  return TimeRow{.encode_ns = nanoseconds(times[0], mesh),
                 .draco_encode_ns = nanoseconds(times[1], mesh),
                 .decode_ns = nanoseconds(times[2], mesh),
                 .draco_decode_ns = nanoseconds(times[3], mesh),
                 .default_encode_ns = nanoseconds(slow_times[0], mesh),
                 .vde_encode_ns = nanoseconds(slow_times[1], mesh),
                 .slow_draco_encode_ns = nanoseconds(slow_times[2], mesh),
                 .bytes_per_vertex = static_cast<double>(ours.bytes.size()) / vertices,
                 .draco_bytes_per_vertex = static_cast<double>(theirs.size()) / vertices};
}

}  // namespace deltamesh::bench
