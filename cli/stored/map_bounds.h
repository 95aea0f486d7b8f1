// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// bounds.json of a map's folder: what was asked of positions when the map was last made or changed.
#pragma once

#include <string>

#include "deltamesh/map/encode_map.h"
#include "deltamesh/result.h"

namespace deltamesh::cli {

/// Fills `asked` and `bounds` of a state; a folder without the file leaves them empty. Errors: kFileRead,
/// kInvalidFile.
Result<void> load_bounds(const std::string& folder, MapState& state);

/// Where nothing is known there is no file. Errors: kFileWrite.
Result<void> save_bounds(const std::string& folder, const MapState& state);

/// "max error 0.02% = 0.00146, vde 0.01": what was asked, and what it is in model units where that is in
/// percent.
std::string bounds_text(const MapState& state);

}  // namespace deltamesh::cli
