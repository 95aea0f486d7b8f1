// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/face_matching.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "measure/face_claim.h"
#include "measure/tree/point_tree.h"

namespace deltamesh {
namespace {

class FaceMatcher {
 public:
  FaceMatcher(const FaceGraph& a, const FaceGraph& b, const VertexDifference& difference)
      : a_(a),
        b_(b),
        difference_(difference),
        tree_(a.welded_positions),
        taken_(a.face_count()),
        left_(a.face_count()),
        trial_faces_left_(kTrialFaces * kTrials * 64 + 32 * b.face_count()),
        matches_(b.face_count()),
        placed_(b.positions.size(), kNowhere) {}

  std::vector<FaceMatch> run() {
    // Faces that A may not have wait until the others have taken theirs.
    const std::vector<std::uint32_t> order = longest_first();
    for (const bool far : {false, true})
      for (const std::uint32_t face : order) {
        if (left_ == 0) break;
        if (matches_[face].face == kNoFace) start_at(face, far);
      }
    return std::move(matches_);
  }

 private:
  std::vector<std::uint32_t> longest_first() const {
    std::vector<std::pair<double, std::uint32_t>> faces(b_.face_count());
    for (std::uint32_t f = 0; f < faces.size(); ++f) faces[f] = {-b_.longest_edge(f), f};
    std::sort(faces.begin(), faces.end());
    std::vector<std::uint32_t> order;
    order.reserve(faces.size());
    for (const auto& [size, face] : faces) order.push_back(face);
    return order;
  }

  bool is_point(const FaceGraph& graph, std::uint32_t face) const noexcept {
    return face >= graph.real_faces;
  }

  Claim claim(std::uint32_t b, std::uint32_t a, std::uint8_t rotation, bool choice) const {
    Claim made;
    made.b = b;
    made.a = a;
    made.rotation = rotation;
    made.conflicts = conflicts(made);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t other = (k + rotation) % 3;
      const Vec3 apart = b_.at(b, k) - a_.at(a, other);
      made.cost += dot(apart, apart);
      if (choice && difference_)
        made.difference +=
            difference_(a_.vertices[3 * std::size_t{a} + other], b_.vertices[3 * std::size_t{b} + k]);
    }
    return made;
  }

  std::uint8_t conflicts(const Claim& c) const noexcept {
    std::uint8_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t place = placed_[b_.vertices[3 * std::size_t{c.b} + k]];
      if (place != kNowhere && place != a_corner(c, k)) ++count;
    }
    return count;
  }

  /// A's welded vertex for corner `k` of B's face.
  std::uint32_t a_corner(const Claim& c, std::size_t k) const noexcept {
    return a_.corners[3 * std::size_t{c.a} + (k + c.rotation) % 3];
  }

  /// Calls visit(claim) for what `at` says of the faces across the edge of B's corner `k`.
  template <class Visit>
  void across(const Claim& at, std::size_t k, Visit visit) const {
    const FacesAcross of_b = b_.across(at.b, k);
    if (of_b.size == 0) return;
    const FacesAcross of_a = a_.across(at.a, (k + at.rotation) % 3);
    const bool shared = of_a.any_shared() && of_b.any_shared();
    const bool choice = of_a.size > 1 || of_b.size > 1;
    for (const FaceAcross& b : of_b)
      for (const FaceAcross& a : of_a) {
        if (a.same_way != b.same_way || (shared && !(a.shared && b.shared))) continue;
        Claim next = claim(b.face, a.face, rotation_between(b.corner, a.corner), choice);
        next.doubt = shared ? 0 : choice ? 2 : 1;
        visit(next);
      }
  }

  bool is_free(const Claim& c) const noexcept { return matches_[c.b].face == kNoFace && taken_[c.a] == 0; }

  /// Free faces of A around the vertices nearest to a corner of `face`, or around those that earlier matches
  /// say its corners are; best first. `most`: squared distance beyond which vertices do not count.
  std::vector<Claim> candidates(std::uint32_t face, double most) {
    // The corner with the fewest faces, so that hubs cost nothing.
    const std::size_t first = 3 * std::size_t{face};
    std::size_t corner = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (b_.around(b_.corners[first + k]).size() < b_.around(b_.corners[first + corner]).size()) corner = k;
    tree_.nearest(b_.at(face, corner), kNearVertices, near_, most);
    std::vector<Claim> found;
    for (const NearPoint& near : near_) add_candidates(face, corner, near.point, found);
    for (std::size_t k = 0; k < 3; ++k)
      if (placed_[b_.vertices[first + k]] != kNowhere)
        add_candidates(face, k, placed_[b_.vertices[first + k]], found);
    std::sort(found.begin(), found.end(), nearer);
    const auto same = [](const Claim& x, const Claim& y) { return x.a == y.a && x.rotation == y.rotation; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    // The next one is four times as far where there can be no doubt.
    while (found.size() > 1 && (found.size() > kTrials || found.back().cost > kNoDoubt * found.front().cost))
      found.pop_back();
    return found;
  }

  void add_candidates(std::uint32_t face, std::size_t corner, std::uint32_t vertex,
                      std::vector<Claim>& found) const {
    for (const std::uint32_t other : a_.around(vertex)) {
      if (taken_[other] != 0 || is_point(a_, other) != is_point(b_, face)) continue;
      for (std::size_t k = 0; k < 3; ++k)
        if (a_.corners[3 * std::size_t{other} + k] == vertex)
          found.push_back(claim(face, other, rotation_between(corner, k), true));
    }
  }

  /// Mean cost of the claims that follow from `start` in its neighbourhood; borders that do not fit cost too.
  /// `noise`: what the best claim costs, part of the price of a border.
  double trial_cost(const Claim& start, double noise) {
    std::vector<Claim> visited{start};
    double sum = 0;
    for (std::size_t i = 0; i < visited.size(); ++i) {
      const Claim at = visited[i];
      sum += at.cost;
      for (std::size_t k = 0; k < 3; ++k) {
        if (b_.across(at.b, k).any_shared() != a_.across(at.a, (k + at.rotation) % 3).any_shared()) {
          const Vec3 edge = b_.at(at.b, (k + 1) % 3) - b_.at(at.b, k);
          sum += 16 * (dot(edge, edge) + noise);
        }
        across(at, k, [&](const Claim& next) {
          const auto known = [&](const Claim& c) { return c.b == next.b || c.a == next.a; };
          if (visited.size() < kTrialFaces && std::none_of(visited.begin(), visited.end(), known))
            visited.push_back(next);
        });
      }
    }
    trial_faces_left_ -= std::min(trial_faces_left_, visited.size());
    return sum / static_cast<double>(visited.size());
  }

  /// `far`: also where all candidates are a good part of an edge away.
  void start_at(std::uint32_t face, bool far) {
    const double edge = b_.longest_edge(face);
    const double most_cost = far ? std::numeric_limits<double>::infinity() : edge * edge / 4;
    const std::vector<Claim> found = candidates(face, kNoDoubt * most_cost);
    if (found.empty() || found.front().cost > most_cost) return;
    Claim best = found.front();
    if (found.size() > 1 && trial_faces_left_ > 0) {
      double lowest = std::numeric_limits<double>::infinity();
      for (const Claim& c : found) {
        const double cost = trial_cost(c, found.front().cost);
        if (c.conflicts > best.conflicts || (c.conflicts == best.conflicts && cost >= lowest)) continue;
        lowest = cost;
        best = c;
      }
    }
    flood(best);
  }

  void flood(const Claim& start) {
    std::priority_queue<Claim, std::vector<Claim>, std::greater<>> open;
    open.push(start);
    double sum = 0;
    std::size_t count = 0;
    while (!open.empty()) {
      Claim at = open.top();
      open.pop();
      if (!is_free(at)) continue;
      if (const std::uint8_t now = conflicts(at); now > at.conflicts) {
        at.conflicts = now;
        open.push(at);
        continue;
      }
      if (at.conflicts > start.conflicts && at.cost * static_cast<double>(count) > 16 * sum) continue;
      commit(at);
      sum += at.cost;
      ++count;
      for (std::size_t k = 0; k < 3; ++k)
        across(at, k, [&](const Claim& next) {
          if (is_free(next)) open.push(next);
        });
    }
  }

  void commit(const Claim& c) {
    matches_[c.b] = {.face = c.a, .rotation = c.rotation};
    taken_[c.a] = 1;
    --left_;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& place = placed_[b_.vertices[3 * std::size_t{c.b} + k]];
      if (place == kNowhere) place = a_corner(c, k);
    }
  }

  static constexpr std::uint32_t kNowhere = 0xffffffff;
  static constexpr std::size_t kNearVertices = 16;
  static constexpr std::size_t kTrials = 24;
  static constexpr double kNoDoubt = 16;  ///< so many times the cost of the best: no candidate
  static constexpr std::size_t kTrialFaces = 32;

  const FaceGraph& a_;
  const FaceGraph& b_;
  const VertexDifference& difference_;
  PointTree tree_;
  std::vector<std::uint8_t> taken_;
  std::size_t left_ = 0;              ///< faces of A that are not taken
  std::size_t trial_faces_left_ = 0;  ///< a bound on the work where nothing fits
  std::vector<FaceMatch> matches_;
  std::vector<std::uint32_t> placed_;  ///< for each vertex of B the welded one of A, or kNowhere
  std::vector<NearPoint> near_;
};

}  // namespace

std::vector<FaceMatch> match_faces(const FaceGraph& a, const FaceGraph& b,
                                   const VertexDifference& difference) {
  return FaceMatcher(a, b, difference).run();
}

}  // namespace deltamesh
