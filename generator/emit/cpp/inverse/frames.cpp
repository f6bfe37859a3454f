// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/frames.h"

#include <fmt/format.h>

#include "dag/import.h"
#include "emit/cpp/code.h"
#include "emit/cpp/symbol_table.h"
#include "exact/constant_angle.h"
#include "passes/constants.h"
#include "symbolic/model.h"

namespace qvgen::emit {
namespace {

using nlohmann::json;

/// The displacement's inverse as the arguments of a Pose: quaternion w, x, y, z and position.
json inverse_pose(const model::Robot& robot, const model::Displacement& displacement,
                  const Dialect& dialect) {
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
  const SymbolTable symbols = symbol_table(robot, {}, {}, dialect.spelling());
  // Once a call, so that their sines have no names of their own.
  SymbolTable names = symbols;
  names.sine = [&](const dag::Angle& angle) {
    return names.spelling.call("sin", angle_code(angle, symbols));
  };
  names.cosine = [&](const dag::Angle& angle) {
    return names.spelling.call("cos", angle_code(angle, symbols));
  };
  const Code code = straight_code(function, names);
  json values{{"temporaries", json::array()}};
  for (const auto& value : code.temporaries)
    values["temporaries"].push_back({{"name", value.name}, {"expression", value.expression}});
  for (const auto& output : code.outputs) values[output.name] = output.expression;
  return values;
}

double phase_in_radians(const exact::Angle& phase) { return cln::double_approx(*exact::radians(phase)); }

}  // namespace

json change_of_arm(const derive::inverse::Problem& problem, const Dialect& dialect) {
  const bool has_phases = problem.has_phases();
  if (!problem.has_frames && !has_phases) return false;
  json phases = json::array();
  for (std::size_t i = 0; i < problem.phases.size(); ++i)
    phases.push_back({{"phase", fmt::format("{}", phase_in_radians(problem.phases[i]))},
                      {"last", i + 1 == problem.phases.size()}});
  json result{{"phases", phases}, {"has_phases", has_phases}, {"frames", false}};
  if (problem.has_frames) {
    result["frames"] = {{"base", inverse_pose(problem.moving, problem.base, dialect)},
                        {"tool", inverse_pose(problem.moving, problem.tool, dialect)}};
  }
  return result;
}

}  // namespace qvgen::emit
