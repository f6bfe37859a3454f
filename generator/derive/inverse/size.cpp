// SPDX-License-Identifier: MIT
#include "derive/inverse/size.h"

namespace qvgen::derive::inverse {
namespace {

std::size_t nodes(const symbolic::Program& program) {
  std::size_t sum = 0;
  for (const auto& step : program.steps()) sum += inverse::nodes(step.value);
  for (const auto& output : program.outputs()) sum += inverse::nodes(output.value);
  return sum;
}

}  // namespace

std::size_t nodes(const GiNaC::ex& value) {
  std::size_t sum = 1;
  for (std::size_t i = 0; i < value.nops(); ++i) sum += nodes(value.op(i));
  return sum;
}

std::size_t nodes(const Plan& plan) {
  std::size_t sum = nodes(plan.target);
  for (const Step& step : plan.steps) sum += nodes(step.before) + nodes(step.after);
  return sum;
}

}  // namespace qvgen::derive::inverse
