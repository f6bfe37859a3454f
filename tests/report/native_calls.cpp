// SPDX-License-Identifier: MIT
// Functions that are generated in C++ alone, to be called from Python beside those of a page: with ROBOT its
// name, SOURCE a generated source, and HAS_ARM_ANGLE or HAS_INVERSE.
#include SOURCE

namespace arm = qvgen::robots::ROBOT;

namespace {

using Joints = arm::JointVector<double>;

const arm::Geometry& shape(const double* g) { return *reinterpret_cast<const arm::Geometry*>(g); }
qvgen::Pose<double> pose_of(const double* p) {
  return {Eigen::Quaterniond(p[0], p[1], p[2], p[3]), qvgen::Vector3<double>(p[4], p[5], p[6])};
}

template <class Rows>
int written(const Rows& found, double* out) {
  for (const auto& row : found) {
    for (int k = 0; k < arm::dof; ++k) *out++ = row.q[k];
    *out++ = row.branch;
    *out++ = row.continuum;
  }
  return found.size();
}

}  // namespace

#ifdef HAS_INVERSE
extern "C" int solutions(const double* pose, const double* q, const double* g, double* out) {
  const Joints seed = Eigen::Map<const Joints>(q);
  return written(arm::inverse_kinematics(pose_of(pose), seed, shape(g)), out);
}
#endif
#ifdef HAS_ARM_ANGLE
extern "C" double arm_angle(const double* q, const double* g) {
  const Joints seed = Eigen::Map<const Joints>(q);
  return arm::arm_angle(seed, {}, shape(g));
}
extern "C" int solutions_at_arm_angle(const double* pose, const double* q, double psi, const double* g,
                                      double* out) {
  const Joints seed = Eigen::Map<const Joints>(q);
  return written(arm::inverse_kinematics_arm_angle(pose_of(pose), psi, seed, {}, shape(g)), out);
}
#endif
