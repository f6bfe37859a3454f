// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <vector>

#include <ginac/ginac.h>

namespace qvgen::derive {

/// A polynomial would have more terms than there is a budget for. What to factor is bounded by the number of
/// its terms, so that the same arm is factored, or not, on every machine.
class TooManyTerms : public std::runtime_error {
 public:
  TooManyTerms() : std::runtime_error("its polynomial has too many terms") {}
};

/// Factors of a trigonometric polynomial, with no factor left that splits over the rationals.
///
/// Modulo sin^2 + cos^2 = 1 polynomials in sines and cosines have no unique factors; written in the half
/// angles' sines and cosines, homogeneous of even degree in each pair, they have: dividing by the cosines
/// leaves an ordinary polynomial in the half angles' tangents, which is factored. Factors of odd degree in
/// some angle (sin(x/2) of sin x = 2 sin(x/2) cos(x/2)) are joined until all degrees are even again, and
/// written back in full angles.
class CirclePolynomials {
 public:
  struct Factor {
    GiNaC::ex value;
    int multiplicity = 1;
  };
  struct Product {
    GiNaC::ex constant = 1;  ///< of parameters and numbers alone
    std::vector<Factor> factors;
  };

  /// The polynomial of an expression in sines and cosines of linear forms: circular functions replaced,
  /// squares of sines removed, expanded.
  GiNaC::ex polynomial(const GiNaC::ex& expression);
  /// Throws TooManyTerms if the product of two expanded polynomials would go beyond the budget.
  static void check_product(const GiNaC::ex& a, const GiNaC::ex& b);
  /// Removes squares of sines and expands.
  GiNaC::ex reduced(const GiNaC::ex& polynomial) const;
  /// Factors of a reduced polynomial other than 0. `variables`: the prismatic joints' variables, which are no
  /// parameters.
  Product factored(const GiNaC::ex& polynomial, const std::vector<GiNaC::ex>& variables) const;
  /// An expression in sines and cosines of linear forms as the shorter of sums of products and sums of
  /// angles.
  GiNaC::ex written_out(const GiNaC::ex& expression);
  /// True if the second expression is a multiple of the first, and so vanishes wherever the first does.
  bool divides(const GiNaC::ex& factor, const GiNaC::ex& multiple);

 private:
  struct Circle {
    GiNaC::ex angle;
    GiNaC::symbol sine, cosine, tangent;  ///< of the angle, the angle, and half the angle
  };
  /// A polynomial in tangents with its degree in each circle's half-angle pair.
  struct Half {
    GiNaC::ex value;
    std::vector<int> degrees;
  };
  std::size_t circle_of(const GiNaC::ex& angle);
  std::pair<GiNaC::ex, GiNaC::ex> cosine_sine(const GiNaC::ex& form);
  int degree(const GiNaC::ex& polynomial, const Circle& circle) const;
  GiNaC::ex in_tangents(const GiNaC::ex& polynomial, std::vector<int>& degrees) const;
  struct Splitting;
  /// Factors of a product in tangents of these degrees; multiplies the constant by what does not vary.
  std::vector<Half> split(const GiNaC::ex& factored, const std::vector<int>& degrees, GiNaC::ex& constant,
                          const std::vector<GiNaC::ex>& variables) const;
  GiNaC::ex key(const Half& half) const;
  Half join(const Half& a, const Half& b) const;
  std::vector<Half> joined(std::vector<Half> factors) const;
  GiNaC::ex in_full_angles(const Half& half) const;
  GiNaC::ex as_sums_of_angles(const GiNaC::ex& polynomial) const;
  GiNaC::ex written(const GiNaC::ex& polynomial) const;

  std::vector<Circle> circles_;
};

}  // namespace qvgen::derive
