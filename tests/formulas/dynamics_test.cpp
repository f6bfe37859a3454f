// SPDX-License-Identifier: MIT
// What `show --dynamics` prints, read as a reader would, against Newton and Euler in numbers: the arms of the
// sixteen codes without their wrists, masses in the middle of the links and at their ends.
#include "reference/dynamics.h"

#include <random>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "description/write.h"
#include "emit/math/dynamics_closed_form.h"
#include "model/links.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

using namespace reference;

/// With what primes say spelled out: theta1'' is theta1_acceleration; "[a] b" is a product.
std::string readable(std::string line) {
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = line.find(from); at != std::string::npos; at = line.find(from, at + to.size()))
      line.replace(at, from.size(), to);
  };
  replace("] ", "]*");
  replace("]*+", "] +");
  replace("]*-", "] -");
  replace("[", "(");
  replace("]", ")");
  replace("''", "_acceleration");
  replace("'", "_rate");
  return line;
}

/// The right sides of tau1 = ..., lines put together.
std::vector<std::string> forces_in(const std::vector<std::string>& lines) {
  std::vector<std::string> forces;
  for (const std::string& line : lines) {
    const std::size_t equals = line.find(" = ");
    if (line.rfind("tau", 0) == 0 && equals != std::string::npos)
      forces.push_back(line.substr(equals + 3));
    else if (!forces.empty())
      forces.back() += " " + line.substr(line.find_first_not_of(' '));
  }
  for (std::string& force : forces) force = readable(force);
  return forces;
}

/// The arm at random values of everything: what is printed and what the recursion in numbers finds.
void expect_same_forces(const model::Robot& arm) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.2, 1.4);
  Values values{{"gravity", 9.81}};
  for (const auto* parameters : {&arm.geometry, &arm.inertia_parameters})
    for (const model::Parameter& parameter : *parameters) values[parameter.name] = uniform(random);
  const Chain chain = load_text(description::write_text(arm), values);
  VectorXd q(3);
  VectorXd qd(3);
  VectorXd qdd(3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const std::string& name = chain.joints[static_cast<std::size_t>(i)].variable;
    values[name] = q[i] = uniform(random);
    values[name + "_rate"] = qd[i] = uniform(random);
    values[name + "_acceleration"] = qdd[i] = uniform(random);
  }
  const VectorXd expected = inverse_dynamics(chain, q, qd, qdd);
  const auto forces = forces_in(emit::dynamics_closed_form_lines(arm, emit::Notation::text));
  ASSERT_EQ(forces.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(evaluate(forces[i], values), expected[static_cast<Eigen::Index>(i)], 1e-12)
        << arm.name << " tau" << i + 1 << " = " << forces[i];
}

class ForcesOf : public testing::TestWithParam<const char*> {};

TEST_P(ForcesOf, ThreeJointsAreTheRecursionsInNumbers) {
  const auto read =
      description::read_file(std::string(QVGEN_SOURCE_DIR "/generator/robots/") + GetParam() + ".toml");
  const model::Robot arm = model::first_joints(read.robot.value(), 3);
  for (const auto place : {model::MassPlace::middle, model::MassPlace::end})
    expect_same_forces(model::with_masses(arm, place));
}

INSTANTIATE_TEST_SUITE_P(Codes, ForcesOf,
                         testing::Values("ss", "sc", "sn", "sr", "cs", "cc", "cn", "cr", "ns", "nc", "nn",
                                         "nr", "rs", "rc", "rn", "rr"),
                         [](const auto& code) { return std::string(code.param); });

/// The thesis places the masses of its NS arm so (page before (5.22)): link 1 is the column, link 2 the
/// offset along the axis of joint 2, link 3 the rod.
TEST(Links, OfTheSphericalArmAreThoseOfTheThesis) {
  const auto read = [](const std::string& name) {
    return description::read_file(QVGEN_SOURCE_DIR "/generator/robots/" + name + ".toml").robot.value();
  };
  const auto terms = [](const model::Robot& arm) {
    std::vector<std::string> lines = emit::dynamics_closed_form_lines(arm, emit::Notation::text);
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  };
  std::string ours = terms(model::with_masses(model::first_joints(read("ns"), 3), model::MassPlace::middle));
  EXPECT_NE(ours.find("m3*(d3^2 + 0.25*length3^2 - d3*length3)"), std::string::npos) << ours;
  EXPECT_NE(ours.find("cos(theta2)^2*(Izz2 + Izz3)"), std::string::npos) << ours;
  EXPECT_EQ(std::count(ours.begin(), ours.end(), '['), 17) << ours;
}

TEST(Links, OfArmsWithFewerJointsAreRefused) {
  const auto read = description::read_file(QVGEN_SOURCE_DIR "/generator/robots/ns_arm.toml");
  EXPECT_THROW(model::first_joints(read.robot.value(), 4), std::domain_error);
}

}  // namespace
}  // namespace qvgen::test
