// SPDX-License-Identifier: MIT
// Freedoms of a mechanism with loops, counted twice: by Gruebler's formula, which looks at numbers of joints
// alone, and by the rank of the loops' equations where the mechanism is assembled. They differ where loops
// are overconstrained, as all planar ones are; the rank is what moves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "dag/graph.h"
#include "derive/loops/constraints.h"
#include "model/evaluate.h"
#include "model/mechanism.h"

namespace qvgen::verify {

/// Gaps of loops, m and radians, and their derivatives as numbers, at the default geometry (numbers from 1 to
/// 2 without one).
class LoopNumbers {
 public:
  explicit LoopNumbers(const model::Mechanism& mechanism);

  [[nodiscard]] Eigen::VectorXd gaps(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& q) const;  ///< a row for each gap
  [[nodiscard]] double size() const { return size_; }                      ///< of the mechanism, m
  /// Index of the loop that a row belongs to.
  [[nodiscard]] const std::vector<std::size_t>& loop_of_row() const { return loop_of_row_; }
  /// Joints at which all loops are closed, by Newton's steps from random ones; nothing if none of many starts
  /// ends so.
  [[nodiscard]] std::optional<Eigen::VectorXd> assembled(unsigned seed) const;

 private:
  [[nodiscard]] std::optional<Eigen::VectorXd> closed_from(Eigen::VectorXd q) const;
  /// A rod's equation has the square of its length.
  [[nodiscard]] Eigen::VectorXd with_lengths_above_zero(Eigen::VectorXd q) const;
  /// Length of the rod that a row is the gap of, m; 0: of none.
  [[nodiscard]] double rod_length(Eigen::Index row, const Eigen::VectorXd& q) const;

  model::Robot robot_;
  model::Bindings geometry_;
  dag::Function gap_, jacobian_;
  std::vector<std::size_t> loop_of_row_;
  /// A rod's length, or the slide whose value it is.
  struct Rod {
    double length = 0;
    std::optional<Eigen::Index> joint;
  };
  std::vector<Rod> rods_;          ///< for each row
  std::vector<bool> are_lengths_;  ///< for each row: it is no angle
  double size_ = 1;
};

struct Mobility {
  bool assembled = false;  ///< false: no joints were found at which all loops close
  int joints = 0;
  int gruebler = 0;
  int in_planes = 0;  ///< Gruebler's count where loops whose axes are parallel have the equations of a plane
  int free = 0;
  std::vector<std::size_t> redundant;  ///< loops that hold nothing more than those before them
  std::vector<std::size_t> still;      ///< joints that never move
  std::vector<std::size_t> loose;      ///< joints that move although the driven ones stand still
};

/// Counts freedoms at random assemblies. Some may be of another kind than the mechanism's: a scissor whose
/// feet meet folds, and its bars turn by themselves. The mechanism's are those that the driven joints
/// determine, then those within all limits, then those in which most joints move, then those with most
/// freedoms.
Mobility mobility_of(const model::Mechanism& mechanism);

/// Returns the derivatives of all gaps at assemblies of that kind; nothing if none are found.
std::vector<Eigen::MatrixXd> jacobians_of(const model::Mechanism& mechanism);

/// In words: how many freedoms, which loops are redundant, which joints never move, what is wrong with the
/// number of driven joints. One sentence an entry.
std::vector<std::string> text_of(const Mobility& mobility, const model::Mechanism& mechanism);

}  // namespace qvgen::verify
