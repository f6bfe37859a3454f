// SPDX-License-Identifier: MIT
#include "emit/inverse/frames.h"

#include <fmt/format.h>

#include "dag/import.h"
#include "emit/ast/angle.h"
#include "emit/code.h"
#include "emit/leaves.h"
#include "exact/constant_angle.h"
#include "passes/constants.h"
#include "symbolic/model.h"

namespace qvgen::emit {
namespace {

using nlohmann::json;

/// The displacement's inverse as the arguments of a Pose: quaternion w, x, y, z and position.
json inverse_pose(const model::Robot& robot, const model::Displacement& displacement,
                  const ast::Printer& language) {
  const symbolic::Pair pair = symbolic::inverse(symbolic::to_symbolic(displacement));
  symbolic::Program program;
  program.output("w", pair.q.w);
  program.output("x", pair.q.x);
  program.output("y", pair.q.y);
  program.output("z", pair.q.z);
  program.output("px", pair.p.x);
  program.output("py", pair.p.y);
  program.output("pz", pair.p.z);
  const dag::Function function = passes::fold_constants(dag::import(program));
  const auto symbol = robot_leaves(robot, {}).symbol;
  // Once a call, so that their sines have no names of their own.
  const auto called = [&](const char* name) {
    return [symbol, name](const dag::Angle& angle) {
      return ast::call(ast::Expression::Kind::function, name, {ast::angle_value(angle, symbol)});
    };
  };
  const ast::Straight tree = ast::straight(function, {symbol, called("sin"), called("cos")});
  const Code code = code_of(tree, language);
  json values{{"temporaries", json::array()}, {"reads_g", ast::mentions(tree, "g")}};
  for (const auto& value : code.temporaries)
    values["temporaries"].push_back({{"name", value.name}, {"expression", value.expression}});
  for (const auto& output : code.outputs) values[output.name] = output.expression;
  return values;
}

double phase_in_radians(const exact::Angle& phase) { return cln::double_approx(*exact::radians(phase)); }

}  // namespace

json change_of_arm(const derive::inverse::Problem& problem, const ast::Printer& language) {
  const bool has_phases = problem.has_phases();
  if (!problem.has_frames && !has_phases) return false;
  json phases = json::array();
  for (std::size_t i = 0; i < problem.phases.size(); ++i)
    phases.push_back({{"phase", fmt::format("{}", phase_in_radians(problem.phases[i]))},
                      {"last", i + 1 == problem.phases.size()}});
  json result{{"phases", phases}, {"has_phases", has_phases}, {"frames", false}};
  if (problem.has_frames) {
    result["frames"] = {{"base", inverse_pose(problem.moving, problem.base, language)},
                        {"tool", inverse_pose(problem.moving, problem.tool, language)}};
  }
  return result;
}

}  // namespace qvgen::emit
