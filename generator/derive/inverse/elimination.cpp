// SPDX-License-Identifier: MIT
#include "derive/inverse/elimination.h"

#include <algorithm>
#include <cmath>

#include <qvgen/inverse/elimination/any_arm.h>

#include "derive/inverse/elimination_choice.h"
#include "derive/inverse/requests.h"
#include "derive/inverse/scope.h"
#include "exact/named_constant.h"
#include "model/replace.h"
#include "model/tasks.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

namespace elimination = qvgen::inverse::elimination;

namespace {

using model::Robot;
using symbolic::Pair;
using symbolic::Vector;

constexpr int six = elimination::joints;

/// The chain in sixty digits: numbers, however long the symbolic expressions would become. Of an arm without
/// parameters.
class Placed {
 public:
  explicit Placed(const Robot& robot) : scope_(robot) {
    Pair frame = in_numbers(robot.base);
    for (const model::Joint& joint : robot.joints) {
      frame = frame * in_numbers(joint.before);
      const Vector axis = symbolic::rotate(frame.q, in_numbers(symbolic::to_symbolic(joint.axis)));
      joints.push_back({joint.type == model::JointType::revolute, rounded(axis), rounded(frame.p)});
      frame = frame * in_numbers(joint.after);
    }
    frame = frame * in_numbers(robot.tool);
    const auto number = [&](const GiNaC::ex& value) { return scope_.sample(value); };
    const symbolic::Quaternion& q = frame.q;
    tool.orientation = Eigen::Quaterniond(number(q.w), number(q.x), number(q.y), number(q.z));
    tool.position = {number(frame.p.x), number(frame.p.y), number(frame.p.z)};
  }

  std::vector<qvgen::inverse::Screw<double>> joints;
  Pose<double> tool;

 private:
  [[nodiscard]] Vector in_numbers(const Vector& v) const {
    return {scope_.value(v.x), scope_.value(v.y), scope_.value(v.z)};
  }
  [[nodiscard]] Pair in_numbers(const model::Displacement& displacement) const {
    const Pair pair = symbolic::to_symbolic(displacement);
    const symbolic::Quaternion& q = pair.q;
    return {{scope_.value(q.w), scope_.value(q.x), scope_.value(q.y), scope_.value(q.z)}, in_numbers(pair.p)};
  }
  [[nodiscard]] qvgen::inverse::Triple<double> rounded(const Vector& v) const {
    return {scope_.sample(v.x), scope_.sample(v.y), scope_.sample(v.z)};
  }

  Scope scope_;
};

bool is_in_numbers(const Robot& robot) {
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

/// True if three axes in a row are nearly parallel or nearly meet in pairs.
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

const char* text_of(elimination::Pair pair) {
  switch (pair) {
    case elimination::Pair::skew:
      return "skew axes";
    case elimination::Pair::repeats:
      return "axes that meet or are parallel, an equation replaced by a derivative";
    default:  // confuses
      return "axes that meet or are parallel, the determinant by derivatives of first order";
  }
}

/// The problem with a joint held, which knows the arm with that joint moving.
Problem held(const Problem& problem, std::size_t joint) {
  Problem result = with_held(problem, joint);
  result.moving = problem.robot;
  return result;
}

/// The problems with six joints, one of which is to be solved, or all that the description names.
std::vector<Problem> problems_of(const Robot& robot) {
  const std::size_t count = robot.joints.size();
  const model::Task task = robot.inverse.task.value_or(model::Task::pose);
  std::vector<Problem> result;
  const bool leaves_heading = task == model::Task::position_and_inclination;
  const bool gives_one =
      count == six + 1 || (count == six && (leaves_heading || task == model::Task::position_and_direction));
  if (!gives_one && !robot.inverse.given.empty()) return result;
  if (count == six && task == model::Task::pose) result.push_back(problem_of(robot, task));
  if (count == six + 1 && task == model::Task::pose)
    for (const std::size_t joint : given_joints(robot))
      result.push_back(held(problem_of(robot, task), joint));
  if (count == six && task == model::Task::position_and_direction)
    for (const std::size_t joint : given_from_the_tool(robot))
      for (const model::Vector3& axis : tool_axes(robot.inverse))
        result.push_back(held(with_turn(problem_of(robot, task), axis), joint));
  if (count == six && leaves_heading)
    for (const std::size_t joint : given_from_the_tool(robot)) {
      result.push_back(held(with_heading(problem_of(robot, task)), joint));
      // Behind a spherical wrist a shoulder and an elbow leave the wrist's centre in a plane: about their own
      // axis they cannot incline the tool. What stands before them may be upright.
      const bool is_upright = robot.joints[joint].type == model::JointType::revolute &&
                              static_cast<int>(joint) < result.back().heading_joint();
      if (!is_upright) continue;
      result.push_back(result.back());
      result.back().heading = static_cast<int>(joint);
    }
  if (count + 1 == six && leaves_heading) result.push_back(with_heading(problem_of(robot, task)));
  // A heading about no joint of the arm's own is about nothing.
  if (leaves_heading)
    std::erase_if(result, [](const Problem& each) { return each.heading_joint() >= each.own_joints; });
  const bool leaves_a_turn = task == model::Task::pose || task == model::Task::position_and_direction;
  if (count + 1 == six && leaves_a_turn)
    for (const model::Vector3& axis : tool_axes(robot.inverse)) {
      result.push_back(with_turn(problem_of(robot, model::Task::position_and_direction), axis));
      if (!robot.inverse.task || task != model::Task::pose) continue;
      result.back().task = task;
      result.back().filter = Filter::pose;
    }
  return result;
}

/// The arm of a problem with its geometry in numbers, the given joint, if there is one, at no place.
Robot sample_arm(const Robot& described, const Problem& problem) {
  const Robot& arm = problem.has_heading() ? described : problem.given < 0 ? problem.robot : problem.moving;
  return model::with_geometry(arm, model::sample_geometry(described));
}

/// Nothing if no elimination serves.
std::optional<EliminationDerivation> derived(const Robot& described, const Problem& problem) {
  EliminationDerivation result;
  result.problem = problem;
  if (problem.given < 0) result.problem.moving = problem.robot;
  result.arm = sample_arm(described, problem);
  const Placed placed(result.arm);
  result.joints = placed.joints;
  result.tool = placed.tool;
  result.is_constant = problem.given < 0 && is_in_numbers(described);
  choose_eliminations(result);
  if (result.choices.count == 0) return std::nullopt;
  return result;
}

/// Keeps the first derivation with the fewest doubts, of several that are found.
void keep_best(std::vector<EliminationDerivation>& found) {
  const auto best = std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.choices.score < b.choices.score;
  });
  std::rotate(found.begin(), best, best + 1);
  found.resize(1);
}

/// True if three joints are two parallel turns and a slide across them: they move a plane in itself, and a
/// pair of them, or of their neighbours, leaves equations that vanish.
bool move_in_plane(const Axis* three) {
  constexpr double nearly = 1e-9;
  const Axis *slide = nullptr, *turn = nullptr, *other = nullptr;
  for (const Axis* each = three; each != three + 3; ++each)
    (!each->revolute ? slide : turn == nullptr ? turn : other) = each;
  if (slide == nullptr || other == nullptr) return false;
  const auto normal = cross(turn->axis, other->axis);
  return dot(normal, normal) < nearly * nearly && std::abs(dot(slide->axis, turn->axis)) < nearly;
}

/// The variables of three joints in a row that do so, where need be in the order that results if a turn and a
/// slide along its direction change places; empty if there are none.
std::vector<std::string> joints_in_plane(const Robot& arm) {
  std::vector<Axis> axes = Placed(arm).joints;
  std::vector<std::string> names;
  for (const model::Joint& joint : arm.joints) names.push_back(joint.variable);
  const auto found = [&]() -> std::vector<std::string> {
    for (std::size_t k = 0; k + 2 < axes.size(); ++k)
      if (move_in_plane(&axes[k])) return {names[k], names[k + 1], names[k + 2]};
    return {};
  };
  const auto change_places = [&](std::size_t i) {
    if (axes[i].revolute == axes[i + 1].revolute) return false;
    const auto normal = cross(axes[i].axis, axes[i + 1].axis);
    if (dot(normal, normal) > 1e-18) return false;
    std::swap(axes[i], axes[i + 1]);
    std::swap(names[i], names[i + 1]);
    return true;
  };
  std::vector<std::string> result = found();
  for (std::size_t i = 0; result.empty() && i + 1 < axes.size(); ++i) {
    if (!change_places(i)) continue;
    result = found();
    change_places(i);
  }
  return result;
}

std::string without_elimination(const Robot& robot, const Robot& arm) {
  const auto slides = std::count_if(robot.joints.begin(), robot.joints.end(), [](const auto& joint) {
    return joint.type == model::JointType::prismatic;
  });
  if (slides > 2) return "by elimination: more than two of the joints slide";
  const bool is_whole = arm.joints.size() == static_cast<std::size_t>(six);
  const std::vector<std::string> plane = is_whole ? joints_in_plane(arm) : std::vector<std::string>();
  if (!plane.empty())
    return "by elimination: the joints " + plane[0] + ", " + plane[1] + " and " + plane[2] +
           ", two parallel turns and a slide across them, move in a plane, and none serves";
  return "by elimination: none finds the joints of sampled poses";
}

}  // namespace

EliminationDerivations derive_eliminations(const Robot& described) {
  EliminationDerivations result;
  const std::vector<Problem> problems = problems_of(described);
  const model::InverseRequest& request = described.inverse;
  const bool asks_for_all = !request.given.empty();
  const auto has_found = [&](int given) {
    return std::any_of(result.found.begin(), result.found.end(),
                       [&](const auto& one) { return one.problem.given == given; });
  };
  for (const Problem& problem : problems) {
    const bool leaves_a_turn = problem.row_size > problem.own_joints;
    if (leaves_a_turn && (asks_for_all ? has_found(problem.given) : !result.found.empty())) continue;
    if (auto one = derived(described, problem)) result.found.push_back(std::move(*one));
  }
  const bool is_enough = asks_for_all && !request.every_given ? result.found.size() == request.given.size()
                                                              : !result.found.empty();
  if (!is_enough) {
    result.found.clear();
    if (!problems.empty())
      result.reasons.push_back(without_elimination(described, sample_arm(described, problems.front())));
  } else if (!asks_for_all) {
    keep_best(result.found);
  }
  return result;
}

bool lacks_structure(const Robot& described) {
  if (described.joints.size() != static_cast<std::size_t>(six) || !is_in_numbers(described)) return false;
  const Placed arm(described);
  for (std::size_t i = 0; i + 2 < six; ++i)
    if (may_have_structure(arm.joints[i], arm.joints[i + 1], arm.joints[i + 2])) return false;
  return true;
}

namespace {

/// The variables of an elimination's loop, in its order.
std::vector<std::string> variables_of(const EliminationDerivation& derivation,
                                      const elimination::Elimination& e) {
  std::vector<std::string> variables;
  for (const int joint : e.joint)
    variables.push_back(derivation.problem.robot.joints[static_cast<std::size_t>(joint)].variable);
  return variables;
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

std::vector<std::string> describe_pair(const std::vector<std::string>& variable,
                                       const elimination::Elimination& e) {
  return {variable[3] + " from det A(" + variable[3] + ") = 0, 6 equations in 9 products of powers of " +
              variable[4] + " and " + variable[5],
          variable[0] + " dropped; " + variable[1] + ", " + variable[2] + " linear: " + text_of(e.pair)};
}

std::vector<std::string> describe_slides(const std::vector<std::string>& variable,
                                         const elimination::Elimination& e) {
  std::vector<std::string> turns, slides;
  for (std::size_t i = 0; i < six; ++i)
    if (i != 3) (e.slide[i] ? slides : turns).push_back(variable[i]);
  return {variable[3] + " from the way left for " + list_of(slides) +
              ", which lies in the plane of their directions; times the conjugate of that equation",
          list_of(turns) + " by the orientation, up to the sign of a root; " + list_of(slides) + " linear"};
}

}  // namespace

std::vector<std::string> describe_elimination(const EliminationDerivation& derivation) {
  const bool slides = derivation.setup.eliminations[0].pair == elimination::Pair::slides;
  std::vector<std::string> lines{
      slides
          ? "six joints, two of which slide: elimination to a polynomial of degree 4 in cosine and sine of "
            "one angle"
          : "six joints of any geometry: elimination to a polynomial of degree 8 in cosine and sine of one "
            "angle"};
  for (int i = 0; i < derivation.setup.count; ++i) {
    const elimination::Elimination& e = derivation.setup.eliminations[i];
    const std::vector<std::string> variable = variables_of(derivation, e);
    const auto text = slides ? describe_slides(variable, e) : describe_pair(variable, e);
    lines.push_back((i == 0 ? "- " : "- if in doubt: ") + text[0]);
    lines.push_back("  " + text[1]);
  }
  return lines;
}

bool nearly_has_structure(const Robot& described) {
  if (described.joints.size() != static_cast<std::size_t>(six) || !is_in_numbers(described)) return false;
  const Placed placed(described);
  EliminationDerivation arm;
  arm.joints = placed.joints;
  arm.tool = placed.tool;
  const double size = elimination::chain_of(elimination::description_of(arm.arm_at_zero<six>())).size;
  for (std::size_t i = 0; i + 1 < six; ++i) {
    const Axis &a = arm.joints[i], &b = arm.joints[i + 1];
    const auto normal = cross(a.axis, b.axis);
    if (!a.revolute || !b.revolute || dot(normal, normal) < 1e-18) continue;
    const double gap = distance(a, b);
    if (gap > 1e-12 * size && gap < 0.1 * size) return true;
  }
  return false;
}

}  // namespace qvgen::derive::inverse
