// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/predictive_trials.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/progress.h"
#include "grid/grid.h"
#include "positions/lattice/exact_lattice.h"
#include "positions/lattice/lattice.h"
#include "positions/plain.h"
#include "search/cell_quality.h"
#include "states/stream_models.h"

namespace deltamesh {
namespace {

constexpr std::size_t kQuickSample = 1U << 15;  ///< vertices that effort 0 looks for grids in

constexpr double kOrderWorth = 0.97;     ///< of the bytes without one, at most: an order costs decoders time
constexpr double kDeepHopeless = 0.985;  ///< of the bytes without one: orders hardly matter to this mesh

/// n x 3.
std::vector<float> to_rows(std::span<const Vec3> positions) {
  std::vector<float> rows;
  rows.reserve(3 * positions.size());
  for (const Vec3& position : positions)
    for (const double x : position) rows.push_back(static_cast<float>(x));
  return rows;
}

/// `rows`, n x 3, by the numbers in `order`.
std::vector<float> rows_in_order(std::span<const float> rows, std::span<const std::uint32_t> order) {
  std::vector<float> ordered;
  ordered.reserve(rows.size());
  for (const std::uint32_t v : order)
    for (std::size_t axis = 0; axis < 3; ++axis) ordered.push_back(rows[3 * std::size_t{v} + axis]);
  return ordered;
}

const LatticeModels* start_of(const Request& request) noexcept {
  return request.start != nullptr ? request.start->of_lattice() : nullptr;
}

}  // namespace

PredictiveTrials::PredictiveTrials(const Request& request, const SourceGeometry& source,
                                   const StreamRest& rest)
    : request_(request),
      source_(source),
      rest_(rest),
      values_(source.positions, request.effort < kSearchEffort ? kQuickSample : source.positions.size()) {}

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

Candidate PredictiveTrials::finished(Candidate candidate, std::vector<std::byte> payload) const {
  candidate.chunks = ChunkList(request_.profile, request_.effort);
  candidate.chunks.add(kTagPositions, std::move(payload));
  candidate.bytes = rest_.bytes_with(candidate);
  return candidate;
}

Candidate PredictiveTrials::in_form(const PositionForm& form, Candidate candidate,
                                    const WritePositions& write) const {
  candidate.form = form;
  return finished(std::move(candidate), write(form));
}

Candidate PredictiveTrials::in_smallest_form(Candidate candidate, const WritePositions& write) const {
  const bool may_guess = candidate.predictive.kind == PositionKind::kLattice;
  if (request_.effort < kSearchEffort) {
    const PositionForm form{.fit = BlendFit::kSample,
                            .guesses = may_guess ? Guessing::kPrediction : Guessing::kNever};
    return in_form(form, std::move(candidate), write);
  }
  std::vector<std::byte> best = write(candidate.form);
  if (best.empty()) return finished(std::move(candidate), {});
  // Returns how many bytes `form` takes, which is the best from now on if these are at most `most`.
  const auto consider = [&](const PositionForm& form, double most) {
    auto payload = write(form);
    const auto size = static_cast<double>(payload.size());
    if (size < static_cast<double>(best.size()) && size <= most) {
      best = std::move(payload);
      candidate.form = form;
    }
    return size;
  };
  const auto any = static_cast<double>(best.size());
  PositionForm form = candidate.form;
  form.guesses = Guessing::kAlways;
  if (may_guess) consider(form, any);
  const auto size = static_cast<double>(best.size());
  const double most = request_.effort < kThoroughEffort ? kOrderWorth * size : size;
  form = candidate.form;
  form.coding_order = CodingOrder::kBroad;
  if (consider(form, most) < kDeepHopeless * size) {
    form.coding_order = CodingOrder::kDeep;
    consider(form, most);
  }
  form = candidate.form;
  form.guesses = form.guesses == Guessing::kNever ? Guessing::kAlways : Guessing::kNever;
  if (may_guess && form.coding_order != CodingOrder::kAsDecoded) consider(form, any);
  form = candidate.form;
  form.fit = BlendFit::kBits;
  consider(form, any);
  return finished(std::move(candidate), std::move(best));
}

Candidate PredictiveTrials::shell(const LatticeTrial& trial) const {
  Candidate candidate;
  candidate.coder = kGeometryPredictive;
  candidate.predictive = trial.parameters;
  candidate.quality = trial.quality;
  if (!(candidate.quality.vde_rms > 0) && candidate.quality.lfe_rms > 0 && is_declarable(candidate.quality))
    candidate.quality.vde_rms =
        visual_error(source_.edges, source_.positions, trial.cells, trial.parameters.lattice);
  candidate.positions = to_rows(to_positions(trial.cells, trial.parameters.lattice));
  deltamesh::apply(trial.replacements, std::span<float>(candidate.positions));
  return candidate;
}

PredictiveTrials::WritePositions PredictiveTrials::writer(const LatticeTrial& trial) const {
  return [&](const PositionForm& form) {
    if (request_.progress != nullptr) request_.progress->tick();
    return write_positions(faces(), trial.cells, trial.parameters, form, trial.replacements,
                           start_of(request_));
  };
}

std::optional<Candidate> PredictiveTrials::code_in_cubes(const LatticeTrial& trial) const {
  if (request_.progress != nullptr) request_.progress->tick();
  auto grid = write_grid(source_.triangles, trial.cells, trial.parameters,
                         request_.start != nullptr ? request_.start->grid.get() : nullptr, request_.known);
  if (!grid) return std::nullopt;
  Candidate candidate = shell(trial);
  candidate.positions = rows_in_order(candidate.positions, grid->vertex_order);
  if (request_.known != nullptr) {
    const auto rows = to_rows(to_positions(grid->surface_cells, trial.parameters.lattice));
    std::copy(rows.begin(), rows.end(), candidate.positions.begin());
  }
  candidate.chunks = ChunkList(request_.profile, request_.effort);
  candidate.chunks.add(kTagGrid, std::exchange(grid->payloads.surface, {}));
  candidate.chunks.add(kTagConnectivity, std::exchange(grid->payloads.rest_faces, {}));
  candidate.grid = std::move(grid);
  candidate.bytes = rest_.bytes_with(candidate);
  return candidate;
}

Candidate PredictiveTrials::code(const LatticeTrial& trial, const std::optional<PositionForm>& form) const {
  if (is_plain()) return finished(shell(trial), write_plain_cells(trial.cells));
  return form ? in_form(*form, shell(trial), writer(trial)) : in_smallest_form(shell(trial), writer(trial));
}

Result<Candidate> PredictiveTrials::code_step(double step) const {
  if (step < finest_step(source_.box))
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "a step so fine takes over 2^28 points along a side; `lossless` keeps every bit"};
  return code(try_lattice(cubic_lattice(source_.box, step)));
}

Candidate PredictiveTrials::code_floats(const std::optional<PositionForm>& form) const {
  Candidate candidate;
  candidate.coder = kGeometryPredictive;
  candidate.predictive.kind = PositionKind::kFloats;
  candidate.positions = to_rows(source_.positions);
  if (is_plain()) return finished(std::move(candidate), write_plain_floats(source_.positions));
  const auto write = [&](const PositionForm& one) {
    return write_floats(faces(), source_.positions, source_.box, one);
  };
  return form ? in_form(*form, std::move(candidate), write) : in_smallest_form(std::move(candidate), write);
}

std::optional<PositionLattice> PredictiveTrials::exact_lattice() const {
  return is_plain() ? std::nullopt : find_exact_lattice(source_.positions, source_.box);
}

Candidate PredictiveTrials::code_exactly(const std::optional<PositionForm>& form) const {
  Candidate floats = code_floats(form);
  const auto lattice = exact_lattice();
  if (!lattice) return floats;
  LatticeTrial trial{.parameters = {.lattice = *lattice}, .cells = to_cells(source_.positions, *lattice)};
  trial.replacements = find_replacements(source_.positions, to_positions(trial.cells, *lattice));
  Candidate on_lattice = code(trial, form);
  return on_lattice.bytes < floats.bytes ? on_lattice : floats;
}

const std::optional<VoxelFit>& PredictiveTrials::voxels() const {
  if (!voxels_ && is_plain()) voxels_.emplace();
  if (!voxels_) {
    voxels_ =
        request_.grid ? fit_to_grid(*request_.grid, values_, source_.box) : fit_voxels(values_, source_.box);
    if (*voxels_) *voxels_ = for_most_faces(**voxels_, values_, source_.triangles);
  }
  return *voxels_;
}

std::uint32_t PredictiveTrials::usual_levels() const noexcept {
  return request_.start != nullptr ? request_.start->levels : 0;
}

}  // namespace deltamesh
