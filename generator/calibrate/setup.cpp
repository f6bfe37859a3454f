// SPDX-License-Identifier: MIT
#include "calibrate/setup.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace qvgen::calibrate {
namespace {

constexpr std::array axes{"x", "y", "z"};

class Builder {
 public:
  Builder(const Geometry<double>& geometry, const Setup& setup) : geometry_(geometry), setup_(setup) {}

  std::vector<Parameter> all() {
    if (setup_.has_tracker() && !setup_.tracker_known) add_frame(0, 0, Kind::tracker_shift, "tracker", true);
    for (std::size_t gap = 1; gap <= geometry_.joints.size(); ++gap) add_gap(gap);
    const std::size_t tool = geometry_.joints.size() + 1;
    if (setup_.errors == Errors::all) add_frame(tool, 0, Kind::tool_shift, "tool", true);
    if (setup_.errors == Errors::lengths) add_frame(tool, 0, Kind::tool_shift, "tool", false);
    if (!setup_.target_known)
      for (std::size_t i = 0; i < setup_.targets; ++i)
        add_frame(tool + 1, i, Kind::target_shift,
                  setup_.targets > 1 ? fmt::format("target {}", i + 1) : "target", setup_.has_orientation());
    for (std::size_t i = 0; i < setup_.surfaces; ++i) add_surface(i);
    return std::move(parameters_);
  }

 private:
  void add(Kind kind, std::size_t gap, std::size_t direction, bool turns, std::string name) {
    const bool nuisance = kind >= Kind::tracker_shift;
    parameters_.push_back({kind, gap, direction, 0, std::move(name), turns, nuisance});
  }

  /// Adds three shifts of a frame, and three turns. The kind of turns is the next one.
  void add_frame(std::size_t gap, std::size_t object, Kind shift, const std::string& name, bool turns) {
    const Kind turn = static_cast<Kind>(static_cast<int>(shift) + 1);
    for (std::size_t i = 0; i < 3; ++i)
      add(shift, gap, i, false, fmt::format("the {} along {}", name, axes.at(i)));
    for (std::size_t i = 0; turns && i < 3; ++i)
      add(turn, gap, i, true, fmt::format("the {}'s turn about {}", name, axes.at(i)));
    for (std::size_t i = parameters_.size() - (turns ? 6 : 3); i < parameters_.size(); ++i)
      parameters_[i].object = object;
  }

  void add_gap(std::size_t gap) {
    const bool slides = !geometry_.joints[gap - 1].revolute;
    const bool follows = is_follower(gap - 1);
    const std::string link = gap == 1 ? "the base" : fmt::format("link {}", gap - 1);
    if (setup_.errors != Errors::zeros) {
      add(Kind::length, gap, 0, false, "the length of " + link);
      add(Kind::shift, gap, 1, false, fmt::format("the sideways shift of axis {}", gap));
      if (!slides) add(Kind::offset, gap, 2, false, "the offset of " + link);
    }
    if (setup_.errors == Errors::all) {
      add(Kind::twist, gap, 0, true, "the twist of " + link);
      add(Kind::tilt, gap, 1, true, fmt::format("the tilt of axis {}", gap));
      if (slides) add(Kind::swing, gap, 2, true, fmt::format("the turn of joint {} about its axis", gap));
    }
    add(Kind::zero, gap, 2, !slides, fmt::format("the zero of joint {}", gap));
    if (setup_.eccentric && !slides && !follows) {
      add(Kind::eccentric_cosine, gap, 2, true, fmt::format("the eccentricity of gear {} (cosine)", gap));
      add(Kind::eccentric_sine, gap, 2, true, fmt::format("the eccentricity of gear {} (sine)", gap));
    }
    if (setup_.bending && !slides && !follows && geometry_.greatest_loads[gap - 1] > 0)
      add(Kind::bend, gap, 2, true,
          fmt::format("the bend of joint {} under {:.4g} Nm", gap, geometry_.greatest_loads[gap - 1]));
  }

  [[nodiscard]] bool is_follower(std::size_t joint) const { return !geometry_.joints[joint].is_variable(); }

  void add_surface(std::size_t object) {
    static constexpr std::array plane{"first tilt", "second tilt", "place"};
    static constexpr std::array sphere{"centre along x", "centre along y", "centre along z", "radius"};
    const std::size_t count = setup_.data == Data::sphere ? 4 : 3;
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_plane = setup_.data == Data::plane;
      const std::string what = is_plane ? "plane" : setup_.data == Data::sphere ? "sphere" : "fixed point";
      add(Kind::surface, geometry_.joints.size() + 3, i, is_plane && i < 2,
          fmt::format("the {} of {} {}", is_plane ? plane.at(i) : sphere.at(i), what, object + 1));
      parameters_.back().object = object;
    }
  }

  const Geometry<double>& geometry_;
  const Setup& setup_;
  std::vector<Parameter> parameters_;
};

int rank_of(const Parameter& each) {
  if (each.nuisance) return 0;
  if (each.kind == Kind::zero && each.turn) return 1;
  if (each.kind == Kind::zero) return 2;
  return 3 + static_cast<int>(each.kind);
}

}  // namespace

std::vector<Parameter> parameters_of(const Geometry<double>& geometry, const Setup& setup) {
  return Builder(geometry, setup).all();
}

std::vector<std::size_t> priority_of(const std::vector<Parameter>& parameters) {
  std::vector<std::size_t> order(parameters.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rank_of(parameters[a]) < rank_of(parameters[b]);
  });
  return order;
}

}  // namespace qvgen::calibrate
