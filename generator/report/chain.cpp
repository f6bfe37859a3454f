// SPDX-License-Identifier: MIT
#include "report/chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "model/evaluate.h"
#include "report/html.h"

namespace qvgen::report {
namespace {

using model::Expression;
using std::numbers::pi;

constexpr double nothing = 1e-12;

class Reader {
 public:
  explicit Reader(const model::Robot& robot) : values_(model::default_bindings(robot)) {
    for (const model::Parameter& parameter : robot.geometry)
      if (values_.count(parameter.name) == 0) {
        values_[parameter.name] = cln::cl_R(assumed_value);
        assumed.push_back(parameter.name);
      }
  }

  double number(const Expression& expression) const {
    return model::to_double(model::evaluate(expression, values_));
  }
  Vector vector(const model::Vector3& v) const { return {number(v[0]), number(v[1]), number(v[2])}; }

  Way way(const model::Displacement& displacement) const {
    Way result;
    for (const model::Turn& each : displacement.turns)
      result.motion = result.motion * turn(vector(each.axis), number(each.angle));
    result.motion.translation() = vector(displacement.translation);
    for (std::size_t i = 0; i < 3; ++i)
      result.names.at(i) =
          name(displacement.translation.at(i), result.motion.translation()[static_cast<Eigen::Index>(i)]);
    return result;
  }

  std::vector<std::string> assumed;

 private:
  std::string name(const Expression& entry, double value) const {
    if (std::abs(value) < nothing) return "";
    const std::string size = fmt::format("{:.4g}", std::abs(value));
    if (model::symbols(entry).empty()) return size;
    std::string text = model::to_string(entry);
    if (text.front() == '-') text.erase(0, 1);
    return text.size() > 14 ? size : typeset(text) + " = " + size;
  }

  model::Bindings values_;
};

/// Walks along a way, leg by leg, and adds those that lead somewhere.
void append_legs(const Motion& start, const Way& way, std::vector<Posture::Leg>& legs) {
  Vector at = start.translation();
  for (const int axis : {2, 0, 1}) {  // along z first, as tables of Denavit and Hartenberg do
    const double part = way.motion.translation()[axis];
    if (std::abs(part) < nothing) continue;
    const Vector next = at + part * start.linear().col(axis);
    legs.push_back({at, next, way.names.at(static_cast<std::size_t>(axis))});
    at = next;
  }
}

/// The joint that another one follows alone. Joints that follow motors are drawn as joints of their own.
std::optional<std::pair<std::size_t, double>> follows_one(const model::Robot& robot,
                                                          const model::Joint& joint) {
  if (joint.follows.size() != 1) return std::nullopt;
  const auto& [leader, ratio] = joint.follows.front();
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].variable == leader) return std::pair(i, cln::double_approx(ratio));
  return std::nullopt;
}

}  // namespace

Chain chain_of(const model::Robot& robot) {
  const Reader reader(robot);
  Chain chain{reader.way(robot.base), {}, reader.way(robot.tool), {}, reader.assumed};
  for (const model::Parameter& parameter : robot.geometry)
    chain.geometry.push_back(reader.number(Expression::symbol(parameter.name)));
  for (const model::Joint& joint : robot.joints) {
    ChainJoint numbers{joint.variable,           joint.type == model::JointType::revolute,
                       reader.way(joint.before), reader.vector(joint.axis),
                       reader.way(joint.after),  std::nullopt};
    if (joint.limits)
      numbers.limits.emplace(reader.number(joint.limits->lower), reader.number(joint.limits->upper));
    numbers.follows = follows_one(robot, joint);
    if (joint.greatest_velocity) numbers.speed = reader.number(*joint.greatest_velocity);
    chain.joints.push_back(std::move(numbers));
  }
  return chain;
}

Vector numbers_of(const model::Robot& robot, const model::Vector3& vector) {
  return Reader(robot).vector(vector);
}

Motion motion_of(const model::Robot& robot, const model::Displacement& displacement) {
  return Reader(robot).way(displacement).motion;
}

std::vector<double> following(const Chain& chain, std::vector<double> q) {
  for (std::size_t i = 0; i < q.size(); ++i)
    if (const auto& follows = chain.joints[i].follows) q[i] = follows->second * q[follows->first];
  return q;
}

Posture posture_of(const Chain& chain, const std::vector<double>& q) {
  Posture posture;
  Motion at = Motion::Identity();
  const auto go = [&](const Way& way) {
    append_legs(at, way, posture.legs);
    at = at * way.motion;
  };
  go(chain.base);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const ChainJoint& joint = chain.joints[i];
    go(joint.before);
    const Vector point = at.translation();
    const Vector axis = at.linear() * joint.axis;
    at = at * (joint.revolute ? turn(joint.axis, q[i]) : Motion(Eigen::Translation3d(q[i] * joint.axis)));
    posture.joints.push_back({point, axis, at.translation(), at});
    go(joint.after);
  }
  go(chain.tool);
  posture.tool = at;
  return posture;
}

double size_of(const Chain& chain) {
  double size = 0;
  for (const auto& leg : posture_of(chain, std::vector<double>(chain.joints.size())).legs)
    size += (leg.to - leg.from).norm();
  for (const ChainJoint& joint : chain.joints)
    if (!joint.revolute && joint.limits) size += joint.limits->second - joint.limits->first;
  return size > nothing ? size : 1;
}

std::pair<double, double> range_of(const Chain& chain, std::size_t index) {
  const ChainJoint& joint = chain.joints[index];
  if (joint.limits) return *joint.limits;
  if (joint.revolute) return {-pi, pi};
  return {0, size_of(chain)};
}

std::vector<double> zero_pose(const Chain& chain) {
  std::vector<double> q;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const auto [lower, upper] = range_of(chain, i);
    q.push_back(std::clamp(0.0, lower, upper));
  }
  return following(chain, q);
}

std::vector<double> bent_pose(const Chain& chain) {
  constexpr std::array<double, 7> degrees{30, -35, 55, 40, 60, -30, 45};
  std::vector<double> q;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const auto [lower, upper] = range_of(chain, i);
    const double margin = 0.1 * (upper - lower);
    const double wanted =
        chain.joints[i].revolute ? degrees.at(i % degrees.size()) * pi / 180 : (lower + upper) / 2;
    q.push_back(std::clamp(wanted, lower + margin, upper - margin));
  }
  return following(chain, q);
}

}  // namespace qvgen::report
