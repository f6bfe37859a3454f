// SPDX-License-Identifier: MIT
// Forces of motors against Lagrange's equations in sixty digits, whose energies are functions of the motors'
// coordinates: linkages of tests/loops, and random linkages of pins, one pair of links closed after the
// other.
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "assembly_laws.h"
#include "embedded_energy.h"
#include "standing_functions.h"

namespace qvgen::test::loops {
namespace {

constexpr unsigned linkages_wanted = QVGEN_LOOP_RODS < 100 ? 1 : QVGEN_LOOP_RODS / 10;

/// Cranks, then pairs of links on any two links, pinned together: numbers of a crank's motor, masses and
/// drives are random.
class RandomPins {
 public:
  explicit RandomPins(unsigned seed) : random_(seed) {
    const int cranks = 1 + below(2);
    for (int i = 0; i < cranks; ++i) {
      add_joint("base");
      driven_ += (i == 0 ? "\"" : ", \"") + links_.back() + '"';
    }
    for (int pair = 0, pairs = 1 + below(3); pair < pairs; ++pair) {
      const std::string first = links_[static_cast<std::size_t>(below(static_cast<int>(links_.size())))];
      std::string second = "base";
      for (int i = 0; i < 5 && (second == first || second == "base"); ++i)
        second = links_[static_cast<std::size_t>(below(static_cast<int>(links_.size())))];
      add_joint(first);
      add_joint(second == first ? "base" : second);
      loops_ += "[[loop]]\ntype = \"pin\"\nbetween = [\"" + links_[links_.size() - 2] + "\", \"" +
                links_.back() + "\"]\nat = [[" + number(0.5, 0.9) + ", 0, 0], [" + number(0.5, 0.9) +
                ", 0, 0]]\n";
    }
  }
  [[nodiscard]] std::string text() const {
    return "name = \"m\"\ntitle = \"m\"\nactuated = [" + driven_ + "]\n" + joints_ +
           "[[tip]]\nname = \"end\"\n" + loops_;
  }

 private:
  void add_joint(const std::string& parent) {
    links_.push_back("q" + std::to_string(links_.size() + 1));
    joints_ += "[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"" + links_.back() +
               "\"\nparent = \"" + parent + "\"\norigin = [" + number(-0.4, 0.4) + ", 0, " +
               number(-0.4, 0.4) + "]\nmass = " + number(0.5, 2) + "\ncentre_of_mass = [" +
               number(-0.2, 0.2) + ", " + number(-0.2, 0.2) + ", " + number(-0.2, 0.2) +
               "]\ninertia = [0.05, 0.06, 0.07, 0.01, -0.005, 0.002]\nrotor_inertia = " + number(0, 0.1) +
               "\nviscous_friction = " + number(0, 0.3) + "\ncoulomb_friction = " + number(0, 0.2) + "\n";
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string number(double from, double to) {
    return std::to_string(std::uniform_real_distribution<double>(from, to)(random_));
  }
  std::mt19937 random_;
  std::vector<std::string> links_;
  std::string driven_, joints_, loops_;
};

/// Compares forces at assemblies for random values of the motors; returns at how many.
int compare_forces(const std::filesystem::path& file, const std::string& name, unsigned seed) {
  const reference::LoopMechanism of = reference::load_loops(file);
  const Compiled compiled(file, "dynamics,assembly");
  const StandingFunctions functions(compiled, name, of);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-2, 2);
  const auto driven = static_cast<Eigen::Index>(of.driven.size());
  const auto draw = [&] { return VectorXd::NullaryExpr(driven, [&] { return unit(random); }).eval(); };
  int compared = 0;
  for (int k = 0; k < 30 && compared < 6; ++k) {
    const VectorXd a = random_values(of, of.driven, random);
    for (const Row& row : functions.assemble(a).rows) {
      if (functions.drive_measure(row.q) < 0.03) continue;
      const EmbeddedEnergy energy(of, row.q);
      const VectorXd ad = draw(), add = draw(), q = EmbeddedEnergy::rounded(energy.joints(energy.exact(a)));
      const VectorXd expected =
          EmbeddedEnergy::rounded(energy.forces(energy.exact(a), energy.exact(ad), energy.exact(add)));
      const double scale = 1 + functions.rates(q).squaredNorm();
      EXPECT_LT((functions.inverse_dynamics(q, ad, add) - expected).norm(),
                1e-12 * (1 + expected.norm()) * scale);
      EXPECT_LT((functions.forward_dynamics(q, ad, expected) - add).norm(),
                1e-10 * (1 + expected.norm()) * scale);
      ++compared;
    }
  }
  return compared;
}

TEST(Lagrange, ForcesOfMotorsAreThoseOfLinkages) {
  std::vector<std::string> robots{"slider_crank", "geared_five_bar"};
  if (linkages_wanted > 1)
    robots.insert(robots.end(), {"four_bar", "five_bar", "delta", "excavator", "palletiser", "planar_3rpr"});
  for (const std::string& robot : robots) {
    SCOPED_TRACE(robot);
    const Folder folder;
    const std::filesystem::path file = folder.path / (robot + ".toml");
    std::filesystem::copy(std::filesystem::path(QVGEN_LOOP_ROBOTS) / (robot + ".toml"), file);
    EXPECT_GE(compare_forces(file, robot, 1), 6);
  }
}

TEST(Lagrange, ForcesOfMotorsAreThoseOfRandomPins) {
  unsigned compared = 0;
  for (unsigned seed = 1; compared < linkages_wanted && seed < 40 * linkages_wanted; ++seed) {
    const std::string text = RandomPins(seed).text();
    SCOPED_TRACE(text);
    const Folder folder;
    const std::filesystem::path file = folder.path / "m.toml";
    std::ofstream(file) << text;
    const reference::LoopMechanism of = reference::load_loops(file);
    const auto joints = static_cast<Eigen::Index>(of.chain.joints.size());
    if (reference::assemblies(of, VectorXd::Zero(joints), {}, 5, seed).empty()) continue;
    compared += compare_forces(file, "m", seed) > 0 ? 1 : 0;
  }
  EXPECT_EQ(compared, linkages_wanted);
}

}  // namespace
}  // namespace qvgen::test::loops
