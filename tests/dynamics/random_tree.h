// SPDX-License-Identifier: MIT
// Random trees of joints as descriptions, motions of them, and the values of formulations at a motion.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dag/evaluate.h"
#include "derive/dynamics/formulation.h"
#include "description/reader.h"
#include "exact/constant_angle.h"
#include "model/followers.h"
#include "model/mechanism.h"

namespace qvgen::test::trees {

using derive::dynamics::Formulation;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How many random trees a law has: 32, in which every size comes with composed joints and with followers,
/// or the variable QVGEN_TREES.
inline unsigned tree_count() {
  const char* trees = std::getenv("QVGEN_TREES");
  return trees == nullptr ? 32 : static_cast<unsigned>(std::atoi(trees));
}

/// Seeds of one of the four parts of a test of random trees, `part` being 1, 51, 101 or 151: a quarter of
/// them.
struct Seeds {
  explicit Seeds(unsigned part) {
    const unsigned each = tree_count() / 4;
    first = part / 50 * each + 1;
    end = first + each;
  }
  unsigned first, end;
};

/// How universal, spherical and planar joints are written, if there are any: each as one joint, or as the
/// turns and slides that it means.
enum class Composed { none, as_one, written_out };

/// Writes trees of joints as TOML.
class TreeWriter {
 public:
  explicit TreeWriter(unsigned seed, Composed composed = Composed::none)
      : random_(seed), composed_(composed) {}

  std::string tree(int joints, bool followers) {
    return head() + "[base]\n" + vector("translation") + turns() + limbs(joints, followers);
  }

  /// One robot twice: with a base that floats, and with six joints, three slides and three turns, in
  /// place of that. The joints of the second are called x, y, z, rz, ry, rx, and q0, q1, ... behind them.
  struct Floating {
    std::string floating, with_joints;
  };
  Floating floating_tree(int joints, bool followers) {
    const std::string base = inertia();
    const std::string others = limbs(joints, followers);
    std::string hung = others;
    const std::string on_base = "parent = \"base\"";
    for (std::size_t at = hung.find(on_base); at != std::string::npos; at = hung.find(on_base))
      hung.replace(at, on_base.size(), "parent = \"rx\"");
    std::string six;
    for (const char* axis : {"x", "y", "z"})
      six += fmt::format("[[joint]]\ntype = \"prismatic\"\naxis = \"+{0}\"\nvariable = \"{0}\"\n", axis);
    for (const char* axis : {"z", "y", "x"})
      six += fmt::format("[[joint]]\ntype = \"revolute\"\naxis = \"+{0}\"\nvariable = \"r{0}\"\n", axis);
    return {head() + "[floating_base]\n" + base + others, head() + six + base + hung};
  }

 private:
  static std::string head() {
    return "name = \"tree\"\ntitle = \"tree\"\naccept_unphysical_inertia = true\n";
  }
  std::string limbs(int joints, bool followers) {
    std::string text;
    std::vector<int> parents;  // -1: the base
    for (int i = 0; i < joints; ++i) parents.push_back(below(i + 1) - 1);
    for (int i = 0; i < joints; ++i) {
      const bool last = std::find(parents.begin(), parents.end(), i) == parents.end();
      text += joint(i, parents[static_cast<std::size_t>(i)], last, followers);
    }
    return text + "[[tip]]\nname = \"tip\"\n";
  }

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double number() { return (below(19) - 9) / 10.0; }
  std::string vector(const std::string& key) {
    return fmt::format("{} = [{}, {}, {}]\n", key, number(), below(2) * number(), below(2) * number());
  }
  std::string axis() {
    static const std::vector<std::string> axes{"\"+x\"",
                                               "\"-y\"",
                                               "\"+z\"",
                                               "\"-z\"",
                                               "\"+y\"",
                                               "[\"3/5\", 0, \"-4/5\"]",
                                               "[\"2/3\", \"-1/3\", \"2/3\"]"};
    return axes[static_cast<std::size_t>(below(7))];
  }
  std::string turns() {
    static const std::vector<std::string> angles{"90 deg", "-90 deg", "180 deg",
                                                 "30 deg", "45 deg",  "120 deg"};
    return below(2) == 0 ? ""
                         : fmt::format("turns = [{{ axis = {}, angle = \"{}\" }}]\n", axis(),
                                       angles[static_cast<std::size_t>(below(6))]);
  }
  /// A last link has a mass, others may have none; beside composed joints, whose parts may repeat a motion,
  /// all have one.
  std::string joint(int i, int parent, bool last, bool followers) {
    if (composed_ != Composed::none && i > 0 && below(3) == 0) return composed_joint(i, parent);
    std::string text = fmt::format("[[joint]]\ntype = \"{}\"\naxis = {}\nvariable = \"q{}\"\n",
                                   below(3) == 0 ? "prismatic" : "revolute", axis(), i);
    if (i > 0) text += parent_text(parent);
    if (followers && i > 0 && !last && below(4) == 0) text += "follows = \"q0\"\nratio = \"-3/2\"\n";
    text += vector("origin") + turns() + vector("link");
    if (composed_ == Composed::none && !last && below(4) == 0) return text;  // without mass
    return text + inertia() + "rotor_inertia = 0.1\nviscous_friction = 0.2\n";
  }
  std::string parent_text(int parent) {
    const std::string name = parent < 0 ? "base" : fmt::format("q{}", parent);
    const auto part = last_parts_.find(parent);
    return fmt::format("parent = \"{}\"\n", part == last_parts_.end() ? name : part->second);
  }
  std::string composed_joint(int i, int parent) {
    struct Type {
      std::string name, parts;  ///< R or P, and the axis, of each part
    };
    static const std::array<Type, 3> types{
        {{"universal", "RxRy"}, {"spherical", "RxRyRz"}, {"planar", "PxPyRz"}}};
    const auto& [name, parts] = types.at(static_cast<std::size_t>(below(3)));
    const std::string before = parent_text(parent) + vector("origin") + turns();
    const std::string behind = vector("link") + inertia();
    if (composed_ == Composed::as_one)
      return fmt::format("[[joint]]\ntype = \"{}\"\nvariable = \"q{}\"\n", name, i) + before + behind +
             (parts.size() == 4 ? "viscous_friction = [0.1, 0.2]\n" : "viscous_friction = [0.1, 0.2, 0.3]\n");
    std::string text;
    for (std::size_t k = 0; k < parts.size(); k += 2) {
      last_parts_[i] = fmt::format("q{}_{}", i, parts[k + 1]);
      text += fmt::format("[[joint]]\ntype = \"{}\"\naxis = \"+{}\"\nvariable = \"{}\"\n",
                          parts[k] == 'R' ? "revolute" : "prismatic", parts[k + 1], last_parts_[i]) +
              (k == 0 ? before : "") + (k + 2 == parts.size() ? behind : "") +
              fmt::format("viscous_friction = 0.{}\n", k / 2 + 1);
    }
    return text;
  }
  std::string inertia() {
    return fmt::format("mass = {}\n", 1 + below(9)) + vector("centre_of_mass") +
           "inertia = [0.5, 0.6, 0.7, 0.05, -0.04, 0.03]\n";
  }

  std::mt19937 random_;
  Composed composed_;
  std::map<int, std::string> last_parts_;  ///< of joints that are written out
};

inline model::Robot read(const std::string& text) {
  const description::ReadResult result = description::read_text(text, "tree.toml");
  for (const auto& diagnostic : result.diagnostics)
    EXPECT_NE(diagnostic.severity, description::Diagnostic::error) << to_string(diagnostic) << "\n" << text;
  return result.robot.value();
}

/// A motion of a robot, by the symbols that formulations have.
struct Motion {
  Motion(const model::Robot& robot, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-2, 2);
    const std::vector<std::string> variables = model::variables(robot);
    const auto n = static_cast<Eigen::Index>(variables.size());
    const auto draw = [&] { return VectorXd::NullaryExpr(n, [&] { return unit(random); }).eval(); };
    q = draw(), qd = draw(), qdd = draw(), force = draw();
    const std::vector<std::vector<model::Share>> shares = model::shares(robot);
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const std::string& name = robot.joints[i].variable;
      double &value = values[name], &rate = values[derive::dynamics::velocity_of(name)];
      for (const model::Share& share : shares[i]) {
        value += cln::double_approx(share.ratio) * q[static_cast<Eigen::Index>(share.driven)];
        rate += cln::double_approx(share.ratio) * qd[static_cast<Eigen::Index>(share.driven)];
      }
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      values[derive::dynamics::velocity_of(variables[static_cast<std::size_t>(i)])] = qd[i];
      values[derive::dynamics::acceleration_of(variables[static_cast<std::size_t>(i)])] = qdd[i];
      values[derive::dynamics::force_of(variables[static_cast<std::size_t>(i)])] = force[i];
    }
    values[derive::dynamics::gravity_symbol] = 9.81;
  }
  VectorXd q, qd, qdd, force;
  std::map<std::string, double> values;
};

struct Leaves {
  const std::map<std::string, double>& values;

  [[nodiscard]] double constant(const exact::Number& number) const { return number.to_double(); }
  [[nodiscard]] double symbol(const std::string& name) const {
    if (const auto angle = exact::constant_angle(name))
      return std::atan2(angle->sine.to_double(), angle->cosine.to_double());
    const auto place = values.find(name);
    return place == values.end() ? 0 : place->second;
  }
  [[nodiscard]] double angle(const exact::Angle& angle) const {
    double sum = cln::double_approx(angle.pi) * std::acos(-1);
    for (const auto& [name, factor] : angle.terms) sum += cln::double_approx(factor) * symbol(name);
    return sum;
  }
  [[nodiscard]] double sine(const exact::Angle& a) const { return std::sin(angle(a)); }
  [[nodiscard]] double cosine(const exact::Angle& a) const { return std::cos(angle(a)); }
  [[nodiscard]] double root(double value) const { return std::sqrt(value); }
  [[nodiscard]] double arctangent(double y, double x) const { return std::atan2(y, x); }
};

/// The outputs, without suggestions.
inline VectorXd values_of(const Formulation& formulation, const Motion& motion) {
  std::map<std::string, double> values = motion.values;
  const auto constants = dag::evaluate<double>(formulation.constants, Leaves{motion.values});
  for (std::size_t i = 0; i < constants.size(); ++i)
    values[formulation.constants.outputs[i].name] = constants[i];
  const auto all = dag::evaluate<double>(formulation.function, Leaves{values});
  std::vector<double> kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (formulation.function.outputs[i].name.front() != '?') kept.push_back(all[i]);
  return Eigen::Map<const VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
}

inline MatrixXd symmetric(const VectorXd& upper, Eigen::Index n) {
  MatrixXd result(n, n);
  Eigen::Index next = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = i; k < n; ++k) result(i, k) = result(k, i) = upper[next++];
  return result;
}

inline void expect_close(const MatrixXd& a, const MatrixXd& b, const std::string& what,
                         double tolerance = 1e-12) {
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance * (1 + b.cwiseAbs().maxCoeff())) << what;
}

}  // namespace qvgen::test::trees
