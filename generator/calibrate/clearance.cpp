// SPDX-License-Identifier: MIT
#include "calibrate/clearance.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace qvgen::calibrate {
namespace {

double length(const Vec<double>& v) { return std::sqrt(dot(v, v)); }

std::string name_of(std::size_t link) { return link == 0 ? "the base" : fmt::format("link {}", link); }

}  // namespace

Clearance::Clearance(const Geometry<double>& geometry, const std::vector<Sphere>& spheres, double least)
    : geometry_(geometry), spheres_(spheres) {
  for (std::size_t a = 0; a < spheres.size(); ++a)
    for (std::size_t b = 0; b < spheres.size(); ++b)
      if (spheres[a].link + 1 < spheres[b].link)
        pairs_.push_back({a, b, spheres[a].radius + spheres[b].radius + least});
}

std::vector<Vec<double>> Clearance::centres_at(const std::vector<double>& q) const {
  const Posture<double> posture = posture_of(geometry_, q.data());
  std::vector<Rigid<double>> links{identity(1.0)};
  for (std::size_t i = 0; i < geometry_.joints.size(); ++i) {
    const Vec<double>& axis = geometry_.gaps[i].directions[2];
    const CosSin<double>& circular = posture.circular[i];
    links.push_back(links.back() * geometry_.gaps[i].way *
                    (geometry_.joints[i].revolute ? turn(axis, circular.cosine, circular.sine, 1.0)
                                                  : shift(posture.values[i] * axis, 1.0)));
  }
  std::vector<Vec<double>> centres;
  for (const Sphere& each : spheres_) centres.push_back(links[each.link] * each.centre);
  return centres;
}

double Clearance::gap(const Pair& pair, const std::vector<Vec<double>>& centres) {
  return length(centres[pair.a] - centres[pair.b]) - pair.distance;
}

bool Clearance::kept_at(const std::vector<double>& q) const {
  const std::vector<Vec<double>> centres = centres_at(q);
  return std::all_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) { return gap(pair, centres) >= 0; });
}

/// A sphere goes about each turn between the two links on a circle no larger than all that is in between
/// stretched out.
double Clearance::speed(const Pair& pair, const std::vector<double>& by,
                        const std::vector<double>& slides) const {
  const Sphere& moved = spheres_[pair.b];
  double radius = length(moved.centre), sum = 0;
  for (std::size_t i = moved.link; i-- > spheres_[pair.a].link;) {
    sum += geometry_.joints[i].revolute ? by[i] * radius : by[i];
    radius += length(geometry_.gaps[i].way.position) + slides[i];
  }
  return sum;
}

std::vector<double> Clearance::speeds(const std::vector<double>& from, const std::vector<double>& to) const {
  const std::vector<double> start = posture_of(geometry_, from.data()).values,
                            end = posture_of(geometry_, to.data()).values;
  std::vector<double> by, slides, result;
  for (std::size_t i = 0; i < start.size(); ++i) {
    by.push_back(std::abs(end[i] - start[i]));
    slides.push_back(geometry_.joints[i].revolute ? 0 : std::max(std::abs(start[i]), std::abs(end[i])));
  }
  for (const Pair& pair : pairs_) result.push_back(speed(pair, by, slides));
  return result;
}

bool Clearance::kept_between(const std::vector<double>& from, const std::vector<double>& to) const {
  constexpr double shortest_step = 1e-4;  // which bounds the number of steps
  const std::vector<double> fastest = speeds(from, to);
  std::vector<double> q(from.size());
  for (double share = 0; share <= 1;) {
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = from[i] + share * (to[i] - from[i]);
    const std::vector<Vec<double>> centres = centres_at(q);
    double step = 1;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const double left = gap(pairs_[k], centres);
      if (left < 0) return false;
      if (fastest[k] > 0) step = std::min(step, left / fastest[k]);
    }
    if (step < shortest_step) return false;
    share += step;
  }
  return kept_at(to);
}

std::string Clearance::words(const Pair& pair) const {
  return name_of(spheres_[pair.a].link) + " and " + name_of(spheres_[pair.b].link);
}

std::vector<std::string> Clearance::leave_out_constant(const std::vector<std::vector<double>>& postures) {
  std::vector<bool> constant(pairs_.size(), !postures.empty());
  for (const std::vector<double>& q : postures) {
    const std::vector<Vec<double>> centres = centres_at(q);
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      if (gap(pairs_[k], centres) >= 0) constant[k] = false;
  }
  std::vector<std::string> names;
  std::vector<Pair> kept;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (!constant[k]) {
      kept.push_back(pairs_[k]);
    } else if (const std::string name = words(pairs_[k]);
               std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  }
  pairs_ = std::move(kept);
  return names;
}

std::string Clearance::nearest_links(const std::vector<std::vector<double>>& postures) const {
  std::vector<std::size_t> near(pairs_.size(), 0);
  for (const std::vector<double>& q : postures) {
    const std::vector<Vec<double>> centres = centres_at(q);
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      if (gap(pairs_[k], centres) < 0) ++near[k];
  }
  return words(pairs_[static_cast<std::size_t>(std::max_element(near.begin(), near.end()) - near.begin())]);
}

}  // namespace qvgen::calibrate
