// SPDX-License-Identifier: MIT
// Inverse kinematics in C of some arms, in double and in float, each by one name.
#pragma once

#include <array>
#include <cstddef>

#define QVGEN_USUAL_ARMS(arm) arm(ur5, 6, ) arm(stanford, 6, ) arm(rrr, 3, _of_position)
#if defined(QVGEN_ALL_ARMS)
#define QVGEN_ARMS(arm) QVGEN_USUAL_ARMS(arm) arm(puma560, 6, ) arm(nn, 6, )
#else
#define QVGEN_ARMS QVGEN_USUAL_ARMS
#endif

extern "C" {
#if defined(QVGEN_ALL_ARMS)
#include "qvgen_nn.h"
#include "qvgen_nn_in_float.h"
#include "qvgen_nn_in_float_inverse.h"
#include "qvgen_nn_inverse.h"
#include "qvgen_puma560.h"
#include "qvgen_puma560_in_float.h"
#include "qvgen_puma560_in_float_inverse.h"
#include "qvgen_puma560_inverse.h"
#endif
#include "qvgen_rrr.h"
#include "qvgen_rrr_in_float.h"
#include "qvgen_rrr_in_float_inverse.h"
#include "qvgen_rrr_inverse.h"
#include "qvgen_stanford.h"
#include "qvgen_stanford_in_float.h"
#include "qvgen_stanford_in_float_inverse.h"
#include "qvgen_stanford_inverse.h"
#include "qvgen_ur5.h"
#include "qvgen_ur5_in_float.h"
#include "qvgen_ur5_in_float_inverse.h"
#include "qvgen_ur5_inverse.h"
}

namespace qvgen::test {

/// A pose as both languages take it.
template <class Scalar>
struct Target {
  std::array<Scalar, 4> orientation;
  std::array<Scalar, 3> position;
};

// Positions alone are what three joints are asked for.
#define QVGEN_TASK_6(pose) (pose).orientation.data(), (pose).position.data()
#define QVGEN_TASK_3(pose) (pose).position.data()

#define QVGEN_SPACE(robot, functions, scalar_type, dof_, suffix)                                             \
  struct functions##_arm {                                                                                   \
    using Scalar = scalar_type;                                                                              \
    using Found = functions##_solutions;                                                                     \
    static constexpr std::size_t dof = dof_;                                                                 \
    static Target<Scalar> tool(const std::array<Scalar, dof>& q) {                                           \
      functions##_pose pose;                                                                                 \
      functions##_forward_kinematics(q.data(), &functions##_default_geometry, &pose);                        \
      Target<Scalar> target;                                                                                 \
      for (std::size_t i = 0; i < 4; ++i) target.orientation[i] = pose.orientation[i];                       \
      for (std::size_t i = 0; i < 3; ++i) target.position[i] = pose.position[i];                             \
      return target;                                                                                         \
    }                                                                                                        \
    static Found all(const Target<Scalar>& target, const Scalar* seed = nullptr) {                           \
      Found found;                                                                                           \
      functions##_inverse_kinematics##suffix(QVGEN_TASK_##dof_(target), seed, &functions##_default_geometry, \
                                             functions##_default_tolerance, &found);                         \
      return found;                                                                                          \
    }                                                                                                        \
    static Found near(const Target<Scalar>& target, const std::array<Scalar, dof>& seed) {                   \
      Found found;                                                                                           \
      functions##_inverse_kinematics_near##suffix(QVGEN_TASK_##dof_(target), seed.data(),                    \
                                                  &functions##_default_geometry,                             \
                                                  functions##_default_tolerance, &found);                    \
      return found;                                                                                          \
    }                                                                                                        \
    static Found within(const Target<Scalar>& target, const std::array<Scalar, dof>& seed,                   \
                        const std::array<Scalar, dof>& lower, const std::array<Scalar, dof>& upper) {        \
      Found found;                                                                                           \
      functions##_inverse_kinematics##suffix##_within_limits(                                                \
          QVGEN_TASK_##dof_(target), seed.data(), lower.data(), upper.data(), &functions##_default_geometry, \
          functions##_default_tolerance, &found);                                                            \
      return found;                                                                                          \
    }                                                                                                        \
    static bool turns(std::size_t joint) { return functions##_is_revolute[joint] != 0; }                     \
  };
#define QVGEN_BOTH(robot, dof, suffix)                     \
  QVGEN_SPACE(robot, robot, double, dof, suffix)           \
  QVGEN_SPACE(robot, robot##_in_float, float, dof, suffix) \
  struct robot##_pair {                                    \
    using InDouble = robot##_arm;                          \
    using InFloat = robot##_in_float_arm;                  \
  };
QVGEN_ARMS(QVGEN_BOTH)

}  // namespace qvgen::test
