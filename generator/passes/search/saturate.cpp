// SPDX-License-Identifier: MIT
#include "passes/search/saturate.h"

#include <map>
#include <vector>

namespace qvgen::passes::search_detail {
namespace {

using Definitions = std::vector<ENode>;

Definitions of_kind(const EClass& entry, dag::Op op) {
  Definitions result;
  for (const ENode& d : entry.nodes)
    if (d.op == op) result.push_back(d);
  return result;
}

/// The sum of a product with common factor: left = common * x, right = common * y.
void factor_out(Classes& classes, std::uint32_t common, Ref x, Ref y) {
  if (common != Classes::one) classes.product({common, false}, classes.sum(x, y));
}

void factor_sum(Classes& classes, const ENode& sum) {
  const Definitions left = of_kind(classes[sum.a.id], dag::Op::product);
  const Definitions right = of_kind(classes[sum.b.id], dag::Op::product);
  for (const ENode& l : left)
    for (const ENode& r : right) {
      const bool sign_l = sum.a.negative != l.negative;
      const bool sign_r = sum.b.negative != r.negative;
      for (const auto& [lf, lx] : {std::pair{l.a, l.b}, std::pair{l.b, l.a}})
        for (const auto& [rf, rx] : {std::pair{r.a, r.b}, std::pair{r.b, r.a}})
          if (lf.id == rf.id) factor_out(classes, lf.id, lx.signed_by(sign_l), rx.signed_by(sign_r));
    }
}

/// factor * (free * rest), if the class is such a product.
std::optional<Ref> absorbed(Classes& classes, Ref factor, Ref into) {
  for (const ENode& d : of_kind(classes[into.id], dag::Op::product))
    for (const auto& [free, rest] : {std::pair{d.a, d.b}, std::pair{d.b, d.a}})
      if (classes[free.id].free)
        return classes.product(classes.product(factor, free), rest).signed_by(into.negative != d.negative);
  return std::nullopt;
}

/// Other ways to multiply by a free factor; none unless it meets another one on its way in.
void push_inward(Classes& classes, Ref factor, Ref into) {
  absorbed(classes, factor, into);
  for (const ENode& sum : of_kind(classes[into.id], dag::Op::sum)) {
    const auto left = absorbed(classes, factor, sum.a);
    const auto right = absorbed(classes, factor, sum.b);
    if (!left && !right) continue;
    classes.sum(left ? *left : classes.product(factor, sum.a),
                right ? *right : classes.product(factor, sum.b));
  }
}

struct Circle {
  Ref cosine, sine;
};

/// Defines the sine and cosine of a (+ or -) b if at least one of them is a leaf.
void relate(Classes& classes, const Circle& a, const Circle& b, bool minus) {
  const Field cosine_value = classes.value(a.cosine) * classes.value(b.cosine);
  const Field sine_product = classes.value(a.sine) * classes.value(b.sine);
  const Field cross_1 = classes.value(a.sine) * classes.value(b.cosine);
  const Field cross_2 = classes.value(a.cosine) * classes.value(b.sine);
  const auto cosine = classes.find(minus ? cosine_value + sine_product : cosine_value - sine_product);
  const auto sine = classes.find(minus ? cross_1 - cross_2 : cross_1 + cross_2);
  const auto product_of = [&](Ref x, Ref y) { return classes.product(x, y); };
  if (cosine && classes[cosine->id].leaf)
    classes.sum(product_of(a.cosine, b.cosine), product_of(a.sine, b.sine).signed_by(!minus));
  if (sine && classes[sine->id].leaf)
    classes.sum(product_of(a.sine, b.cosine), product_of(a.cosine, b.sine).signed_by(minus));
}

void relate_double(Classes& classes, const Circle& a) {
  const Field one = Field::from(1);
  const Field square = classes.value(a.sine) * classes.value(a.sine);
  const auto cosine = classes.find(one - square - square);
  if (!cosine || !classes[cosine->id].leaf) return;
  const Ref s2 = classes.product(a.sine, a.sine);
  const Ref c2 = classes.product(a.cosine, a.cosine);
  const Ref unit{Classes::one, false};
  classes.sum(unit, -classes.sum(s2, s2));
  classes.sum(classes.sum(c2, c2), -unit);
  const Ref product = classes.product(a.sine, a.cosine);
  classes.sum(product, product);
}

}  // namespace

void relate_angles(Classes& classes, const AngleTable& angles, const Fingerprint& fingerprint) {
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < angles.angles.size(); ++i) {
    if (angles.free[i]) continue;
    const CosineSine values = fingerprint.circular(angles.angles[i]);
    const auto index = static_cast<std::uint32_t>(i);
    circles.push_back({classes.leaf({dag::Op::cosine, {}, {}, index, false}, values.cosine, false),
                       classes.leaf({dag::Op::sine, {}, {}, index, false}, values.sine, false)});
  }
  for (std::size_t i = 0; i < circles.size(); ++i) {
    relate_double(classes, circles[i]);
    for (std::size_t j = 0; j <= i; ++j) {
      relate(classes, circles[i], circles[j], false);
      if (j < i) relate(classes, circles[i], circles[j], true);
      if (j < i) relate(classes, circles[j], circles[i], true);
    }
  }
}

void factor(Classes& classes, std::uint32_t limit) {
  const std::uint32_t before = classes.size();
  for (std::uint32_t id = 0; id < before && classes.size() < limit; ++id) {
    if (classes[id].free) continue;
    for (const ENode& sum : of_kind(classes[id], dag::Op::sum)) factor_sum(classes, sum);
  }
}

void gather_free_factors(Classes& classes, std::uint32_t limit) {
  const std::uint32_t before = classes.size();
  for (std::uint32_t id = 0; id < before && classes.size() < limit; ++id) {
    if (classes[id].free) continue;
    for (const ENode& product : of_kind(classes[id], dag::Op::product))
      for (const auto& [factor, rest] : {std::pair{product.a, product.b}, std::pair{product.b, product.a}})
        if (classes[factor.id].free && !classes[rest.id].free) push_inward(classes, factor, rest);
  }
}

void share_reciprocals(Classes& classes) {
  std::map<std::uint32_t, std::vector<Ref>> numerators;
  for (std::uint32_t id = 0; id < classes.size(); ++id)
    for (const ENode& d : of_kind(classes[id], dag::Op::quotient)) numerators[d.b.id].push_back(d.a);
  for (const auto& [denominator, users] : numerators) {
    if (users.size() < 2) continue;
    const Ref reciprocal = classes.quotient({Classes::one, false}, {denominator, false});
    for (const Ref numerator : users) classes.product(numerator, reciprocal);
  }
}

namespace {

/// Filter that tells if a value may be one of the classes' or its negative: a bit for each of many
/// remainders, small enough for the processor's cache. Most of the values that the closure asks for are none.
class ValueFilter {
 public:
  explicit ValueFilter(const Classes& classes) {
    std::size_t bits = 1024;
    while (bits < 64 * static_cast<std::size_t>(classes.size())) bits *= 2;
    words_.assign(bits / 64, 0);
    for (std::uint32_t id = 0; id < classes.size(); ++id)
      for (const Field value : {classes[id].value, -classes[id].value})
        words_[word(value)] |= std::uint64_t{1} << (value.bits() % 64);
  }
  [[nodiscard]] bool may_hold(Field value) const {
    return ((words_[word(value)] >> (value.bits() % 64)) & 1U) != 0;
  }

 private:
  /// Values are those of a random point, so any of their bits will do.
  [[nodiscard]] std::size_t word(Field value) const { return (value.bits() / 64) & (words_.size() - 1); }

  std::vector<std::uint64_t> words_;
};

}  // namespace

void close(Classes& classes) {
  const std::uint32_t size = classes.size();
  const ValueFilter filter(classes);
  const auto wanted = [&](Field value) {
    if (!filter.may_hold(value)) return false;
    const auto target = classes.find(value);
    return target && target->id != Classes::zero && !classes[target->id].free;
  };
  std::vector<Field> values;
  for (std::uint32_t id = 0; id < size; ++id) values.push_back(classes[id].value);
  for (std::uint32_t i = 2; i < size; ++i) {
    const Field a = values[i];
    for (std::uint32_t j = i; j < size; ++j) {
      const Field b = values[j];
      if (wanted(a + b)) classes.sum({i, false}, {j, false});
      if (i != j && wanted(a - b)) classes.sum({i, false}, {j, true});
      if (wanted(a * b)) classes.product({i, false}, {j, false});
    }
  }
}

}  // namespace qvgen::passes::search_detail
