// SPDX-License-Identifier: MIT
#include "simulate.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "description/reader.h"

namespace calibrate_test {
namespace {

Vector3d normal_vector(std::mt19937& random) {
  std::normal_distribution<double> number;
  return {number(random), number(random), number(random)};
}

Isometry3d small(const Vector3d& shift, const Vector3d& turn) {
  Isometry3d result = Isometry3d::Identity();
  result.translation() = shift;
  if (turn.norm() > 0) result.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  return result;
}

Isometry3d random_frame(std::mt19937& random, double size) {
  return small(size * normal_vector(random), normal_vector(random));
}

Vector3d rotation_vector(const Isometry3d& m) {
  const Eigen::AngleAxisd turn(m.linear());
  return turn.angle() * turn.axis();
}

/// Changes one of the parameters of the full, redundant model.
Scene changed(Scene scene, std::size_t index, double by) {
  const std::size_t gaps = scene.truth.joints.size() + 1;
  Vector3d shift = Vector3d::Zero(), turn = Vector3d::Zero();
  (index % 6 < 3 ? shift : turn)[static_cast<Eigen::Index>(index % 3)] = by;
  const Isometry3d error = small(shift, turn);
  const std::size_t frame = index / 6;
  if (frame + 1 < gaps)
    scene.truth.joints[frame].before = scene.truth.joints[frame].before * error;
  else if (frame < gaps)
    scene.truth.tool = scene.truth.tool * error;
  else if (frame == gaps)
    scene.tracker = scene.tracker * error;
  else if (frame <= gaps + scene.targets.size())
    scene.targets[frame - gaps - 1] = scene.targets[frame - gaps - 1] * error;
  else if (index % 6 < 3)
    scene.point += shift;
  else
    scene.radius += turn.x() + turn.y() + turn.z();
  return scene;
}

double height(const Scene& scene, const VectorXd& q, std::size_t target) {
  const Vector3d at = (reference::forward_kinematics(scene.truth, q) * scene.targets[target]).translation();
  if (scene.data == Data::plane) return (at - scene.point).dot(scene.point.normalized());
  return (at - scene.point).norm() - (scene.data == Data::sphere ? scene.radius : 0);
}

VectorXd values_of(const Scene& scene, const VectorXd& q, std::size_t target, const Isometry3d& middle) {
  if (scene.data == Data::distance || scene.data == Data::plane || scene.data == Data::sphere)
    return VectorXd::Constant(1, height(scene, q, target));
  const Isometry3d pose = seen(scene, q, target);
  if (scene.data == Data::position) return pose.translation();
  VectorXd result(6);
  result << pose.translation(), rotation_vector(pose * middle.inverse());
  return result;
}

/// Moves joints until the target touches the surface, by Newton's steps of least length.
bool touch(const Scene& scene, VectorXd& q, std::size_t target) {
  constexpr double step = 1e-6;
  for (int i = 0; i < 60; ++i) {
    const double off = height(scene, q, target);
    if (std::abs(off) < 1e-13) return true;
    VectorXd slope(q.size());
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      VectorXd more = q, less = q;
      more[k] += step;
      less[k] -= step;
      slope[k] = (height(scene, more, target) - height(scene, less, target)) / (2 * step);
    }
    if (slope.squaredNorm() < 1e-8) return false;
    q -= std::clamp(off, -0.3, 0.3) / slope.squaredNorm() * slope;
  }
  return std::abs(height(scene, q, target)) < 1e-12;
}

Scene scene_from(const qvgen::description::ReadResult& read, reference::Chain chain, unsigned seed,
                 double error) {
  for (const auto& each : read.diagnostics)
    if (each.severity == qvgen::description::Diagnostic::error) ADD_FAILURE() << to_string(each);
  Scene scene;
  scene.robot = read.robot.value();
  scene.nominal = scene.truth = std::move(chain);
  scene.random.seed(seed);
  for (reference::Joint& joint : scene.truth.joints)
    joint.before =
        joint.before * small(error * normal_vector(scene.random), 5 * error * normal_vector(scene.random));
  scene.truth.tool =
      scene.truth.tool * small(error * normal_vector(scene.random), 5 * error * normal_vector(scene.random));
  scene.targets = {Isometry3d::Identity()};
  return scene;
}

}  // namespace

Rigid<double> rigid(const Isometry3d& m) {
  Rigid<double> result;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      result.axes[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = m.linear()(j, i);
  result.position = {m.translation().x(), m.translation().y(), m.translation().z()};
  return result;
}

Isometry3d motion(const Rigid<double>& m) {
  Isometry3d result = Isometry3d::Identity();
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      result.linear()(j, i) = m.axes[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  result.translation() = Vector3d(m.position[0], m.position[1], m.position[2]);
  return result;
}

Scene scene_of(const std::string& robot, unsigned seed, double error) {
  const std::string file = QVGEN_SOURCE_DIR "/generator/robots/" + robot + ".toml";
  return scene_from(qvgen::description::read_file(file), reference::load(file), seed, error);
}

Scene scene_of_text(const std::string& toml, unsigned seed, double error) {
  return scene_from(qvgen::description::read_text(toml, "arm.toml"), reference::load_text(toml), seed, error);
}

Scene scene_with_tool(const std::string& robot, unsigned seed) {
  std::ifstream file(QVGEN_SOURCE_DIR "/generator/robots/" + robot + ".toml");
  std::ostringstream text;
  text << file.rdbuf() << "\n[tool]\ntranslation = [0.07, 0.04, 0.12]\n";
  return scene_of_text(text.str(), seed);
}

void stand_anywhere(Scene& scene, std::size_t targets) {
  scene.tracker = random_frame(scene.random, 1);
  scene.targets.clear();
  for (std::size_t i = 0; i < targets; ++i) scene.targets.push_back(random_frame(scene.random, 0.1));
}

VectorXd random_joints(const Scene& scene) {
  std::uniform_real_distribution<double> angle(-2.6, 2.6), length(0, 0.3);
  VectorXd q(scene.truth.size());
  const std::vector<std::string> driven = scene.truth.driven();
  for (std::size_t k = 0; k < driven.size(); ++k) {
    const auto slides = [&](const reference::Joint& joint) {
      return joint.variable == driven[k] && joint.leaders.empty() && !joint.revolute;
    };
    const bool is_slide = std::any_of(scene.truth.joints.begin(), scene.truth.joints.end(), slides);
    q[static_cast<Eigen::Index>(k)] = is_slide ? length(scene.random) : angle(scene.random);
  }
  return q;
}

Isometry3d seen(const Scene& scene, const VectorXd& q, std::size_t target) {
  const Isometry3d pose =
      scene.tracker * reference::forward_kinematics(scene.truth, q) * scene.targets[target];
  return scene.data == Data::camera ? pose.inverse() : pose;
}

Measurement measured(const Scene& scene, VectorXd q, std::size_t target) {
  Measurement result;
  result.target = target;
  if (scene.data == Data::plane || scene.data == Data::sphere)
    while (!touch(scene, q, target)) q = random_joints(scene);
  const Isometry3d noisy =
      small(scene.noise * normal_vector(scene.random), scene.noise * normal_vector(scene.random));
  Isometry3d pose = seen(scene, q, target);
  pose.translation() += noisy.translation();
  pose.linear() = noisy.linear() * pose.linear();
  if (scene.data == Data::position) pose.linear().setIdentity();
  result.pose = rigid(pose);
  if (scene.data == Data::distance) result.distance = height(scene, q, target) + noisy.translation().x();
  result.sigma = scene.noise > 0 ? scene.noise : 1e-4;
  result.sigma_angle = result.sigma;
  result.q.assign(q.data(), q.data() + q.size());
  return result;
}

DataSet measure(const Scene& scene, std::size_t count, int held) {
  DataSet set;
  set.file = "data.csv";
  set.data = scene.data;
  set.sigma_known = scene.noise > 0;
  const VectorXd fixed = random_joints(scene);
  for (std::size_t i = 0; i < count; ++i) {
    VectorXd q = random_joints(scene);
    if (held >= 0) q[held] = fixed[held];
    set.rows.push_back(measured(scene, q, i % scene.targets.size()));
    set.rows.back().line = static_cast<int>(i) + 2;
  }
  for (std::size_t i = 0; i < scene.targets.size(); ++i) set.targets.push_back(static_cast<int>(i) + 1);
  set.surfaces = {1};
  return set;
}

MatrixXd derivative(const Scene& scene, const Measurement& at, bool tracker_known, bool target_known) {
  constexpr double step = 1e-4;
  const VectorXd q = VectorXd::Map(at.q.data(), static_cast<Eigen::Index>(at.q.size()));
  const std::size_t gaps = scene.truth.joints.size() + 1;
  const bool scalar = scene.data == Data::distance || scene.data == Data::plane || scene.data == Data::sphere;
  const std::size_t count = 6 * (gaps + 1 + scene.targets.size() + 1);
  const Isometry3d middle = scalar ? Isometry3d::Identity() : seen(scene, q, at.target);
  MatrixXd result;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t frame = i / 6;
    const bool left_out =
        (frame == gaps && (tracker_known || scalar)) ||
        (frame > gaps && frame <= gaps + scene.targets.size() && target_known) ||
        (frame > gaps + scene.targets.size() && (!scalar || (i % 6 > 2 && scene.data != Data::sphere)));
    const VectorXd column = left_out ? VectorXd(0 * values_of(scene, q, at.target, middle))
                                     : VectorXd((values_of(changed(scene, i, step), q, at.target, middle) -
                                                 values_of(changed(scene, i, -step), q, at.target, middle)) /
                                                (2 * step));
    if (i == 0) result.resize(column.size(), static_cast<Eigen::Index>(count));
    result.col(static_cast<Eigen::Index>(i)) = column;
  }
  return result;
}

int trial_count(int usual) {
  const char* text = std::getenv("QVGEN_TRIALS");
  return text == nullptr ? usual : std::atoi(text);
}

}  // namespace calibrate_test
