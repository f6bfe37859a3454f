// SPDX-License-Identifier: MIT
#include <qvgen/inverse_velocity.h>

namespace qvgen::detail {

template bool damped_solve(const Matrix3<double>&, const Vector3<double>&, Eigen::Index,
                           const InverseVelocityOptions<double>&, Vector3<double>&, Damping<double, 3>*);
template bool damped_solve(const Matrix3<float>&, const Vector3<float>&, Eigen::Index,
                           const InverseVelocityOptions<float>&, Vector3<float>&, Damping<float, 3>*);
template bool damped_solve(const Matrix6<double>&, const Vector6<double>&, Eigen::Index,
                           const InverseVelocityOptions<double>&, Vector6<double>&, Damping<double, 6>*);
template bool damped_solve(const Matrix6<float>&, const Vector6<float>&, Eigen::Index,
                           const InverseVelocityOptions<float>&, Vector6<float>&, Damping<float, 6>*);

}  // namespace qvgen::detail
