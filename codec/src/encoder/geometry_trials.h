// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rate control's trials on a real mesh: coded, decoded, measured.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "encoder/coded_geometry.h"
#include "geometry/highpass.h"
#include "laplacian/anchor_sequence.h"
#include "quality/bounds.h"
#include "quality/trial.h"

namespace deltamesh {

/// The geometry of a mesh, ready to be coded. Everything must outlive the trials.
struct GeometryInput {
  const Adjacency& graph;
  const Components& components;
  std::span<const Vec3> positions;  ///< n, relative to the mesh's origin, in coding order
  Box box;                          ///< of `positions`
  AnchorSequence& anchors;          ///< of `graph`
};

class GeometryTrials final : public TrialCoder {
 public:
  GeometryTrials(const GeometryInput& input, const StreamFrame& frame);

  /// Settled positions, with room for what plan_kept() may cost in quality.
  Result<TrialFigures> run(const CoderSettings& settings) override;
  Result<std::uint64_t> bytes(const CoderSettings& settings) override;
  double delta_error(const CoderSettings& settings) override;
  void keep() override { kept_ = last_; }
  std::vector<std::uint32_t> worst_vertices(double threshold, std::size_t count) override;
  std::uint32_t anchors_for_density(std::uint32_t density) override;
  std::uint32_t fewest_anchors() override { return input_.anchors.fewest(); }
  std::uint32_t most_anchors() override { return input_.anchors.most(); }
  double largest_delta() override { return coder_.largest_delta(); }
  double delta_range() override { return coder_.range(); }
  double longest_side() override { return input_.box.longest_side(); }
  bool has_small_components() override { return input_.anchors.most() < input_.positions.size(); }

  double step_for_bits(int bits) const noexcept { return coder_.step_for_bits(bits); }

  /// What keep() kept last. Precondition: it has been called.
  const GeometryChoice& kept() const noexcept { return kept_->choice; }

  /// The same mesh with the fewest planned cycles that keep `bounds` in hardly more bytes than kept() takes,
  /// and at most `most_bytes`; kept() itself where no number of cycles does. Cost: some solves.
  GeometryChoice plan_kept(const Bounds& bounds, std::optional<std::uint64_t> most_bytes);

 private:
  struct Trial {
    HighpassSettings settings;
    LargeVector<Vec3> settled;  ///< n: without planned cycles
    GeometryChoice choice;
  };
  HighpassSettings highpass_settings(const CoderSettings& settings);
  Result<GeometryChoice> to_choice(const CodedHighpass& coded) const;

  GeometryInput input_;
  StreamFrame frame_;
  HighpassCoder coder_;
  std::vector<double> errors_;  ///< of the last run, per vertex, model units
  std::shared_ptr<const Trial> last_;
  std::shared_ptr<const Trial> kept_;
};

}  // namespace deltamesh
