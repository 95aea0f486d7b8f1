// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "drive.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "field/noise.h"
#include "field/scan.h"
#include "generators.h"
#include "rooms.h"
#include "scenes.h"

namespace deltamesh {
namespace {

using scenes::Item;
using scenes::kUnobserved;
using scenes::Lattice;
using scenes::Point;
using scenes::smooth_noise;

constexpr double kMetresPerStep = 0.5 * kDriveStepSeconds;
constexpr double kCameraHeight = 1.2;
constexpr double kRange = 3;  ///< metres
constexpr double kConeCosine = 0.75;
constexpr double kPersonAhead = 1.4;  ///< metres along the path
constexpr std::uint8_t kMostWeight = 40;
constexpr double kGrain = 0.1;   ///< voxels: noise of each node and step
constexpr double kDrift = 0.04;  ///< voxels: of a step, smooth

double dot(const Point& a, const Point& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// What all of a building's viewpoints see.
std::vector<float> scan_all(const scenes::Building& building, const Lattice& lattice, std::uint64_t seed) {
  scenes::Scan scan(building, lattice, seed);
  std::vector<float> values;
  values.reserve(lattice.nodes[0] * lattice.layer_size());
  for (std::uint32_t i = 0; i < lattice.nodes[0]; ++i) {
    const auto layer = scan.layer(i);
    values.insert(values.end(), layer.begin(), layer.end());
  }
  return values;
}

Item person_at(const Point& place) {
  return {Item::Shape::kCylinder, {place.x, place.y, 0.85}, {0.22, 0, 0.8}, {}};
}

bool same_surface(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

}  // namespace

Result<Drive> Drive::make(std::uint64_t vertices, std::uint64_t seed) {
  if (vertices < kMinSceneVertices || vertices > kMaxDriveVertices)
    return Error{.code = ErrorCode::kInvalidArgument, .message = "a drive has 12 to 1000000 vertices"};
  scenes::Random random(seed);
  const scenes::RoomsPlan plan = scenes::plan_rooms(vertices);
  const std::uint64_t building_seed = random.bits();
  return Drive(scenes::make_building(plan, building_seed), plan.voxel, random.bits());
}

Drive::Drive(scenes::Building building, double voxel, std::uint64_t seed)
    : building_(std::move(building)), lattice_(scenes::lattice_around(building_, voxel)), seed_(seed) {
  still_ = scan_all(building_, lattice_, seed_);
  mapped_.assign(still_.size(), kUnobserved);
  weight_.assign(still_.size(), 0);
  plan_path();
}

void Drive::plan_path() {
  for (const scenes::Room& room : building_.rooms()) {
    path_.push_back(0.5 * (room.low + room.high));
    path_.insert(path_.end(), room.viewpoints.begin(), room.viewpoints.end());
  }
  path_.push_back(path_.front() + Point{0.5, 0, 0});
  for (Point& p : path_) p.z = kCameraHeight;
}

/// On the closed path, so far from its beginning.
Point Drive::place_at(double metres) const {
  double whole = 0;
  for (std::size_t i = 0; i < path_.size(); ++i) whole += length(path_[(i + 1) % path_.size()] - path_[i]);
  double rest = metres - whole * std::floor(metres / whole);
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const Point side = path_[(i + 1) % path_.size()] - path_[i];
    const double size = length(side);
    if (rest < size) return path_[i] + (rest / size) * side;
    rest -= size;
  }
  return path_.front();
}

SequenceStep Drive::next() {
  ++step_;
  std::set<SequenceBlockId> touched;
  observe(touched);
  SequenceStep update;
  for (const SequenceBlockId& id : touched) {
    Mesh mesh = mesh_of(id);
    const auto known = blocks_.find(id);
    if (mesh.triangles.empty()) {
      if (known == blocks_.end()) continue;
      update.removed.push_back(id);
      blocks_.erase(known);
    } else if (known == blocks_.end() || !same_surface(mesh, known->second)) {
      blocks_[id] = mesh;
      update.changed.push_back({id, std::move(mesh)});
    }
  }
  return update;
}

/// Sees the nodes of the robot's room in a cone ahead. Nodes whose value changes touch every block with a
/// cube at them.
void Drive::observe(std::set<SequenceBlockId>& touched) {
  const double driven = kMetresPerStep * step_;
  const Point eye = place_at(driven);
  const Point ahead = place_at(driven + 0.3) - eye;
  const Point gaze = (1 / std::max(length(ahead), 1e-6)) * ahead;
  const scenes::Room* room = &building_.room_at(eye);
  const Item person = person_at(place_at(driven + kPersonAhead));
  const auto range_of = [&](double at, double base, std::uint32_t nodes) {
    const double low = std::max(std::floor((at - kRange - base) / lattice_.voxel), 0.0);
    const double high = std::min(std::ceil((at + kRange - base) / lattice_.voxel), nodes - 1.0);
    return std::pair(static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(std::max(high, low)));
  };
  const auto [i0, i1] = range_of(eye.x, lattice_.base.x, lattice_.nodes[0]);
  const auto [j0, j1] = range_of(eye.y, lattice_.base.y, lattice_.nodes[1]);
  for (std::uint32_t i = i0; i <= i1; ++i) {
    for (std::uint32_t j = j0; j <= j1; ++j) {
      if (&building_.room_at(lattice_.at(i, j, 0)) != room) continue;
      for (std::uint32_t k = 0; k < lattice_.nodes[2]; ++k) {
        const Point p = lattice_.at(i, j, k);
        const double away = length(p - eye);
        if (away > kRange || dot(p - eye, gaze) < kConeCosine * away) continue;
        if (!observe_node(node_at(i, j, k), p, person)) continue;
        const auto block = [](std::uint32_t n) { return static_cast<std::int32_t>(n / kDriveBlockVoxels); };
        for (unsigned corner = 0; corner < 8; ++corner)
          touched.insert({block(i - std::min(i, corner & 1)), block(j - std::min(j, corner >> 1 & 1)),
                          block(k - std::min(k, corner >> 2))});
      }
    }
  }
}

/// Returns whether the node's value has changed.
bool Drive::observe_node(std::size_t node, const Point& p, const Item& person) {
  const double truncation = 3 * lattice_.voxel;
  const double to_person = distance(person, p);
  double value = still_[node];
  if (std::fabs(to_person) < truncation) value = std::min(value, to_person);
  float& mapped = mapped_[node];
  if (value == double{kUnobserved}) {
    const bool was_known = mapped != kUnobserved;
    mapped = kUnobserved;
    weight_[node] = 0;
    return was_known;
  }
  const auto place = static_cast<std::int64_t>(node);
  value += lattice_.voxel * (kGrain * scenes::place_noise(place, step_, 0, seed_ + 7) +
                             kDrift * smooth_noise(0.7 * p, seed_ + 100 + step_));
  // What moved by more than noise is new.
  if (mapped == kUnobserved || std::fabs(value - double{mapped}) > lattice_.voxel) {
    mapped = static_cast<float>(value);
    weight_[node] = 1;
    return true;
  }
  weight_[node] = static_cast<std::uint8_t>(std::min(weight_[node] + 1, int{kMostWeight}));
  const float before = mapped;
  mapped = static_cast<float>(double{mapped} + (value - double{mapped}) / weight_[node]);
  return mapped != before;
}

Mesh Drive::mesh_of(const SequenceBlockId& id) const {
  Lattice piece = lattice_;
  std::array<std::uint32_t, 3> first{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<std::uint32_t>(id[axis]) * kDriveBlockVoxels;
    piece.nodes[axis] = std::min(kDriveBlockVoxels + 1, lattice_.nodes[axis] - first[axis]);
  }
  piece.first = {static_cast<double>(first[0]), static_cast<double>(first[1]), static_cast<double>(first[2])};
  std::vector<float> layer(piece.layer_size());
  scenes::Surface surface = scenes::march_cubes(piece, [&](std::uint32_t i) {
    for (std::uint32_t j = 0; j < piece.nodes[1]; ++j)
      for (std::uint32_t k = 0; k < piece.nodes[2]; ++k)
        layer[std::size_t{j} * piece.nodes[2] + k] =
            mapped_[node_at(first[0] + i, first[1] + j, first[2] + k)];
    return std::span<const float>(layer);
  });
  Mesh mesh;
  mesh.positions = std::move(surface.positions);
  mesh.triangles = std::move(surface.triangles);
  std::vector<std::uint8_t> colors;
  for (std::size_t v = 0; v < mesh.positions.size(); v += 3) {
    const Point p{mesh.positions[v], mesh.positions[v + 1], mesh.positions[v + 2]};
    const double light = 4 * smooth_noise((1 / lattice_.voxel) * p, seed_ + 8);
    for (const std::uint8_t c : building_.color_at(p, seed_))
      colors.push_back(static_cast<std::uint8_t>(std::clamp(c + light, 0.0, 255.0)));
  }
  scenes::add_attribute<std::uint8_t>(mesh, AttributeKind::kColor, ComponentType::kU8, 3, "red", colors);
  return mesh;
}

}  // namespace deltamesh
