// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rules for names of attributes.
#pragma once

#include <string_view>

namespace deltamesh {

/// UTF-8 (RFC 3629: shortest form, no surrogates), 1 to 255 bytes.
bool is_attribute_name(std::string_view name) noexcept;

}  // namespace deltamesh
