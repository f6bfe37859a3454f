// SPDX-License-Identifier: MIT
#include "emit/cpp/leaf_names.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <cln/integer.h>

#include "dag/rebuild.h"
#include "emit/cpp/literal.h"
#include "exact/constant_angle.h"

namespace qvgen::emit {

using dag::Angle;
using dag::Op;

std::vector<Angle> angles_of(const dag::Function& function) {
  std::map<std::string, Angle> found;
  for (const std::uint32_t id : dag::reachable(function)) {
    const dag::Node& node = function.graph.node(id);
    if (node.op != Op::sine && node.op != Op::cosine) continue;
    const Angle& angle = function.graph.angle_of(node);
    if (exact::radians(angle)) continue;  // a number
    found.emplace(to_string(angle), angle);
  }
  std::vector<Angle> angles;
  for (const auto& [text, angle] : found) angles.push_back(angle);
  // Single joints first: theta1/2, theta2/2, then the sums.
  std::stable_sort(angles.begin(), angles.end(),
                   [](const Angle& a, const Angle& b) { return a.terms.size() < b.terms.size(); });
  return angles;
}

namespace {

std::string place_of(const std::vector<Angle>& angles, const Angle& angle) {
  const auto place = std::find(angles.begin(), angles.end(), angle);
  if (place == angles.end()) throw std::logic_error("angle " + to_string(angle) + " has no place");
  return "[" + std::to_string(place - angles.begin()) + "]";
}

cln::cl_I common_denominator(const Angle& angle) {
  cln::cl_I common = 1;
  for (const auto& [name, coefficient] : angle.terms)
    common = cln::lcm(common, cln::denominator(coefficient));
  return common;
}

std::string scalar(const exact::Number& number) { return "Scalar(" + literal(number) + ")"; }

/// pi * turns, in double.
std::string radians(const cln::cl_RA& turns) {
  const cln::cl_RA pi = cln::cl_RA(cln::cl_I("3141592653589793238462643383279502884197")) /
                        cln::cl_RA(cln::expt_pos(cln::cl_I(10), 39));
  return scalar(exact::Number(turns * pi));
}

}  // namespace

Names leaf_names(const model::Robot& robot, const std::vector<Angle>& angles,
                 const std::function<std::string(const std::string&)>& others) {
  std::map<std::string, std::string> known{{"pi", radians(1)}};
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    known[robot.joints[i].variable] = "q[" + std::to_string(i) + "]";
  for (const model::Parameter& parameter : robot.geometry) known[parameter.name] = "g." + parameter.name;
  const auto symbol = [known, others](const std::string& name) {
    if (const auto constant = exact::constant_angle(name))
      return scalar(exact::Number(exact::radians(*constant)));
    const auto place = known.find(name);
    if (place != known.end()) return place->second;
    if (!others) throw std::logic_error("symbol " + name + " has no place in the generated code");
    return others(name);
  };
  return {symbol, [angles](const Angle& angle) { return "s" + place_of(angles, angle); },
          [angles](const Angle& angle) { return "c" + place_of(angles, angle); }};
}

std::string angle_code(const Angle& angle, const Names& names) {
  const cln::cl_I common = common_denominator(angle);
  std::string sum;
  for (const auto& [name, coefficient] : angle.terms) {
    const cln::cl_RA factor = coefficient * common;
    const cln::cl_RA size = cln::abs(factor);
    sum += cln::minusp(factor) ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
    sum += (size == 1 ? "" : scalar(exact::Number(size)) + " * ") + names.symbol(name);
  }
  const bool compound = angle.terms.size() > 1;
  if (common != 1)
    sum = scalar(exact::Number(cln::recip(cln::cl_RA(common)))) + " * " + (compound ? "(" + sum + ")" : sum);
  if (cln::zerop(angle.pi)) return sum;
  if (sum.empty()) return radians(angle.pi);
  return sum + (cln::minusp(angle.pi) ? " - " : " + ") + radians(cln::abs(angle.pi));
}

nlohmann::json angle_values(const std::vector<Angle>& angles, const Names& names) {
  nlohmann::json values = nlohmann::json::array();
  for (std::size_t i = 0; i < angles.size(); ++i)
    values.push_back({{"text", to_string(angles[i])},
                      {"code", angle_code(angles[i], names)},
                      {"index", i},
                      {"last", i + 1 == angles.size()}});
  return values;
}

std::string sines_cosines_code(const std::vector<Angle>& angles, const Names& names,
                               const std::string& empty) {
  if (angles.empty()) return empty + "<Scalar>{}";
  std::string arguments;
  for (const Angle& angle : angles) arguments += (arguments.empty() ? "" : ", ") + angle_code(angle, names);
  return "sines_and_cosines<Scalar>(" + arguments + ")";
}

}  // namespace qvgen::emit
