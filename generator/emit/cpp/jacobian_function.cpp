// SPDX-License-Identifier: MIT
#include "emit/cpp/jacobian_function.h"

#include <algorithm>
#include <stdexcept>

#include "derive/jacobian/rates.h"
#include "emit/code.h"
#include "emit/cpp/angles.h"
#include "emit/cpp/compact.h"
#include "emit/leaves.h"
#include "emit/template_values.h"
#include "model/followers.h"
#include "optimise/optimised_json.h"
#include "verify/counts_json.h"

namespace qvgen::emit {
namespace {

using nlohmann::json;

/// Joint rates are qd[i], the free point is point[i].
ast::Leaves leaves_of(const model::Robot& robot, const std::vector<dag::Angle>& angles) {
  const auto others = [variables = model::variables(robot)](const std::string& name) -> ast::Expression {
    for (std::size_t i = 0; i < variables.size(); ++i)
      if (name == derive::rate_name(variables[i])) return ast::entry("qd", i);
    const std::string axes = "xyz";
    for (std::size_t i = 0; i < 3; ++i)
      if (name == std::string("point.") + axes[i]) return ast::entry("point", i);
    throw std::logic_error("symbol " + name + " has no place in the generated code");
  };
  return robot_leaves(robot, angles, others);
}

/// The places of a function's angles among those of the header.
std::string selection(const std::vector<dag::Angle>& angles, const std::vector<dag::Angle>& all,
                      const std::string& array) {
  std::string text;
  for (const dag::Angle& angle : angles) {
    const auto place = std::find(all.begin(), all.end(), angle) - all.begin();
    text += (text.empty() ? "" : ", ") + ("angles." + array + "[" + std::to_string(place) + "]");
  }
  return text;
}

/// References to entries of a struct `angles`, in few bytes.
std::vector<std::string> compact_angles_of_struct(const std::vector<std::string>& named) {
  std::vector<std::string> lines = compact_angles(named);
  if (!lines.empty())
    lines.insert(lines.begin(), {"[[maybe_unused]] const auto& s=angles.sine;",
                                 "[[maybe_unused]] const auto& c=angles.cosine;"});
  return lines;
}

}  // namespace

std::vector<dag::Angle> angles_of(const std::vector<JacobianFunction>& functions) {
  std::vector<std::vector<dag::Angle>> lists;
  for (const JacobianFunction& function : functions) lists.push_back(angles_of(function.optimised.function));
  return merged(lists);
}

Code jacobian_code(const JacobianFunction& function, const model::Robot& robot,
                   const std::vector<dag::Angle>& angles, const ast::Printer& language) {
  return straight_code(function.optimised.function, leaves_of(robot, angles), language);
}

json to_values(const JacobianFunction& function, const model::Robot& robot,
               const std::vector<dag::Angle>& all, const std::string& no_angles) {
  const auto angles = angles_of(function.optimised.function);
  const ast::Leaves leaves = leaves_of(robot, angles);
  const Code code = jacobian_code(function, robot, angles);
  json values{{"function", function.name}, {"result", function.result}, {"text", lines_of(function.text)}};
  values["counts"] = verify::describe(function.optimised.counts);
  values["points"] = function.optimised.certified_points;
  values["ulp"] = to_json(function.optimised).at("largest_error_ulp").dump();
  values["arguments"] = json::array();
  for (const auto& argument : function.arguments)
    values["arguments"].push_back({{"type", argument.type}, {"argument", argument.name}});
  values["sines_cosines"] = sines_cosines_code(angles, leaves, no_angles);
  values["angle_count"] = angles.size();
  values["sines"] = selection(angles, all, "sine");
  values["cosines"] = selection(angles, all, "cosine");
  const bool in_few_bytes = bytes_count(robot, code);
  const std::vector<std::string> named = sine_cosine_declarations(robot, function.optimised.function, angles);
  values["named_angles"] = lines_of(in_few_bytes ? compact_angles_of_struct(named) : named);
  const Body body = in_few_bytes ? compact_body_of(code, function.targets) : body_of(code, function.targets);
  values["declarations"] = lines_of(body.declarations);
  values["statements"] = lines_of(body.statements);
  values["last_statements"] = json::array();
  if (!function.last_statement.empty())
    values["last_statements"].push_back({{"statement", function.last_statement}});
  return values;
}

}  // namespace qvgen::emit
