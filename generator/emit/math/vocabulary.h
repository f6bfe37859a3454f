// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/plan.h"
#include "emit/math/notation.h"

namespace qvgen::emit {

/// How the names of a plan read for people: the thesis's ([w, <a, b, c>], <p_x, p_y, p_z>) for the pose, N_i
/// for the pose with the joints before i taken off, M and N for the two sides of a position equation, bars
/// for half angles.
class Vocabulary {
 public:
  Vocabulary(const derive::inverse::Plan& plan, std::vector<std::string> variables, Notation notation);

  /// A name in the programs of a step (or of the target, with the default step).
  [[nodiscard]] std::string operator()(const std::string& name, const derive::inverse::Step& step = {}) const;
  /// Variables within a sentence, typeset.
  [[nodiscard]] std::string sentence(std::string text) const;

 private:
  [[nodiscard]] std::string variable(const std::string& name) const;
  [[nodiscard]] std::string function(const std::string& name, const std::string& of, bool half) const;
  [[nodiscard]] std::string symbol(const std::string& letters, const std::string& index) const;
  [[nodiscard]] std::string solved(const std::string& name, const derive::inverse::Step& step) const;
  [[nodiscard]] std::string part_of_pose(const std::string& name) const;
  [[nodiscard]] std::string without_joints(const std::string& name) const;
  [[nodiscard]] std::string other(const std::string& name) const;

  std::vector<std::string> variables_;
  std::vector<std::string>
      planes_;  ///< variables with plane coordinates, base first: the first is N's, the other M's
  bool latex_;
  Notation notation_;
};

}  // namespace qvgen::emit
