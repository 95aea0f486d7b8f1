// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The outermost layer: turns what the standard and JSON libraries may throw into errors.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include "deltamesh/result.h"

namespace deltamesh::gltf {

/// Returns what `work` returns; kOutOfMemory or kInternal where it throws.
template <class Work>
auto guarded(Work&& work) noexcept -> decltype(work()) {
  constexpr Error kNoMemory{.code = ErrorCode::kOutOfMemory, .message = "the asset does not fit into memory"};
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return kNoMemory;
  } catch (const std::length_error&) {
    return kNoMemory;
  } catch (const std::exception&) {
    return Error{.code = ErrorCode::kInternal, .message = "unexpected JSON in a checked asset"};
  }
}

}  // namespace deltamesh::gltf
