// SPDX-License-Identifier: MIT
#include "verify/loops/driven.h"

#include <algorithm>

#include "derive/loops/assembly_plan.h"
#include "matrices/decompositions.h"
#include "verify/loops/mobility.h"

namespace qvgen::verify {
namespace {

using Eigen::MatrixXd;

constexpr int most_tried = 20000;
/// Singular values below this share of the greatest are none.
constexpr double rank_share = 1e-7;

/// Returns the motions of all joints that the loops allow, a column each.
MatrixXd motions_at(const MatrixXd& jacobian) {
  const auto [values, motions] = matrices::singular_motions(jacobian);
  const auto rank =
      (values.array() > rank_share * std::max(values.size() > 0 ? values[0] : 0.0, 1e-300)).count();
  return motions.rightCols(jacobian.cols() - rank);
}

/// Goes through the sets of joints of one size that hold the driven ones, in their order.
class Search {
 public:
  Search(std::vector<MatrixXd> motions, std::vector<std::size_t> driven, DrivenChoices& into)
      : motions_(std::move(motions)), into_(into), driven_(driven), chosen_(std::move(driven)) {}

  void run(std::size_t from = 0) {
    if (chosen_.size() == into_.free) return add();
    for (std::size_t joint = from; into_.are_all && joint < static_cast<std::size_t>(motions_[0].rows());
         ++joint) {
      if (std::find(driven_.begin(), driven_.end(), joint) != driven_.end()) continue;
      chosen_.push_back(joint);
      if (tells_apart()) run(joint + 1);
      chosen_.pop_back();
    }
  }

 private:
  void add() {
    if (into_.choices.size() == most_choices) {
      into_.are_all = false;
      return;
    }
    into_.choices.push_back(chosen_);
    std::sort(into_.choices.back().begin(), into_.choices.back().end());
  }

  /// True if the chosen joints move independently of each other at some sample.
  bool tells_apart() {
    if (++tried_ > most_tried) into_.are_all = false;
    return std::any_of(motions_.begin(), motions_.end(), [&](const MatrixXd& motions) {
      MatrixXd rows(static_cast<Eigen::Index>(chosen_.size()), motions.cols());
      for (Eigen::Index i = 0; i < rows.rows(); ++i)
        rows.row(i) = motions.row(static_cast<Eigen::Index>(chosen_[static_cast<std::size_t>(i)]));
      return matrices::singular_values(rows).minCoeff() > rank_share;
    });
  }

  std::vector<MatrixXd> motions_;
  DrivenChoices& into_;
  std::vector<std::size_t> driven_, chosen_;
  int tried_ = 0;
};

}  // namespace

DrivenChoices driven_choices(const model::Mechanism& mechanism, const std::vector<std::size_t>& driven) {
  DrivenChoices result;
  std::vector<MatrixXd> motions;
  for (const MatrixXd& jacobian : jacobians_of(mechanism)) motions.push_back(motions_at(jacobian));
  result.assembled = !motions.empty();
  if (result.assembled) result.free = static_cast<std::size_t>(motions.front().cols());
  if (result.assembled && result.free > 0 && driven.size() <= result.free)
    Search(std::move(motions), driven, result).run();
  return result;
}

std::optional<OtherMotor> motor_for_closed_form(const model::Mechanism& mechanism) {
  const std::vector<std::size_t>& motors = mechanism.loops.actuated;
  for (const std::size_t motor : motors) {
    std::vector<std::size_t> others = motors;
    std::erase(others, motor);
    for (const std::vector<std::size_t>& choice : driven_choices(mechanism, others).choices) {
      if (!derive::loops::assembly_plan(mechanism, choice).found) continue;
      for (const std::size_t joint : choice)
        if (std::find(motors.begin(), motors.end(), joint) == motors.end()) return OtherMotor{motor, joint};
    }
  }
  return std::nullopt;
}

}  // namespace qvgen::verify
