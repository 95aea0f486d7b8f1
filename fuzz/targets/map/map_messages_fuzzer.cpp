// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Every message of a map. What is read is written to the same bytes, but for its checksum.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/map/description.h"
#include "deltamesh/map/fragment.h"
#include "deltamesh/map/messages.h"
#include "goal.h"

namespace {

using namespace deltamesh;

fuzz::Goal description_read("description");
fuzz::Goal part_read("part");
fuzz::Goal patch_read("patch");
fuzz::Goal start_read("start");
fuzz::Goal view_read("view");
fuzz::Goal fault_read("fault");
fuzz::Goal pose_read("pose");
fuzz::Goal receipt_read("receipt");
fuzz::Goal fragment_read("fragment");
fuzz::Goal entry_read("entry");

/// Every message that can be read can be written; reading and writing it again gives the same bytes.
template <class Read, class Write>
void check(Read read, Write write, std::span<const std::byte> bytes, fuzz::Goal& goal) {
  const auto message = read(bytes);
  if (!fuzz::check(message)) return;
  const auto written = write(*message);
  if (!written) std::abort();
  const auto again = read(*written);
  if (!again || *write(*again) != *written) std::abort();
  goal.reach();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  check(read_description, write_description, bytes, description_read);
  check(read_part, write_part, bytes, part_read);
  check(read_patch, write_patch, bytes, patch_read);
  check(read_start, write_start, bytes, start_read);
  check(read_view, write_view, bytes, view_read);
  check(read_fault, write_fault, bytes, fault_read);
  check(read_pose, write_pose, bytes, pose_read);
  check(read_receipt, write_receipt, bytes, receipt_read);
  check(read_fragment, write_fragment, bytes, fragment_read);
  for (const std::size_t attributes : {0U, 1U}) {
    const auto read = [&](std::span<const std::byte> entry) { return read_entry(entry, attributes); };
    check(read, write_entry, bytes, entry_read);
  }
  return 0;
}
