// SPDX-License-Identifier: MIT
#include "pipeline/products/from_ideal.h"

#include "emit/render.h"

namespace qvgen::pipeline {

void generate_from_ideal(const model::Robot& robot, RobotOutput& output) {
  if (robot.ideal.empty()) return;
  output.files.push_back({"include/qvgen/robots/" + robot.name + "/from_ideal.h",
                          emit::render("cpp/from_ideal.h", {{"name", robot.name}, {"ideal", robot.ideal}})});
}

void generate_from_ideal_c(const model::Robot& robot, RobotOutput& output) {
  if (!robot.ideal.empty())
    output.missing.push_back({"from_ideal", Missing::Kind::not_in_language, "it is written in C++"});
}

}  // namespace qvgen::pipeline
