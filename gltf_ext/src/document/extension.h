// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The extension's object of a primitive: from JSON and to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "deltamesh/result.h"
#include "document/semantics.h"
#include "io/gltf/structure.h"

namespace deltamesh::gltf {

/// An accessor of the primitive, and the number of the stream's attribute that it stands for.
struct AttributeUse {
  Semantic semantic;
  std::size_t accessor = 0;
  std::uint64_t id = 0;
};

/// A primitive with the extension, its references checked as far as possible without the stream.
struct PackedPrimitive {
  PrimitiveNumber number{};
  std::uint64_t view = 0;  ///< of the stream
  std::uint64_t group = 0;
  std::size_t position = 0;                ///< accessor
  std::size_t indices = 0;                 ///< accessor
  std::vector<AttributeUse> attributes{};  ///< with those of morph targets
};

/// kInvalidFile at a primitive, with the extension's rule that it breaks.
Error rule_error(const char* message, const char* rule, const PrimitiveNumber& primitive) noexcept;

/// Nothing where the primitive does not have the extension. Precondition: check_structure(). Errors:
/// kInvalidFile [GLTF-1, 2, 3, 4, 11].
Result<std::optional<PackedPrimitive>> read_extension(const Json& primitive, const PrimitiveNumber& number);

/// Gives the primitive the extension and the accessors that `packed` names.
void write_extension(Json& primitive, const PackedPrimitive& packed);

void remove_extension(Json& primitive);

}  // namespace deltamesh::gltf
