// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include "application/certificate.h"
#include "application/dynamics_function.h"
#include "description/reader.h"
#include "passes/search/random.h"

namespace qvgen::application {
namespace {

using passes::search_detail::Random;

model::Robot read(const std::string& text) {
  const description::ReadResult result = description::read_text(text, "test.toml");
  for (const auto& diagnostic : result.diagnostics)
    EXPECT_NE(diagnostic.severity, description::Diagnostic::error) << to_string(diagnostic);
  return result.robot.value();
}

/// A few joints of both kinds anywhere, axes along coordinate axes, offsets on both sides, all inertias free.
std::string random_robot(std::uint64_t seed, const std::string& kinds) {
  Random random(seed);
  const std::string axes[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  std::string text = "name = \"random\"\ntitle = \"random\"\ninertia = \"free\"\n";
  const auto offset = [&](const std::string& name) {
    std::string list;
    for (const char* axis : {"x", "y", "z"})
      list +=
          (list.empty() ? "" : ", ") + (random.chance(100) ? "\"" + name + axis + "\"" : std::string("0"));
    return "[" + list + "]";
  };
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    text += "[[joint]]\ntype = \"" + std::string(kinds[i] == 'R' ? "revolute" : "prismatic") +
            "\"\naxis = \"" + axes[random.below(6)] + "\"\nvariable = \"q" + n +
            "\"\norigin = " + offset("o" + n) + "\n";
    if (kinds[i] == 'R') text += "link = " + offset("l" + n) + "\n";
  }
  return text;
}

constexpr DynamicsEffort little{.trial_steps = 1'000, .final_steps = 5'000, .certificate_points = 1};

/// The certificate in generate_dynamics holds every function against the plain recursion, so this throws if
/// any frame, gauge or formulation is wrong for some arrangement of joints.
TEST(Dynamics, RandomRobotsPassTheirCertificates) {
  std::uint64_t seed = 0;
  for (const char* kinds : {"R", "P", "PR", "RP", "RR", "PRR", "RPR", "RRP", "PPR", "RRR", "RPP"})
    for (int k = 0; k < 2; ++k) {
      const std::string text = random_robot(++seed, kinds);
      const model::Robot robot = read(text);
      for (const DynamicsQuantity& quantity : dynamics_quantities())
        EXPECT_NO_THROW(generate_dynamics(robot, quantity, little)) << quantity.name << "\n" << text;
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
  const DynamicsFunction function = generate_dynamics(read(pendulum), dynamics_quantities().front(), little);
  EXPECT_EQ(function.counts.multiplications, 2);  // (J + m l^2) theta'' - (m g l) cos theta
  EXPECT_EQ(function.counts.additions, 1);
  EXPECT_EQ(function.constants.outputs.size(), 2U);
}

TEST(Dynamics, CertificateRefusesAWrongFunction) {
  DynamicsQuantity wrong = dynamics_quantities().front();
  const auto formulate = wrong.formulate;
  wrong.formulate = [formulate](const model::Robot& robot, const derive::dynamics::Choices& choices) {
    derive::dynamics::Formulation result = formulate(robot, choices);
    for (dag::Output& output : result.function.outputs) output.value.negative = !output.value.negative;
    return result;
  };
  EXPECT_THROW(generate_dynamics(read(pendulum), wrong, little), CertificateError);
}

TEST(Dynamics, DrivesAddTheirInertiaAndFriction) {
  const std::string driven =
      pendulum + "rotor_inertia = \"Ir\"\nviscous_friction = \"b\"\ncoulomb_friction = \"f\"\n";
  for (const DynamicsQuantity& quantity : dynamics_quantities())
    EXPECT_NO_THROW(generate_dynamics(read(driven), quantity, little)) << quantity.name;
  const DynamicsFunction function = generate_dynamics(read(driven), dynamics_quantities().front(), little);
  EXPECT_LE(function.counts.multiplications, 5);
  EXPECT_LE(function.counts.additions, 4);
}

TEST(Dynamics, ARobotWithoutInertiaHasNone) {
  EXPECT_TRUE(has_inertia(read(pendulum)));
  EXPECT_FALSE(has_inertia(read(
      "name = \"x\"\ntitle = \"x\"\n[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"q1\"\n")));
}

}  // namespace
}  // namespace qvgen::application
