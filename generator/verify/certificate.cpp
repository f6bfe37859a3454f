// SPDX-License-Identifier: MIT
#include "verify/certificate.h"

#include "dag/evaluate.h"
#include "symbolic/evaluate.h"
#include "verify/some_given.h"

namespace qvgen::verify {

using exact::Number;

void certify(const dag::Function& function, const dag::Function& constants, const Residuals& residuals,
             const std::set<std::string>& whole, int points, const std::string& what) {
  for (int k = 0; k < points; ++k) {
    const exact::ExactPoint point(static_cast<std::uint64_t>(k) + 1, whole);
    SomeGiven leaves{point, {}};
    const auto values = dag::evaluate<Number>(constants, point);
    for (std::size_t i = 0; i < values.size(); ++i) leaves.given[constants.outputs[i].name] = values[i];
    const auto rest = residuals(point, dag::evaluate<Number>(function, leaves));
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (!exact::agree(rest[i], 0))
        throw CertificateError(what + ": output " + function.outputs.at(i).name +
                               " differs from its definition");
  }
}

Residuals residuals_of(const symbolic::Program& definition) {
  return [definition](const exact::ExactPoint& point, std::vector<Number> values) {
    const std::vector<Number> expected = symbolic::evaluate(definition, point);
    values.resize(expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) values[i] = values[i] - expected[i];
    return values;
  };
}

void certify(const dag::Function& function, const symbolic::Program& definition, int points,
             const std::string& what) {
  const auto& outputs = definition.outputs();
  for (std::size_t i = 0; i < outputs.size(); ++i)
    if (function.outputs.at(i).name != outputs[i].name)
      throw CertificateError(what + ": outputs are not those of the definition");
  certify(function, {}, residuals_of(definition), {}, points, what);
}

}  // namespace qvgen::verify
