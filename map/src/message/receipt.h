// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a receiver has got, as bytes [MAP-21].
#pragma once

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// The reason why not, or null.
const char* what_is_wrong(const Receipt& receipt) noexcept;
/// Precondition: nothing is wrong.
void write_receipt_fields(ByteWriter& out, const Receipt& receipt);
/// Errors: kTruncated, kInvalidStream [MAP-21].
Result<Receipt> read_receipt_fields(ByteReader& in);

}  // namespace deltamesh
