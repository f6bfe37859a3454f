// SPDX-License-Identifier: MIT
#include "reference/loops.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <toml++/toml.h>

#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace reference {
namespace {

double value_of(const toml::node& node, const Values& values) {
  if (const auto text = node.value_exact<std::string>()) return evaluate(*text, values);
  return node.value<double>().value();
}

Eigen::Index joint_named(const Chain& chain, const std::string& name) {
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    if (chain.joints[i].variable == name) return static_cast<Eigen::Index>(i);
  if (name != "base") throw std::runtime_error("no joint " + name);
  return -1;
}

std::vector<Eigen::Index> joints_in(const toml::table& file, const char* key, const Chain& chain) {
  std::vector<Eigen::Index> joints;
  if (const toml::array* list = file[key].as_array())
    for (const toml::node& name : *list)
      joints.push_back(joint_named(chain, name.value<std::string>().value()));
  return joints;
}

Vector3d vector_of(const toml::node& node, const Values& values) {
  if (const auto name = node.value_exact<std::string>())
    return (name->front() == '-' ? -1.0 : 1.0) * Vector3d::Unit(name->back() - 'x');
  Vector3d v;
  for (std::size_t k = 0; k < 3; ++k)
    v[static_cast<Eigen::Index>(k)] = value_of(*node.as_array()->get(k), values);
  return v;
}

/// How a weld or a slide ties two links.
void read_rigid(const toml::table& table, const Values& values, Closure& closure) {
  const std::string type = table["type"].value_or(std::string());
  closure.is_rigid = type == "weld" || type == "slide";
  closure.turn.setIdentity();
  if (const toml::node* rpy = table.get("rpy")) {
    const Vector3d angles = vector_of(*rpy, values);
    for (const int axis : {2, 1, 0})
      closure.turn *= Eigen::AngleAxisd(angles[axis], Vector3d::Unit(axis)).toRotationMatrix();
  }
  if (const toml::array* turns = table["turns"].as_array())
    for (const toml::node& each : *turns) {
      const toml::table& turn = *each.as_table();
      closure.turn *=
          Eigen::AngleAxisd(value_of(*turn.get("angle"), values), vector_of(*turn.get("axis"), values))
              .toRotationMatrix();
    }
  if (type == "slide") closure.line = vector_of(*table.get("axis"), values);
}

Closure closure_of(const toml::table& table, const Chain& chain, const Values& values) {
  Closure closure;
  for (std::size_t i = 0; i < 2; ++i) {
    closure.links[i] = joint_named(chain, table["between"][i].value<std::string>().value());
    for (std::size_t k = 0; k < 3; ++k)
      closure.points[i][static_cast<Eigen::Index>(k)] = value_of(*table["at"][i][k].node(), values);
  }
  read_rigid(table, values, closure);
  const toml::node* length = table.get("length");
  const auto named = length == nullptr ? std::nullopt : length->value_exact<std::string>();
  for (std::size_t i = 0; named && i < chain.joints.size(); ++i)
    if (chain.joints[i].variable == *named) closure.length_joint = static_cast<Eigen::Index>(i);
  if (length != nullptr && closure.length_joint < 0) closure.length = value_of(*length, values);
  return closure;
}

/// Motors become joints that move nothing, and joints that follow others get values of their own.
void take_gears(LoopMechanism& mechanism) {
  Chain& chain = mechanism.chain;
  for (const Motor& motor : chain.motors) {
    Joint joint;
    joint.variable = motor.variable;
    joint.rotor_inertia = motor.rotor_inertia;
    joint.viscous_friction = motor.viscous_friction;
    joint.coulomb_friction = motor.coulomb_friction;
    joint.parent = -1;
    chain.joints.push_back(joint);
  }
  chain.motors.clear();
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    Joint& joint = chain.joints[i];
    if (joint.leaders.empty()) continue;
    Gear gear{static_cast<Eigen::Index>(i), {}, joint.offset, joint.polynomial};
    gear.variable = joint.leaders.front().first;
    for (const auto& [name, ratio] : joint.leaders)
      gear.leaders.emplace_back(joint_named(chain, name), ratio);
    mechanism.gears.push_back(gear);
    const Vector3d way = joint.offset * joint.axis;
    joint.before = joint.revolute ? joint.before * Eigen::AngleAxisd(-joint.offset, joint.axis)
                                  : joint.before * Eigen::Translation3d(-way);
    joint.leaders.clear();
  }
}

struct Ends {
  std::array<Vector3d, 2> at;
};

Ends ends_of(const LoopMechanism& mechanism, const Closure& closure, const std::vector<Isometry3d>& frames) {
  Ends ends;
  for (std::size_t i = 0; i < 2; ++i)
    ends.at[i] =
        (closure.links[i] < 0 ? mechanism.chain.base : frames[static_cast<std::size_t>(closure.links[i])]) *
        closure.points[i];
  return ends;
}

/// How the first link of a weld or a slide is turned against where the second one has it, in the world's
/// frame.
Vector3d turn_between(const LoopMechanism& mechanism, const Closure& closure,
                      const std::vector<Isometry3d>& frames) {
  std::array<Eigen::Matrix3d, 2> at;
  for (std::size_t i = 0; i < 2; ++i)
    at[i] = (closure.links[i] < 0 ? mechanism.chain.base : frames[static_cast<std::size_t>(closure.links[i])])
                .linear();
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(at[0] * closure.turn * at[1].transpose()));
  return turn.angle() * turn.axis();
}

/// Directions across the line of a slide, in the world's frame.
Eigen::Matrix<double, 2, 3> across_line(const LoopMechanism& mechanism, const Closure& closure,
                                        const std::vector<Isometry3d>& frames) {
  const Eigen::Matrix3d link =
      (closure.links[0] < 0 ? mechanism.chain.base : frames[static_cast<std::size_t>(closure.links[0])])
          .linear();
  const Vector3d first = closure.line->unitOrthogonal();
  Eigen::Matrix<double, 2, 3> rows;
  rows.row(0) = (link * first).transpose();
  rows.row(1) = (link * closure.line->cross(first)).transpose();
  return rows;
}

double wrapped(double angle) { return std::remainder(angle, 2 * M_PI); }

double distance(const LoopMechanism& mechanism, const VectorXd& a, const VectorXd& b) {
  double worst = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const bool turns = mechanism.chain.joints[static_cast<std::size_t>(i)].revolute;
    worst = std::max(worst, std::abs(turns ? wrapped(a[i] - b[i]) : a[i] - b[i]));
  }
  return worst;
}

/// The gaps, and how far a frame is from the pose that it has to be in: metres and a rotation vector.
VectorXd left(const LoopMechanism& mechanism, const std::optional<Reached>& reached, const VectorXd& q) {
  const VectorXd open = gaps(mechanism, q);
  if (!reached) return open;
  const Isometry3d at = pose_of(mechanism.chain, reached->frame, q);
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(at.linear() * reached->pose.linear().transpose()));
  VectorXd all(open.size() + 6);
  all << open, at.translation() - reached->pose.translation(), turn.angle() * turn.axis();
  return all;
}

MatrixXd left_jacobian(const LoopMechanism& mechanism, const std::optional<Reached>& reached,
                       const VectorXd& q) {
  const MatrixXd open = gap_jacobian(mechanism, q);
  if (!reached) return open;
  MatrixXd all(open.rows() + 6, q.size());
  all << open, jacobian_of(mechanism.chain, reached->frame, q);
  return all;
}

/// True if Newton's steps of the passive joints close the gaps.
bool close(const LoopMechanism& mechanism, const std::vector<Eigen::Index>& open,
           const std::optional<Reached>& reached, VectorXd& q) {
  for (int step = 0; step < 40; ++step) {
    const VectorXd off = left(mechanism, reached, q);
    if (off.cwiseAbs().maxCoeff() < 1e-12 * mechanism.size) return true;
    const MatrixXd all = left_jacobian(mechanism, reached, q);
    MatrixXd by(off.size(), static_cast<Eigen::Index>(open.size()));
    for (std::size_t i = 0; i < open.size(); ++i) by.col(static_cast<Eigen::Index>(i)) = all.col(open[i]);
    VectorXd way = least_squares(by, off);
    const double longest = way.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest)) return false;
    if (longest > 1) way /= longest;
    for (std::size_t i = 0; i < open.size(); ++i) q[open[i]] -= way[static_cast<Eigen::Index>(i)];
  }
  return false;
}

}  // namespace

LoopMechanism load_loops(const std::filesystem::path& path, const Values& given) {
  const toml::table file = toml::parse_file(path.string());
  Values values = given;
  if (const toml::table* defaults = file["defaults"].as_table())
    for (const auto& [key, node] : *defaults) values.emplace(std::string(key.str()), value_of(node, {}));
  LoopMechanism mechanism;
  mechanism.chain = load(path, given);
  take_gears(mechanism);
  mechanism.size = 0;
  const toml::array none;
  for (const toml::node& node : file.contains("loop") ? *file["loop"].as_array() : none) {
    mechanism.closures.push_back(closure_of(*node.as_table(), mechanism.chain, values));
    const Closure& closure = mechanism.closures.back();
    mechanism.size += closure.length + closure.points[0].norm() + closure.points[1].norm();
  }
  for (const Joint& joint : mechanism.chain.joints)
    mechanism.size += joint.before.translation().norm() + joint.after.translation().norm();
  mechanism.driven = joints_in(file, "actuated", mechanism.chain);
  mechanism.outputs = joints_in(file, "outputs", mechanism.chain);
  for (std::size_t i = 0; i < mechanism.chain.joints.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    if (std::find(mechanism.driven.begin(), mechanism.driven.end(), joint) == mechanism.driven.end())
      mechanism.passive.push_back(joint);
  }
  return mechanism;
}

VectorXd gaps(const LoopMechanism& mechanism, const VectorXd& q) {
  const std::vector<Isometry3d> at = frames(mechanism.chain, q);
  std::vector<double> result;
  for (const Closure& closure : mechanism.closures) {
    const Ends ends = ends_of(mechanism, closure, at);
    const Vector3d way = ends.at[0] - ends.at[1];
    if (closure.is_rod())
      result.push_back(way.norm() - (closure.length_joint < 0 ? closure.length : q[closure.length_joint]));
    else if (closure.line) {
      const Eigen::Vector2d off = across_line(mechanism, closure, at) * way;
      result.insert(result.end(), {off.x(), off.y()});
    } else {
      result.insert(result.end(), {way.x(), way.y(), way.z()});
    }
    if (!closure.is_rigid) continue;
    const Vector3d turn = turn_between(mechanism, closure, at);
    result.insert(result.end(), {turn.x(), turn.y(), turn.z()});
  }
  const VectorXd expected = followed(mechanism, q);
  for (const Gear& gear : mechanism.gears) result.push_back(q[gear.joint] - expected[gear.joint]);
  return Eigen::Map<VectorXd>(result.data(), static_cast<Eigen::Index>(result.size()));
}

VectorXd followed(const LoopMechanism& mechanism, VectorXd q) {
  for (const Gear& gear : mechanism.gears) {
    q[gear.joint] = value_of(gear, q);
  }
  return q;
}

double value_of(const Gear& gear, const VectorXd& q) {
  if (!gear.polynomial.empty())
    return evaluate(gear.polynomial, {{gear.variable, q[gear.leaders.front().first]}});
  double value = gear.offset;
  for (const auto& [leader, ratio] : gear.leaders) value += ratio * q[leader];
  return value;
}

double derivative_of(const Gear& gear, const std::pair<Eigen::Index, double>& leader, const VectorXd& q) {
  if (gear.polynomial.empty()) return leader.second;
  const auto difference = [&](double step) {
    VectorXd above = q, below = q;
    above[leader.first] += step;
    below[leader.first] -= step;
    return (value_of(gear, above) - value_of(gear, below)) / 2;
  };
  constexpr double step = 0.25;
  return (difference(step) * 8 / 5 - difference(2 * step) * 2 / 5 + difference(3 * step) * 8 / 105 -
          difference(4 * step) / 140) /
         step;
}

MatrixXd gap_jacobian(const LoopMechanism& mechanism, const VectorXd& q) {
  const Chain& chain = mechanism.chain;
  const std::vector<Isometry3d> at = frames(chain, q);
  const std::vector<JointPlace> places = joint_places(chain, q);
  MatrixXd result = MatrixXd::Zero(gaps(mechanism, q).size(), q.size());
  Eigen::Index row = 0;
  for (const Closure& closure : mechanism.closures) {
    const Ends ends = ends_of(mechanism, closure, at);
    MatrixXd by = MatrixXd::Zero(3, q.size()), spin = by, of_line = by;
    const Vector3d way = ends.at[0] - ends.at[1];
    for (std::size_t end = 0; end < 2; ++end) {
      for (std::size_t i = 0; closure.links[end] >= 0 && i < chain.joints.size(); ++i) {
        if (!chain.moves(i, static_cast<std::size_t>(closure.links[end]))) continue;
        const Vector3d rate =
            chain.joints[i].revolute ? places[i].axis.cross(ends.at[end] - places[i].point) : places[i].axis;
        const auto joint = static_cast<Eigen::Index>(i);
        by.col(joint) += (end == 0 ? 1 : -1) * rate;
        if (!chain.joints[i].revolute) continue;
        spin.col(joint) += (end == 0 ? 1 : -1) * places[i].axis;
        if (end == 0) of_line.col(joint) = places[i].axis.cross(way);  // which turns with the first link
      }
    }
    if (closure.is_rod()) {
      result.row(row) = (ends.at[0] - ends.at[1]).normalized().transpose() * by;
      if (closure.length_joint >= 0) result(row, closure.length_joint) -= 1;
      ++row;
    } else if (closure.line) {
      result.middleRows(row, 2) = product(across_line(mechanism, closure, at), by - of_line);
      row += 2;
    } else {
      result.middleRows(row, 3) = by;
      row += 3;
    }
    if (!closure.is_rigid) continue;
    result.middleRows(row, 3) = spin;
    row += 3;
  }
  for (const Gear& gear : mechanism.gears) {
    result(row, gear.joint) = 1;
    for (const auto& leader : gear.leaders) result(row, leader.first) -= derivative_of(gear, leader, q);
    ++row;
  }
  return result;
}

std::vector<VectorXd> assemblies(const LoopMechanism& mechanism, const VectorXd& q,
                                 const std::vector<Eigen::Index>& given, int starts, unsigned seed,
                                 const std::optional<Reached>& reached) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(-M_PI, M_PI), slide(-mechanism.size, mechanism.size);
  std::vector<Eigen::Index> open;
  for (Eigen::Index i = 0; i < q.size(); ++i)
    if (std::find(given.begin(), given.end(), i) == given.end()) open.push_back(i);
  std::vector<VectorXd> found;
  for (int start = 0; start < starts; ++start) {
    VectorXd at = q;
    for (const Eigen::Index i : open)
      at[i] = mechanism.chain.joints[static_cast<std::size_t>(i)].revolute ? turn(random) : slide(random);
    if (!close(mechanism, open, reached, at)) continue;
    for (const Eigen::Index i : open)
      if (mechanism.chain.joints[static_cast<std::size_t>(i)].revolute) at[i] = wrapped(at[i]);
    const auto same = [&](const VectorXd& other) { return distance(mechanism, at, other) < 1e-5; };
    if (std::none_of(found.begin(), found.end(), same)) found.push_back(at);
  }
  return found;
}

VectorXd constrained_acceleration(const LoopMechanism& mechanism, const VectorXd& q, const VectorXd& qd,
                                  const VectorXd& forces) {
  const Chain& chain = mechanism.chain;
  const Eigen::Index n = q.size();
  const MatrixXd jacobian = gap_jacobian(mechanism, q);
  // The rate of the Jacobian along qd, by differences in the middle.
  const double step = 1e-5;
  const MatrixXd rate =
      (gap_jacobian(mechanism, q + step * qd) - gap_jacobian(mechanism, q - step * qd)) / (2 * step);
  // Loops may hold the same twice: the directions of their gaps in which they hold anything are equations.
  const SingularValues parts = singular_values(jacobian);
  const Eigen::Index rows = (parts.values.array() > 1e-9 * parts.values[0]).count();
  const MatrixXd equations = product(parts.u.leftCols(rows).transpose(), jacobian);
  MatrixXd whole = MatrixXd::Zero(n + rows, n + rows);
  whole.topLeftCorner(n, n) = mass_matrix(chain, q);
  whole.topRightCorner(n, rows) = equations.transpose();
  whole.bottomLeftCorner(rows, n) = equations;
  VectorXd right(n + rows);
  right.head(n) = forces - inverse_dynamics(chain, q, qd, VectorXd::Zero(n));
  right.tail(rows) = -(parts.u.leftCols(rows).transpose() * (rate * qd));
  return least_squares(whole, right).head(n);
}

}  // namespace reference
