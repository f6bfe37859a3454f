// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/problem.h"
#include "verify/inverse/definition.h"
#include "verify/inverse/execute.h"

namespace qvgen::verify {

/// The arm of a problem as it is described, in sixty digits: its poses, and the way from them to what a plan
/// takes and from a plan's rows back, which generated code goes around the plan. Rows are in the order of the
/// problem's places, what the caller gives among them.
class DescribedArm {
 public:
  /// `geometry`: values of all symbols. Both have to outlive this.
  DescribedArm(const derive::inverse::Problem& problem, const model::Bindings& geometry);

  [[nodiscard]] Pair pose(const std::vector<Real>& row) const { return described_.pose(row); }
  /// Seen from the frames that the plan's arm has.
  [[nodiscard]] Pair pose_of_plan(const Pair& pose) const;
  /// The value of a place in the plan's arm, whose joints have other zeros.
  [[nodiscard]] Real value_of_plan(const std::vector<Real>& row, int place) const;
  /// `given`: a row that has what the caller gives.
  [[nodiscard]] std::vector<Real> row(const Row& of_plan, const std::vector<Real>& given) const;

 private:
  [[nodiscard]] Real phase(std::size_t place) const;

  const derive::inverse::Problem& problem_;
  Definition described_, moving_;
};

}  // namespace qvgen::verify
