// SPDX-License-Identifier: MIT
// Numbers of a description in the two scalars of this stage: doubles, and a prime field in which every sine,
// cosine and root that arms have is exact. What holds in the field for random joint values holds for almost
// all real ones.
#pragma once

#include <cmath>
#include <string>

#include "model/evaluate.h"
#include "passes/search/fingerprint.h"

namespace qvgen::calibrate {

using Field = passes::search_detail::Field;

template <class S>
struct CosSin {
  S cosine, sine;
};

/// Values of expressions as doubles.
class DoubleValues {
 public:
  using Scalar = double;
  explicit DoubleValues(const model::Robot& robot) : bindings_(model::default_bindings(robot)) {}
  [[nodiscard]] double one() const { return 1; }
  [[nodiscard]] double number(const model::Expression& e) const {
    return model::to_double(model::evaluate(e, bindings_));
  }
  [[nodiscard]] CosSin<double> circular(const model::Expression& angle) const {
    const double value = number(angle);
    return {std::cos(value), std::sin(value)};
  }

 private:
  model::Bindings bindings_;
};

/// Values of expressions in the field. Transcendental constants get random values,
/// equal for equal text: relations between them may be missed, never invented.
class FieldValues {
 public:
  using Scalar = Field;
  explicit FieldValues(const model::Robot& robot);
  [[nodiscard]] Field one() const { return Field::from(1); }
  [[nodiscard]] Field number(const model::Expression& e);
  [[nodiscard]] CosSin<Field> circular(const model::Expression& angle);

 private:
  [[nodiscard]] Field root(const model::Expression& e);
  [[nodiscard]] Field symbol(const std::string& name);

  std::map<std::string, model::Expression> defaults_;
  passes::search_detail::Fingerprint point_;
};

}  // namespace qvgen::calibrate
