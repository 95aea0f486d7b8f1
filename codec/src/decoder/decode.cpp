// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/decode.h"

#include <optional>
#include <thread>

#include "base/guard.h"
#include "base/threads/thread_team.h"
#include "base/try.h"
#include "decoder/stream_decoder.h"
#include "deltamesh/stream_info.h"
#include "format/container.h"

namespace deltamesh {
namespace {

/// Bytes of a stream from which on its decoding takes longer than to start threads.
constexpr std::size_t kLargeStream = std::size_t{1} << 14;

/// For work on a stream of `bytes`.
unsigned thread_count(const DecodeOptions& options, std::size_t bytes) {
  if (!kHasThreads || bytes < kLargeStream) return 1;
  return options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
}

}  // namespace

Result<Mesh> decode(std::span<const std::byte> stream, const DecodeOptions& options) noexcept {
  return guarded([&]() -> Result<Mesh> {
    DELTAMESH_TRY(const auto container, Container::open(stream));
    std::optional<ThreadTeam> team;
    if (const unsigned threads = thread_count(options, stream.size()); threads > 1) team.emplace(threads);
    return decode_container(container, options, team ? &*team : nullptr);
  });
}

Result<void> verify(std::span<const std::byte> stream, const DecodeOptions& options) noexcept {
  DELTAMESH_TRY([[maybe_unused]] const auto info, inspect(stream));
  DELTAMESH_TRY([[maybe_unused]] const auto mesh, decode(stream, options));
  return {};
}

}  // namespace deltamesh
