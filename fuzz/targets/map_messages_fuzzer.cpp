// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Every message of a map. What is read is written to the same bytes, but for its checksum.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/map/description.h"
#include "deltamesh/map/messages.h"

namespace {

using namespace deltamesh;

template <class Message, class Write>
void check(const Result<Message>& read, std::span<const std::byte> bytes, Write write) {
  if (!read) {
    if (read.error().code == ErrorCode::kInternal) std::abort();
    return;
  }
  const auto again = write(*read);
  constexpr std::size_t kChecksum = 4;
  if (!again || again->size() != bytes.size() ||
      !std::equal(again->begin(), again->end() - kChecksum, bytes.begin()))
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  check(read_description(bytes), bytes, write_description);
  check(read_part(bytes), bytes, write_part);
  check(read_start(bytes), bytes, write_start);
  check(read_view(bytes), bytes, write_view);
  for (const std::size_t attributes : {0U, 1U}) check(read_entry(bytes, attributes), bytes, write_entry);
  return 0;
}
