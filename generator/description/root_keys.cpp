// SPDX-License-Identifier: MIT
#include "description/root_keys.h"

namespace qvgen::description {

const std::vector<std::string>& root_keys() {
  static const std::vector<std::string> keys{"name",
                                             "title",
                                             "source",
                                             "symbols",
                                             "inertia",
                                             "drives",
                                             "accept_unphysical_inertia",
                                             "base",
                                             "tool",
                                             "defaults",
                                             "joint",
                                             "convention",
                                             "dh",
                                             "home",
                                             "screw",
                                             "task",
                                             "tool_axis",
                                             "given",
                                             "ideal",
                                             "unit",
                                             "angle_unit",
                                             "frame",
                                             "on_request",
                                             "tip",
                                             "floating_base",
                                             "loop",
                                             "actuated",
                                             "outputs",
                                             "motor"};
  return keys;
}

}  // namespace qvgen::description
