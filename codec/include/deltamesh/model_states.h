// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The states that the coders' adaptive models have at the end of one stream. Other streams may start from
// them.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "deltamesh/decode.h"
#include "deltamesh/result.h"

namespace deltamesh {

struct StreamModels;

/// The states of the adaptive models of faces, positions (predictive), colours and attributes at a mean error
/// as they are after a stream. Given to encode() and decode(), parts of one mesh take fewer bytes: none has
/// to learn again what all have in common. A stream that was encoded with states is decoded with the states
/// of the same stream, and says nothing of them: that is for what holds it, such as a map. Immutable; several
/// threads may use it.
class ModelStates {
 public:
  /// Errors: as decode().
  static Result<ModelStates> learn(std::span<const std::byte> stream,
                                   const DecodeOptions& options = {}) noexcept;

  const StreamModels& models() const noexcept { return *models_; }  ///< not for callers

 private:
  explicit ModelStates(std::shared_ptr<const StreamModels> models) noexcept;
  std::shared_ptr<const StreamModels> models_;
};

}  // namespace deltamesh
