// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers that extensions unknown to us may mean as accessors or buffer views.
#pragma once

#include <cstdint>
#include <set>
#include <string_view>

#include "json.h"

namespace deltamesh::gltf {

/// True for an extension that is known to hold no accessor numbers, no vertex numbers, and buffer views only
/// in members named "bufferView".
bool is_harmless_extension(std::string_view name) noexcept;

/// Every whole number inside an extension that is not harmless, except members named "bufferView" and extras.
/// An accessor or buffer view with such a number must keep number and content: any of them may be meant.
std::set<std::uint64_t> numbers_in_unknown_extensions(Json& json);

}  // namespace deltamesh::gltf
