// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <qvgen/inverse/elimination/solve.h>

namespace qvgen::test {

using Joints6 = Eigen::Matrix<double, 6, 1>;
using Random = std::mt19937_64;

double uniform(Random& random, double low = -1, double high = 1);

/// T(q) = J1 C1 ... J6 C6, each J a turn about z or a slide along it. The tests' own kinematics: it shares
/// nothing with the solver.
struct Arm {
  std::string name;
  std::array<Eigen::Isometry3d, 6> links;
  std::array<bool, 6> slides{};

  [[nodiscard]] Eigen::Isometry3d tool(const Joints6& q) const;
  /// Axes and tool at the zero pose, as the solver wants them.
  [[nodiscard]] inverse::elimination::Description description() const;
  [[nodiscard]] double size() const;
  /// Uniform in [-pi, pi), slides over the arm's size.
  [[nodiscard]] Joints6 joints(Random& random) const;
  /// Largest difference of two joint vectors, revolute joints the short way round.
  [[nodiscard]] double distance(const Joints6& a, const Joints6& b) const;
  /// Returns the determinant of the Jacobian at the tool, lengths in units of the arm's size.
  [[nodiscard]] double determinant(const Joints6& q) const;
};

/// Joints at which the Jacobian's determinant vanishes, sampled but for one, which is turned there, if it can
/// be.
std::optional<Joints6> at_a_singularity(const Arm& arm, Random& random, int joint);

/// Rows d, a, alpha (m, degrees) of Denavit and Hartenberg's table, angles measured from its x axes.
Arm of_table(const std::string& name, const double (&table)[6][3]);
/// Returns an arm by a table in Craig's convention: a and alpha come before the joint.
Arm of_modified_table(const std::string& name, const double (&table)[6][3]);
/// Every axis turned and moved by as much as this, rad and m.
Arm miscalibrated(Arm arm, double by, unsigned seed);
Arm random_arm(unsigned seed, int slides);
/// Every axis along a coordinate axis, the first along z, lengths drawn at random; one joint slides.
/// `parallel`: one axis in three may have the direction of the one before, else none has.
Arm arm_along_axes(unsigned seed, int slide, bool parallel);

Arm manseur_doty();
Arm raghavan_roth();
Arm jaco2();
Arm crx10ia();
Arm xarm6();
Arm m10();
Arm ur5();
Arm irb6640();
Arm piper();
/// All axes in two directions at many poses, four of them in two lines, as a Gen3's: several joints are free
/// at once.
Arm in_line();
/// All of these, the last three miscalibrated by 1e-4.
std::vector<Arm> named_arms();

/// Instruction sets of the solver; each test runs with all that the machine has.
inline constexpr InstructionSet instruction_sets[] = {InstructionSet::avx512, InstructionSet::avx2,
                                                      InstructionSet::baseline};
inverse::elimination::Found solve(const inverse::elimination::Setup& setup, const Pose<double>& pose,
                                  InstructionSet set = InstructionSet::avx512);

/// Returns the fault of a pose's rows; empty if there is none.
std::string fault(const Arm& arm, const Eigen::Isometry3d& target, const inverse::elimination::Found& found);
bool contains(const Arm& arm, const inverse::elimination::Found& found, const Joints6& q,
              double close = 1e-6);

}  // namespace qvgen::test
