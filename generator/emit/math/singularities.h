// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/form.h"
#include "derive/jacobian/singularities.h"
#include "emit/math/notation.h"

namespace qvgen::emit {

/// Quantities that vanish at an arm's singular configurations, in a fixed order, with signs that no run of
/// GiNaC changes.
struct SingularityMeasures {
  std::vector<std::string>
      names;  ///< shoulder, elbow, workspace boundary, inner boundary, wrist; determinant
  std::vector<int> multiplicities;  ///< in the determinant
  std::vector<int> rows;            ///< of the Jacobian, whose determinant it is
  bool decoupled = false;
  std::string constant;  ///< determinant = constant * product of the measures' powers; text
  /// Outputs m1, m2, ...
  derive::Quantity quantity;
};

/// Certified: the product of the factors is the determinant of the plain Jacobian, exactly. Nothing for arms
/// with more than six joints; for arms whose determinant is not factored the determinant itself.
SingularityMeasures singularity_measures(const model::Robot& robot);

/// The factored determinant for people.
struct SingularityFormulas {
  std::string none;  ///< why there are no factors
  std::vector<std::string> legend = {};
  std::string determinant = {};  ///< of what, in words
  std::string product = {};
  struct Factor {
    std::string kind;  ///< "elbow", ...; numbered if there are several of a kind
    std::string name;
    std::string value;
    std::string meaning;  ///< what happens where it vanishes
  };
  std::vector<Factor> factors = {};
};
SingularityFormulas singularity_formulas(const model::Robot& described, Notation notation);

/// For `qvgen show ROBOT --singularities`: one line a factor.
std::vector<std::string> singularity_lines(const model::Robot& described, Notation notation);

}  // namespace qvgen::emit
