// SPDX-License-Identifier: MIT
#include "calibrate/chain.h"

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
    const double value = joint.ratio * q[joint.variable];
    posture.values.push_back(value);
    posture.circular.push_back({std::cos(value), std::sin(value)});
  }
  posture.loads = loads_of(geometry, posture, 1.0);
  for (std::size_t i = 0; i < geometry.greatest_loads.size() && i < posture.loads.size(); ++i)
    posture.loads[i] *= geometry.greatest_loads[i] > 0 ? standard_gravity / geometry.greatest_loads[i] : 0;
  return posture;
}

Posture<Field> random_posture(const Geometry<Field>& geometry, std::uint64_t seed) {
  const passes::search_detail::Fingerprint point(seed);
  Posture<Field> posture;
  for (const JointForm& joint : geometry.joints) {
    exact::Angle angle;
    const std::string name = "q" + std::to_string(joint.variable);
    angle.terms[name] = joint.exact_ratio;
    const auto value = point.circular(angle);
    exact::Number ratio(joint.exact_ratio);
    posture.values.push_back(passes::search_detail::Fingerprint(seed).number(ratio) * point.symbol(name));
    posture.circular.push_back({value.cosine, value.sine});
  }
  posture.loads = loads_of(geometry, posture, Field::from(1));
  return posture;
}

}  // namespace qvgen::calibrate
