// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "peers/measure.h"

#include <utility>
#include <vector>

#include "deltamesh/compare.h"

namespace deltamesh::bench {
Result<Measurement> measure(Peer& peer, const std::string& name, const Mesh& mesh,
                            const TimingEffort& effort) {
  if (const auto loaded = peer.load(mesh); !loaded) return loaded.error();
  std::vector<std::byte> bytes;
  const auto encode = time_in_turn(effort, [&]() -> Result<void> {
    auto encoded = peer.encode();
    if (!encoded) return encoded.error();
    bytes = *std::move(encoded);
    return {};
  });
  if (!encode) return encode.error();
  const auto decode = time_in_turn(effort, [&] { return peer.decode(bytes); });
  if (!decode) return decode.error();

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
                     .encode_seconds = median(encode->front()),
                     .decode_seconds = median(decode->front()),
                     .shares = peer.shares(bytes)};
}

}  // namespace deltamesh::bench
