// SPDX-License-Identifier: MIT
#include "derive/jacobian/circle_polynomial.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "exact/hash.h"

namespace qvgen::derive {

using GiNaC::ex;
using GiNaC::pow;

namespace {

/// Terms of an expanded sum.
std::vector<ex> terms(const ex& sum) {
  if (!GiNaC::is_a<GiNaC::add>(sum)) return {sum};
  return {sum.begin(), sum.end()};
}

bool even(const std::vector<int>& degrees) {
  return std::all_of(degrees.begin(), degrees.end(), [](int d) { return d % 2 == 0; });
}

/// By name.
std::vector<ex> symbols_of(const ex& form) {
  std::map<std::string, ex> symbols;
  for (auto it = form.preorder_begin(); it != form.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::symbol>(*it)) symbols[GiNaC::ex_to<GiNaC::symbol>(*it).get_name()] = *it;
  std::vector<ex> result;
  for (const auto& [name, symbol] : symbols) result.push_back(symbol);
  return result;
}

/// Sign of a linear form's first coefficient by name.
int leading_sign(const ex& form) {
  const std::vector<ex> symbols = symbols_of(form);
  return !symbols.empty() && form.expand().coeff(symbols.front(), 1).info(GiNaC::info_flags::negative) ? -1
                                                                                                       : 1;
}

/// Same parity in each entry.
bool match(const std::vector<int>& a, const std::vector<int>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if ((a[i] + b[i]) % 2 != 0) return false;
  return true;
}

}  // namespace

/// The longest of the robots in generator/robots has 31 terms in tangents, five-joint arms have about a
/// hundred; a thousand take ten seconds to factor.
constexpr std::size_t most_terms_of_product = 5'000;
constexpr std::size_t most_terms_to_factor = 300;

void CirclePolynomials::check_product(const ex& a, const ex& b) {
  const auto count = [](const ex& e) { return e.is_zero() ? std::size_t{0} : terms(e).size(); };
  if (count(a) * count(b) > most_terms_of_product) throw TooManyTerms();
}

std::size_t CirclePolynomials::circle_of(const ex& angle) {
  for (std::size_t i = 0; i < circles_.size(); ++i)
    if (circles_[i].angle.is_equal(angle)) return i;
  // No symbol of a description has such a name.
  const std::string index = std::to_string(circles_.size());
  circles_.push_back({angle, GiNaC::symbol("sine " + index), GiNaC::symbol("cosine " + index),
                      GiNaC::symbol("tangent " + index)});
  return circles_.size() - 1;
}

/// Cosine and sine of a linear form, by the addition theorems: circles of single joints are independent.
std::pair<ex, ex> CirclePolynomials::cosine_sine(const ex& form) {
  ex constant = form.expand();
  std::pair<ex, ex> turn{1, 0};
  for (const ex& symbol : symbols_of(form)) {
    const int count = GiNaC::ex_to<GiNaC::numeric>(constant.coeff(symbol, 1)).to_int();
    constant = constant.coeff(symbol, 0);
    const Circle circle = circles_[circle_of(symbol)];
    const ex sine = count < 0 ? -ex(circle.sine) : ex(circle.sine);
    for (int i = 0; i < std::abs(count); ++i)
      turn = {turn.first * circle.cosine - turn.second * sine,
              turn.second * circle.cosine + turn.first * sine};
  }
  const ex c = GiNaC::cos(constant);
  const ex s = GiNaC::sin(constant);
  return {turn.first * c - turn.second * s, turn.second * c + turn.first * s};
}

ex CirclePolynomials::polynomial(const ex& expression) {
  GiNaC::exmap replacements;
  for (auto it = expression.preorder_begin(); it != expression.preorder_end(); ++it) {
    const bool sine = GiNaC::is_the_function<GiNaC::sin_SERIAL>(*it);
    if (!sine && !GiNaC::is_the_function<GiNaC::cos_SERIAL>(*it)) continue;
    const auto [c, s] = cosine_sine(it->op(0));
    replacements[*it] = sine ? s : c;
  }
  return reduced(expression.subs(replacements, GiNaC::subs_options::no_pattern));
}

ex CirclePolynomials::reduced(const ex& polynomial) const {
  ex result = polynomial.expand();
  for (const Circle& circle : circles_) {
    const ex square = 1 - pow(circle.cosine, 2);
    ex sum = 0;
    for (int k = 0; k <= result.degree(circle.sine); ++k)
      sum += result.coeff(circle.sine, k) * pow(square, k / 2) * pow(circle.sine, k % 2);
    result = sum.expand();
  }
  return result;
}

int CirclePolynomials::degree(const ex& polynomial, const Circle& circle) const {
  int highest = 0;
  for (const ex& term : terms(polynomial))
    highest = std::max(highest, term.degree(circle.sine) + term.degree(circle.cosine));
  return highest;
}

/// sin x = 2 t / (1 + t^2), cos x = (1 - t^2) / (1 + t^2), multiplied by (1 + t^2)^degree.
ex CirclePolynomials::in_tangents(const ex& polynomial, std::vector<int>& degrees) const {
  ex result = polynomial;
  for (const Circle& circle : circles_) {
    const int all = degree(result, circle);
    const ex t = circle.tangent;
    ex sum = 0;
    for (const ex& term : terms(result)) {
      const int s = term.degree(circle.sine);
      const int c = term.degree(circle.cosine);
      sum += term.coeff(circle.sine, s).coeff(circle.cosine, c) * pow(2 * t, s) * pow(1 - t * t, c) *
             pow(1 + t * t, all - s - c);
    }
    result = sum.expand();
    if (terms(result).size() > most_terms_of_product) throw TooManyTerms();
    degrees.push_back(2 * all);
  }
  return result;
}

CirclePolynomials::Half CirclePolynomials::join(const Half& a, const Half& b) const {
  Half result{a.value * b.value, a.degrees};
  for (std::size_t i = 0; i < result.degrees.size(); ++i) result.degrees[i] += b.degrees[i];
  return result;
}

/// A number that tells factors apart up to sign and is the same in every run, whatever order GiNaC's terms
/// have.
ex CirclePolynomials::key(const Half& half) const {
  GiNaC::exmap values;
  const auto number = [](const ex& symbol) {
    const auto hash = exact::hash(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name());
    return GiNaC::numeric(static_cast<long>(hash % 9973) + 2, 997);
  };
  for (const Circle& circle : circles_) values[circle.tangent] = number(circle.angle);
  for (const ex& symbol : symbols_of(half.value)) values.emplace(symbol, number(symbol));
  return GiNaC::abs(half.value.subs(values, GiNaC::subs_options::no_pattern).expand());
}

/// Joins factors of odd degree: with that of the same parity that gives the shortest result, else with any.
std::vector<CirclePolynomials::Half> CirclePolynomials::joined(std::vector<Half> factors) const {
  std::stable_sort(factors.begin(), factors.end(), [this](const Half& a, const Half& b) {
    return std::pair(a.degrees.size(), GiNaC::ex_to<GiNaC::numeric>(key(a)).to_double()) <
           std::pair(b.degrees.size(), GiNaC::ex_to<GiNaC::numeric>(key(b)).to_double());
  });
  std::vector<Half> result;
  while (!factors.empty()) {
    const Half first = factors.front();
    factors.erase(factors.begin());
    if (even(first.degrees)) {
      result.push_back(first);
      continue;
    }
    auto partner = factors.end();
    std::size_t shortest = 0;
    for (auto other = factors.begin(); other != factors.end(); ++other) {
      if (even(other->degrees) || !match(first.degrees, other->degrees)) continue;
      const std::size_t length = terms(written(in_full_angles(join(first, *other)))).size();
      if (partner != factors.end() && length >= shortest) continue;
      partner = other;
      shortest = length;
    }
    if (partner == factors.end())
      partner = std::find_if(factors.begin(), factors.end(),
                             [&](const Half& other) { return !even(other.degrees); });
    if (partner == factors.end()) throw std::logic_error("a trigonometric polynomial of odd degree");
    const Half both = join(first, *partner);
    factors.erase(partner);
    factors.insert(factors.begin(), both);
  }
  return result;
}

/// With S = sin(x/2), C = cos(x/2): S^2 = (1 - cos x)/2, S C = sin x / 2, C^2 = (1 + cos x)/2.
ex CirclePolynomials::in_full_angles(const Half& half) const {
  ex result = half.value.expand();
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    const Circle& circle = circles_[i];
    ex sum = 0;
    for (int k = 0; k <= result.degree(circle.tangent); ++k) {
      const int odd = k % 2;
      sum += result.coeff(circle.tangent, k) * pow(circle.sine, odd) * pow(1 - circle.cosine, k / 2) *
             pow(1 + circle.cosine, (half.degrees[i] - k - odd) / 2);
    }
    result = sum.expand();
  }
  return reduced(result);
}

/// Products of sines and cosines as sums of sines and cosines of sums: by way of exponentials e^(i k x), the
/// coefficients' real and imaginary parts apart.
ex CirclePolynomials::as_sums_of_angles(const ex& polynomial) const {
  using Wave = std::vector<int>;
  std::map<Wave, std::pair<ex, ex>> sum;
  for (const ex& term : terms(polynomial)) {
    ex coefficient = term;
    std::map<Wave, std::pair<ex, ex>> waves;
    for (const Circle& circle : circles_) {
      coefficient = coefficient.coeff(circle.sine, coefficient.degree(circle.sine));
      coefficient = coefficient.coeff(circle.cosine, coefficient.degree(circle.cosine));
    }
    waves[Wave(circles_.size(), 0)] = {coefficient, 0};
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      const int sines = term.degree(circles_[i].sine);
      for (int k = 0; k < sines + term.degree(circles_[i].cosine); ++k) {
        std::map<Wave, std::pair<ex, ex>> next;
        for (const auto& [wave, value] : waves)
          for (const int sign : {1, -1}) {
            Wave moved = wave;
            moved[i] += sign;
            auto& [re, im] = next[moved];
            // sin x = -i/2 e^(ix) + i/2 e^(-ix), cos x = 1/2 e^(ix) + 1/2 e^(-ix)
            re += (k < sines ? sign * value.second : value.first) / 2;
            im += (k < sines ? -sign * value.first : value.second) / 2;
          }
        waves = std::move(next);
      }
    }
    for (const auto& [wave, value] : waves) {
      sum[wave].first += value.first;
      sum[wave].second += value.second;
    }
  }
  ex result = 0;
  for (const auto& [wave, value] : sum) {
    ex angle = 0;
    for (std::size_t i = 0; i < circles_.size(); ++i) angle += wave[i] * circles_[i].angle;
    const int sign = leading_sign(angle);
    result += value.first.expand() * GiNaC::cos(sign * angle) -
              sign * value.second.expand() * GiNaC::sin(sign * angle);
  }
  return result.expand();
}

/// The shorter of sums of products and sums of angles, in sines and cosines.
ex CirclePolynomials::written(const ex& polynomial) const {
  GiNaC::exmap functions;
  for (const Circle& circle : circles_) {
    functions[circle.sine] = GiNaC::sin(circle.angle);
    functions[circle.cosine] = GiNaC::cos(circle.angle);
  }
  const ex products = polynomial.subs(functions, GiNaC::subs_options::no_pattern);
  const ex sums = as_sums_of_angles(polynomial);
  const auto length = [](const ex& e) {
    std::size_t nodes = 0;
    for (auto it = e.preorder_begin(); it != e.preorder_end(); ++it)
      nodes += GiNaC::is_a<GiNaC::function>(*it) ? 1 : 0;
    return std::pair(terms(e).size(), nodes);
  };
  return length(sums) <= length(products) ? sums : products;
}

ex CirclePolynomials::written_out(const ex& expression) { return written(polynomial(expression)); }

/// In half-angle tangents; what their degrees lack are factors cos(x/2), which must divide too.
bool CirclePolynomials::divides(const ex& factor, const ex& multiple) {
  const ex divisor = polynomial(factor);
  const ex dividend = polynomial(multiple);
  if (dividend.is_zero()) return true;
  std::vector<int> divisor_degrees;
  std::vector<int> degrees;
  const ex divisor_in_tangents = in_tangents(divisor, divisor_degrees);
  const ex in_all_tangents = in_tangents(dividend, degrees);
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const ex t = circles_[k].tangent;
    if (degrees[k] - in_all_tangents.degree(t) < divisor_degrees[k] - divisor_in_tangents.degree(t))
      return false;
  }
  ex quotient;
  return GiNaC::divide(in_all_tangents, divisor_in_tangents, quotient);
}

namespace {

/// The largest numeric coefficient's size.
ex largest_coefficient(const ex& polynomial) {
  ex largest = 0;
  for (const ex& term : terms(polynomial)) {
    ex coefficient = 1;
    if (GiNaC::is_a<GiNaC::numeric>(term))
      coefficient = term;
    else if (GiNaC::is_a<GiNaC::mul>(term))
      for (const ex& factor : term)
        if (GiNaC::is_a<GiNaC::numeric>(factor)) coefficient = factor;
    const ex size = GiNaC::abs(coefficient);
    if (GiNaC::ex_to<GiNaC::numeric>(size) > GiNaC::ex_to<GiNaC::numeric>(largest)) largest = size;
  }
  return largest;
}

}  // namespace

CirclePolynomials::Product CirclePolynomials::factored(const ex& polynomial,
                                                       const std::vector<ex>& variables) const {
  std::vector<int> degrees;
  const ex tangents = in_tangents(polynomial, degrees);
  if (terms(tangents).size() > most_terms_to_factor) throw TooManyTerms();
  Product product;
  const ex factors = GiNaC::factor(tangents, GiNaC::factor_options::all);
  for (const Half& half : joined(split(factors, degrees, product.constant, variables))) {
    const ex written_out = written(in_full_angles(half));
    const ex size = largest_coefficient(written_out.expand());
    const ex value = (written_out / size).expand();
    // Each S^2, S C or C^2 was written without its 1/2.
    int pairs = 0;
    for (const int d : half.degrees) pairs += d / 2;
    product.constant *= size / pow(2, pairs);
    const auto same = std::find_if(product.factors.begin(), product.factors.end(), [&](const Factor& known) {
      return (known.value - value).expand().is_zero();
    });
    if (same != product.factors.end())
      ++same->multiplicity;
    else
      product.factors.push_back({value, 1});
  }
  return product;
}

}  // namespace qvgen::derive
