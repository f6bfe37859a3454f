// SPDX-License-Identifier: MIT
// Random arms whose links are bodies that could be, as descriptions; those with motors have pairs of bevel
// gears, nested shafts, belts and gears.
#pragma once

#include <random>
#include <sstream>
#include <string>

#include <Eigen/Core>
#include <fmt/format.h>

namespace qvgen::test {

/// Draws from one generator, so that a seed means one arm.
class ArmWriter {
 public:
  explicit ArmWriter(unsigned seed) : random_(seed) {}

  /// An arm of `joints`, letters R and P; friction and rotor inertia of every joint if `drives`.
  std::string text(const std::string& joints, bool drives = true) {
    std::string result = "# an arm of a test\nname = \"arm\"\ntitle = \"arm\"\n";
    for (std::size_t i = 0; i < joints.size(); ++i) result += joint(joints[i], i + 1, drives);
    return result;
  }

  /// Such an arm whose motors are no joints, or few of them are; constants in the relations, limits of none.
  std::string with_motors(const std::string& joints, bool drives = true) {
    std::string result = "# an arm of a test\nname = \"arm\"\ntitle = \"arm\"\n";
    const std::vector<std::string> relations = relations_of(joints);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      result += joint(joints[i], i + 1, drives && relations[i].empty());
      if (relations[i].empty()) continue;
      result += "follows = \"" + relations[i] + "\"\n";
      if (drives && below(2) == 0)
        result += fmt::format("rotor_inertia = {}\nviscous_friction = {}\n", number(0.1, 1), number(0.5, 2));
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (relations[i].empty()) continue;
      result += fmt::format("\n[[motor]]  # number {}\nvariable = \"m{}\"\n", i + 1, i + 1);
      if (drives)
        result += fmt::format("rotor_inertia = {}\nviscous_friction = {}\ncoulomb_friction = {}\n",
                              number(0.1, 1), number(0.5, 2), number(0.5, 3));
    }
    return result;
  }

  double number(double lower, double upper) {
    return std::round(std::uniform_real_distribution(lower, upper)(random_) * 1000) / 1000;
  }

 private:
  int below(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
  std::string factor() {
    static const std::string factors[] = {"1/2 ", "-2/3 ", "", "-", "1.06 ", "3/5 "};
    return factors[below(6)];
  }

  /// Each joint has a motor of its own name, its own value, or half the sum, or half the difference, of a
  /// pair.
  std::vector<std::string> relations_of(const std::string& joints) {
    std::vector<std::string> relations, leaders;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const std::string own = fmt::format("m{}", i + 1), next = fmt::format("m{}", i + 2);
      if (i + 1 < joints.size() && below(3) == 0) {
        relations.push_back(fmt::format("1/2 {} + 1/2 {}", own, next));
        relations.push_back(fmt::format("({} - {})/2", own, next));
        leaders.insert(leaders.end(), {own, next});
        ++i;
      } else if (below(4) == 0 && i > 0) {
        relations.emplace_back();
        leaders.push_back(fmt::format("q{}", i + 1));
      } else {
        relations.push_back(factor() + own);
        for (const std::string& leader : leaders)
          if (below(2) == 0)
            relations.back() += " + " + std::string(below(2) == 0 ? "1/3 " : "2/5 ") + leader;
        leaders.push_back(own);
      }
      if (joints[i] == 'R' && !relations.back().empty() && below(2) == 0) relations.back() += " + 10 deg";
    }
    return relations;
  }

  std::string joint(char letter, std::size_t count, bool drives) {
    static const std::string axes[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    const std::string& axis = axes[std::uniform_int_distribution<std::size_t>(0, 5)(random_)];
    std::string result = fmt::format(
        "\n[[joint]]  # number {}\ntype = \"{}\"\naxis = \"{}\"\nvariable = \"q{}\"\norigin = {}\nlink = "
        "{}\n",
        count, letter == 'R' ? "revolute" : "prismatic", axis, count, vector(0.3), vector(0.2));
    result += body();
    if (drives)
      result += fmt::format("rotor_inertia = {}\nviscous_friction = {}\ncoulomb_friction = {}\n",
                            number(0.1, 1), number(0.5, 2), number(0.5, 3));
    return result;
  }

  std::string vector(double size) {
    return fmt::format("[{}, {}, {}]", number(-size, size), number(-size, size), number(-size, size));
  }

  /// Some points with masses: their moments are those of a body.
  std::string body() {
    const double mass = number(1, 8);
    const Eigen::Matrix3d points = Eigen::Matrix3d::NullaryExpr([&] { return number(-0.15, 0.15); });
    const Eigen::Matrix3d moments =
        mass * (points * points.transpose() + 0.001 * Eigen::Matrix3d::Identity());
    const Eigen::Matrix3d i = moments.trace() * Eigen::Matrix3d::Identity() - moments;
    return fmt::format(
        "mass = {}\ncentre_of_mass = {}\ninertia = [{:.6f}, {:.6f}, {:.6f}, {:.6f}, {:.6f}, {:.6f}]\n", mass,
        vector(0.2), i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(1, 2), i(0, 2));
  }

  std::mt19937 random_;
};

/// The arm without a line on inertias and drives.
inline std::string without_inertia(const std::string& text) {
  std::istringstream stream(text);
  std::string result;
  for (std::string line; std::getline(stream, line);) {
    bool stays = true;
    for (const char* key : {"mass", "centre_of_mass", "inertia", "rotor_inertia", "viscous", "coulomb"})
      stays = stays && !line.starts_with(key);
    if (stays) result += line + "\n";
  }
  return result;
}

}  // namespace qvgen::test
