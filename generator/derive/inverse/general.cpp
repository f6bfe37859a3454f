// SPDX-License-Identifier: MIT
#include "derive/inverse/general.h"

#include <algorithm>
#include <cmath>

#include "derive/inverse/scope.h"
#include "exact/named_constant.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

namespace general = qvgen::inverse::general;

namespace {

using Numbers = std::array<double, 3>;
using symbolic::Pair;
using symbolic::Vector;

/// The chain in sixty digits: numbers, however long the symbolic expressions would become.
class Placed {
 public:
  explicit Placed(const model::Robot& robot) : scope_(robot) {
    Pair frame = in_numbers(robot.base);
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const model::Joint& joint = robot.joints[i];
      frame = frame * in_numbers(joint.before);
      const Vector axis = symbolic::rotate(frame.q, in_numbers(symbolic::to_symbolic(joint.axis)));
      arm_.axes[i] = {joint.type == model::JointType::revolute, rounded(axis), rounded(frame.p)};
      frame = frame * in_numbers(joint.after);
    }
    set_tool(frame * in_numbers(robot.tool));
  }
  [[nodiscard]] const general::Description& arm() const { return arm_; }

 private:
  [[nodiscard]] Vector in_numbers(const Vector& v) const {
    return {scope_.value(v.x), scope_.value(v.y), scope_.value(v.z)};
  }
  [[nodiscard]] Pair in_numbers(const model::Displacement& displacement) const {
    const Pair pair = symbolic::to_symbolic(displacement);
    const symbolic::Quaternion& q = pair.q;
    return {{scope_.value(q.w), scope_.value(q.x), scope_.value(q.y), scope_.value(q.z)}, in_numbers(pair.p)};
  }
  [[nodiscard]] Numbers rounded(const Vector& v) const {
    return {scope_.sample(v.x), scope_.sample(v.y), scope_.sample(v.z)};
  }
  void set_tool(const Pair& tool) {
    const std::array<Vector, 3> units = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const Numbers origin = rounded(tool.p);
    for (std::size_t k = 0; k < 3; ++k) {
      const Numbers column = rounded(symbolic::rotate(tool.q, units[k]));
      for (std::size_t i = 0; i < 3; ++i) arm_.tool.rotation[3 * i + k] = column[i];
      arm_.tool.translation[k] = origin[k];
    }
  }

  Scope scope_;
  general::Description arm_;
};

bool is_in_numbers(const model::Robot& robot) {
  const auto names = model::symbols(robot);
  return robot.geometry.empty() && std::all_of(names.begin(), names.end(), [](const std::string& name) {
           return exact::named_value(name).has_value();
         });
}

using qvgen::inverse::cross;
using qvgen::inverse::difference;
using qvgen::inverse::dot;
using Axis = qvgen::inverse::Screw<double>;

/// Distance of the lines through two axes that are not parallel.
double distance(const Axis& a, const Axis& b) {
  const auto normal = cross(a.axis, b.axis);
  return std::abs(dot(normal, difference(a.point, b.point))) / std::sqrt(dot(normal, normal));
}

/// Whether three axes in a row are nearly parallel or nearly meet in pairs.
bool may_have_structure(const Axis& a, const Axis& b, const Axis& c) {
  constexpr double nearly = 1e-9;
  const auto parallel = [](const Axis& x, const Axis& y) {
    const auto normal = cross(x.axis, y.axis);
    return dot(normal, normal) < nearly * nearly;
  };
  const auto meet = [&](const Axis& x, const Axis& y) { return !parallel(x, y) && distance(x, y) < nearly; };
  if (!a.revolute || !b.revolute || !c.revolute) return true;
  return (parallel(a, b) && parallel(b, c)) || (meet(a, b) && meet(b, c)) || (meet(a, b) && meet(a, c));
}

std::string number(int joint) { return std::to_string(joint + 1); }

const char* text_of(general::Pair pair) {
  switch (pair) {
    case general::Pair::skew:
      return "skew axes";
    case general::Pair::repeats:
      return "axes that meet or are parallel, an equation replaced by a derivative";
    default:
      return "axes that meet or are parallel, the determinant by derivatives of first order";
  }
}

}  // namespace

GeneralDerivation derive_general(const model::Robot& described) {
  GeneralDerivation result;
  if (described.joints.size() != general::joints) return result;
  const auto slides = std::count_if(described.joints.begin(), described.joints.end(), [](const auto& joint) {
    return joint.type == model::JointType::prismatic;
  });
  if (slides > 1) {
    result.reason = "any six joints: more than one of them slides";
    return result;
  }
  if (!is_in_numbers(described)) {
    result.reason = "any six joints: there are symbols in the arm's geometry";
    return result;
  }
  result.setup = general::set_up(Placed(described).arm());
  result.found = result.setup.count > 0;
  if (!result.found) result.reason = "any six joints: no elimination finds the joints of sampled poses";
  return result;
}

bool lacks_structure(const model::Robot& described) {
  if (described.joints.size() != general::joints || !is_in_numbers(described)) return false;
  const general::Description arm = Placed(described).arm();
  for (int i = 0; i + 2 < general::joints; ++i)
    if (may_have_structure(arm.axes[i], arm.axes[i + 1], arm.axes[i + 2])) return false;
  return true;
}

std::vector<std::string> describe_general(const model::Robot& described,
                                          const GeneralDerivation& derivation) {
  std::vector<std::string> lines{
      "six joints of any geometry: elimination to a polynomial of degree 8 in cosine and sine of one angle"};
  for (int i = 0; i < derivation.setup.count; ++i) {
    const general::Elimination& e = derivation.setup.eliminations[i];
    const auto variable = [&](int k) {
      return described.joints[static_cast<std::size_t>(e.joint[k])].variable;
    };
    lines.push_back((i == 0 ? "- " : "- if in doubt: ") + variable(3) + " from det A(" + variable(3) +
                    ") = 0, 6 equations in 9 products of powers of " + variable(4) + " and " + variable(5));
    lines.push_back("  " + variable(0) + " dropped; " + variable(1) + ", " + variable(2) + " (axes " +
                    number(e.joint[1]) + ", " + number(e.joint[2]) + ") linear: " + text_of(e.pair));
  }
  return lines;
}

}  // namespace qvgen::derive::inverse
