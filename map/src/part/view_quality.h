// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a view asks of a part's quality.
#pragma once

#include <span>

#include "deltamesh/map/description.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"

namespace deltamesh {

/// Whether a sender of the map can keep what the view asks for, as far as it is known before parts are
/// encoded. Errors: kUnmetRequest (a largest error below what the lattice allows; best_value),
/// kInvalidArgument (bounds of attributes that the map does not have, or that have none; where: the
/// attribute).
Result<void> check_view(const View& view, const MapDescription& description) noexcept;

/// The view's bounds, for encode_part().
PartQuality part_quality(const View& view, const MapDescription& description);

/// Whether a part's errors are within the view's bounds. `errors`: of every attribute of the map; colours are
/// satisfies()' matter.
bool keeps_attributes(std::span<const double> errors, const View& view, const MapDescription& description);

}  // namespace deltamesh
