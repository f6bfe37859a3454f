// SPDX-License-Identifier: MIT
#include "kdl_inverse.h"

#include <algorithm>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

#include "chain.h"
#include "reference/load.h"

namespace comparison {
namespace {

constexpr double accuracy = 1e-6;
constexpr unsigned iterations = 100;

KDL::Frame frame(const double* numbers) {
  KDL::Frame result;
  std::copy_n(numbers, 3, result.p.data);
  std::copy_n(numbers + 3, 9, result.M.data);
  return result;
}

}  // namespace

/// The solvers keep references to their chain and to each other: the order of members matters.
struct KdlInverse::Solvers {
  explicit Solvers(const reference::Chain& robot)
      : chain(to_kdl(robot)),
        n(chain.getNrOfJoints()),
        forward(chain),
        velocity(chain),
        newton(chain, forward, velocity, iterations, accuracy),
        levenberg_marquardt(chain, accuracy) {}

  KDL::Chain chain;
  unsigned n;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::ChainIkSolverVel_pinv velocity;
  KDL::ChainIkSolverPos_NR newton;
  KDL::ChainIkSolverPos_LMA levenberg_marquardt;
  KDL::JntArray start{n}, result{n};
};

KdlInverse::KdlInverse(const std::string& description)
    : solvers_(std::make_unique<Solvers>(reference::load(description))) {}

KdlInverse::~KdlInverse() = default;

int KdlInverse::levenberg_marquardt(const double* start, const double* goal) {
  std::copy_n(start, solvers_->n, solvers_->start.data.data());
  return solvers_->levenberg_marquardt.CartToJnt(solvers_->start, frame(goal), solvers_->result);
}

int KdlInverse::newton(const double* start, const double* goal) {
  std::copy_n(start, solvers_->n, solvers_->start.data.data());
  return solvers_->newton.CartToJnt(solvers_->start, frame(goal), solvers_->result);
}

const double* KdlInverse::result() const { return solvers_->result.data.data(); }

}  // namespace comparison
