// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "optimise/dynamics.h"
#include "optimise/dynamics_derivatives.h"
#include "passes/search/random.h"
#include "verify/certificate.h"

namespace qvgen::optimise {
namespace {

using passes::search_detail::Random;

model::Robot read(const std::string& text) {
  const description::ReadResult result = description::read_text(text, "test.toml");
  for (const auto& diagnostic : result.diagnostics)
    EXPECT_NE(diagnostic.severity, description::Diagnostic::error) << to_string(diagnostic);
  return result.robot.value();
}

using Axes = std::vector<std::string>;
const Axes coordinate_axes = {"\"+x\"", "\"-x\"", "\"+y\"", "\"-y\"", "\"+z\"", "\"-z\""};
const Axes oblique_axes = {"[\"3/5\", 0, \"-4/5\"]",       "[0, \"5/13\", \"12/13\"]",
                           "[\"2/3\", \"-1/3\", \"2/3\"]", "[\"sqrt(2)/2\", \"1/2\", \"-1/2\"]",
                           "[\"-sqrt(3)/2\", \"1/2\", 0]", "\"+y\""};

/// A few joints of both kinds anywhere, offsets on both sides, a base and a tool, all inertias free.
std::string random_robot(std::uint64_t seed, const std::string& kinds, const Axes& axes = coordinate_axes) {
  Random random(seed);
  std::string text = "name = \"random\"\ntitle = \"random\"\ninertia = \"free\"\n";
  const auto offset = [&](const std::string& name) {
    std::string list;
    for (const char* axis : {"x", "y", "z"})
      list +=
          (list.empty() ? "" : ", ") + (random.chance(100) ? "\"" + name + axis + "\"" : std::string("0"));
    return "[" + list + "]";
  };
  text += "[base]\ntranslation = " + offset("b") + "\nturns = [{ axis = " + axes[random.below(6)] +
          ", angle = \"90 deg\" }]\n[tool]\ntranslation = " + offset("t") + "\n";
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    text += "[[joint]]\ntype = \"" + std::string(kinds[i] == 'R' ? "revolute" : "prismatic") +
            "\"\naxis = " + axes[random.below(6)] + "\nvariable = \"q" + n +
            "\"\norigin = " + offset("o" + n) + "\n";
    if (kinds[i] == 'R') text += "link = " + offset("l" + n) + "\n";
  }
  return text;
}

/// Little search: whether a function is right does not depend on how far it is simplified.
constexpr DynamicsEffort little{.trial_steps = 1'000, .final_steps = 5'000, .certificate_points = 1};

DynamicsModel model_of(const std::string& text) { return dynamics_model(read(text), little); }

const DynamicsQuantity& quantity(const std::string& name) {
  for (const DynamicsQuantity& q : dynamics_quantities())
    if (q.name == name) return q;
  throw std::invalid_argument(name);
}

std::vector<DynamicsQuantity> all_quantities() {
  std::vector<DynamicsQuantity> all = dynamics_quantities();
  for (const LoadedQuantity& loaded : loaded_quantities()) all.push_back(loaded.quantity);
  return all;
}

/// The certificate in generate_dynamics holds every function against the plain recursion, so this throws if
/// any frame, convention or formulation is wrong for some arrangement of joints.
/// In long runs axes are along coordinates and oblique in each arrangement. A usual run has one joint of each
/// type, two in each order, and three turns, or turns about a slide, each with axes of one kind.
TEST(Dynamics, RandomRobotsPassTheirCertificates) {
  const bool has_all = std::getenv("QVGEN_TREES") != nullptr;
  std::vector<std::string> arrangements{"R", "P", "PR", "RP", "RR", "RRR", "RPR"};
  if (has_all) arrangements.insert(arrangements.end(), {"RRP", "PPR", "PRR", "RPP", "PRP"});
  std::uint64_t seed = 0;
  for (const bool oblique : {false, true})
    for (std::size_t k = 0; k < arrangements.size(); ++k) {
      ++seed;
      if (arrangements[k].size() > 1 && (k % 2 == 1) != oblique && !has_all) continue;
      const std::string text = random_robot(seed, arrangements[k], oblique ? oblique_axes : coordinate_axes);
      const DynamicsModel model = model_of(text);
      for (const DynamicsQuantity& quantity : all_quantities())
        EXPECT_NO_THROW(generate_dynamics(model, quantity, little)) << quantity.name << "\n" << text;
    }
}

/// A rational unit vector, the third column of a random quaternion's matrix.
std::string random_axis(Random& random) {
  const auto any = [&] { return static_cast<int>(random.below(9)) - 4; };
  const int a = any(), b = any(), c = any(), d = any();
  const int norm = a * a + b * b + c * c + d * d;
  if (norm == 0) return random_axis(random);
  const auto part = [&](int number) {
    return "\"" + std::to_string(number) + "/" + std::to_string(norm) + "\"";
  };
  return "[" + part(2 * (b * d + a * c)) + ", " + part(2 * (c * d - a * b)) + ", " +
         part(a * a - b * b - c * c + d * d) + "]";
}

/// Sines of angles between such axes are square roots of any numbers. Derivatives have two forms, which the
/// search holds against each other before the certificate does.
TEST(Dynamics, DerivativesOfArmsWithAnyAxesPassTheirCertificates) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    Axes axes;
    for (int i = 0; i < 6; ++i) axes.push_back(random_axis(random));
    const std::string text = random_robot(seed, "RRR", axes);
    const DynamicsModel model = model_of(text);
    const Optimised forces = generate_dynamics(model, quantity("inverse_dynamics"), little);
    EXPECT_NO_THROW(inverse_dynamics_derivatives(model, forces, little)) << text;
  }
}

/// Two axes at any angle meet in z x z: nothing stands between two links, and no offset is left sideways.
TEST(Dynamics, ObliqueAxesNeedNoLinksInBetween) {
  const Axes rational(oblique_axes.begin(), oblique_axes.begin() + 3);
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    dag::Graph graph;
    Axes axes = rational;
    axes.insert(axes.end(), rational.begin(), rational.end());
    const model::Robot robot = read(random_robot(seed, "RRRR", axes));
    const auto chain = derive::dynamics::make_chain(robot, graph);
    EXPECT_EQ(chain.links.size(), 4U);
    for (const auto& link : chain.links) EXPECT_TRUE(link.b.is_zero() || link.alpha.terms.empty());
  }
}

TEST(Dynamics, AnAxisThatIsNotExactIsRefusedWithAReason) {
  const std::string text =
      "name = \"x\"\ntitle = \"x\"\ninertia = \"free\"\n[[joint]]\ntype = \"revolute\"\nvariable = \"q1\"\n"
      "axis = [\"sin(20 deg)\", 0, \"cos(20 deg)\"]\n";
  const model::Robot robot = read(text);
  const DynamicsModel as_described{{robot, {exact::Angle{}}}, robot};
  try {
    generate_dynamics(as_described, dynamics_quantities().front(), little);
    FAIL() << "nothing thrown";
  } catch (const std::domain_error& error) {
    EXPECT_EQ(std::string(error.what()),
              "dynamics: sin(1/9*pi) in the direction of an axis is not exact; write the axis as \"+z\" "
              "after turns that lead there");
  }
}

std::string pendulum = R"(
name = "pendulum"
title = "Pendulum"
[[joint]]
type = "revolute"
axis = "+y"
variable = "theta1"
mass = "m"
centre_of_mass = ["l", 0, 0]
inertia = [0, "J", 0]
)";

TEST(Dynamics, PendulumTakesTwoMultiplicationsAndAnAddition) {
  const Optimised function = generate_dynamics(model_of(pendulum), dynamics_quantities().front(), little);
  EXPECT_EQ(function.counts.multiplications, 2);  // (J + m l^2) theta'' - (m g l) cos theta
  EXPECT_EQ(function.counts.additions, 1);
  EXPECT_EQ(function.constants.outputs.size(), 2U);
}

TEST(Dynamics, CertificateRefusesAWrongFunction) {
  DynamicsQuantity wrong = dynamics_quantities().front();
  const auto formulate = wrong.formulate;
  wrong.formulate = [formulate](const model::Robot& robot,
                                const derive::dynamics::FormulationOptions& choices) {
    derive::dynamics::Formulation result = formulate(robot, choices);
    for (dag::Output& output : result.function.outputs) output.value.negative = !output.value.negative;
    return result;
  };
  EXPECT_THROW(generate_dynamics(model_of(pendulum), wrong, little), verify::CertificateError);
}

TEST(Dynamics, DrivesAddTheirInertiaAndFriction) {
  const std::string driven =
      pendulum + "rotor_inertia = \"Ir\"\nviscous_friction = \"b\"\ncoulomb_friction = \"f\"\n";
  for (const DynamicsQuantity& quantity : all_quantities())
    EXPECT_NO_THROW(generate_dynamics(model_of(driven), quantity, little)) << quantity.name;
  const Optimised function = generate_dynamics(model_of(driven), dynamics_quantities().front(), little);
  EXPECT_LE(function.counts.multiplications, 5);
  EXPECT_LE(function.counts.additions, 4);
}

/// C qd has no friction in it, whatever the drives: coriolis_torque is that product.
TEST(Dynamics, CoriolisTorqueLeavesFrictionOut) {
  const std::string driven = pendulum + "viscous_friction = \"b\"\ncoulomb_friction = \"f\"\n";
  const Optimised function = generate_dynamics(model_of(driven), quantity("coriolis_torque"), little);
  EXPECT_EQ(function.constants.outputs.size(), 0U);
  EXPECT_TRUE(function.function.graph.is_zero(function.function.outputs.front().value));
}

TEST(Dynamics, CertificateRefusesACoriolisMatrixThatIsNotOfChristoffelsSymbols) {
  // C + [[q2', -q1'], [0, 0]] gives the same C q', but M' - 2 C is skew-symmetric no more.
  const model::Robot robot = read(random_robot(4, "RR"));
  DynamicsQuantity wrong = quantity("coriolis_matrix");
  const auto formulate = wrong.formulate;
  wrong.formulate = [formulate](const model::Robot& r, const derive::dynamics::FormulationOptions& choices) {
    derive::dynamics::Formulation result = formulate(r, choices);
    dag::Graph& graph = result.function.graph;
    const auto add = [&](const std::string& entry, const std::string& rate, bool negative) {
      for (dag::Output& output : result.function.outputs) {
        const dag::Edge term = graph.symbol(derive::dynamics::velocity_of(rate));
        if (output.name == entry) output.value = graph.sum({output.value, negative ? -term : term});
      }
    };
    add("c1_1", "q2", false);
    add("c1_2", "q1", true);
    return result;
  };
  EXPECT_THROW(generate_dynamics(dynamics_model(robot, little), wrong, little), verify::CertificateError);
}

TEST(Dynamics, ARobotWithoutInertiaHasNone) {
  EXPECT_TRUE(has_inertia(read(pendulum)));
  EXPECT_FALSE(has_inertia(read(
      "name = \"x\"\ntitle = \"x\"\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"q1\"\n")));
}

}  // namespace
}  // namespace qvgen::optimise
