// SPDX-License-Identifier: MIT
#include "emit/c/parts.h"
#include "emit/c/printer.h"
#include "emit/leaves.h"
#include "emit/render.h"
#include "emit/template_values.h"

namespace qvgen::emit::c {
namespace {

std::string assignment(const std::string& target, const std::string& value) {
  return target + " = " + value + ";";
}

/// A function of the joint variables alone; output i goes to targets[i].
Function function_of(const model::Robot& robot, const optimise::Optimised& optimised,
                     const std::vector<std::string>& doc, const Parameter& result,
                     const std::vector<std::string>& targets) {
  const auto angles = angles_of(optimised.function);
  const Code code = straight_code(optimised.function, robot_leaves(robot, angles), printer());
  Function function{optimised.name, doc, {joint_array(robot, "q"), geometry(robot), result}};
  append(function.statements, sine_cosine_statements(robot, optimised.function, angles));
  append(function.statements, temporaries(code));
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    function.statements.push_back(assignment(targets.at(i), code.outputs[i].expression));
  return function;
}

std::vector<std::string> entries(const std::string& what, std::size_t count) {
  std::vector<std::string> targets;
  for (std::size_t i = 0; i < count; ++i) targets.push_back(what + "[" + std::to_string(i) + "]");
  return targets;
}

std::vector<std::string> transform_entries() {
  std::vector<std::string> targets;
  for (std::size_t i = 0; i < 9; ++i)
    targets.push_back("result[" + std::to_string(i / 3) + "][" + std::to_string(i % 3) + "]");
  for (std::size_t i = 0; i < 3; ++i) targets.push_back("result[" + std::to_string(i) + "][3]");
  return targets;
}

}  // namespace

Part pose(const model::Robot& robot, const optimise::Optimised& optimised,
          const std::vector<std::string>& doc) {
  std::vector<std::string> places = entries("result->orientation", 4);
  append(places, entries("result->position", 3));
  Part part{render("c/kinematics.h", {{"name", robot.name}})};
  return part += written(robot, {function_of(robot, optimised, doc, result_struct(robot, "pose"), places)});
}

Part transform(const model::Robot& robot, const optimise::Optimised& optimised,
               const std::vector<std::string>& doc) {
  Function matrix = function_of(robot, optimised, doc, result_matrix(4, 4), transform_entries());
  append(matrix.statements, last_row("result"));
  return written(robot, {matrix});
}

Part file(const std::string& robot, const Part& parts, const std::vector<std::string>& missing) {
  return {render("c/header.h", {{"name", robot},
                                {"body", parts.header},
                                {"missing", lines_of(missing)},
                                {"has_missing", !missing.empty()}}),
          render("c/source.c", {{"name", robot}, {"body", parts.source}})};
}

}  // namespace qvgen::emit::c
