// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/model_states.h"

#include <utility>

#include "base/guard.h"
#include "base/try.h"
#include "decoder/stream_decoder.h"
#include "format/container.h"
#include "states/stream_models.h"

namespace deltamesh {

ModelStates::ModelStates(std::shared_ptr<const StreamModels> models) noexcept : models_(std::move(models)) {}

Result<ModelStates> ModelStates::learn(std::span<const std::byte> stream,
                                       const DecodeOptions& options) noexcept {
  return guarded([&]() -> Result<ModelStates> {
    DELTAMESH_TRY(const auto container, Container::open(stream));
    auto models = std::make_shared<StreamModels>();
    DELTAMESH_TRY([[maybe_unused]] const Mesh mesh,
                  decode_container(container, options, nullptr, models.get()));
    models->limit_counts(kMostCountedBefore);
    return ModelStates(std::move(models));
  });
}

}  // namespace deltamesh
