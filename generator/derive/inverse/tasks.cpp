// SPDX-License-Identifier: MIT
#include "model/tasks.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "derive/inverse/attempt.h"
#include "derive/inverse/inverse.h"
#include "derive/inverse/requests.h"
#include "model/arithmetic.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using model::Robot;
using model::Task;
using model::Vector3;

namespace {

struct Kinds {
  std::size_t turns = 0, slides = 0;
  bool parallel = true;  ///< all turns about parallel axes
  bool planar = true;    ///< and all slides across them, or no turns at all
  bool level = false;    ///< the first and the last joint turn about parallel axes, with all joints at zero
};

Kinds kinds_of(const Robot& robot) {
  const Problem problem = problem_of(canonical::for_dynamics(robot), Task::pose);
  const Attempt attempt(problem);
  Kinds kinds;
  const Screw* turn = nullptr;
  const auto along = [&](const Screw& a, const Screw& b) {
    return attempt.scope.is_zero(symbolic::cross(a.axis, b.axis));
  };
  for (const Screw& screw : attempt.chain.screws) {
    ++(screw.revolute ? kinds.turns : kinds.slides);
    if (!screw.revolute) continue;
    if (turn == nullptr) turn = &screw;
    kinds.parallel = kinds.parallel && along(*turn, screw);
  }
  const Screw& first = attempt.chain.screws.front();
  const Screw& last = attempt.chain.screws.back();
  kinds.level = first.revolute && last.revolute && along(first, last);
  kinds.planar = kinds.parallel;
  for (const Screw& screw : attempt.chain.screws)
    if (!screw.revolute && turn != nullptr)
      kinds.planar = kinds.planar && attempt.scope.is_zero(symbolic::dot(turn->axis, screw.axis));
  return kinds;
}

/// Takes the first that is found, else all reasons.
template <class Try, class Choices>
Derivation first_found(const Choices& choices, const Try& attempt) {
  Derivation none;
  for (const auto& choice : choices) {
    Derivation derivation = attempt(choice);
    if (derivation.found) return derivation;
    for (const std::string& reason : derivation.reasons)
      if (std::find(none.reasons.begin(), none.reasons.end(), reason) == none.reasons.end())
        none.reasons.push_back(reason);
  }
  return none;
}

/// With a turn about an axis of the tool: its direction is asked for.
Derivation with_direction(const Robot& robot, Task task,
                          const std::function<Derivation(const Problem&)>& derived) {
  return first_found(tool_axes(robot.inverse), [&](const Vector3& axis) {
    Derivation derivation = in_canonical_frames(with_turn(problem_of(robot, task), axis), derived);
    for (std::string& reason : derivation.reasons)
      reason = "with the direction of the tool's axis " + model::axis_text(axis) + " left: " + reason;
    return derivation;
  });
}

/// With slides at the tool until there are so many joints. On the poses that the arm can follow they are
/// zero.
Derivation with_slides(const Problem& problem, std::size_t count, Derivation derived(const Problem&)) {
  if (problem.robot.joints.size() == count) return in_canonical_frames(problem, derived);
  return first_found(tool_axes({}), [&](const Vector3& axis) {
    return with_slides(with_slide(problem, axis), count, derived);
  });
}

Derivation candidates(const Robot& robot, Task task, Filter filter, std::size_t count,
                      Derivation derived(const Problem&)) {
  Problem problem = problem_of(robot, task);
  problem.filter = filter;
  return with_slides(problem, count, derived);
}

/// A palletiser. If its joints do not move in a plane, what a direction leaves is looked at, and of all poses
/// those with the tool level are asked for.
Derivation kept_level(const Robot& robot) {
  Derivation level = in_canonical_frames(problem_of(robot, Task::position_and_yaw), derive_level);
  if (level.found) return level;
  Derivation derivation = with_direction(robot, Task::position_and_yaw, derive_pose);
  derivation.problem.filter = Filter::pose;
  return derivation;
}

/// True if an axis of the tool is inclined by the joints that turn about the last one's axis.
bool has_pitch(const Problem& problem, const Vector3& axis) {
  const Attempt attempt(problem);
  const symbolic::Vector at_zero = symbolic::rotate(attempt.chain.home.q, symbolic::to_symbolic(axis));
  return !attempt.scope.is_zero(symbolic::cross(at_zero, attempt.chain.screws.back().axis));
}

/// Derives the pitch of the first axis of the tool that has one. `joint`: the one whose value is given, if
/// there is one.
Derivation pitched(const Robot& robot, std::optional<std::size_t> joint) {
  const auto moving = [&](const Problem& problem) { return joint ? with_held(problem, *joint) : problem; };
  return first_found(tool_axes(robot.inverse), [&](const Vector3& axis) -> Derivation {
    Problem problem = problem_of(robot, Task::position_and_pitch);
    problem.tool_axis = axis;
    if (!has_pitch(moving(problem), axis))
      return {false, {}, {}, {"no joint changes the pitch of the tool's axis " + model::axis_text(axis)}};
    return in_canonical_frames(problem, [&](const Problem& arm) { return derive_pitch(moving(arm)); });
  });
}

/// Derives the inclination of the tool. `joint`: the one whose value is given, if there is one.
Derivation inclined(const Robot& robot, std::optional<std::size_t> joint) {
  return in_canonical_frames(problem_of(robot, Task::position_and_inclination), [&](const Problem& arm) {
    return derive_inclination(joint ? with_held(arm, *joint) : arm);
  });
}

/// Ways to derive what an arm may be asked for, the most it can follow first.
using Way = std::function<Derivation()>;
struct Offer {
  Task task;
  Way way;
};

std::vector<Offer> offers(const Robot& robot) {
  const Kinds kinds = kinds_of(robot);
  std::vector<Offer> result;
  const auto offer = [&](Task task, Way way) { result.push_back({task, std::move(way)}); };
  const auto whole = [&](Task task, Derivation derived(const Problem&)) {
    offer(task, [&robot, task, derived] { return in_canonical_frames(problem_of(robot, task), derived); });
  };
  const auto checked = [&](Task task, Filter filter, std::size_t count, Derivation derived(const Problem&)) {
    offer(task, [=, &robot] { return candidates(robot, task, filter, count, derived); });
  };
  const auto directed = [&](Task task, Derivation derived(const Problem&)) {
    offer(task, [=, &robot] { return with_direction(robot, task, derived); });
  };
  const std::size_t count = robot.joints.size();
  if (count == 6) whole(Task::pose, derive_pose);
  if (count == 5) directed(Task::position_and_direction, derive_pose);
  if (count == 5 && kinds.level) offer(Task::position_and_yaw, [&robot] { return kept_level(robot); });
  if (count == 5 && robot.inverse.task == Task::position_and_inclination)
    offer(Task::position_and_inclination, [&robot] { return inclined(robot, std::nullopt); });
  if (count == 4 && kinds.parallel) whole(Task::position_and_yaw, derive_pose);
  if (count == 4) checked(Task::pose, Filter::pose, 4, derive_pose);
  if (count == 4 && !kinds.parallel && kinds.turns > 1)
    offer(Task::position_and_pitch, [&robot] { return pitched(robot, std::nullopt); });
  if (count == 3 && kinds.planar && kinds.slides == 0) whole(Task::pose, derive_pose);
  if (count == 3 && !kinds.planar) whole(Task::position, derive_position);
  if (count == 3 && kinds.turns == 3) whole(Task::orientation, derive_orientation);
  if (count == 3 && kinds.slides == 3) whole(Task::position, derive_position);
  if (count == 2 && kinds.turns == 2) whole(Task::position, derive_position);
  if (count == 2 && kinds.turns == 2) directed(Task::direction, derive_orientation);
  if (count == 2 && kinds.planar && kinds.slides > 0)
    checked(Task::position, Filter::position, 3, derive_position);
  if (count < 4 && kinds.turns > 0)
    checked(kinds.planar && count == 3 ? Task::position_and_yaw : Task::pose, Filter::pose, 4, derive_pose);
  if (count < 4 && kinds.turns == 0) checked(Task::pose, Filter::pose, 3, derive_position);
  return result;
}

bool turns_in_plane(const Robot& robot) {
  const Kinds kinds = kinds_of(robot);
  return robot.joints.size() == 3 && kinds.planar && kinds.turns == 3;
}

bool has_one_too_many_for_a_pitch(const Robot& robot) {
  return robot.joints.size() == 5 && robot.inverse.task == Task::position_and_pitch;
}

bool has_one_too_many_for_a_direction(const Robot& robot) {
  return robot.joints.size() == 6 && robot.inverse.task == Task::position_and_direction;
}

bool has_one_too_many_for_an_inclination(const Robot& robot) {
  return robot.joints.size() == 6 && robot.inverse.task == Task::position_and_inclination;
}

/// True if a joint has to be given.
bool has_one_too_many_for_its_task(const Robot& robot) {
  return has_one_too_many_for_a_pitch(robot) || has_one_too_many_for_a_direction(robot) ||
         has_one_too_many_for_an_inclination(robot);
}

/// True if a joint's value may be given.
bool has_one_too_many(const Robot& robot) {
  const std::size_t count = robot.joints.size();
  return count == 7 || (count == 4 && robot.inverse.task == Task::position) || turns_in_plane(robot) ||
         has_one_too_many_for_its_task(robot);
}

/// Says why no joint of so many may be given.
std::string joints_over(std::size_t count) {
  return "here, " + std::to_string(count) + " joints leave none over";
}

}  // namespace

namespace {

/// The first of the joints that may be given, the roll of the tool first: it changes no pitch of its own
/// axis.
Derivation derive_with_given(const Robot& robot,
                             Derivation derived(const Robot& robot, std::optional<std::size_t> joint)) {
  return first_found(given_from_the_tool(robot), [&](std::size_t joint) {
    Derivation derivation = derived(robot, joint);
    for (std::string& reason : derivation.reasons)
      reason = "with " + robot.joints[joint].variable + " given: " + reason;
    return derivation;
  });
}

/// Returns what an arm of five joints may be asked for that nothing else is derived for.
std::vector<std::string> other_task(const Robot& robot) {
  if (robot.joints.size() != 5) return {};
  const Derivation derivation = derive_with_given(robot, pitched);
  if (!derivation.found) return {};
  return {"it may be asked for task = \"position_and_pitch\", with joint " +
          std::to_string(derivation.problem.given + 1) + " given"};
}

}  // namespace

Derivation derive(const Robot& robot) {
  if (has_one_too_many_for_its_task(robot)) return {};
  const std::vector<Offer> all = offers(robot);
  if (!robot.inverse.given.empty() && !has_one_too_many(robot))
    return {
        false,
        {},
        {},
        {"a joint's value may be given for seven joints, six that are asked for a position and a direction "
         "(task = \"position_and_direction\") or an inclination, five that are asked for a position and a "
         "pitch, four that are "
         "asked for a position, or three that turn in a plane; " +
         joints_over(robot.joints.size())}};
  const auto asked = robot.inverse.task;
  std::vector<Offer> wanted;
  std::string tasks;
  for (const Offer& each : all) {
    if (!asked || each.task == *asked || *asked == Task::pose) wanted.push_back(each);
    tasks += (tasks.empty() ? "" : ", ") + model::task_name(each.task);
  }
  if (robot.joints.size() == 6)
    tasks += ", position_and_direction or position_and_inclination with a joint given";
  Derivation derivation = first_found(wanted, [](const Offer& each) { return each.way(); });
  if (!derivation.found && all.empty() && !has_one_too_many(robot))
    derivation.reasons.push_back(std::to_string(robot.joints.size()) +
                                 " joints: a pose in space fixes six, a point three");
  if (wanted.empty() && !all.empty())
    derivation.reasons.push_back("the task " + model::task_name(*asked) +
                                 " is none for this arm: it may be asked for " + tasks);
  if (!derivation.found)
    for (const std::string& other : other_task(robot)) derivation.reasons.push_back(other);
  if (derivation.found && asked == Task::pose) ask_for_poses(derivation.problem);
  return derivation;
}

void ask_for_poses(Problem& problem) {
  if (problem.task == Task::pose) return;
  problem.task = Task::pose;
  problem.filter = Filter::pose;
}

namespace {

Derivation with_given(const Robot& robot, Task task, std::size_t joint, Derivation derived(const Problem&)) {
  return in_canonical_frames(problem_of(robot, task),
                             [&](const Problem& moving) { return derived(with_held(moving, joint)); });
}

/// Six joints, the tool point and a direction: one joint is given, the turn of the tool is left.
Derivation direction_with_given(const Robot& robot, std::size_t joint) {
  return with_direction(robot, Task::position_and_direction,
                        [joint](const Problem& moving) { return derive_pose(with_held(moving, joint)); });
}

/// The best of several joints: the first of those that leave no quartic, if there is one.
Derivation derive_best_of(const Robot& robot, const std::vector<std::size_t>& joints,
                          const std::function<Derivation(std::size_t)>& derived) {
  Derivation best;
  for (const std::size_t joint : joints) {
    Derivation derivation = derived(joint);
    for (std::string& reason : derivation.reasons)
      best.reasons.push_back("with " + robot.joints[joint].variable + " given: " + reason);
    if (!derivation.found || (best.found && !best.plan.quartic())) continue;
    if (!best.found || !derivation.plan.quartic()) best = derivation;
    if (!best.plan.quartic()) break;
  }
  if (best.found) best.reasons.clear();
  return best;
}

/// The best of the joints that may be given.
Derivation derive_best_given(const Robot& robot) {
  const std::size_t count = robot.joints.size();
  if (has_one_too_many_for_a_pitch(robot)) return derive_with_given(robot, pitched);
  if (has_one_too_many_for_an_inclination(robot)) return derive_with_given(robot, inclined);
  if (turns_in_plane(robot) || (count == 4 && robot.inverse.task == Task::position))
    return first_found(given_joints(robot), [&](std::size_t joint) {
      return with_given(robot, Task::position, joint, derive_position);
    });
  if (has_one_too_many_for_a_direction(robot))
    return derive_best_of(robot, given_from_the_tool(robot),
                          [&](std::size_t joint) { return direction_with_given(robot, joint); });
  if (count != 7) return {};
  return derive_best_of(robot, given_joints(robot),
                        [&](std::size_t joint) { return with_given(robot, Task::pose, joint, derive_pose); });
}

/// Says which joint may be given where none of those does that the description names.
std::vector<std::string> other_given(const Robot& robot) {
  if (!has_one_too_many_for_a_direction(robot) || robot.inverse.given.empty()) return {};
  Robot any = robot;
  any.inverse.given.clear();
  const Derivation derivation = derive_best_given(any);
  if (!derivation.found) return {};
  const std::string& joint = robot.joints[static_cast<std::size_t>(derivation.problem.given)].variable;
  return {"there is a closed form with given = \"" + joint + "\""};
}

}  // namespace

std::vector<Derivation> derive_given(const Robot& robot) {
  const model::InverseRequest& request = robot.inverse;
  if (request.given.size() < 2 || !has_one_too_many(robot)) {
    Derivation best = derive_best_given(robot);
    if (!best.found)
      for (const std::string& other : other_given(robot)) best.reasons.push_back(other);
    return {best};
  }
  std::vector<Derivation> found, refused;
  for (const std::size_t joint : given_joints(robot)) {
    Robot one = robot;
    one.inverse.given = {robot.joints[joint].variable};
    Derivation derivation = derive_best_given(one);
    (derivation.found ? found : refused).push_back(std::move(derivation));
  }
  const bool is_enough = request.every_given ? !found.empty() : refused.empty();
  return is_enough ? found : refused;
}

}  // namespace qvgen::derive::inverse
