// SPDX-License-Identifier: MIT
#include "derive/loops/hoist.h"

#include <algorithm>
#include <map>
#include <string>

#include "derive/inverse/names.h"

namespace qvgen::derive::loops {
namespace {

using inverse::Plan;
using symbolic::Program;
namespace names = inverse::names;

bool is_output(const Program& program, const std::string& name) {
  return std::any_of(program.outputs().begin(), program.outputs().end(),
                     [&](const Program::Output& output) { return output.name == name; });
}

/// True for the value of a joint, which its own step leaves.
bool is_joint(const Plan& plan, const std::string& name) {
  return std::any_of(plan.joints.begin(), plan.joints.end(), [&](const inverse::JointValue& joint) {
    return joint.cosine == name || joint.sine == name;
  });
}

class Hoist {
 public:
  explicit Hoist(Plan& plan) : plan_(plan) {}

  void run() {
    for (std::size_t i = 0; i < plan_.steps.size(); ++i) move_from(i);
  }

 private:
  /// Places are steps, counted from 1; 0 is the target.
  [[nodiscard]] std::size_t place_of(const GiNaC::ex& value) const {
    if (GiNaC::is_a<GiNaC::symbol>(value)) {
      const auto known = places_.find(GiNaC::ex_to<GiNaC::symbol>(value).get_name());
      return known == places_.end() ? 0 : known->second;
    }
    std::size_t place = 0;
    for (std::size_t i = 0; i < value.nops(); ++i) place = std::max(place, place_of(value.op(i)));
    return place;
  }
  Program& program(std::size_t place) { return place == 0 ? plan_.target : plan_.steps[place - 1].after; }

  void move_from(std::size_t index) {
    const std::size_t own = index + 1;
    for (const char* result :
         {names::cosine_result, names::sine_result, names::result, names::result_1, names::result_2})
      places_[result] = own;
    const Program before = plan_.steps[index].after;
    Program rest;
    for (const Program::Step& each : before.steps()) {
      const std::string& name = each.name.get_name();
      const bool may_move = is_output(before, name) && !is_joint(plan_, name);
      const std::size_t place = may_move ? place_of(each.value) : own;
      places_[name] = place;
      place < own ? program(place).output(each.name, each.value) : rest.append(each);
    }
    for (const Program::Output& output : before.outputs()) {
      const auto known = places_.find(output.name);
      if (known == places_.end() || known->second == own) rest.output(output.name, output.value);
    }
    plan_.steps[index].after = rest;
  }

  Plan& plan_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

void hoist(Plan& plan) { Hoist(plan).run(); }

}  // namespace qvgen::derive::loops
