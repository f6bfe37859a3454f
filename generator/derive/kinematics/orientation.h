// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "derive/kinematics/zero_reference.h"
#include "symbolic/program.h"

namespace qvgen::derive {

struct OrientationForm {
  std::string name;
  std::function<symbolic::Quaternion(symbolic::Program&)> build;
};

/// Ways to multiply the joints' half-angle quaternions: every choice of disjoint Euler triples taken in
/// closed form, multiplied from the left and from the right.
std::vector<OrientationForm> orientation_forms(const ZeroReferenceChain& chain);

struct MatrixForm {
  std::string name;
  std::function<symbolic::Matrix3(symbolic::Program&)> build;
};

/// Ways to multiply the joints' rotation matrices in full angles: from the left, from the right, split at
/// each joint; and each with one column as the cross product of the other two.
std::vector<MatrixForm> matrix_forms(const ZeroReferenceChain& chain);

/// The orientation multiplied out without names, Euler triples merged from the left.
symbolic::Quaternion written_out_orientation(const ZeroReferenceChain& chain);

}  // namespace qvgen::derive
