// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "run/measure.h"

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

#include "deltamesh/compare.h"

namespace deltamesh::bench {
namespace {

double median(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// Runs `work` as often as `effort` says; median processor seconds, which other programs on the machine
/// disturb least. Errors: of the first failing run.
template <class Work>
Result<double> time_median(const TimingEffort& effort, Work work) {
  std::vector<double> seconds;
  double total = 0;
  do {
    const std::clock_t start = std::clock();
    if (const Result<void> done = work(); !done) return done.error();
    seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    total += seconds.back();
  } while (static_cast<int>(seconds.size()) < effort.repeats && total < effort.seconds);
  return median(seconds);
}

}  // namespace

Result<Measurement> measure(Peer& peer, const std::string& name, const Mesh& mesh,
                            const TimingEffort& effort) {
  if (const auto loaded = peer.load(mesh); !loaded) return loaded.error();
  std::vector<std::byte> bytes;
  const auto encode_seconds = time_median(effort, [&]() -> Result<void> {
    auto encoded = peer.encode();
    if (!encoded) return encoded.error();
    bytes = *std::move(encoded);
    return {};
  });
  if (!encode_seconds) return encode_seconds.error();
  const auto decode_seconds = time_median(effort, [&] { return peer.decode(bytes); });
  if (!decode_seconds) return decode_seconds.error();

  const auto decoded = peer.decoded();
  if (!decoded) return decoded.error();
  const auto comparison = compare(mesh, decoded->mesh, decoded->order);
  if (!comparison) return comparison.error();
  if (!comparison->corresponding)
    return Error{.code = ErrorCode::kInternal, .message = "the decoded mesh has another topology"};
  return Measurement{.mesh = name,
                     .peer = peer.name(),
                     .setting = peer.setting(),
                     .vertices = mesh.vertex_count(),
                     .triangles = mesh.triangle_count(),
                     .diagonal = comparison->diagonal,
                     .bytes = bytes.size(),
                     .quality = comparison->quality,
                     .encode_seconds = *encode_seconds,
                     .decode_seconds = *decode_seconds,
                     .shares = peer.shares(bytes)};
}

}  // namespace deltamesh::bench
