// SPDX-License-Identifier: MIT
#include "derive/inverse/scope.h"

#include <cmath>

#include <cln/cln.h>

#include "derive/inverse/names.h"
#include "exact/named_constant.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using GiNaC::numeric;
using symbolic::Quaternion;
using symbolic::Vector;

namespace {

/// GiNaC's number of digits is a global of the process: set while a Scope computes, and put back.
class Digits {
 public:
  Digits() : before_(GiNaC::Digits) { GiNaC::Digits = 60; }
  ~Digits() { GiNaC::Digits = before_; }
  Digits(const Digits&) = delete;
  Digits& operator=(const Digits&) = delete;

 private:
  long before_;
};

/// Most terms of an expression that is multiplied out: for longer ones it gains nothing and takes ages.
constexpr double most_terms = 2'000;

/// An upper bound on the terms of an expression when multiplied out.
double expanded_terms(const ex& value) {
  if (GiNaC::is_a<GiNaC::add>(value)) {
    double sum = 0;
    for (const ex& term : value) sum += expanded_terms(term);
    return sum;
  }
  if (GiNaC::is_a<GiNaC::mul>(value)) {
    double product = 1;
    for (const ex& factor : value) product *= expanded_terms(factor);
    return product;
  }
  if (GiNaC::is_a<GiNaC::power>(value) && value.op(1).info(GiNaC::info_flags::posint))
    return std::pow(expanded_terms(value.op(0)), GiNaC::ex_to<numeric>(value.op(1)).to_double());
  return 1;
}

ex value_at(const ex& value, const SamplePoint& point) {
  const auto known = point.value(value);
  return known ? ex(*known).evalf() : value;
}

}  // namespace

Scope::Scope(const model::Robot& robot, const std::string& held) {
  for (const auto& parameter : robot.geometry) length(parameter.name);
  for (const std::string& name : model::symbols(robot)) {
    const auto value = exact::named_value(name);
    if (value) add(name, {numeric(*value), numeric(*value), numeric(*value)});
  }
  for (const auto& [name, definition] : robot.definitions) {
    std::array<ex, points> values;
    const Digits digits;
    for (std::size_t i = 0; i < points; ++i)
      values[i] = value_at(symbolic::to_symbolic(definition), samples_[i]);
    add(name, values);
  }
  if (held.empty()) return;
  held_.emplace(held);
  const Digits digits;
  for (SamplePoint& sample : samples_) {
    const ex cosine = value_at(held_->cosine_value, sample), sine = value_at(held_->sine_value, sample);
    sample.set(held_->cosine, cosine);
    sample.set(held_->sine, sine);
  }
}

numeric Scope::random() {
  state_ ^= state_ << 13;
  state_ ^= state_ >> 7;
  state_ ^= state_ << 17;
  return numeric(static_cast<long>(state_ % 9973) + 1000, 7919);
}

ex Scope::add(const std::string& name, const std::array<ex, points>& values) {
  const GiNaC::symbol symbol = symbolic::symbol(name);
  for (std::size_t i = 0; i < points; ++i) samples_[i].set(symbol, values[i]);
  return symbol;
}

ex Scope::length(const std::string& name) {
  std::array<ex, points> values;
  for (ex& value : values) value = random();
  return add(name, values);
}

Vector Scope::vector(const std::string& prefix) {
  return {length(prefix + "_x"), length(prefix + "_y"), length(prefix + "_z")};
}

Scope::Turn Scope::turn(const std::string& name) {
  std::array<ex, points> cosines;
  std::array<ex, points> sines;
  for (std::size_t i = 0; i < points; ++i) {
    const ex t = random();
    cosines[i] = (1 - t * t) / (1 + t * t);
    sines[i] = 2 * t / (1 + t * t);
  }
  const ex cosine = add(names::cosine(name), cosines);
  return {cosine, add(names::sine(name), sines)};
}

Quaternion Scope::quaternion(const std::string& prefix) {
  std::array<std::array<ex, points>, 4> values;
  for (std::size_t i = 0; i < points; ++i) {
    // The square of any rational quaternion, divided by its length, is a rational unit quaternion.
    const Quaternion q{random(), -random(), random(), random()};
    const Quaternion square = q * q;
    const ex length = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    values[0][i] = square.w / length;
    values[1][i] = square.x / length;
    values[2][i] = square.y / length;
    values[3][i] = square.z / length;
  }
  return {add(prefix + "_w", values[0]), add(prefix + "_x", values[1]), add(prefix + "_y", values[2]),
          add(prefix + "_z", values[3])};
}

Quaternion Scope::unscaled(const std::string& prefix, const std::string& scale, const Quaternion& unit) {
  const auto same = [&](const std::string& part, const ex& value) {
    std::array<ex, points> values;
    for (std::size_t i = 0; i < points; ++i) values[i] = samples_[i].at(value);
    return add(prefix + part, values);
  };
  add(scale, {1, 1, 1});
  return {same("_w", unit.w), same("_x", unit.x), same("_y", unit.y), same("_z", unit.z)};
}

bool Scope::is_zero(const ex& value) const {
  if (value.is_zero()) return true;
  if (GiNaC::is_a<numeric>(value)) return false;
  const Digits digits;
  for (const SamplePoint& point : samples_) {
    const ex number = value_at(value, point);
    if (!GiNaC::is_a<numeric>(number)) return false;
    if (GiNaC::abs(GiNaC::ex_to<numeric>(number)) > GiNaC::pow(numeric(10), numeric(-45))) return false;
  }
  return true;
}

ex Scope::clean(const ex& value) const {
  if (is_zero(value)) return 0;
  if (expanded_terms(value) > most_terms) return value;
  return held_ ? held_->in_whole_angle(value.expand()) : value.expand();
}

bool Scope::is_number(const ex& value) {
  if (GiNaC::is_a<GiNaC::symbol>(value)) return false;
  for (std::size_t i = 0; i < value.nops(); ++i)
    if (!is_number(value.op(i))) return false;
  return true;
}

bool Scope::is_known(const ex& value) const {
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    const std::string& name = GiNaC::ex_to<GiNaC::symbol>(value).get_name();
    return known_.count(name) != 0 || exact::named_value(name).has_value();
  }
  for (std::size_t i = 0; i < value.nops(); ++i)
    if (!is_known(value.op(i))) return false;
  return true;
}

numeric Scope::value(const ex& value) const {
  const Digits digits;
  return GiNaC::ex_to<numeric>(value_at(value, samples_[0]));
}

double Scope::sample(const ex& value) const { return this->value(value).to_double(); }

ex Scope::settled(const ex& value) const {
  const ex cleaned = clean(value);
  if (is_number(cleaned)) return cleaned;
  const cln::cl_N sample = this->value(cleaned).to_cl_N();
  // To fewer digits than were computed: what rounding has left is not to be made good.
  const cln::cl_R rounded = cln::cl_float(cln::realpart(sample), cln::float_format(40));
  const cln::cl_RA simplest = cln::rationalize(rounded);
  const bool is_short = cln::denominator(simplest) < cln::cl_I(1000000000);
  return is_short && is_zero(cleaned - numeric(simplest)) ? ex(numeric(simplest)) : cleaned;
}

ex Scope::define(symbolic::Program& program, const std::string& name, const ex& value) {
  if (is_number(value) || GiNaC::is_a<GiNaC::symbol>(value) || GiNaC::is_a<GiNaC::symbol>(-value))
    return value;
  return rename(program, name, value);
}

ex Scope::rename(symbolic::Program& program, const std::string& name, const ex& value) {
  program.output(symbolic::symbol(name), value);
  if (is_known(value)) known_.insert(name);
  std::array<ex, points> values;
  {
    const Digits digits;
    for (std::size_t i = 0; i < points; ++i) values[i] = value_at(value, samples_[i]);
  }
  return add(name, values);
}

Vector Scope::define(symbolic::Program& program, const std::string& name, const Vector& v) {
  return {define(program, name + "_x", v.x), define(program, name + "_y", v.y),
          define(program, name + "_z", v.z)};
}

Quaternion Scope::define(symbolic::Program& program, const std::string& name, const Quaternion& q) {
  return {define(program, name + "_w", q.w), define(program, name + "_x", q.x),
          define(program, name + "_y", q.y), define(program, name + "_z", q.z)};
}

}  // namespace qvgen::derive::inverse
