// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact payload of one coding, with what decoders get from it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "attributes/attribute.h"
#include "attributes/payload.h"
#include "attributes/values.h"
#include "base/byte_writer.h"

namespace deltamesh {

/// Empty where `values` are: the coding does not keep what is asked for.
template <class T>
std::optional<CodedAttribute> code_compact(AttributeCoding coding,
                                           const std::optional<CodedValues<T>>& values) {
  if (!values) return std::nullopt;
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(coding));
  out.write_bytes(values->bytes);
  CodedAttribute coded;
  coded.payload = out.take();
  coded.is_compact = true;
  const auto decoded = std::as_bytes(std::span(values->values));
  coded.decoded.values.assign(decoded.begin(), decoded.end());
  return coded;
}

}  // namespace deltamesh
