// SPDX-License-Identifier: MIT
#include "pipeline/products/geometry_jacobian.h"

#include "canonical/right_angles.h"
#include "derive/jacobian/geometry_jacobian.h"
#include "derive/jacobian/quantities.h"
#include "emit/c/parts.h"
#include "emit/cpp/scalars.h"
#include "emit/render.h"
#include "model/followers.h"
#include "model/frames.h"
#include "optimise/described.h"
#include "optimise/optimised_json.h"
#include "pipeline/c_files.h"
#include "verify/accuracy.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

std::size_t column_count(const model::Robot& described) {
  return derive::errors_of_frame * (described.joints.size() + 1);
}

/// The function, certified; its counts go to the output.
emit::JacobianFunction geometry_function(const model::Robot& described, RobotOutput& output) {
  constexpr int accuracy_points = 16;
  optimise::OptimiseOptions options;
  options.also_fewest = false;
  options.certificate_points = 3;
  options.simplify_forms = false;
  const model::Robot robot = canonical::for_dynamics(described);
  optimise::Optimised found = optimise::optimise(derive::geometry_jacobian(robot, described), options);
  std::vector<verify::OutputGroup> groups;
  std::vector<std::string> targets;
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t k = 0; k < column_count(described); ++k) {
      targets.push_back("result(" + std::to_string(row) + ", " + std::to_string(k) + ")");
      if (row % 3 == 0)
        groups.push_back({derive::jacobian_entry(row, k), derive::jacobian_entry(row + 1, k),
                          derive::jacobian_entry(row + 2, k)});
    }
  found.largest_error = verify::largest_error_in_ulps(found.function, groups, accuracy_points);
  found.function = optimise::with_definitions(found.function, robot);
  if (model::has_followers(described))
    found.function = optimise::in_terms_of_leaders(found.function, described);
  found.counts = dag::count(found.function);
  emit::JacobianFunction function{"geometry_jacobian",
                                  "GeometryJacobian",
                                  {},
                                  {"Derivative of the tool's pose by errors of the geometry; column 6 i + k "
                                   "belongs to the frame of joint i, counted",
                                   "from 0, before it moves: shifts along its x, y, z (m) for k = 0, 1, 2, "
                                   "turns about them (rad) for k = 3, 4, 5.",
                                   "The last six columns are those of the tool's frame. Rows: linear, then "
                                   "angular velocity in the world frame."},
                                  "",
                                  targets,
                                  std::move(found)};
  output.counts[function.name] = to_json(function.optimised);
  output.counts[function.name].erase("forms");
  return function;
}

}  // namespace

void generate_geometry_jacobian(const model::Robot& described, RobotOutput& output) {
  const emit::JacobianFunction function = geometry_function(described, output);
  const std::vector<dag::Angle> angles = emit::angles_of(std::vector{function});
  json values{{"name", described.name}, {"scalars", emit::scalars()}};
  values["columns"] = column_count(described);
  values["functions"] =
      json::array({emit::to_values(function, described, angles, "detail::NoGeometryAngles")});
  const std::string headers = "include/qvgen/robots/" + described.name + "/";
  output.files.push_back({headers + "geometry_jacobian.h", emit::render("cpp/geometry_jacobian.h", values)});
  output.files.push_back({headers + "geometry_jacobian_definitions.h",
                          emit::render("cpp/geometry_jacobian_definitions.h", values)});
  output.files.push_back({"source/" + described.name + "/geometry_jacobian.cpp",
                          emit::render("cpp/geometry_jacobian.cpp", values)});
}

void generate_geometry_jacobian_c(const model::Robot& described, RobotOutput& output) {
  add_c_part(output, emit::c::geometry_jacobian(described, geometry_function(described, output)));
}

}  // namespace qvgen::pipeline
