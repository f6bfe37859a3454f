// SPDX-License-Identifier: MIT
#include "configurations.h"

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include <Eigen/Geometry>
#include <toml++/toml.h>

#include "arm_values.h"
#include "frame_values.h"
#include "newton_euler_values.h"
#include "reference/load.h"
#include "screw_values.h"

namespace qvgen::test::sources {
namespace {

constexpr unsigned samples = 20;

class Random {
 public:
  explicit Random(unsigned number) : engine_(number) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// Turns by less than half a turn, so that half of one is known; slides likewise.
  Eigen::VectorXd vector(Eigen::Index size) {
    Eigen::VectorXd result(size);
    for (double& x : result) x = between(-3, 3);
    return result;
  }

 private:
  std::mt19937 engine_;
};

std::string description_of(const Section& section) {
  if (section.robot.empty()) return section.description;
  std::ifstream file(QVGEN_SOURCE_DIR "/generator/robots/" + section.robot + ".toml");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A value for each symbol of a description.
reference::Values constants_of(const std::string& description, Random& random) {
  reference::Values values{{"g", random.between(9, 10)}};
  const toml::table table = toml::parse(description);
  if (const toml::table* defaults = table["defaults"].as_table())
    for (const auto& entry : *defaults) values[std::string(entry.first.str())] = random.between(0.2, 1.2);
  return values;
}

/// The one state of an example that has numbers.
Known values_of_example(const Section& section, const std::string& description) {
  const NumbersOfExample& numbers = section.numbers;
  const reference::Chain chain = reference::load_text(description, numbers.lengths);
  const auto size = static_cast<Eigen::Index>(chain.joints.size());
  Eigen::VectorXd q(size), qd(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double unit = chain.joints[k].revolute ? std::acos(-1.0) / 180 : 1;
    q[i] = unit * numbers.positions.at(k);
    qd[i] = unit * numbers.rates.at(k);
  }
  return frame_values(chain, numbers.lengths, q, qd);
}

Known values_of(const Section& section, const std::string& description, Random& random) {
  reference::Values constants = constants_of(description, random);
  const reference::Chain chain = reference::load_text(description, constants);
  const auto size = static_cast<Eigen::Index>(chain.joints.size());
  const Eigen::VectorXd q = random.vector(size);
  if (section.frames) return frame_values(chain, constants, q, random.vector(size));
  if (section.dynamics)
    return newton_euler_values(chain, constants, q, random.vector(size), random.vector(size));
  constants.erase("g");
  if (!section.screws.empty()) return screw_values(section.screws, chain, constants, q);
  return arm_values(chain, constants, q);
}

void add_displacement(const std::string& number, Random& random, Known& known) {
  const Eigen::Vector3d axis = random.vector(3).normalized();
  const double angle = random.between(-3, 3);
  const Quaternion q{std::cos(angle / 2), std::sin(angle / 2) * axis};
  known["s" + number] = q.s;
  known["v" + number] = q.v;
  known["q" + number] = q;
  known["p" + number] = Eigen::Vector3d(random.vector(3));
  known["Q" + number] = Pair{q, std::get<Eigen::Vector3d>(known["p" + number])};
}

}  // namespace

Known rotation_values(unsigned number) {
  Random random(number);
  Known known;
  const Eigen::Vector3d k = random.vector(3).normalized();
  const double theta = random.between(-3, 3);
  const Eigen::Matrix3d matrix = Eigen::AngleAxisd(theta, k).toRotationMatrix();
  const Eigen::Vector3d v = std::sin(theta / 2) * k;
  known["theta"] = theta;
  known["q"] = Quaternion{std::cos(theta / 2), v};
  known["s"] = std::cos(theta / 2);
  known["v"] = v;
  known["R"] = Eigen::MatrixXd(matrix);
  known["p"] = Eigen::Vector3d(random.vector(3));
  known["Q"] = Pair{std::get<Quaternion>(known["q"]), std::get<Eigen::Vector3d>(known["p"])};
  for (int i = 0; i < 3; ++i) {
    known[std::string("k") + "xyz"[i]] = k[i];
    known[std::string(1, "xyz"[i])] = v[i];
    for (int j = 0; j < 3; ++j) known["r" + std::to_string(10 * (i + 1) + j + 1)] = matrix(i, j);
  }
  add_displacement("1", random, known);
  add_displacement("2", random, known);
  return known;
}

std::vector<std::string> joint_variables(const Section& section) {
  std::vector<std::string> names;
  for (const reference::Joint& joint : reference::load_text(description_of(section)).joints)
    names.push_back(joint.variable);
  return names;
}

std::vector<Known> configurations(const Section& section) {
  const std::string description = description_of(section);
  if (!section.numbers.positions.empty()) return {values_of_example(section, description)};
  std::vector<Known> result;
  for (unsigned number = 1; number <= samples; ++number) {
    Random random(number);
    if (section.screws == "axes") {
      std::mt19937 engine(number);
      result.push_back(turned_twice(engine));
      continue;
    }
    result.push_back(description.empty() ? rotation_values(number) : values_of(section, description, random));
  }
  return result;
}

}  // namespace qvgen::test::sources
