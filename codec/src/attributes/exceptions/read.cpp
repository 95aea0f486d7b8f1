// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cstring>

#include "attributes/exceptions/exceptions.h"
#include "base/try.h"

namespace deltamesh {

void put_exceptions(const Exceptions& exceptions, std::size_t row_size,
                    std::span<std::byte> values) noexcept {
  for (const ExceptionRun& run : exceptions.runs)
    for (std::size_t v = run.begin; v < std::size_t{run.begin} + run.length; ++v)
      std::memcpy(values.data() + v * row_size, exceptions.rows.data() + run.row * row_size, row_size);
}

Result<Exceptions> read_exceptions(ByteReader& in, std::size_t row_size, std::uint32_t count) {
  Exceptions exceptions;
  DELTAMESH_TRY(const auto values, in.read_varint(count));
  if (values == 0) return in.invalid("exceptions without values", "ATTR-12");
  DELTAMESH_TRY(const auto rows, in.read_bytes(values * row_size));
  exceptions.rows.assign(rows.begin(), rows.end());
  DELTAMESH_TRY(const auto runs, in.read_varint(count));
  if (runs == 0) return in.invalid("no run of exceptions", "ATTR-12");
  std::uint32_t end = 0;
  for (std::uint64_t i = 0; i < runs; ++i) {
    if (end == count) return in.invalid("exceptions beyond the last vertex", "ATTR-12");
    ExceptionRun run;
    DELTAMESH_TRY(const auto gap, in.read_varint(count - end - 1));
    run.begin = end + static_cast<std::uint32_t>(gap);
    DELTAMESH_TRY(const auto more, in.read_varint(count - run.begin - 1));
    run.length = 1 + static_cast<std::uint32_t>(more);
    if (values > 1) {
      DELTAMESH_TRY(const auto row, in.read_varint(values - 1));
      run.row = static_cast<std::uint32_t>(row);
    }
    end = run.begin + run.length;
    exceptions.runs.push_back(run);
  }
  return exceptions;
}

}  // namespace deltamesh
