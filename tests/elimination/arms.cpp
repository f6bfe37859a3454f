// SPDX-License-Identifier: MIT
#include "arms.h"

#include <sstream>

namespace qvgen::test {

namespace {

constexpr double pi = 3.14159265358979323846;

Eigen::Isometry3d link(double d, double a, double alpha) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translate(Eigen::Vector3d(a, 0, d));
  result.rotate(Eigen::AngleAxisd(alpha * pi / 180, Eigen::Vector3d::UnitX()));
  return result;
}

Eigen::Isometry3d motion(bool slides, double q) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (slides)
    result.translate(Eigen::Vector3d(0, 0, q));
  else
    result.rotate(Eigen::AngleAxisd(q, Eigen::Vector3d::UnitZ()));
  return result;
}

inverse::Triple<double> triple(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

}  // namespace

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::Isometry3d Arm::tool(const Joints6& q) const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < 6; ++i) result = result * motion(slides[i], q[static_cast<int>(i)]) * links[i];
  return result;
}

inverse::elimination::Description Arm::description() const {
  inverse::elimination::Description result;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < 6; ++i) {
    result.axes[i] = {!slides[i], triple(frame.linear().col(2)), triple(frame.translation())};
    frame = frame * links[i];
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result.tool.rotation[3 * i + k] = frame.linear()(i, k);
    result.tool.translation[i] = frame.translation()[i];
  }
  return result;
}

double Arm::size() const {
  double sum = 0;
  for (std::size_t i = 0; i < 5; ++i) sum += links[i].translation().norm();
  return sum / 4;
}

Joints6 Arm::joints(Random& random) const {
  Joints6 q;
  for (int i = 0; i < 6; ++i) q[i] = uniform(random) * (slides[static_cast<std::size_t>(i)] ? size() : pi);
  return q;
}

double Arm::distance(const Joints6& a, const Joints6& b) const {
  double largest = 0;
  for (int i = 0; i < 6; ++i) {
    const double way = b[i] - a[i];
    largest =
        std::max(largest, std::abs(slides[static_cast<std::size_t>(i)] ? way : std::remainder(way, 2 * pi)));
  }
  return largest;
}

double Arm::determinant(const Joints6& q) const {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d tip = tool(q).translation();
  Eigen::Matrix<double, 6, 6> jacobian;
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector3d axis = frame.linear().col(2);
    const int k = static_cast<int>(i);
    if (slides[i])
      jacobian.col(k) << axis / size(), Eigen::Vector3d::Zero();
    else
      jacobian.col(k) << axis.cross(tip - frame.translation()) / size(), axis;
    frame = frame * motion(slides[i], q[k]) * links[i];
  }
  return jacobian.determinant();
}

std::optional<Joints6> at_a_singularity(const Arm& arm, Random& random, int joint) {
  constexpr double pi = 3.14159265358979323846;
  Joints6 q = arm.joints(random);
  const double range = arm.slides[static_cast<std::size_t>(joint)] ? arm.size() : pi;
  const auto is_negative = [&](double value) {
    q[joint] = value;
    return arm.determinant(q) < 0;
  };
  constexpr int steps = 12;
  for (int k = 0; k < steps; ++k) {
    double low = range * (2.0 * k / steps - 1), high = range * (2.0 * (k + 1) / steps - 1);
    const bool below = is_negative(low);
    if (below == is_negative(high)) continue;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (is_negative(middle) == below ? low : high) = middle;
    }
    q[joint] = low;
    return q;
  }
  return std::nullopt;
}

Arm of_table(const std::string& name, const double (&table)[6][3]) {
  Arm arm{name, {}, {}};
  for (std::size_t i = 0; i < 6; ++i) arm.links[i] = link(table[i][0], table[i][1], table[i][2]);
  return arm;
}

Arm of_modified_table(const std::string& name, const double (&table)[6][3]) {
  Arm arm{name, {}, {}};
  for (std::size_t i = 0; i < 6; ++i)
    arm.links[i] = i < 5 ? link(table[i][2], table[i + 1][0], table[i + 1][1]) : link(table[i][2], 0, 0);
  return arm;
}

Arm miscalibrated(Arm arm, double by, unsigned seed) {
  Random random(seed);
  const auto any = [&] { return Eigen::Vector3d(uniform(random), uniform(random), uniform(random)); };
  for (Eigen::Isometry3d& each : arm.links) {
    const Eigen::Vector3d turn = any();
    each.translate(by * any());
    each.rotate(Eigen::AngleAxisd(by * turn.norm(), turn.normalized()));
  }
  arm.name += "_off";
  return arm;
}

Arm random_arm(unsigned seed, int slides) {
  Random random(seed);
  Arm arm{"random_" + std::to_string(seed), {}, {}};
  for (Eigen::Isometry3d& each : arm.links)
    each = link(uniform(random), uniform(random), 180 * uniform(random));
  while (slides > 0) {
    bool& slide = arm.slides[random() % 6];
    if (slide) continue;
    slide = true;
    --slides;
  }
  return arm;
}

namespace {

/// z along a coordinate axis, or against it.
Eigen::Isometry3d frame_along(int axis, bool against, const Eigen::Vector3d& origin) {
  const Eigen::Vector3d z = Eigen::Vector3d::Unit(axis) * (against ? -1 : 1);
  const Eigen::Vector3d x = Eigen::Vector3d::Unit((axis + 1) % 3);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() << x, z.cross(x), z;
  frame.translation() = origin;
  return frame;
}

}  // namespace

Arm arm_along_axes(unsigned seed, int slide, bool parallel) {
  Random random(seed);
  Arm arm{"along_axes_" + std::to_string(seed) + "_slide_" + std::to_string(slide + 1), {}, {}};
  arm.slides[static_cast<std::size_t>(slide)] = true;
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  int axis = 2;
  for (std::size_t i = 0; i < 6; ++i) {
    for (double& x : place) x += uniform(random);
    const bool may_repeat = parallel && random() % 3 == 0;
    const int last = axis;
    do axis = static_cast<int>(random() % 3);
    while (!may_repeat && axis == last);
    const bool is_tool = i == 5;
    const Eigen::Isometry3d next = frame_along(is_tool ? 2 : axis, !is_tool && random() % 2 == 1, place);
    arm.links[i] = before.inverse() * next;
    before = next;
  }
  return arm;
}

// Manseur and Doty, A Robot Manipulator with 16 Real Inverse Kinematic Solution Sets, IJRR 8 (1989).
Arm manseur_doty() {
  return of_table("manseur_doty",
                  {{0, 0.3, 90}, {0, 1, 1}, {0.2, 0, 90}, {0, 1.5, 1}, {0, 0, 90}, {0, 0, 1}});
}
// Raghavan and Roth, 1993.
Arm raghavan_roth() {
  return of_table(
      "raghavan_roth",
      {{0, 0.8, 20}, {0.9, 1.2, 31}, {3.7, 0.33, 45}, {1.0, 1.8, 81}, {0.5, 0.6, 12}, {2.1, 2.2, 100}});
}
// Kinova, Advanced Specification Guide of the 6 DOF JACO2.
Arm jaco2() {
  const double half = 30 * pi / 180;
  const double share = std::sin(half * 2) / std::sin(half * 4);
  const double d4 = 0.0741, d5 = 0.0741;
  return of_table("jaco2", {{0.2755, 0, 90},
                            {0, 0.41, 180},
                            {-0.0098, 0, 90},
                            {-(0.2073 + share * d4), 0, 120},
                            {-share * (d4 + d5), 0, 120},
                            {-(share * d5 + 0.16), 0, 180}});
}
Arm in_line() {
  return of_table(
      "in_line",
      {{-0.2848, 0, 90}, {-0.0118, -0.41, 180}, {0, 0, 90}, {-0.3143, 0, 90}, {0, 0, 90}, {-0.1674, 0, 180}});
}
Arm crx10ia() {
  return of_modified_table(
      "crx10ia",
      {{0, 0, 0.245}, {0, -90, 0}, {0.54, 180, 0}, {0, -90, -0.54}, {0, 90, 0.15}, {0, -90, -0.16}});
}
Arm xarm6() {
  return of_modified_table(
      "xarm6",
      {{0, 0, 0.267}, {0, -90, 0}, {0.28949, 0, 0}, {0.0775, -90, 0.3425}, {0, 90, 0}, {0.076, -90, 0.097}});
}
// A welding arm's proportions with a wrist that has an offset.
Arm m10() {
  return of_modified_table(
      "m10", {{0, 0, 0.45}, {0.15, -90, 0}, {0.6, 0, 0}, {0.2, -90, 0.64}, {0, 90, 0}, {0.05, -90, 0.1}});
}
Arm ur5() {
  return of_table("ur5", {{0.089159, 0, 90},
                          {0, -0.425, 0},
                          {0, -0.39225, 0},
                          {0.10915, 0, 90},
                          {0.09465, 0, -90},
                          {0.0823, 0, 0}});
}
Arm irb6640() {
  return of_table(
      "irb6640",
      {{0.78, 0.32, -90}, {0, 1.075, 0}, {0, 0.2, -90}, {1.1425, 0, 90}, {0, 0, -90}, {0.2, 0, 0}});
}
Arm piper() {
  return of_modified_table(
      "piper",
      {{0, 0, 0.123}, {0, -90, 0}, {0.28503, 0, 0}, {-0.02198, 90, 0.25075}, {0, -90, 0}, {0, 90, 0.091}});
}

std::vector<Arm> named_arms() {
  return {manseur_doty(),
          raghavan_roth(),
          jaco2(),
          crx10ia(),
          xarm6(),
          m10(),
          miscalibrated(ur5(), 1e-4, 3),
          miscalibrated(irb6640(), 1e-4, 4),
          miscalibrated(piper(), 1e-4, 5)};
}

inverse::elimination::Found solve(const inverse::elimination::Setup& setup, const Pose<double>& pose,
                                  InstructionSet set) {
  inverse::elimination::Found found;
  inverse::elimination::solve(setup, pose, inverse::default_tolerance, inverse::zero_preference<6>, set,
                              found);
  return found;
}

std::string fault(const Arm& arm, const Eigen::Isometry3d& target, const inverse::elimination::Found& found) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < found.size(); ++i) {
    const Eigen::Isometry3d reached = arm.tool(found[i].q);
    // Two slides may go far where their directions are nearly parallel: what they carry is rounded as they
    // are.
    double size = arm.size();
    for (int j = 0; j < 6; ++j)
      if (arm.slides[static_cast<std::size_t>(j)]) size = std::max(size, std::abs(found[i].q[j]));
    const double position = (reached.translation() - target.translation()).norm() / size;
    const double orientation = (reached.linear() - target.linear()).norm();
    if (!(std::max(position, orientation) < 1e-12))
      text << arm.name << ": row " << i << " misses the pose by " << position << ", " << orientation << "\n";
    for (int k = 0; k < i; ++k)
      if (arm.distance(found[i].q, found[k].q) < 1e-9)
        text << arm.name << ": rows " << k << " and " << i << " are the same\n";
  }
  return text.str();
}

bool contains(const Arm& arm, const inverse::elimination::Found& found, const Joints6& q, double close) {
  for (const auto& row : found)
    if (arm.distance(row.q, q) < close) return true;
  return false;
}

}  // namespace qvgen::test
