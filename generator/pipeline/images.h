// SPDX-License-Identifier: MIT
// Equal limbs of a robot: what is derived for one serves all that are its images in mirrors (model/image.h).
//
// The products of the first limb write the headers of its images beside its own: functions that call its
// functions and change signs. So limbs are derived once, proved once, and their code is there once. An image
// that a product has no header for is derived on its own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// A robot to be derived, with its images.
struct Original {
  model::Robot robot;
  std::vector<model::Image> images = {};
};

/// Derives robots: outputs in their order.
using Derive = std::function<std::vector<RobotOutput>(const std::vector<Original>&)>;

/// Derives robots, but limbs that are images of another limb of the same robot with that one. `limb_of`: for
/// each the robot that it is a limb of, empty for none. `progress` is told of images.
std::vector<RobotOutput> derived_once(const std::vector<model::Robot>& robots,
                                      const std::vector<std::string>& limb_of, const Derive& derive,
                                      const std::function<void(const std::string& robot)>& progress);

/// For products: adds the header of an image of a robot, and one of definitions if the part has some.
/// `values` are those of the robot's own header, and what image_PART.h needs besides.
void add_image(const model::Robot& robot, const model::Image& image, const std::string& part,
               bool has_definitions, const nlohmann::json& values, RobotOutput& output);

}  // namespace qvgen::pipeline
