// SPDX-License-Identifier: MIT
// Dynamics of joints that branch. Random trees of turns, slides, joints that follow others and links without
// mass, their frames turned anyhow: each quantity, as it is derived, against the tests' own recursion, which
// shares no code; and a few of them through search and certificate.
#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dag/evaluate.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/regressor.h"
#include "description/reader.h"
#include "exact/constant_angle.h"
#include "model/followers.h"
#include "model/mechanism.h"
#include "optimise/dynamics.h"
#include "reference/dynamics.h"
#include "reference/load.h"

namespace qvgen::test::trees {
namespace {

using derive::dynamics::Formulation;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Writes trees of joints as TOML.
class TreeWriter {
 public:
  explicit TreeWriter(unsigned seed) : random_(seed) {}

  std::string tree(int joints, bool followers) {
    std::string text = "name = \"tree\"\ntitle = \"tree\"\naccept_unphysical_inertia = true\n[base]\n" +
                       vector("translation") + turns();
    std::vector<int> parents;  // -1: the base
    for (int i = 0; i < joints; ++i) parents.push_back(below(i + 1) - 1);
    for (int i = 0; i < joints; ++i) {
      const bool last = std::find(parents.begin(), parents.end(), i) == parents.end();
      text += joint(i, parents[static_cast<std::size_t>(i)], last, followers);
    }
    return text + "[[tip]]\nname = \"tip\"\n";
  }

 private:
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
  /// A last link has a mass, others may have none.
  std::string joint(int i, int parent, bool last, bool followers) {
    std::string text = fmt::format("[[joint]]\ntype = \"{}\"\naxis = {}\nvariable = \"q{}\"\n",
                                   below(3) == 0 ? "prismatic" : "revolute", axis(), i);
    if (i > 0) text += fmt::format("parent = \"{}\"\n", parent < 0 ? "base" : fmt::format("q{}", parent));
    if (followers && i > 0 && !last && below(4) == 0) text += "follows = \"q0\"\nratio = \"-3/2\"\n";
    text += vector("origin") + turns() + vector("link");
    if (!last && below(4) == 0) return text;  // without mass
    return text + fmt::format("mass = {}\n", 1 + below(9)) + vector("centre_of_mass") +
           "inertia = [0.5, 0.6, 0.7, 0.05, -0.04, 0.03]\nrotor_inertia = 0.1\nviscous_friction = 0.2\n";
  }

  std::mt19937 random_;
};

model::Robot read(const std::string& text) {
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
VectorXd values_of(const Formulation& formulation, const Motion& motion) {
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

MatrixXd symmetric(const VectorXd& upper, Eigen::Index n) {
  MatrixXd result(n, n);
  Eigen::Index next = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = i; k < n; ++k) result(i, k) = result(k, i) = upper[next++];
  return result;
}

void expect_close(const MatrixXd& a, const MatrixXd& b, const std::string& what, double tolerance = 1e-12) {
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance * (1 + b.cwiseAbs().maxCoeff())) << what;
}

class RandomTrees : public testing::TestWithParam<int> {};

TEST_P(RandomTrees, EveryQuantityIsTheReference) {
  for (unsigned seed = static_cast<unsigned>(GetParam()); seed < static_cast<unsigned>(GetParam()) + 50;
       ++seed) {
    const std::string text = TreeWriter(seed).tree(2 + static_cast<int>(seed % 9), seed % 3 == 0);
    const model::Robot robot = read(text);
    const reference::Chain chain = reference::load_text(text);
    const Motion motion(robot, seed);
    const auto& [q, qd, qdd, force, unused] = motion;
    const VectorXd zero = VectorXd::Zero(q.size());
    const derive::dynamics::FormulationOptions choices;
    const VectorXd torque = values_of(inverse_dynamics(robot, choices), motion);
    expect_close(torque, reference::inverse_dynamics(chain, q, qd, qdd), text);
    expect_close(values_of(inverse_dynamics(robot, choices, derive::dynamics::Effects::gravity), motion),
                 reference::inverse_dynamics(chain, q, zero, zero), text);
    const MatrixXd mass = symmetric(values_of(mass_matrix(robot, choices), motion), q.size());
    expect_close(mass, reference::mass_matrix(chain, q), text);
    const double kinetic = reference::kinetic_energy(chain, q, qd);
    EXPECT_NEAR(values_of(kinetic_energy(robot, choices), motion)[0], kinetic, 1e-12 * (1 + kinetic)) << text;
    const double potential = reference::potential_energy(chain, q);
    EXPECT_NEAR(values_of(potential_energy(robot, choices), motion)[0], potential,
                1e-12 * (1 + std::abs(potential)))
        << text;
    expect_close(values_of(centre_of_mass(robot, choices), motion), reference::centre_of_mass(chain, q),
                 text);
    const VectorXd found = values_of(forward_dynamics(robot, choices), motion);
    expect_close(reference::inverse_dynamics(chain, q, qd, found), force, text,
                 1e-13 * (1 + mass.norm() * found.norm()));
    const VectorXd coriolis = values_of(coriolis_matrix(robot, choices), motion);
    const Eigen::Index n = q.size();
    const MatrixXd c =
        Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(coriolis.data(), n, n);
    expect_close(c * qd,
                 values_of(inverse_dynamics(robot, choices, derive::dynamics::Effects::velocity), motion),
                 text);
    if (HasFailure()) return;
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomTrees, testing::Values(1, 51, 101, 151));

/// An entry of the mass matrix that is written as zero belongs to joints that do not carry one another, and
/// no other entry does.
TEST(Trees, SparsityOfTheMassMatrixIsExact) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::string text = TreeWriter(seed).tree(6, false);
    const model::Robot robot = read(text);
    const Formulation mass = derive::dynamics::mass_matrix(robot, {});
    std::size_t next = 0;
    for (std::size_t i = 0; i < robot.joints.size(); ++i)
      for (std::size_t k = i; k < robot.joints.size(); ++k) {
        std::size_t at = k;
        while (at != model::base_link && at != i) at = model::parent_of(robot, at);
        while (mass.function.outputs[next].name.front() == '?') ++next;
        const dag::Output& output = mass.function.outputs[next++];
        EXPECT_EQ(output.name, fmt::format("m{}_{}", i + 1, k + 1));
        const bool is_zero = mass.function.graph.is_zero(output.value);
        if (at == model::base_link) {
          EXPECT_TRUE(is_zero) << output.name << "\n" << text;
        }
      }
  }
}

/// Search and certificate, which throws if any output differs from the plain recursion.
TEST(Trees, PassTheirCertificates) {
  const optimise::DynamicsEffort little{.trial_steps = 500, .final_steps = 2'000, .certificate_points = 1};
  for (const unsigned seed : {3U, 4U, 8U, 9U}) {
    const std::string text = TreeWriter(seed).tree(4, seed % 3 == 0);
    const optimise::DynamicsModel model = optimise::dynamics_model(read(text));
    std::vector<optimise::DynamicsQuantity> all = optimise::dynamics_quantities();
    for (const optimise::DynamicsQuantity& quantity : optimise::mass_quantities(model.described))
      all.push_back(quantity);
    for (const optimise::DynamicsQuantity& quantity : all)
      EXPECT_NO_THROW(generate_dynamics(model, quantity, little)) << quantity.name << "\n" << text;
  }
}

/// Each joint that is not moved by the other is in a limb of its own: its torque does not depend on the
/// other.
TEST(Trees, JointsBesideOneAnotherHaveTheTorquesOfTheirOwnChains) {
  const std::string both = TreeWriter(77).tree(1, false);
  const std::string joint =
      both.substr(both.find("[[joint]]"), both.find("[[tip]]") - both.find("[[joint]]"));
  std::string second = joint;
  second.replace(second.find("\"q0\""), 4, "\"q1\"\nparent = \"base\"");
  std::string text = both;
  text.insert(text.find("[[tip]]"), second);
  const model::Robot robot = read(text);
  const Motion motion(robot, 5);
  const VectorXd torque = values_of(derive::dynamics::inverse_dynamics(robot, {}), motion);
  const reference::Chain one = reference::load_text(both);
  for (Eigen::Index i = 0; i < 2; ++i)
    expect_close(torque.segment<1>(i),
                 reference::inverse_dynamics(one, motion.q.segment<1>(i), motion.qd.segment<1>(i),
                                             motion.qdd.segment<1>(i)),
                 text);
}

}  // namespace
}  // namespace qvgen::test::trees
