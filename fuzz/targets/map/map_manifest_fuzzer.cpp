// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes as a map's message and as a manifest; what is read is written as it was.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/map/folder.h"
#include "deltamesh/map/map_codec.h"
#include "goal.h"

namespace {

using namespace deltamesh;

fuzz::Goal map_opened("a map's message");
fuzz::Goal manifest_read("a manifest");

/// But for the checksum, which a fuzzer cannot guess.
void expect_same(std::span<const std::byte> in, const Result<std::vector<std::byte>>& out) {
  if (!out || out->size() != in.size()) std::abort();
  if (!std::equal(in.begin(), in.end() - 4, out->begin())) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto description = read_description(bytes);
  if (fuzz::check(description)) {
    expect_same(bytes, write_description(*description));
    const auto codec = MapCodec::open(*description, {.vertices = 1U << 14, .triangles = 1U << 15});
    if (fuzz::check(codec)) map_opened.reach();
  }
  const auto manifest = read_manifest(bytes);
  if (fuzz::check(manifest)) {
    if (!write_manifest(*manifest)) std::abort();
    manifest_read.reach();
  }
  return 0;
}
