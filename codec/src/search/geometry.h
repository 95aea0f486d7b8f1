// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions of a mesh coded as a request asks, by the coder that it asks for or that suits it.
#pragma once

#include "search/candidate.h"
#include "search/request.h"

namespace deltamesh {

/// The smallest candidate that keeps the request, or the best that fits its bytes. Where the request leaves
/// the coder open and asks for a VDE, both are compared, unless a forecast says that one cannot win;
/// otherwise the predictive coder is taken. Errors: kUnmetRequest; kInvalidMesh for coordinates that no
/// stream can hold.
Result<Candidate> code_geometry(const Request& request, const SourceGeometry& source, const StreamRest& rest);

}  // namespace deltamesh
