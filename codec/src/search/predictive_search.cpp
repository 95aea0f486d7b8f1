// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/predictive_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/numbers/short_float.h"
#include "base/try.h"
#include "positions/lattice/lattice.h"
#include "search/bracket.h"

namespace deltamesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMostTrials = 10;
constexpr int kDefaultLatticeBits = 12;
constexpr int kFirstLevels = 8;
/// With one face of so many in no cube, or fewer, the grid coder takes fewer bytes than a lattice.
constexpr std::size_t kOneInNoCube = 100;

/// Loads of 0.9995 and 0.997.
constexpr double kLatticeAim = -0.0007;
constexpr double kLatticeTight = -0.0043;
/// One byte in so many of a budget may be left.
constexpr std::uint64_t kOneLeft = 100;
/// On a cubic lattice of so many bits along the longest side positions take nearly as many bytes as floats.
constexpr int kBitsOfFloats = 17;

/// Whether an axis has a grid, and grid_lattice() at `step` or a little above would take it.
bool has_grid(const std::array<AxisGrid, 3>& axes, double step) noexcept {
  return std::any_of(axes.begin(), axes.end(), [step](const AxisGrid& axis) { return axis.step > step / 2; });
}

double largest_side(const VoxelFit& fit) noexcept {
  return *std::max_element(fit.voxel.begin(), fit.voxel.end());
}

/// Heights over a grid have a lattice of their own. But a part of a map on a given grid may be a floor.
bool may_be_heights(const VoxelFit& fit) noexcept {
  constexpr double kMostAlongOneAxis = 0.9;
  return fit.along_one_axis > kMostAlongOneAxis && !fit.is_given;
}

/// Whether most of the mesh is: then the grid coder takes less than any lattice.
bool is_of_cubes(const VoxelFit& fit) noexcept {
  constexpr double kMost = 0.5;  // of the vertices on edges, of the faces in cubes
  return !may_be_heights(fit) && std::min(fit.share, fit.in_cubes) > kMost;
}

/// A side of 10.00005 steps is tried with 10 levels first: it is not known more exactly.
constexpr double kNearlyOne = 1 - 1e-5;

/// The coarsest lattice or the fewest levels that keep the bounds; see search_predictive().
class BoundSearch {
 public:
  explicit BoundSearch(const PredictiveTrials& trials)
      : trials_(trials), bounds_(trials.request().bounds), box_(trials.source().box) {}

  Candidate run() {
    const bool is_quick = trials_.request().effort < kSearchEffort;
    const double step = lattice_step_for(bounds_, box_);
    const auto& voxels = trials_.voxels();
    const bool enough = voxels && are_voxels_enough(trials_);
    if (voxels && (!is_quick || is_of_cubes(*voxels))) {
      keep_smaller(on_voxels(*voxels));
      keep_smaller(on_usual_levels(*voxels));
    }
    if (!best_ || may_be_heights(*voxels))
      if (const auto axes = trials_.axes(step / 8); has_grid(axes, step)) keep_smaller(on_lattice(axes));
    const bool compares = trials_.request().effort >= kThoroughEffort || (!is_quick && !enough);
    const auto faces_in_no_cube = best_ && best_->grid ? best_->grid->rest_triangles : 0;
    if (!best_ || compares || faces_in_no_cube > trials_.source().triangles.size() / 3 / kOneInNoCube)
      keep_smaller(on_lattice({}));
    // Lattices end where floats do.
    return best_ ? *std::move(best_) : trials_.code_exactly();
  }

 private:
  void keep_smaller(std::optional<Candidate> candidate) {
    if (candidate && (!best_ || candidate->bytes < best_->bytes)) best_ = std::move(candidate);
  }

  double tolerance() const noexcept {
    return trials_.request().effort < kSearchEffort ? -kInfinity : kLatticeTight;
  }

  /// On a cubic lattice but for `axes` with steps of their own; empty where none keeps the bounds.
  std::optional<Candidate> on_lattice(const std::array<AxisGrid, 3>& axes) const {
    Bracket bracket({.first = lattice_step_for(bounds_, box_),
                     .aim = kLatticeAim,
                     .tolerance = tolerance(),
                     .trials = kMostTrials});
    std::optional<LatticeTrial> best;
    std::array<double, 3> last_steps{};
    while (!bracket.is_done()) {
      const PositionLattice lattice = grid_lattice(box_, axes, short_float_below(bracket.setting()));
      if (lattice.step == last_steps) break;
      last_steps = lattice.step;
      LatticeTrial trial = trials_.try_lattice(lattice, bounds_);
      const double load = bounds_.load(trial.quality);
      if (bracket.tell(excess_of_load(load))) best = std::move(trial);
      if (load == 0) break;
    }
    return best ? std::optional(trials_.code(*best, trials_.request().form)) : std::nullopt;
  }

  std::optional<Candidate> on_voxels(const VoxelFit& fit) const {
    // A vertex is off along its edge only, by half a level at most, which is a step; see lattice_step_for().
    const double step = lattice_step_for(bounds_, box_) * std::sqrt(3.0);
    Bracket bracket({.first = std::max(std::ceil(kNearlyOne * largest_side(fit) / step), 1.0),
                     .least = 1,
                     .most = kMostLevels,
                     .whole = true,
                     .slope = -1,
                     .tolerance = tolerance(),
                     .trials = kMostTrials});
    std::optional<LatticeTrial> best;
    while (!bracket.is_done()) {
      auto trial = trials_.try_levels(fit, static_cast<std::uint32_t>(bracket.setting()), bounds_);
      // More than the grid has room for would be good enough.
      if (bracket.tell(trial ? excess_of_load(bounds_.load(trial->quality)) : -kInfinity))
        best = std::move(trial);
    }
    return best ? trials_.code_in_cubes(*best) : std::nullopt;
  }

  /// As many levels as the starting states know, if these keep the bounds. Empty where the best has as many.
  std::optional<Candidate> on_usual_levels(const VoxelFit& fit) const {
    const std::uint32_t levels = trials_.usual_levels();
    if (levels == 0 || (best_ && best_->predictive.levels == levels)) return std::nullopt;
    const auto trial = trials_.try_levels(fit, levels, bounds_);
    if (!trial || bounds_.load(trial->quality) > 1) return std::nullopt;
    return trials_.code_in_cubes(*trial);
  }

  const PredictiveTrials& trials_;
  const Bounds& bounds_;
  const Box& box_;
  std::optional<Candidate> best_;
};

/// The finest lattice or the most levels that fit a number of bytes.
class BudgetSearch {
 public:
  explicit BudgetSearch(const PredictiveTrials& trials) : trials_(trials) {}

  Result<Candidate> run() {
    const auto& voxels = trials_.voxels();
    if (voxels) fit_levels(*voxels);
    if (!best_ || !is_of_cubes(*voxels)) fit_lattice();
    if (!best_ || may_fit_exactly()) fit_exactly();
    if (!best_) return too_few_bytes(fewest_);
    return *std::move(best_);
  }

 private:
  std::uint64_t budget() const noexcept { return *trials_.request().target_bytes; }
  double excess(std::uint64_t bytes) const noexcept {
    return excess_of_bytes(bytes, budget(), trials_.source().positions.size());
  }
  double tolerance() const noexcept { return excess(budget() - budget() / kOneLeft); }

  /// `code(setting)`: a candidate, or none where the setting is finer than can be. Of those that fit the
  /// finest is considered, if any does: the VDE of a few coarse steps says little.
  template <class Code>
  bool fit(const BracketPlan& plan, const Code& code) {
    std::optional<Candidate> finest;
    Bracket bracket(plan);
    while (!bracket.is_done()) {
      std::optional<Candidate> candidate = code(bracket.setting());
      if (candidate) fewest_ = std::min(fewest_, candidate->bytes);
      if (bracket.tell(candidate ? excess(candidate->bytes) : kInfinity)) finest = std::move(candidate);
    }
    if (!finest) return false;
    consider(*std::move(finest));
    return true;
  }

  void consider(Candidate candidate) {
    fewest_ = std::min(fewest_, candidate.bytes);
    if (candidate.bytes <= budget() && (!best_ || candidate.quality.vde_rms < best_->quality.vde_rms))
      best_ = std::move(candidate);
  }

  /// Whether exact positions may be as small as what fits, which is nearly as fine as they are.
  bool may_fit_exactly() const {
    const auto own = trials_.exact_lattice();
    double finest = trials_.step_for_bits(kBitsOfFloats);
    if (own) finest = std::max(finest, *std::max_element(own->step.begin(), own->step.end()));
    const auto& steps = best_->predictive.lattice.step;
    return *std::max_element(steps.begin(), steps.end()) < 2 * finest;
  }

  /// The smallest form saves a tenth of one at most.
  void fit_exactly() {
    constexpr PositionForm kOne{.fit = BlendFit::kSample, .guesses = Guessing::kPrediction};
    const std::uint64_t in_one_form = trials_.code_exactly(kOne).bytes;
    fewest_ = std::min(fewest_, in_one_form);
    if (in_one_form / 10 * 9 <= budget()) consider(trials_.code_exactly());
  }

  /// Where axes have a grid, as heights have, lattices that keep it come first, and others only if none of
  /// them fits: without the grid a coarser lattice takes more bytes.
  void fit_lattice() {
    const double first = trials_.step_for_bits(kDefaultLatticeBits);
    const std::array<AxisGrid, 3> axes = trials_.axes(first / 8);
    double coarsest = 0;
    for (const AxisGrid& axis : axes) coarsest = std::max(coarsest, coarsest_step_on(axis));
    if (coarsest > 0 && fit_lattice(axes, std::min(first, coarsest), coarsest)) return;
    const double side = std::max(trials_.source().box.longest_side(), 1e-30);
    fit_lattice({}, first, 2 * side);  // where all coordinates are 0
  }

  bool fit_lattice(const std::array<AxisGrid, 3>& axes, double first, double most) {
    const Box& box = trials_.source().box;
    return fit({.first = first,
                .least = std::max(finest_step(box), 1e-30),
                .most = most,
                .slope = -1,
                .aim = tolerance() / 2,
                .tolerance = tolerance(),
                .trials = kMostTrials},
               [&](double step) {
                 const auto form = form_.at(step);
                 Candidate candidate = trials_.code(
                     trials_.try_lattice(grid_lattice(box, axes, short_float_below(step))), form);
                 if (!form) form_.chosen(candidate.form, step);
                 return std::optional(std::move(candidate));
               });
  }

  void fit_levels(const VoxelFit& voxels) {
    fit({.first = kFirstLevels,
         .least = 1,
         .most = kMostLevels,
         .whole = true,
         .slope = 1.0 / 3,  // one coordinate costs a bit more where the levels double
         .tolerance = tolerance(),
         .trials = kMostTrials},
        [&](double levels) {
          const auto trial = trials_.try_levels(voxels, static_cast<std::uint32_t>(levels));
          return trial ? trials_.code_in_cubes(*trial) : std::nullopt;
        });
  }

  const PredictiveTrials& trials_;
  ChosenForm form_;  ///< by the step
  std::optional<Candidate> best_;
  std::uint64_t fewest_ = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace

double lattice_step_for(const Bounds& bounds, const Box& box) noexcept {
  double step = std::max(box.longest_side(), 1e-30);
  // Half a step per axis is the most; a uniform error of one step has a variance of 1/12, and a vertex's
  // neighbours add a little to what is seen at it.
  if (bounds.max_error) step = std::min(step, 2 / std::sqrt(3.0) * *bounds.max_error);
  if (bounds.lfe) step = std::min(step, 2 * *bounds.lfe);
  if (bounds.vde) step = std::min(step, 1.85 * *bounds.vde);
  return step > 0 ? step : 1.0;  // a bound in percent of nothing
}

bool are_voxels_enough(const PredictiveTrials& trials) {
  constexpr double kMuchFiner = 0.25;  // than the lattice: then a plane of voxels means nothing
  const auto& voxels = trials.voxels();
  return voxels && is_of_cubes(*voxels) &&
         largest_side(*voxels) > kMuchFiner * lattice_step_for(trials.request().bounds, trials.source().box);
}

Result<Candidate> search_predictive(const PredictiveTrials& trials) {
  const Request& request = trials.request();
  if (request.lossless) return trials.code_exactly();
  if (request.has_bounds()) {
    Candidate candidate = BoundSearch(trials).run();
    if (request.target_bytes && candidate.bytes > *request.target_bytes)
      return too_few_bytes_for_bounds(candidate.bytes);
    return candidate;
  }
  if (request.target_bytes) return BudgetSearch(trials).run();
  if (request.step) return trials.code_step(*request.step);
  const int bits = request.bits.value_or(kDefaultLatticeBits);
  DELTAMESH_TRY(Candidate candidate, trials.code_step(trials.step_for_bits(bits)));
  candidate.predictive.bits = static_cast<std::uint8_t>(bits);
  return candidate;
}

}  // namespace deltamesh
