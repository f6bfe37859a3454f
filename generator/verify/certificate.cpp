// SPDX-License-Identifier: MIT
#include "verify/certificate.h"

#include "dag/evaluate.h"
#include "symbolic/evaluate.h"

namespace qvgen::verify {

void certify(const dag::Function& function, const symbolic::Program& definition, int points,
             const std::string& what) {
  for (int k = 0; k < points; ++k) {
    const exact::ExactPoint point(static_cast<std::uint64_t>(k) + 1);
    const std::vector<exact::Number> expected = symbolic::evaluate(definition, point);
    const std::vector<exact::Number> values = dag::evaluate<exact::Number>(function, point);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const std::string& name = definition.outputs()[i].name;
      if (function.outputs.at(i).name != name)
        throw CertificateError(what + ": outputs are not those of the definition");
      if (!exact::agree(values[i], expected[i]))
        throw CertificateError(what + ": output " + name + " differs from its definition");
    }
  }
}

}  // namespace qvgen::verify
