// SPDX-License-Identifier: MIT
#include "symbolic/program.h"

namespace qvgen::symbolic {

using GiNaC::ex;

namespace {

bool is_atom(const ex& value) {
  return GiNaC::is_a<GiNaC::numeric>(value) || GiNaC::is_a<GiNaC::symbol>(value) ||
         GiNaC::is_a<GiNaC::symbol>(-value);
}

void add_names(const ex& value, const std::set<std::string>& except, std::set<std::string>& names) {
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(value).get_name();
    if (except.count(name) == 0) names.insert(name);
  }
  for (std::size_t i = 0; i < value.nops(); ++i) add_names(value.op(i), except, names);
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

Matrix3 Program::let(const Matrix3& value) {
  Matrix3 named;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) named[i][j] = let(value[i][j]);
  return named;
}

void Program::output(const std::string& name, const ex& value) { outputs_.push_back({name, value}); }

void Program::output(const GiNaC::symbol& name, const ex& value) {
  steps_.push_back({name, value});
  outputs_.push_back({name.get_name(), name});
}

const std::set<std::string>& Program::reads() const {
  for (; read_.steps < steps_.size(); ++read_.steps) {
    const Step& step = steps_[read_.steps];
    add_names(step.value, read_.own, read_.names);
    read_.own.insert(step.name.get_name());
    read_.names.erase(step.name.get_name());
  }
  for (; read_.outputs < outputs_.size(); ++read_.outputs)
    add_names(outputs_[read_.outputs].value, read_.own, read_.names);
  return read_.names;
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
