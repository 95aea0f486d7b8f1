// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The stages of decoding, one after the other.
#pragma once

#include "deltamesh/decode.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "format/container.h"

namespace deltamesh {

class ThreadTeam;
struct StreamModels;

/// The mesh in `container`. On the threads of `team`; null: on this one. `learnt`: gets what coders learn,
/// where it is wanted.
/// Errors: as decode(); throws std::bad_alloc.
Result<Mesh> decode_container(const Container& container, const DecodeOptions& options, ThreadTeam* team,
                              StreamModels* learnt = nullptr);

}  // namespace deltamesh
