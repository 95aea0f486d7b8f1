// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/container_frame.h"

bool deltamesh::checksum_holds(std::uint32_t, std::uint32_t) noexcept { return true; }
