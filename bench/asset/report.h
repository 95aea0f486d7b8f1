// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tables of assets: bytes, parts, times and what they come to.
#pragma once

#include <string>
#include <vector>

#include "asset/row.h"

namespace deltamesh::bench {

/// Markdown: for every setting the assets' bytes and the bytes of their parts, then times, then means.
std::string render_asset_markdown(const std::vector<AssetRow>& rows);

/// RFC 4180 with a header line: a line for each part of an asset at a setting, and one for its total.
std::string render_asset_csv(const std::vector<AssetRow>& rows);

}  // namespace deltamesh::bench
