// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Selects the part of a glTF document's JSON that its parser gets: properties that the importer uses, with
// the types that they must have.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "deltamesh/result.h"

namespace deltamesh {

/// The document with nothing else in it. Errors: kInvalidFile.
Result<std::string> filtered_gltf(const nlohmann::json& root);

}  // namespace deltamesh
