// SPDX-License-Identifier: MIT
// The irreducible factors of a polynomial in half angles' tangents, one by one.
#include <algorithm>

#include "derive/jacobian/circle_polynomial.h"

namespace qvgen::derive {

using GiNaC::ex;
using GiNaC::pow;

struct CirclePolynomials::Splitting {
  const std::vector<Circle>& circles;
  const std::vector<ex>& variables;
  std::vector<int> degrees;  ///< by circle: what the factors so far lack
  std::vector<Half> factors = {};
  ex constant = 1;

  [[nodiscard]] bool varies(const ex& e) const {
    return std::any_of(circles.begin(), circles.end(), [&](const Circle& c) { return e.has(c.tangent); }) ||
           std::any_of(variables.begin(), variables.end(), [&](const ex& v) { return e.has(v); });
  }
  void add(const ex& base, int times) {
    Half half{base, {}};
    for (const Circle& circle : circles) half.degrees.push_back(base.expand().degree(circle.tangent));
    for (int i = 0; i < times; ++i) {
      for (std::size_t k = 0; k < degrees.size(); ++k) degrees[k] -= half.degrees[k];
      factors.push_back(half);
    }
  }
  /// Adds powers of a symbol that GiNaC leaves inside other factors by themselves.
  void add_power(ex base, int times) {
    base = base.expand();
    std::vector<ex> symbols = variables;
    for (const Circle& circle : circles) symbols.push_back(circle.tangent);
    for (const ex& symbol : symbols) {
      const int power = base.ldegree(symbol);
      if (power == 0) continue;
      add(symbol, power * times);
      base = (base / pow(symbol, power)).expand();
    }
    if (varies(base))
      add(base, times);
    else
      constant *= pow(base, times);
  }
  void add_factor(const ex& factor) {
    if (!varies(factor))
      constant *= factor;
    else if (GiNaC::is_a<GiNaC::power>(factor))
      add_power(factor.op(0), GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int());
    else
      add_power(factor, 1);
  }
  /// Adds factors cos(x/2) for what the tangents' degrees lack.
  void add_cosines() {
    for (std::size_t k = 0; k < degrees.size(); ++k)
      for (int i = 0; i < degrees[k]; ++i) {
        Half cosine{1, std::vector<int>(degrees.size(), 0)};
        cosine.degrees[k] = 1;
        factors.push_back(cosine);
      }
  }
};

std::vector<CirclePolynomials::Half> CirclePolynomials::split(const ex& factored,
                                                              const std::vector<int>& degrees, ex& constant,
                                                              const std::vector<ex>& variables) const {
  Splitting parts{circles_, variables, degrees};
  if (GiNaC::is_a<GiNaC::mul>(factored))
    for (const ex& factor : factored) parts.add_factor(factor);
  else
    parts.add_factor(factored);
  parts.add_cosines();
  constant *= parts.constant;
  return parts.factors;
}

}  // namespace qvgen::derive
