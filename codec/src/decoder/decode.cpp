// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/decode.h"

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "base/guard.h"
#include "base/memory_pool.h"
#include "base/thread_team.h"
#include "base/try.h"
#include "decoder/check_limits.h"
#include "decoder/stream_decoder.h"
#include "deltamesh/stream_info.h"
#include "format/container.h"

namespace deltamesh {
namespace {

/// Bytes of a stream from which on its decoding fills large pages and takes longer than to start threads.
constexpr std::size_t kLargeStream = std::size_t{1} << 14;

/// What the decoder's arrays take up at a time, as far as `bytes` may hold that much: untouched, it costs
/// nothing.
std::size_t memory_at_a_time(const FileHeader& header, std::size_t bytes) noexcept {
  constexpr std::size_t kPerPredictedVertex = 84;
  constexpr std::size_t kPerSolvedVertex = 160;
  constexpr std::size_t kRounding = 1024;  // of all arrays together
  constexpr std::size_t kVerticesPerByte = 32;
  const std::size_t per_vertex =
      header.geometry == kGeometryPredictive ? kPerPredictedVertex : kPerSolvedVertex;
  return kRounding + per_vertex * std::min<std::size_t>(header.geometric_vertices, kVerticesPerByte * bytes);
}

/// Working in `memory`, which nobody else uses.
Result<Mesh> decode_in(MemoryPool& memory, std::span<const std::byte> stream, const DecodeOptions& options) {
  DELTAMESH_TRY(const auto container, Container::open(stream));
  DELTAMESH_CHECK(check_limits(container.header(), options.limits));
  if constexpr (!kHasMemoryPool) return decode_container(container, options);
  const unsigned threads = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
  const bool is_large = stream.size() >= kLargeStream;
  std::optional<PoolScope> scope;
  std::optional<ThreadTeam> team;
  // Called while another decode goes on (from its `progress`), with one thread, this one shares its team,
  // and so its pool: all threads of a team have the same.
  const bool shares_team = ThreadTeam::current() != nullptr && (threads <= 1 || !is_large);
  if ((is_large || !memory.is_empty()) && !shares_team) {
    if (is_large) memory.prepare(memory_at_a_time(container.header(), stream.size()));
    scope.emplace(memory);
    if (is_large && threads > 1) team.emplace(threads);
  }
  return decode_container(container, options);
}

}  // namespace

Result<Mesh> decode(std::span<const std::byte> stream, const DecodeOptions& options) noexcept {
  return Decoder().decode(stream, options);
}

Decoder::Decoder() noexcept = default;
Decoder::~Decoder() = default;
Decoder::Decoder(Decoder&&) noexcept = default;
Decoder& Decoder::operator=(Decoder&&) noexcept = default;

Result<Mesh> Decoder::decode(std::span<const std::byte> stream, const DecodeOptions& options) noexcept {
  std::unique_ptr<MemoryPool> memory = std::move(memory_);  // out of reach of a decode within this one
  Result<Mesh> mesh = guarded([&]() -> Result<Mesh> {
    if (!memory) memory = std::make_unique<MemoryPool>();
    return decode_in(*memory, stream, options);
  });
  memory_ = std::move(memory);
  return mesh;
}

Result<void> verify(std::span<const std::byte> stream, const DecodeOptions& options) noexcept {
  DELTAMESH_TRY([[maybe_unused]] const auto info, inspect(stream));
  DELTAMESH_TRY([[maybe_unused]] const auto mesh, decode(stream, options));
  return {};
}

}  // namespace deltamesh
