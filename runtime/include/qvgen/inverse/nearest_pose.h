// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <Eigen/Core>
#include <qvgen/inverse/angles.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/pose.h>

/// The reachable pose that is nearest to a given one.
///
/// An arm with fewer than six joints reaches few poses exactly. A pose that was rounded, measured or planned
/// for another arm misses all of them. The joints that come nearest are a least squares problem; it is solved
/// by damped Gauss-Newton steps (Levenberg 1944, Marquardt 1963) from several starts. The same serves a pose
/// out of the reach of any arm, and joint limits.
namespace qvgen {

/// Which part of a pose comes first where both cannot be reached.
enum class Prefer {
  both,        ///< least squares of metres and of radians times `metres_per_radian`
  position,    ///< the position as near as possible; of those joints the nearest orientation
  orientation  ///< the orientation as near as possible; of those joints the nearest position
};

/// Says what "nearest" means, and where to look.
template <int dof>
struct NearestPoseOptions {
  Prefer prefer = Prefer::both;
  /// m: the distance that counts as much as one radian; 0 takes the arm's size: how far the pose and the tool
  /// at zero are from the world's origin, together.
  double metres_per_radian = 0;
  /// rad or m: rows stay within; infinite where there is no limit.
  JointLimits<dof> limits = {Joints<dof>::Constant(-std::numeric_limits<double>::infinity()),
                             Joints<dof>::Constant(std::numeric_limits<double>::infinity())};
  /// Number of starts spread over the joints' ranges, besides those that the caller knows. Each costs 10 to
  /// 30 steps as a rule and 200 at most; three times that if one part is preferred.
  int starts = 32;
};

/// One local minimum: no joints close to these come nearer to the pose.
template <int dof>
struct NearestRow {
  Joints<dof> q;             ///< angles without limits in (-pi, pi], rad; others within limits, rad or m
  double position_error;     ///< m, from the tool to the pose
  double orientation_error;  ///< rad in [0, pi], from the tool to the pose
  bool continuum;            ///< other joints next to these may be as near
};

/// The rows for one pose, the nearest first. Several may be equally near; later rows may be farther.
template <int dof>
class NearestRows {
 public:
  static constexpr int max_size = 16;

  /// solved: the first row reaches the pose but for rounding; unreachable: it comes as near as its errors
  /// say; invalid: a number is NaN or infinite, the pose is no rotation, or a lower limit exceeds an upper
  /// one; incomplete: no start has led to a minimum.
  Status status = Status::incomplete;

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const NearestRow<dof>& operator[](int i) const { return rows_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const NearestRow<dof>* begin() const { return rows_.data(); }
  [[nodiscard]] const NearestRow<dof>* end() const { return rows_.data() + size_; }
  /// Appends a row; the caller keeps to `max_size`.
  NearestRow<dof>& append() { return rows_[static_cast<std::size_t>(size_++)]; }

 private:
  int size_ = 0;
  std::array<NearestRow<dof>, max_size> rows_;
};

namespace inverse {
namespace nearest {

inline constexpr int most_joints = 16;
inline constexpr int most_rows = 16;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_joints, 1>;
using Twist = Eigen::Matrix<double, 6, 1>;
using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, most_joints>;

/// An arm of any number of joints, so that the solver is compiled once: `reach` sets the pose and the
/// geometric Jacobian of q.
struct Arm {
  int joints;
  const bool* revolute;
  const void* functions;
  void (*reach)(const void* functions, const Vector& q, Pose<double>& pose, Columns& jacobian);
};

struct Request {
  Prefer prefer;
  double metres_per_radian;
  Vector lower, upper;
};

struct Row {
  Vector q;
  double position_error, orientation_error;
  bool continuum;
};

/// Rows in their order, which start after start is added to.
class Search {
 public:
  Search(const Arm& arm, const Pose<double>& pose, const Request& request);

  /// False: no row will be found, see `NearestRows::status`.
  [[nodiscard]] bool is_valid() const { return valid_; }
  /// Adds the minimum below these joints.
  void add(const Vector& start);
  /// Adds those below so many joints spread over their ranges.
  void add_spread(int starts);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const Row& operator[](int i) const { return rows_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Status status() const;

 private:
  struct Place;
  struct Weights;
  [[nodiscard]] bool is_usable(const Pose<double>& pose) const;
  [[nodiscard]] bool turns(int i) const { return arm_.revolute[i]; }
  [[nodiscard]] Vector clamped(Vector q) const;
  [[nodiscard]] Vector spread(int number) const;
  [[nodiscard]] Place place(const Vector& q) const;
  [[nodiscard]] Columns columns(const Weights& weights, const Place& at) const;
  [[nodiscard]] double damping_of(int i, double damping) const;
  [[nodiscard]] Columns held_at_limits(Columns a, const Place& at, const Twist& r) const;
  [[nodiscard]] Vector linear_step(const Columns& a, const Twist& r, double damping) const;
  [[nodiscard]] Vector curved_step(const Columns& a, const Place& at, const Weights& weights, const Twist& r,
                                   double damping) const;
  [[nodiscard]] Place descended(const Weights& weights, Place at) const;
  [[nodiscard]] Place minimum(const Vector& start) const;
  [[nodiscard]] double miss(const Row& row) const;
  [[nodiscard]] bool is_nearer(const Row& a, const Row& b) const;
  [[nodiscard]] bool is_free(const Place& at) const;
  [[nodiscard]] bool is_known(const Row& row) const;
  void insert(const Row& row);

  Arm arm_;
  Request request_;
  Pose<double> goal_;
  double size_of_arm_ = 1;  ///< m
  double length_ = 1;       ///< m a radian
  bool valid_;
  int size_ = 0;
  std::array<Row, most_rows> rows_;
};

/// Joints to start from: as they are, or of a row of a solution set.
template <int dof>
Vector start_of(const Joints<dof>& q) {
  return q;
}
template <int dof>
Vector start_of(const Solution<dof>& row) {
  return row.q;
}

}  // namespace nearest

/// Solves for the nearest poses of one arm. `forward(q)` is its pose, `jacobian(q)` the geometric Jacobian at
/// the tool in the world frame, linear rows first. `--only nearest_pose` generates it as `arm::nearest_pose`;
/// by hand:
///
///     const qvgen::inverse::NearestPose arm{mine::is_revolute,
///         [](const auto& q) { return mine::forward_kinematics(q); },
///         [](const auto& q) { return mine::jacobian(q); }};
///     const auto rows = arm.rows(pose, {}, mine::inverse_kinematics(pose, mine::Geometry{}, 0.01));
///
/// At most 16 joints. The work is bounded; no heap, no exceptions.
template <std::size_t joints, class Forward, class Jacobian>
class NearestPose {
 public:
  static constexpr int dof = static_cast<int>(joints);
  static_assert(dof <= nearest::most_joints, "the nearest pose is for at most 16 joints");

  NearestPose(const std::array<bool, joints>& revolute, Forward forward, Jacobian jacobian)
      : revolute_(revolute), forward_(forward), jacobian_(jacobian) {}

  /// Returns the local minima below `known` joints (a set of solutions, or a range of joint vectors, such as
  /// a seed) and below `options.starts` spread ones.
  template <class Known = std::array<Joints<dof>, 0>>
  [[nodiscard]] NearestRows<dof> rows(const Pose<double>& pose, const NearestPoseOptions<dof>& options = {},
                                      const Known& known = {}) const {
    const nearest::Arm arm{dof, revolute_.data(), this, reach};
    nearest::Search search(arm, pose,
                           {options.prefer, options.metres_per_radian, nearest::Vector(options.limits.lower),
                            nearest::Vector(options.limits.upper)});
    if (search.is_valid()) {
      for (const auto& each : known) search.add(nearest::start_of<dof>(each));
      search.add_spread(options.starts);
    }
    NearestRows<dof> found;
    for (int i = 0; i < search.size(); ++i)
      found.append() = {search[i].q, search[i].position_error, search[i].orientation_error,
                        search[i].continuum};
    found.status = search.status();
    return found;
  }

 private:
  static void reach(const void* functions, const nearest::Vector& q, Pose<double>& pose,
                    nearest::Columns& jacobian) {
    const auto& arm = *static_cast<const NearestPose*>(functions);
    const Joints<dof> fixed = q;
    pose = arm.forward_(fixed);
    jacobian = arm.jacobian_(fixed);
  }

  std::array<bool, joints> revolute_;
  Forward forward_;
  Jacobian jacobian_;
};

}  // namespace inverse
}  // namespace qvgen
