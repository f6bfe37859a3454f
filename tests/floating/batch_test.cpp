// SPDX-License-Identifier: MIT
// Batch forms of a robot whose base floats: each has what single calls have, under gravity along -z and in
// any direction.
#include <qvgen/robots/hopper/batch.h>

#include "batch/laws.h"

namespace qvgen {
namespace {

namespace robot = robots::hopper;
constexpr std::size_t dof = robot::dof, size = robot::velocity_size;

template <class T>
class BatchesOfHopper : public testing::Test {
 protected:
  using Given = std::vector<batch_laws::Owned<T>>;
  using Columns = std::vector<std::vector<T>>;
  using Velocity = robot::Velocity<T>;

  static robot::Configuration<T> at(const Columns& in) {
    const auto& b = in[0];
    return {{Quaternion<T>(b[0], b[1], b[2], b[3]), {b[4], b[5], b[6]}},
            Eigen::Map<const robot::JointVector<T>>(in[1].data())};
  }
  static Velocity velocity(const std::vector<T>& column) { return Eigen::Map<const Velocity>(column.data()); }
  template <class... Values>
  static std::vector<T> rows(const Values&... values) {
    std::vector<T> result;
    (batch_laws::append(result, values), ...);
    return result;
  }
  template <class Form, class Single>
  static void of_configuration(const Form& form, const Single& single) {
    batch_laws::expect_single_calls<T>(
        {7, dof},
        [&](const Given& in, const Batch<T>& result, InstructionSet set) { form(in[0], in[1], result, set); },
        [&](const Columns& in) { return single(at(in)); }, 1024);
  }
  template <class Form, class Single>
  static void of_motion(const Form& form, const Single& single, double bound) {
    batch_laws::expect_single_calls<T>(
        {7, dof, size, size},
        [&](const Given& in, const Batch<T>& result, InstructionSet set) {
          form(in[0], in[1], in[2], in[3], result, set);
        },
        [&](const Columns& in) { return single(at(in), velocity(in[2]), velocity(in[3])); }, bound);
  }
};
#ifdef QVGEN_TESTS_FLOAT
using Scalars = testing::Types<double, float>;
#else
using Scalars = testing::Types<double>;
#endif
TYPED_TEST_SUITE(BatchesOfHopper, Scalars);

TYPED_TEST(BatchesOfHopper, InverseDynamics) {
  using T = TypeParam;
  for (const FreeFall<T>& gravity : {FreeFall<T>(T(9.81)), FreeFall<T>(Eigen::Matrix<T, 3, 1>(1, -2, 3))})
    this->of_motion(
        [&](const auto& base, const auto& q, const auto& qd, const auto& qdd, const auto& result,
            InstructionSet set) {
          robot::inverse_dynamics<T>(base, q, qd, qdd, result, {}, {}, gravity, set);
        },
        [&](const auto& at, const auto& qd, const auto& qdd) {
          return this->rows(robot::inverse_dynamics(at, qd, qdd, {}, {}, gravity));
        },
        1024);
}

TYPED_TEST(BatchesOfHopper, ForwardDynamics) {
  using T = TypeParam;
  this->of_motion(
      [&](const auto& base, const auto& q, const auto& qd, const auto& torque, const auto& result,
          InstructionSet set) {
        robot::forward_dynamics<T>(base, q, qd, torque, result, {}, {}, T(9.81), set);
      },
      [&](const auto& at, const auto& qd, const auto& torque) {
        return this->rows(robot::forward_dynamics(at, qd, torque, {}, {}, T(9.81)));
      },
      batch_laws::bound_of_accelerations);
}

TYPED_TEST(BatchesOfHopper, MassMatrix) {
  using T = TypeParam;
  this->of_configuration([&](const auto& base, const auto& q, const auto& result,
                             InstructionSet set) { robot::mass_matrix<T>(base, q, result, {}, {}, set); },
                         [&](const auto& at) { return this->rows(robot::mass_matrix(at)); });
}

TYPED_TEST(BatchesOfHopper, MomentumMatrix) {
  using T = TypeParam;
  this->of_configuration([&](const auto& base, const auto& q, const auto& result,
                             InstructionSet set) { robot::momentum_matrix<T>(base, q, result, {}, {}, set); },
                         [&](const auto& at) { return this->rows(robot::momentum_matrix(at)); });
}

TYPED_TEST(BatchesOfHopper, PotentialEnergy) {
  using T = TypeParam;
  this->of_configuration(
      [&](const auto& base, const auto& q, const auto& result, InstructionSet set) {
        robot::potential_energy<T>(base, q, result, {}, {}, T(9.81), set);
      },
      [&](const auto& at) { return this->rows(robot::potential_energy(at, {}, {}, T(9.81))); });
}

TYPED_TEST(BatchesOfHopper, DerivativesAndRegressor) {
  using T = TypeParam;
  this->of_motion(
      [&](const auto& base, const auto& q, const auto& qd, const auto& qdd, const auto& result,
          InstructionSet set) {
        robot::inverse_dynamics_derivatives<T>(base, q, qd, qdd, result, {}, {}, T(9.81), set);
      },
      [&](const auto& at, const auto& qd, const auto& qdd) {
        const auto d = robot::inverse_dynamics_derivatives(at, qd, qdd, {}, {}, T(9.81));
        return this->rows(d.torque, d.by_position, d.by_rate);
      },
      1024);
  this->of_motion(
      [&](const auto& base, const auto& q, const auto& qd, const auto& qdd, const auto& result,
          InstructionSet set) { robot::regressor<T>(base, q, qd, qdd, result, {}, {}, T(9.81), set); },
      [&](const auto& at, const auto& qd, const auto& qdd) {
        return this->rows(robot::regressor(at, qd, qdd, {}, {}, T(9.81)));
      },
      1024);
}

}  // namespace
}  // namespace qvgen
