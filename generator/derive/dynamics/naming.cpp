// SPDX-License-Identifier: MIT
#include "derive/dynamics/naming.h"

#include <algorithm>

#include "dag/evaluate.h"
#include "exact/point.h"

namespace qvgen::derive::dynamics {

using exact::Number;

Naming::Naming(dag::Graph source, std::vector<dag::Edge> values, dag::Graph& target) : target_(target) {
  dag::Function all{std::move(source), {}};
  for (const dag::Edge value : values) all.outputs.push_back({"", value});
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] = dag::evaluate<Number>(all, exact::ExactPoint(0x5eed + i));
  constants_.graph = std::move(all.graph);
  edges_ = std::move(values);
}

Scalar Naming::name(std::size_t index) {
  const auto is = [&](const Number& number) {
    return std::all_of(values_.begin(), values_.end(),
                       [&](const auto& point) { return point[index] == number; });
  };
  const Number& value = values_.front()[index];
  if (is(0)) return {};
  if (is(1) || is(-1)) return {target_, target_.constant(value)};
  // The first value met that is no number is positive: which sign the symbols of a description give it says
  // nothing about the arm.
  const bool negative = is(value) ? value.sign() < 0 : known_.contains(key_of(index, true));
  const auto [place, inserted] =
      known_.try_emplace(key_of(index, negative), "$" + std::to_string(known_.size()));
  if (inserted) constants_.outputs.push_back({place->second, negative ? -edges_[index] : edges_[index]});
  const Scalar symbol(target_, target_.symbol(place->second));
  return negative ? -symbol : symbol;
}

std::string Naming::key_of(std::size_t index, bool negative) const {
  std::string key;
  for (const auto& point : values_) key += to_string(negative ? -point[index] : point[index]) + " ";
  return key;
}

}  // namespace qvgen::derive::dynamics
