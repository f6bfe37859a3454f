// SPDX-License-Identifier: MIT
#include "calibrate/chain.h"

#include <cln/integer.h>
#include <cln/rational.h>

#include "calibrate/load.h"

namespace qvgen::calibrate {

std::vector<std::vector<std::size_t>> by_gap(const std::vector<Parameter>& parameters, std::size_t gaps) {
  std::vector<std::vector<std::size_t>> result(gaps + 2);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].kind != Kind::surface) result[parameters[i].gap].push_back(i);
  return result;
}

Prediction<Field> predict(const Model<Field>& model, const Posture<Field>& posture,
                          const Frames<Field>& frames, std::size_t target) {
  const auto none = [](std::size_t, const Parameter&, const Vec<Field>&, Field, const Rigid<Field>& at) {
    return at;
  };
  return Walk(model, posture, frames, Field::from(1), none).to(target);
}

Prediction<double> predict(const Model<double>& model, const Posture<double>& posture,
                           const Frames<double>& frames, std::size_t target,
                           const std::vector<double>& values) {
  const auto move = [&](std::size_t index, const Parameter& each, const Vec<double>& axis, double weight,
                        const Rigid<double>& at) {
    const double amount = values[index] * weight;
    if (amount == 0) return at;
    return at * (each.turn ? turn(axis, std::cos(amount), std::sin(amount), 1.0) : shift(amount * axis, 1.0));
  };
  return Walk(model, posture, frames, 1.0, move).to(target);
}

Posture<double> posture_of(const Geometry<double>& geometry, const double* q) {
  Posture<double> posture;
  for (const JointForm& joint : geometry.joints) {
    double value = 0;
    for (const VariableShare& share : joint.shares) value += share.ratio * q[share.variable];
    posture.values.push_back(value);
    posture.circular.push_back({std::cos(value), std::sin(value)});
  }
  posture.loads = loads_of(geometry, posture, 1.0);
  for (std::size_t i = 0; i < geometry.greatest_loads.size() && i < posture.loads.size(); ++i)
    posture.loads[i] *= geometry.greatest_loads[i] > 0 ? standard_gravity / geometry.greatest_loads[i] : 0;
  return posture;
}

namespace {

/// Returns for each variable a number that makes its shares in all joints whole ones.
std::vector<cln::cl_I> denominators(const Geometry<Field>& geometry) {
  std::vector<cln::cl_I> result(geometry.turning.size(), 1);
  for (const JointForm& joint : geometry.joints)
    for (const VariableShare& share : joint.shares)
      result[share.variable] = cln::lcm(result[share.variable], cln::denominator(share.exact_ratio));
  return result;
}

}  // namespace

/// The random values are those of parts of the variables, of which joints have whole multiples: so sines of
/// all joints are exact together.
Posture<Field> random_posture(const Geometry<Field>& geometry, std::uint64_t seed) {
  passes::search_detail::Fingerprint point(seed);
  const std::vector<cln::cl_I> parts = denominators(geometry);
  Posture<Field> posture;
  for (const JointForm& joint : geometry.joints) {
    exact::Angle angle;
    Field value = Field::from(0);
    for (const VariableShare& share : joint.shares) {
      const std::string name = "q" + std::to_string(share.variable);
      const cln::cl_RA whole = share.exact_ratio * parts[share.variable];
      angle.terms[name] = whole;
      value = value + point.number(exact::Number(whole)) * point.symbol(name);
    }
    const auto turned = point.circular(angle);
    posture.values.push_back(value);
    posture.circular.push_back({turned.cosine, turned.sine});
  }
  posture.loads = loads_of(geometry, posture, Field::from(1));
  return posture;
}

}  // namespace qvgen::calibrate
