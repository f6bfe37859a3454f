// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/branch.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/pose.h>

/// The arm angle of seven joints around a spherical shoulder and a spherical wrist: by how much the elbow is
/// turned about the line from shoulder to wrist (Shimizu et al. 2008). With it a pose has up to eight
/// solutions in closed form; over it, every joint angle moves so that it meets a limit where a
/// cos psi + b sin psi + c = 0.
namespace qvgen {

/// Zero of an arm angle: there the elbow is on the side of a reference direction, in the plane that this
/// direction and the line from shoulder to wrist span. All directions in the base frame, of any length; a
/// zero vector stands for the arm's own choice.
struct ArmAngleReference {
  enum class Kind {
    /// A fixed direction, the arm's own choice being the first axis, away from the base. Undefined where the
    /// wrist is in that direction from the shoulder or opposite.
    conventional,
    /// A direction that turns along when the wrist moves (Elias and Wen 2024): undefined only where the wrist
    /// is in the direction of `half_line` from the shoulder, the arm's own choice being the first axis,
    /// towards the base.
    stereographic
  };
  Kind kind = Kind::conventional;
  Vector3<double> direction = Vector3<double>::Zero();
  Vector3<double> half_line = Vector3<double>::Zero();

  static ArmAngleReference conventional(const Vector3<double>& direction = Vector3<double>::Zero()) {
    return {Kind::conventional, direction, Vector3<double>::Zero()};
  }
  static ArmAngleReference stereographic(const Vector3<double>& half_line = Vector3<double>::Zero(),
                                         const Vector3<double>& direction = Vector3<double>::Zero()) {
    return {Kind::stereographic, direction, half_line};
  }
};

/// Arm angles, rad, with which one branch of a pose is within the joint limits: from `lower` in [-pi, pi] to
/// `upper`, which may be past pi; less than a turn apart, or -pi and pi: all. At either end a joint stands at
/// its limit, up to rounding, or the branch ends.
struct ArmAngleInterval {
  double lower, upper;
  double within;  ///< one of them at which every joint has been found within its limits
  int branch;     ///< that of the solutions

  [[nodiscard]] double width() const { return upper - lower; }
};

/// All of them of a pose, in the order of branches and of arm angles.
class ArmAngleIntervals {
 public:
  /// Between two neighbours of one branch stand two of the at most 36 angles at which something ends.
  static constexpr int capacity = 8 * 18;
  /// solved; unreachable: the pose, or it is within the limits with no arm angle; invalid.
  Status status = Status::unreachable;

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const ArmAngleInterval& operator[](int i) const {
    return intervals_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] const ArmAngleInterval* begin() const { return intervals_.data(); }
  [[nodiscard]] const ArmAngleInterval* end() const { return intervals_.data() + size_; }
  void append(const ArmAngleInterval& interval) { intervals_[static_cast<std::size_t>(size_++)] = interval; }

 private:
  int size_ = 0;
  std::array<ArmAngleInterval, capacity> intervals_;
};

/// An arm angle, rad in (-pi, pi], and its interval; none where there are no intervals.
struct ChosenArmAngle {
  double psi = 0;
  const ArmAngleInterval* interval = nullptr;
};

/// The arm angle of an interval that is nearest to a given one, rad; at an interval's end, a little inside.
double nearest_arm_angle(const ArmAngleInterval& interval, double psi);
/// Returns the nearest arm angle of all intervals; these have to outlive the result.
ChosenArmAngle nearest_arm_angle(const ArmAngleIntervals& intervals, double psi);
/// The one from which arm angles at which a joint meets a limit are farthest: the middle of the widest
/// interval.
ChosenArmAngle widest_arm_angle(const ArmAngleIntervals& intervals);

namespace inverse::arm_angle {

/// An arm with all joints at zero, in the base frame. What generated code knows of it.
struct Arm {
  std::array<Vector3<double>, 7> axes;     ///< unit vectors
  Vector3<double> base;                    ///< where the arm stands
  Vector3<double> shoulder, elbow, wrist;  ///< points: the elbow is the one of axis 4 next to the shoulder
  bool planar;                             ///< shoulder and wrist are in one plane across axis 4
  Pose<double> tool;
};

using Row = Joints<7>;
using Found = Solutions<7, 8>;

double arm_angle(const Arm& arm, const Row& q, const ArmAngleReference& reference);

/// A branch is 4 (the elbow is bent the other way) + 2 (so is the shoulder) + 1 (so is the wrist). Free
/// joints are those of `preference`.
Found solve(const Arm& arm, const Pose<double>& pose, double psi, const ArmAngleReference& reference,
            const Row& preference, double tolerance);

ArmAngleIntervals intervals(const Arm& arm, const Pose<double>& pose, const JointLimits<7>& limits,
                            const ArmAngleReference& reference, double tolerance);

/// One row for each branch that has one within the limits, in the middle of its widest interval, each joint's
/// whole turns as near to zero as may be.
LimitedSolutions<7, 8> solve_within(const Arm& arm, const Pose<double>& pose, const JointLimits<7>& limits,
                                    const ArmAngleReference& reference, double tolerance);
/// Returns the rows within limits at the arm angle that is nearest to the seed's, the nearest row first.
LimitedSolutions<7, 8> solve_within(const Arm& arm, const Pose<double>& pose, const Row& seed,
                                    const JointLimits<7>& limits, const ArmAngleReference& reference,
                                    double tolerance);

}  // namespace inverse::arm_angle
}  // namespace qvgen
