// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Anchors found once for a mesh, for any number of requests.
#pragma once

#include <cstdint>
#include <memory>

namespace deltamesh {

/// The paper's containers Delta_V (section 4): one growing sequence of anchors, whose shortest beginning with
/// no vertex more than V edges from an anchor is container V. A sender keeps the object while its mesh's
/// connectivity stays and passes it with every encode; what one call has searched the next one takes from
/// here. A mesh of another connectivity empties it first, so that a stale object costs time, never quality.
/// One encode at a time may use an object. Streams do not depend on what it holds.
class AnchorContainers {
 public:
  AnchorContainers();
  ~AnchorContainers();
  AnchorContainers(const AnchorContainers&) = delete;
  AnchorContainers& operator=(const AnchorContainers&) = delete;

  /// Breadth-first searches made so far, one for every anchor found.
  std::uint64_t searches() const noexcept;

  class Impl;  ///< laplacian/anchors/anchor_sequence.h; not for callers
  Impl& impl() noexcept { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace deltamesh
