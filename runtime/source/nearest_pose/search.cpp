// SPDX-License-Identifier: MIT
// The nearest reachable pose: Levenberg-Marquardt from several starts, within limits.
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <qvgen/inverse/nearest_pose.h>

namespace qvgen::inverse::nearest {
namespace {

using Stacked = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6 + most_joints, most_joints>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_joints, most_joints>;
using StackedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6 + most_joints, 1>;

constexpr int most_steps = 200;
constexpr double reached = 1e-11;  ///< as a share of the arm's size, and rad

/// An element of Halton's sequence (1960): numbers that fill [0, 1) evenly, coprime bases in many dimensions.
double halton(int number, int base) {
  double share = 0;
  for (double digit = 1.0 / base; number > 0; number /= base, digit /= base) share += digit * (number % base);
  return share;
}

int prime(int i) {
  constexpr std::array<int, most_joints> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
  return primes[static_cast<std::size_t>(i)];
}

/// The inverse of SO(3)'s right Jacobian: how a small turn of the tool changes the rotation vector left.
Eigen::Matrix3d change_of_rotation_vector(const Eigen::Vector3d& left) {
  const double angle = left.norm();
  // Towards a whole turn it grows beyond bounds. The gradient of the least squares is the same with the
  // identity, since the vector itself is not changed.
  if (angle > 3) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d cross;
  cross << 0, -left.z(), left.y(), left.z(), 0, -left.x(), -left.y(), left.x(), 0;
  const double half = angle / 2;
  const double factor = angle > 1e-3 ? (1 - half / std::tan(half)) / (angle * angle) : 1.0 / 12;
  return Eigen::Matrix3d::Identity() + cross / 2 + factor * cross * cross;
}

/// The rotation vector from one orientation to another, rad, at most half a turn long.
Eigen::Vector3d rotation_left(const Eigen::Quaterniond& goal, const Eigen::Quaterniond& at) {
  Eigen::Quaterniond turn = goal * at.conjugate();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  const double sine = turn.vec().norm();
  const double factor = sine > 0 ? 2 * std::atan2(sine, turn.w()) / sine : 2;
  return factor * turn.vec();
}

}  // namespace

struct Search::Place {
  Vector q;
  Columns jacobian;
  Twist off;             ///< metres, then the rotation vector that is left
  bool settled = false;  ///< no step made it nearer
};

/// How much a metre and a radian count, in metres.
struct Search::Weights {
  double position, orientation;

  [[nodiscard]] Twist of(Twist off) const {
    off.head<3>() *= position;
    off.tail<3>() *= orientation;
    return off;
  }
};

Search::Search(const Arm& arm, const Pose<double>& pose, const Request& request)
    : arm_(arm), request_(request), goal_(pose), valid_(is_usable(pose)) {
  if (!valid_) return;
  goal_ = pose.normalised();
  Pose<double> zero;
  Columns jacobian(6, arm.joints);
  arm.reach(arm.functions, Vector::Zero(arm.joints), zero, jacobian);
  const double size = pose.position.norm() + zero.position.norm();
  if (size > 1e-9) size_of_arm_ = size;
  length_ = request.metres_per_radian > 0 ? request.metres_per_radian : size_of_arm_;
}

bool Search::is_usable(const Pose<double>& pose) const {
  const bool ordered = (request_.lower.array() <= request_.upper.array()).all();  // false for NaN
  return qvgen::is_valid(pose) && ordered && request_.metres_per_radian >= 0 &&
         std::isfinite(request_.metres_per_radian);
}

/// An angle without limits in (-pi, pi]; any other value within its limits.
Vector Search::clamped(Vector q) const {
  for (int i = 0; i < arm_.joints; ++i) {
    const bool is_free = std::isinf(request_.lower[i]) && std::isinf(request_.upper[i]);
    if (turns(i) && is_free) q[i] = without_turns(q[i]);
    if (q[i] <= -pi<double>() && is_free && turns(i)) q[i] = pi<double>();
    q[i] = std::min(std::max(q[i], request_.lower[i]), request_.upper[i]);
  }
  return q;
}

Vector Search::spread(int number) const {
  Vector q(arm_.joints);
  for (int i = 0; i < arm_.joints; ++i) {
    const double range = turns(i) ? pi<double>() : size_of_arm_;
    double lower = request_.lower[i], upper = request_.upper[i];
    if (!std::isfinite(lower)) lower = std::isfinite(upper) ? upper - 2 * range : -range;
    if (!std::isfinite(upper)) upper = lower + 2 * range;
    q[i] = lower + (upper - lower) * halton(number, prime(i));
  }
  return q;
}

Search::Place Search::place(const Vector& q) const {
  Place result{q, Columns(6, arm_.joints), {}};
  Pose<double> at;
  arm_.reach(arm_.functions, q, at, result.jacobian);
  result.off << goal_.position - at.position, rotation_left(goal_.orientation, at.orientation);
  return result;
}

Columns Search::columns(const Weights& weights, const Place& at) const {
  const Eigen::Matrix3d change = weights.orientation * change_of_rotation_vector(at.off.tail<3>());
  Columns result = weights.position * at.jacobian;
  result.bottomRows<3>() = change * at.jacobian.bottomRows<3>();
  return result;
}

/// Columns of joints at a limit that the descent would leave are zero: these keep their values.
Columns Search::held_at_limits(Columns a, const Place& at, const Twist& r) const {
  for (int i = 0; i < arm_.joints; ++i) {
    const double descent = a.col(i).dot(r);
    const bool leaves =
        (descent > 0 && at.q[i] >= request_.upper[i]) || (descent < 0 && at.q[i] <= request_.lower[i]);
    if (leaves) a.col(i).setZero();
  }
  return a;
}

double Search::damping_of(int i, double damping) const { return damping * (turns(i) ? size_of_arm_ : 1); }

/// Solves the damped least squares (Gauss, Newton, Levenberg, Marquardt). Zero at a minimum.
Vector Search::linear_step(const Columns& a, const Twist& r, double damping) const {
  const int n = arm_.joints;
  Stacked stacked = Stacked::Zero(6 + n, n);
  StackedVector wanted = StackedVector::Zero(6 + n);
  stacked.topRows(6) = a;
  wanted.head(6) = r;
  for (int i = 0; i < n; ++i) stacked(6 + i, i) = damping_of(i, damping);
  Vector by = stacked.colPivHouseholderQr().solve(wanted);
  // Nothing to gain, even to first order.
  if (!((r - a * by).squaredNorm() < r.squaredNorm() * (1 - 1e-15))) by.setZero();
  return by;
}

/// Solves with the curvature of half the squared miss, damped: where much is left to the pose, linear steps
/// converge slowly. Zero where that is not convex.
///
/// By an earlier joint i the columns of joint j change by w_i x v_j and w_i x w_j; of the rotation vector's
/// change, the inverse right Jacobian, the symmetric part counts.
Vector Search::curved_step(const Columns& a, const Place& at, const Weights& weights, const Twist& r,
                           double damping) const {
  const int n = arm_.joints;
  Columns j = at.jacobian;
  for (int i = 0; i < n; ++i)
    if (a.col(i).isZero(0)) j.col(i).setZero();
  const double of_position = weights.position * weights.position;
  const double of_turn = weights.orientation * weights.orientation;
  const Eigen::Matrix3d change = change_of_rotation_vector(at.off.tail<3>());
  const Eigen::Matrix3d turn = 0.5 * of_turn * (change + change.transpose());
  Square curvature = of_position * j.topRows<3>().transpose() * j.topRows<3>();
  curvature += j.bottomRows<3>().transpose() * turn * j.bottomRows<3>();
  for (int later = 0; later < n; ++later)
    for (int i = 0; i <= later; ++i) {
      const Eigen::Vector3d axis = j.col(i).tail<3>();
      const double bend = of_position * at.off.head<3>().dot(axis.cross(j.col(later).head<3>())) +
                          0.5 * of_turn * at.off.tail<3>().dot(axis.cross(j.col(later).tail<3>()));
      curvature(i, later) -= bend;
      if (i < later) curvature(later, i) -= bend;
    }
  for (int i = 0; i < n; ++i) {
    const double least = damping_of(i, std::max(damping, 1e-12));
    curvature(i, i) += least * least;
  }
  const Eigen::LLT<Square> root(curvature);
  if (root.info() != Eigen::Success) return Vector::Zero(n);
  return root.solve(Vector(a.transpose() * r));
}

/// Descends until no step makes the weighted miss smaller.
Search::Place Search::descended(const Weights& weights, Place at) const {
  double damping = 1e-3;
  const double rounding = 1e-16 * size_of_arm_;
  Twist r = weights.of(at.off);
  bool slow = false;
  for (int i = 0; damping < 1e4 && r.norm() > rounding; ++i) {
    if (i == most_steps) return at;
    const Columns a = held_at_limits(columns(weights, at), at, r);
    Vector by = slow ? curved_step(a, at, weights, r, damping) : linear_step(a, r, damping);
    if (slow && by.isZero(0)) by = linear_step(a, r, damping);
    if (by.isZero(0)) break;
    const Place next = place(clamped(at.q + by));
    const Twist after = weights.of(next.off);
    if (!(after.squaredNorm() < r.squaredNorm())) {
      damping = 8 * std::max(damping, 1e-9);
      continue;
    }
    slow = after.squaredNorm() > 0.2 * r.squaredNorm();
    at = next;
    r = after;
    damping = damping < 1e-12 ? 0 : damping / 8;
  }
  at.settled = true;
  return at;
}

/// If one part comes first the weight of the other falls from stage to stage, and the descent keeps to the
/// valley that it is in.
Search::Place Search::minimum(const Vector& start) const {
  const Place at = place(start);
  if (request_.prefer == Prefer::both) return descended({1, length_}, at);
  const bool position = request_.prefer == Prefer::position;
  Place best = at;
  for (const double share : {1e-2, 1e-4, 1e-6})
    best = descended({position ? 1 : share, length_ * (position ? share : 1)}, best);
  return best;
}

double Search::miss(const Row& row) const {
  return std::hypot(row.position_error, length_ * row.orientation_error);
}

/// The part that comes first decides, unless it is the same but for rounding.
bool Search::is_nearer(const Row& a, const Row& b) const {
  if (request_.prefer == Prefer::both) return miss(a) < miss(b);
  const double position = a.position_error - b.position_error;
  const double orientation = length_ * (a.orientation_error - b.orientation_error);
  const bool first = request_.prefer == Prefer::position;
  const double major = first ? position : orientation, minor = first ? orientation : position;
  return std::abs(major) > 1e-9 * size_of_arm_ ? major < 0 : minor < 0;
}

/// True if joints can move to first order without a change of what they reach.
bool Search::is_free(const Place& at) const {
  Columns a = columns({1, size_of_arm_}, at);
  for (int i = 0; i < arm_.joints; ++i)
    if (!turns(i)) a.col(i) *= size_of_arm_;
  Eigen::ColPivHouseholderQR<Columns> qr(a);
  qr.setThreshold(1e-7);
  return qr.rank() < arm_.joints;
}

/// Equally near rows are one row if their joints are the same, or if both are places of a continuum.
bool Search::is_known(const Row& row) const {
  for (int k = 0; k < size_; ++k) {
    const Row& known = (*this)[k];
    if (std::abs(miss(known) - miss(row)) > 1e-9 * size_of_arm_) continue;
    double apart = 0;
    for (int i = 0; i < arm_.joints; ++i) {
      const double way = known.q[i] - row.q[i];
      apart = std::max(apart, std::abs(turns(i) && std::isinf(request_.lower[i]) ? without_turns(way) : way));
    }
    if (apart < 1e-5 || (known.continuum && row.continuum)) return true;
  }
  return false;
}

void Search::insert(const Row& row) {
  int place = size_;
  while (place > 0 && is_nearer(row, (*this)[place - 1])) --place;
  if (place == most_rows) return;
  if (size_ < most_rows) ++size_;
  for (int i = size_ - 1; i > place; --i)
    rows_[static_cast<std::size_t>(i)] = rows_[static_cast<std::size_t>(i - 1)];
  rows_[static_cast<std::size_t>(place)] = row;
}

void Search::add(const Vector& start) {
  if (!start.allFinite()) return;
  const Place at = minimum(clamped(start));
  if (!at.settled || !at.off.allFinite()) return;
  const Row row{at.q, at.off.head<3>().norm(), at.off.tail<3>().norm(), is_free(at)};
  if (!is_known(row)) insert(row);
}

void Search::add_spread(int starts) {
  for (int i = 1; i <= starts; ++i) add(spread(i));
}

Status Search::status() const {
  if (!valid_) return Status::invalid;
  if (size_ == 0) return Status::incomplete;
  const Row& best = rows_.front();
  const bool reaches = best.position_error <= reached * size_of_arm_ && best.orientation_error <= reached;
  return reaches ? Status::solved : Status::unreachable;
}

}  // namespace qvgen::inverse::nearest
