// SPDX-License-Identifier: MIT
#include "verify/inverse/described_arm.h"

#include "exact/constant_angle.h"

namespace qvgen::verify {

DescribedArm::DescribedArm(const derive::inverse::Problem& problem, const model::Bindings& geometry)
    : problem_(problem), described_(problem.described, geometry), moving_(problem.moving, geometry) {}

Pair DescribedArm::pose_of_plan(const Pair& pose) const {
  if (!problem_.has_frames) return pose;
  return inverse(moving_.pair(problem_.base)) * pose * inverse(moving_.pair(problem_.tool));
}

Real DescribedArm::phase(std::size_t place) const {
  if (place >= problem_.phases.size()) return 0;
  return Real(cln::cl_R(*exact::radians(problem_.phases[place])));
}

Real DescribedArm::value_of_plan(const std::vector<Real>& row, int place) const {
  const auto at = static_cast<std::size_t>(place);
  return row[at] + phase(at);
}

std::vector<Real> DescribedArm::row(const Row& of_plan, const std::vector<Real>& given) const {
  std::vector<Real> result = given;
  for (std::size_t i = 0; i < of_plan.q.size(); ++i) {
    const auto place = static_cast<std::size_t>(problem_.places[i]);
    result[place] = of_plan.q[i] - phase(place);
  }
  return result;
}

}  // namespace qvgen::verify
