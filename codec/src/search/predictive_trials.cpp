// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/predictive_trials.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "deltamesh/model_states.h"
#include "positions/lattice/exact_lattice.h"
#include "positions/lattice/lattice.h"
#include "positions/positions.h"
#include "search/cell_quality.h"
#include "states/stream_models.h"

namespace deltamesh {
namespace {

/// The payload in a given form.
using WritePositions = std::function<std::vector<std::byte>(const PositionForm&)>;

constexpr int kAnyGainEffort = 8;        ///< from here on any gain pays for an order of its own
constexpr double kOrderWorth = 0.97;     ///< of the bytes without one, at most
constexpr double kDeepHopeless = 0.985;  ///< of the bytes without one: orders hardly matter to this mesh

class FormSearch {
 public:
  FormSearch(const WritePositions& write, const PositionForm& first)
      : write_(write), form_(first), bytes_(write(first)) {}

  const PositionForm& form() const noexcept { return form_; }
  std::size_t size() const noexcept { return bytes_.size(); }

  /// Takes `form` where it needs at most `most` bytes and fewer than the best so far. Returns its bytes.
  std::size_t consider(const PositionForm& form, double most) {
    auto bytes = write_(form);
    const std::size_t size = bytes.size();
    if (size < bytes_.size() && static_cast<double>(size) <= most) {
      bytes_ = std::move(bytes);
      form_ = form;
    }
    return size;
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  const WritePositions& write_;
  PositionForm form_;
  std::vector<std::byte> bytes_;
};

PositionForm with_order(PositionForm form, CodingOrder coding_order) noexcept {
  form.coding_order = coding_order;
  return form;
}

PositionForm with_guesses(PositionForm form, bool guesses) noexcept {
  form.guesses = guesses ? Guessing::kAlways : Guessing::kNever;
  return form;
}

PositionForm with_fit(PositionForm form, BlendFit fit) noexcept {
  form.fit = fit;
  return form;
}

/// Tries the forms that `kind` has, one after the other: two to seven calls of `write`, one at effort 0. A
/// coding order costs a decoder time, so up to effort 7 it has to earn it.
std::vector<std::byte> write_smallest(const WritePositions& write, PositionKind kind, int effort) {
  const bool may_guess = kind == PositionKind::kLattice;
  if (effort == 0)
    return write({.fit = BlendFit::kSample, .guesses = may_guess ? Guessing::kPrediction : Guessing::kNever});
  FormSearch search(write, {});
  if (search.size() == 0) return search.take();
  const auto any = static_cast<double>(search.size());
  if (may_guess) search.consider(with_guesses(search.form(), true), any);
  const auto still = static_cast<double>(search.size());
  const double most = effort >= kAnyGainEffort ? still : kOrderWorth * still;
  const std::size_t broad = search.consider(with_order(search.form(), CodingOrder::kBroad), most);
  if (static_cast<double>(broad) < kDeepHopeless * still)
    search.consider(with_order(search.form(), CodingOrder::kDeep), most);
  if (may_guess && search.form().coding_order != CodingOrder::kAsDecoded)
    search.consider(with_guesses(search.form(), search.form().guesses == Guessing::kNever), any);
  const bool has_blends = kind != PositionKind::kVoxel;
  if (has_blends) search.consider(with_fit(search.form(), BlendFit::kBits), any);
  return search.take();
}

constexpr std::size_t kQuickSample = 1U << 15;  ///< vertices that effort 0 looks for grids in

/// n x 3.
std::vector<float> to_rows(std::span<const Vec3> positions) {
  std::vector<float> rows;
  rows.reserve(3 * positions.size());
  for (const Vec3& position : positions)
    for (const double x : position) rows.push_back(static_cast<float>(x));
  return rows;
}

}  // namespace

PredictiveTrials::PredictiveTrials(const EncodeOptions& options, const SourceGeometry& source,
                                   const StreamRest& rest)
    : options_(options),
      source_(source),
      rest_(rest),
      values_(source.positions, options.effort == 0 ? kQuickSample : source.positions.size()) {}

double PredictiveTrials::step_for_bits(int bits) const noexcept {
  const double step = source_.box.longest_side() / (std::ldexp(1.0, bits) - 1);
  return step > 0 ? std::max(step, finest_step(source_.box)) : 1.0;
}

LatticeTrial PredictiveTrials::measured(PredictiveParameters parameters, std::vector<Cell> cells,
                                        const Bounds& bounds) const {
  LatticeTrial trial{.parameters = parameters, .cells = std::move(cells)};
  trial.quality = positional_quality(source_.positions, trial.cells, parameters.lattice, source_.edges);
  if (bounds.vde && is_declarable(trial.quality))
    trial.quality.vde_rms = visual_error(source_.edges, source_.positions, trial.cells, parameters.lattice);
  return trial;
}

LatticeTrial PredictiveTrials::try_lattice(const PositionLattice& lattice, const Bounds& bounds) const {
  return measured({.lattice = lattice}, to_cells(source_.positions, lattice), bounds);
}

std::optional<LatticeTrial> PredictiveTrials::try_levels(const VoxelFit& fit, std::uint32_t levels,
                                                         const Bounds& bounds) const {
  auto voxels = to_voxel_cells(source_.positions, source_.box, fit, levels);
  if (!voxels) return std::nullopt;
  return measured({.kind = PositionKind::kVoxel, .lattice = voxels->lattice, .levels = levels},
                  std::move(voxels->cells), bounds);
}

CodedGeometry PredictiveTrials::code(const LatticeTrial& trial) const {
  CodedGeometry choice{.coder = kGeometryPredictive,
                       .predictive = trial.parameters,
                       .chunks = ChunkList(options_),
                       .quality = trial.quality};
  if (!(choice.quality.vde_rms > 0) && choice.quality.lfe_rms > 0 && is_declarable(choice.quality))
    choice.quality.vde_rms =
        visual_error(source_.edges, source_.positions, trial.cells, trial.parameters.lattice);
  const auto write = [&](const PositionForm& form) {
    return write_positions(faces(), trial.cells, trial.parameters, form, trial.replacements, start());
  };
  choice.chunks.add_compact(kTagPositions, write_smallest(write, trial.parameters.kind, options_.effort));
  choice.positions = to_rows(to_positions(trial.cells, trial.parameters.lattice));
  deltamesh::apply(trial.replacements, std::span<float>(choice.positions));
  return choice;
}

Result<CodedGeometry> PredictiveTrials::code_step(double step) const {
  if (step < finest_step(source_.box))
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "a step so fine takes over 2^28 points along a side; `lossless` keeps every bit"};
  return code(try_lattice(cubic_lattice(source_.box, step)));
}

CodedGeometry PredictiveTrials::code_floats() const {
  CodedGeometry choice{.coder = kGeometryPredictive,
                       .predictive = {.kind = PositionKind::kFloats, .lattice = {}},
                       .chunks = ChunkList(options_)};
  const auto write = [&](const PositionForm& form) {
    return write_floats(faces(), source_.positions, source_.box, form);
  };
  choice.chunks.add_compact(kTagPositions, write_smallest(write, PositionKind::kFloats, options_.effort));
  choice.positions = to_rows(source_.positions);
  return choice;
}

CodedGeometry PredictiveTrials::code_exactly() const {
  CodedGeometry floats = code_floats();
  const auto lattice = find_exact_lattice(source_.positions, source_.box);
  if (!lattice) return floats;
  LatticeTrial trial{.parameters = {.lattice = *lattice}, .cells = to_cells(source_.positions, *lattice)};
  trial.replacements = find_replacements(source_.positions, to_positions(trial.cells, *lattice));
  CodedGeometry choice = code(trial);
  return rest_.bytes_with(choice) < rest_.bytes_with(floats) ? choice : floats;
}

const std::optional<VoxelFit>& PredictiveTrials::voxels() const {
  if (!voxels_) voxels_ = has_usual_voxels() ? fit_usual_voxels() : fit_voxels(values_, source_.box);
  return *voxels_;
}

const PositionModels* PredictiveTrials::start() const noexcept {
  return options_.starting_states != nullptr ? &options_.starting_states->models().positions : nullptr;
}

bool PredictiveTrials::has_usual_voxels() const noexcept {
  return options_.starting_states != nullptr && options_.starting_states->models().voxels;
}

std::uint32_t PredictiveTrials::usual_levels() const noexcept {
  return has_usual_voxels() ? options_.starting_states->models().voxels->levels : 0;
}

std::optional<VoxelFit> PredictiveTrials::fit_usual_voxels() const {
  const PredictiveParameters& usual = *options_.starting_states->models().voxels;
  VoxelFit grid{.origin = usual.lattice.origin};
  for (std::size_t axis = 0; axis < 3; ++axis)
    grid.voxel[axis] = 2.0 * usual.levels * usual.lattice.step[axis];
  return fit_to_grid(grid, values_, source_.box);
}

}  // namespace deltamesh
