// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Text from pieces and numbers.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace deltamesh::bench {

/// The pieces one after the other.
std::string join(std::initializer_list<std::string_view> pieces);

std::string number(std::uint64_t value);

/// With `digits` places after the point.
std::string fixed(double value, int digits);

/// With `digits` significant digits, no trailing zeros, no exponent between 1e-4 and 1e6.
std::string significant(double value, int digits);

/// `a` over `b`; 0 where b is.
double ratio(std::uint64_t a, std::uint64_t b);

}  // namespace deltamesh::bench
