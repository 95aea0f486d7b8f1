// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// bounds.json of a map's folder: what was asked of positions when the map was last split.
#pragma once

#include <string>

#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"

namespace deltamesh::cli {

/// In model units; empty where the folder has no such file, or one that is damaged: then the next split
/// begins anew.
QualityRequest load_bounds(const std::string& folder);

/// Nothing where `bounds` are empty. Errors: kFileWrite.
Result<void> save_bounds(const std::string& folder, const QualityRequest& bounds);

}  // namespace deltamesh::cli
