// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Functions that `core` calls in its parts: the modules `highpass`, `zstd`, `rare` and `grid`. A part works
// in core's memory, with its allocator and on its stack, and all modules are built alike: so functions take
// and return what C++ has, errors included. JavaScript (packages/decoder/decode.js) only finds the part.
// Functions must not be handed over, as every module has a table of its own.
#pragma once

#include "runtime.h"

/// In core: the function `name` that the part exports.
#define DELTAMESH_OF_PART(part, name) __attribute__((import_module(#part), import_name(#name)))
