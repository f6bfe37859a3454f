// SPDX-License-Identifier: MIT
// Measurements, and the parameters that are asked for.
#pragma once

#include "calibrate/chain.h"

namespace qvgen::calibrate {

enum class Data {
  pose,      ///< of a target, by a tracker
  position,  ///< of a target, by a tracker
  camera,    ///< of a board that stands still, by a camera on the tool
  distance,  ///< from a fixed point to a target
  plane,     ///< a plane that stands still was touched by the target
  sphere     ///< likewise a sphere
};

struct Setup {
  Data data = Data::pose;
  bool tracker_known = false;  ///< measured in the description's world
  bool target_known = false;   ///< the target is the tool's frame
  std::size_t targets = 1;
  std::size_t surfaces = 0;
  Errors errors = Errors::all;
  bool eccentric = false, bending = false;

  [[nodiscard]] bool has_tracker() const {
    return data == Data::pose || data == Data::position || data == Data::camera;
  }
  [[nodiscard]] bool has_orientation() const { return data == Data::pose || data == Data::camera; }
};

/// Returns all parameters that the setup asks for, the arm's and the measurement's.
std::vector<Parameter> parameters_of(const Geometry<double>& geometry, const Setup& setup);

/// Returns the order in which parameters are kept where not all can be: frames and surfaces of the
/// measurement first, then zeros, lengths, offsets, twists, and what else there is.
std::vector<std::size_t> priority_of(const std::vector<Parameter>& parameters);

/// Parameters that depend on others, each with those that it cannot be told from.
struct Dependence {
  std::size_t parameter;
  std::vector<std::size_t> on;  ///< empty: the parameter has no effect at all
};
struct Rank {
  std::vector<std::size_t> independent;  ///< in the order of their indices
  std::vector<Dependence> dependent;
};

}  // namespace qvgen::calibrate
