// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How `core` calls its parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "deltamesh/result.h"
#include "part.h"

namespace deltamesh::web {

/// As decoder.js numbers them.
enum class Part : std::uint32_t { kHighpass, kZstd, kRare, kGrid };

extern "C" {
/// Copies bytes into the memory of a part, which releases them; returns their address there.
DELTAMESH_IMPORT(give) std::uint32_t give(Part part, const void* from, std::size_t bytes);
/// Makes the call at that address; 0, or the code of an error that JavaScript keeps. What is returned stays
/// until the part's next call.
DELTAMESH_IMPORT(call) std::uint32_t call(Part part, std::uint32_t arguments, PartArrays* returned);
/// Copies from the memory of a part.
DELTAMESH_IMPORT(take) void take(Part part, void* to, std::uint32_t from, std::size_t bytes);
}

template <class Array>
HandedArray hand_over(Part part, const Array& array) {
  const auto bytes = std::as_bytes(std::span(array));
  return {.address = give(part, bytes.data(), bytes.size()),
          .bytes = static_cast<std::uint32_t>(bytes.size())};
}

/// Errors: as `arguments` have them; JavaScript tells the rest of it.
template <class Call>
Result<PartArrays> call_part(Part part, const Call& arguments) {
  PartArrays returned;
  if (const std::uint32_t code = call(part, give(part, &arguments, sizeof(arguments)), &returned); code != 0)
    return Error{.code = static_cast<ErrorCode>(code)};
  return returned;
}

/// An array that a call returned.
template <class Vector>
void take_array(Part part, HandedArray array, Vector& to) {
  to.resize(array.bytes / sizeof(typename Vector::value_type));
  take(part, to.data(), array.address, array.bytes);
}

}  // namespace deltamesh::web
