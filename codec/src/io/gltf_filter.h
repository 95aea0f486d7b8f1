// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What of a glTF document's JSON is handed to its parser: the properties that matter here, of harmless
// shapes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "deltamesh/result.h"

namespace deltamesh {

/// The document with nothing else in it. Errors: kInvalidFile.
Result<std::string> filtered_gltf(const nlohmann::json& root);

}  // namespace deltamesh
