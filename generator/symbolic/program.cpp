// SPDX-License-Identifier: MIT
#include "symbolic/program.h"

namespace qvgen::symbolic {

using GiNaC::ex;

namespace {

bool is_atom(const ex& value) {
  return GiNaC::is_a<GiNaC::numeric>(value) || GiNaC::is_a<GiNaC::symbol>(value) ||
         GiNaC::is_a<GiNaC::symbol>(-value);
}

}  // namespace

ex Program::let(const ex& value) {
  if (is_atom(value)) return value;
  const GiNaC::symbol name("v" + std::to_string(steps_.size()));
  steps_.push_back({name, value});
  return name;
}

Quaternion Program::let(const Quaternion& value) {
  return {let(value.w), let(value.x), let(value.y), let(value.z)};
}

Vector Program::let(const Vector& value) { return {let(value.x), let(value.y), let(value.z)}; }

void Program::output(const std::string& name, const ex& value) { outputs_.push_back({name, value}); }

void Program::output(const GiNaC::symbol& name, const ex& value) {
  steps_.push_back({name, value});
  outputs_.push_back({name.get_name(), name});
}

std::vector<Program::Output> Program::expanded() const {
  GiNaC::exmap values;
  for (const Step& step : steps_)
    values[step.name] = step.value.subs(values, GiNaC::subs_options::no_pattern);
  std::vector<Output> result;
  for (const Output& output : outputs_)
    result.push_back({output.name, output.value.subs(values, GiNaC::subs_options::no_pattern)});
  return result;
}

}  // namespace qvgen::symbolic
