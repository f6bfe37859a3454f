// SPDX-License-Identifier: MIT
#include "right_angles.h"

#include <array>

#include <qvgen/inverse/elimination/solve.h>
#include <qvgen/inverse/joint_limits.h>

namespace qvgen::test {
namespace {

using inverse::elimination::Description;
using inverse::elimination::Setup;

inverse::Triple<double> triple(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

Description description_of(const reference::Chain& chain) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(6);
  const auto places = reference::joint_places(chain, zero);
  Description result;
  for (std::size_t i = 0; i < 6; ++i)
    result.axes[i] = {chain.joints[i].revolute, triple(places[i].axis), triple(places[i].point)};
  const Eigen::Isometry3d tool = reference::forward_kinematics(chain, zero);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result.tool.rotation[3 * i + k] = tool.linear()(i, k);
    result.tool.translation[i] = tool.translation()[i];
  }
  return result;
}

inverse::elimination::Found solve(const Setup& setup, const Pose<double>& pose, double tolerance,
                                  const inverse::Preference<6>& preference) {
  inverse::elimination::Found found;
  inverse::elimination::solve(setup, pose, tolerance, preference, inverse::Form::fastest, found);
  return found;
}

std::string joint(bool slides, const std::string& axis, int number, const std::string& origin,
                  const std::string& link) {
  return "[[joint]]\ntype = \"" + std::string(slides ? "prismatic" : "revolute") + "\"\naxis = \"" + axis +
         "\"\nvariable = \"q" + std::to_string(number + 1) + "\"\norigin = " + origin + "\n" +
         (slides ? "" : "link = " + link + "\n");
}

/// The standard's distributions differ between libraries.
int below(std::mt19937_64& random, int count) {
  return static_cast<int>(random() % static_cast<unsigned>(count));
}

std::string any_length(std::mt19937_64& random) {
  const int over = 1 + below(random, 9), under = 11 + below(random, 7);
  return "\"" + std::to_string(over) + "/" + std::to_string(under) + "\"";
}

}  // namespace

reference::Chain arm_on_a_rail() {
  const std::string none = "[0, 0, 0]";
  return reference::load_text(
      "name = \"on_a_rail\"\n" + joint(true, "+x", 0, none, "") + joint(true, "+z", 1, none, "") +
      joint(false, "+z", 2, none, "[0.3, 0, 0]") + joint(false, "+z", 3, none, "[0.25, 0, -0.1]") +
      joint(false, "+y", 4, none, "[0.03, 0.04, -0.2]") + joint(false, "+x", 5, none, "[0, 0.02, 0.1]"));
}

reference::Chain right_angled_arm(unsigned seed) {
  std::mt19937_64 random(seed);
  const int first = below(random, 6), second = (first + 1 + below(random, 5)) % 6;
  std::string text = "name = \"right_angled_" + std::to_string(seed) + "\"\n";
  int before = -1;
  for (int i = 0; i < 6; ++i) {
    int axis = below(random, 3);
    while (axis == before) axis = below(random, 3);
    before = axis;
    std::string origin;
    for (int k = 0; k < 3; ++k) {
      const bool none = seed % 2 == 1 && below(random, 2) == 0;
      origin += (k == 0 ? "[" : ", ") + (none ? "0" : any_length(random));
    }
    const std::string link = "[" + (i == 5 ? any_length(random) : "0") + ", 0, 0]";
    const std::string sign = below(random, 2) == 0 ? "+" : "-";
    text += joint(i == first || i == second, sign + "xyz"[axis], i, origin + "]", link);
  }
  return reference::load_text(text);
}

bool is_solved(const reference::Chain& chain) {
  return inverse::elimination::set_up(description_of(chain)).count > 0;
}

WrittenArm written_arm(const reference::Chain& chain) {
  const Setup setup = inverse::elimination::set_up(description_of(chain));
  WrittenArm arm;
  arm.chain = chain;
  arm.functions.name = chain.name;
  arm.functions.dof = 6;
  arm.functions.info = {inverse::elimination::most_solutions, Task::pose, -1, true, false, {0, 0, 1}, true};
  arm.functions.functions.solve = [setup](const Pose<double>& pose, double, double tolerance,
                                          const reference::Values&) {
    return copy(solve(setup, pose, tolerance, inverse::zero_preference<6>));
  };
  arm.functions.functions.solve_from = [setup](const Pose<double>& pose, double, const Eigen::VectorXd& seed,
                                               const reference::Values&) {
    const Eigen::Matrix<double, 6, 1> joints = seed;
    auto found = solve(setup, pose, inverse::default_tolerance, inverse::preference<6>(joints));
    std::array<bool, 6> revolute;
    for (std::size_t i = 0; i < 6; ++i) revolute[i] = !setup.chain.slides[i];
    sort_by_distance(found, joints, revolute);
    return copy(found);
  };
  return arm;
}

}  // namespace qvgen::test
