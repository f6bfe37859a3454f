// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/arm_angle.h>

#include "three_turns.h"

namespace qvgen::inverse::arm_angle {

/// Two directions across the line from shoulder to wrist: where the elbow is at an arm angle of zero, and at
/// a quarter of a turn.
struct ReferencePlane {
  Vector3<double> zero, quarter;
  bool undefined = false;  ///< the reference says nothing there: any directions
};

/// `line`: unit vector from shoulder to wrist.
ReferencePlane reference_plane(const Arm& arm, const ArmAngleReference& reference,
                               const Vector3<double>& line);

/// The upper arm and the forearm: how far the elbow is bent decides how far the wrist is from the shoulder.
class Elbow {
 public:
  explicit Elbow(const Arm& arm);

  /// Squares of the distances from shoulder to wrist that there are, m^2.
  [[nodiscard]] double least_square() const { return least_; }
  [[nodiscard]] double most_square() const { return most_; }
  /// The longest distance, and about the arm's size.
  [[nodiscard]] double longest() const { return longest_; }

  /// The elbow at one angle, as joints 1 to 3 carry it when they are at zero: unit vectors to the wrist,
  /// across it on the elbow's side, and across both.
  struct Bent {
    Rotor<double> turn;  ///< of joint 4
    Vector3<double> line, side, normal;
  };
  /// Shares of the range of squared distances, from the longest and from the shortest: sin^2 and cos^2 of
  /// half the bend. sense = +-1.
  [[nodiscard]] Bent at_shares(double low, double high, double sense) const;
  [[nodiscard]] Bent at_angle(double angle) const;

 private:
  [[nodiscard]] Bent bent(const Rotor<double>& bend, double sense) const;

  Vector3<double> axis_;                  ///< of joint 4
  double along_;                          ///< of the forearm along it
  Vector3<double> forward_;               ///< unit vector from shoulder to elbow
  double upper_length_, forearm_length_;  ///< across axis 4
  double least_, most_, longest_;
  Rotor<double> stretched_;  ///< of joint 4
  bool planar_;
};

/// Rotation of joints 1 to 3 at an arm angle: R(psi) = goal frame, turned about the line by psi, times the
/// elbow's frame transposed.
struct Swivel {
  Vector3<double> line;  ///< unit vector from shoulder to wrist
  ReferencePlane plane;
  Elbow::Bent elbow;

  [[nodiscard]] Matrix3<double> rotation(double psi) const;
  /// p . R(psi) q - value = cosine cos psi + sine sin psi + constant.
  struct Wave {
    double cosine, sine, constant;
  };
  [[nodiscard]] Wave wave(const Vector3<double>& p, const Vector3<double>& q, double value) const;
};

/// Values that the pose alone decides.
struct Goal {
  Status status = Status::unreachable;
  Matrix3<double> rotation;  ///< of all joints together, from where they are at zero
  Vector3<double> line;      ///< unit vector from shoulder to wrist
  ReferencePlane plane;
  double low = 0, high = 0;  ///< shares of the range of squared distances, from the longest and the shortest
  bool undefined =
      false;       ///< the arm angle is: the elbow is straight or folded, or the reference says nothing
  int elbows = 2;  ///< ways to bend it
  bool is_one_elbow =
      false;  ///< over all arm angles both ways are the same: it is straight or folded, in one plane
};
Goal goal_of(const Arm& arm, const Elbow& elbow, const Pose<double>& pose, const ArmAngleReference& reference,
             double tolerance);

inline Swivel swivel_of(const Goal& goal, const Elbow& elbow, int branch) {
  return {goal.line, goal.plane, elbow.at_shares(goal.low, goal.high, branch == 0 ? 1 : -1)};
}

/// Returns the rotation that is left for the wrist when joints 1 to 4 are known.
inline Matrix3<double> wrist_rotation(const Arm& arm, const Goal& goal, const Swivel& swivel,
                                      const Matrix3<double>& upper) {
  const Matrix3<double> rest = upper.transpose() * goal.rotation;
  Matrix3<double> result;
  for (int i = 0; i < 3; ++i)
    result.col(i) = turned(arm.axes[3], inverse::inverse(swivel.elbow.turn), rest.col(i));
  return result;
}

}  // namespace qvgen::inverse::arm_angle
