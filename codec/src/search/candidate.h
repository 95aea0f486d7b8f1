// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One way to code the positions of a mesh: what a coder makes from settings, and what a decoder makes of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/vec3.h"
#include "deltamesh/stream_info.h"
#include "entropy/chunk_list.h"
#include "format/header.h"
#include "grid/grid.h"
#include "highpass/settings.h"
#include "positions/positions.h"

namespace deltamesh {

struct Candidate {
  std::uint8_t coder = kGeometryHighpass;
  HighpassSettings settings{};        ///< of the highpass coder, which made it from these
  HighpassParameters highpass{};      ///< for the header; so is the next
  PredictiveParameters predictive{};  ///< settings of the predictive coder; so is the next
  PositionForm form{};
  ChunkList chunks{};
  Quality quality{};        ///< as decoded
  std::uint64_t bytes = 0;  ///< of the whole stream
  /// n x 3 floats as decoded, of geometric vertices; empty where decoders may differ in their last bits.
  std::vector<float> positions{};
  LargeVector<Vec3> solution{};  ///< n: of the highpass coder, before it is rounded to floats
  /// Of the grid coder, whose chunks have the faces as well: their order and that of vertices, in which
  /// `positions` are. Its payloads are in `chunks`.
  std::optional<CodedGrid> grid{};

  void set_parameters(FileHeader& header) const {
    header.geometry = coder;
    header.highpass = highpass;
    header.predictive = predictive;
  }
};

/// The form that was the smallest at one step, or scale of errors: it is nearly so at others that are near,
/// which then need not try all.
class ChosenForm {
 public:
  /// Empty where all forms are to be tried.
  std::optional<PositionForm> at(double setting) const noexcept {
    constexpr double kFarthest = 4;
    const bool is_near = std::max(setting / setting_, setting_ / setting) <= kFarthest;
    return is_near ? form_ : std::nullopt;
  }
  void chosen(const PositionForm& form, double setting) noexcept {
    form_ = form;
    setting_ = setting;
  }

 private:
  std::optional<PositionForm> form_;
  double setting_ = 1;
};

/// The rest of the stream, so that its size is known.
struct StreamRest {
  const FileHeader& header;
  std::uint64_t chunk_bytes;  ///< of the chunks that are neither the geometry's nor the faces'
  std::uint64_t face_bytes;   ///< of the chunk of faces, unless the geometry has them

  std::uint64_t bytes_with(const Candidate& candidate) const {
    FileHeader whole = header;
    candidate.set_parameters(whole);
    const std::uint64_t faces = candidate.grid ? 0 : face_bytes;
    return stream_bytes(whole, chunk_bytes + faces + candidate.chunks.bytes());
  }
};

}  // namespace deltamesh
