// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/view.h>
#include <qvgen/inverse_velocity.h>

namespace qvgen {

/// The joint rates of many configurations; views, which own nothing.
template <class Scalar>
struct BatchOfRates {
  Batch<Scalar> qd;              ///< dof rows, rad/s or m/s
  Batch<VelocityStatus> status;  ///< one row; may be left empty
  Batch<Scalar> residual;        ///< one row, |J qd - twist|; may be left empty
};

}  // namespace qvgen
