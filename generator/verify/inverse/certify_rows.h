// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "model/evaluate.h"
#include "model/robot.h"

namespace qvgen::verify {

/// A pose in doubles: quaternion w, x, y, z, then position.
using PoseInDoubles = std::array<double, 7>;
/// Solves a pose in doubles: joint values of every row. A solver that asks for more than a pose takes that
/// from the sampled joints.
using RowSolver =
    std::function<std::vector<std::vector<double>>(const PoseInDoubles&, const std::vector<double>& sampled)>;

struct RowCertificate {
  int poses = 0;
  int solutions = 0;
  [[nodiscard]] std::string text() const;
};

/// Runs a numerical solver, the very code that users run, at random joints of an arm: the sampled
/// joints must be among the rows, to 1e-6, and every row must give the pose back to 1e-12, by a forward
/// kinematics of sixty digits. Throws CertificateError otherwise.
/// `geometry`: values of the arm's symbols. `heading`: a joint about whose axis the poses may be turned,
/// since what is asked for leaves that heading; -1 for none.
RowCertificate certify_rows(const model::Robot& robot, const model::Bindings& geometry, double size,
                            const RowSolver& solver, int poses, int heading = -1);

}  // namespace qvgen::verify
