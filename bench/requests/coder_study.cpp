// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "requests/coder_study.h"

#include <cmath>
#include <ctime>

#include "base/try.h"
#include "format/vertex_positions.h"
#include "highpass/highpass.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "measure/measure.h"

namespace deltamesh::bench {
namespace {

constexpr std::uint32_t kVerticesPerAnchor = 500;
constexpr int kAnchorBits = 16;
constexpr int kMostSteps = 12;
constexpr double kEqual = 1e-3;

/// One mesh and its anchors.
class Study {
 public:
  explicit Study(const WeldedMesh& mesh)
      : mesh_(mesh),
        anchors_(mesh.graph, mesh.components),
        coder_(mesh.graph, mesh.components, anchors_, mesh.positions, mesh.box) {}

  HighpassSettings at_bits(int bits) const {
    return {.step = coder_.step_for_bits(bits),
            .anchors = static_cast<std::uint32_t>(vertices() / kVerticesPerAnchor),
            .anchor_bits = kAnchorBits};
  }

  Result<CodedFigures> code(const HighpassSettings& settings) {
    DELTAMESH_TRY(const CodedHighpass coded, coder_.code(settings));
    DELTAMESH_TRY(const auto positions, to_float_positions(coded.positions));
    return CodedFigures{.quality = measure_quality(mesh_.graph, mesh_.positions, positions),
                        .bytes = coded.compact_deltas.size() + coded.compact_anchors.size()};
  }

  std::size_t vertices() const noexcept { return mesh_.positions.size(); }

 private:
  const WeldedMesh& mesh_;
  AnchorSequence anchors_;
  HighpassCoder coder_;
};

/// All containers; returns processor seconds.
double take_containers(const WeldedMesh& mesh, AnchorContainers& containers) {
  const std::clock_t start = std::clock();
  AnchorSequence& sequence = containers.impl().sequence(mesh.graph, mesh.components);
  for (std::uint32_t density = 15; density >= 5; --density)
    sequence.first(mesh.graph, sequence.count_for_density(mesh.graph, density));
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

ContainerFigures time_containers(const WeldedMesh& mesh) {
  AnchorContainers containers;
  const double first = take_containers(mesh, containers);
  return {.first = first, .second = take_containers(mesh, containers)};
}

Result<Comparison> compare_diffusion(const WeldedMesh& mesh, int bits, double strength) {
  Study study(mesh);
  HighpassSettings settings = study.at_bits(bits);
  Comparison result;
  DELTAMESH_TRY(result.plain, study.code(settings));
  settings.diffusion = strength;
  for (int i = 0; i < kMostSteps; ++i) {
    DELTAMESH_TRY(result.other, study.code(settings));
    const double excess = static_cast<double>(result.other.bytes) - static_cast<double>(result.plain.bytes);
    if (std::abs(excess) <= kEqual * static_cast<double>(result.plain.bytes)) break;
    settings.step *= std::exp2(8 * excess / (3 * static_cast<double>(study.vertices())));
  }
  return result;
}

Result<Comparison> compare_frugal(const WeldedMesh& mesh, int bits, double rate_weight) {
  Study study(mesh);
  HighpassSettings settings = study.at_bits(bits);
  settings.centroids = true;
  Comparison result;
  DELTAMESH_TRY(result.plain, study.code(settings));
  settings.rate_weight = rate_weight;
  for (int i = 0; i < kMostSteps; ++i) {
    DELTAMESH_TRY(result.other, study.code(settings));
    const double ratio = result.other.quality.vde_rms / result.plain.quality.vde_rms;
    if (std::abs(ratio - 1) <= kEqual) break;
    settings.step /= ratio;
  }
  return result;
}

}  // namespace deltamesh::bench
