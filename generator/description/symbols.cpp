// SPDX-License-Identifier: MIT
#include "description/symbols.h"

#include <algorithm>
#include <map>
#include <set>

#include "description/entries.h"
#include "description/names.h"
#include "description/size_limits.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

/// Whoever has so many mistakes needs no suggestion for each of the others.
constexpr std::size_t max_diagnostics = 200;

struct Default {
  std::string name;
  Place place;
  std::optional<model::Expression> value;
};

std::vector<Default> read_defaults(const Table& root) {
  std::vector<Default> defaults;
  const auto table = root.table("defaults");
  if (!table) return defaults;
  for (const auto& [key, node] : table->node()) {
    const std::string name(key.str());
    const auto entry = read_entry(table->context(), node, {Role::constant}, "the default of '" + name + "'");
    defaults.push_back({name, begin_of(key.source()), {}});
    if (entry && symbols(entry->value).empty()) defaults.back().value = entry->value;
  }
  return defaults;
}

struct Declared {
  std::string name;
  Place place;
};

/// The names in `symbols` and [defaults]; none of both: nullopt, and every name is a symbol.
std::optional<std::vector<Declared>> read_declared(const Table& root, const std::vector<Default>& defaults) {
  if (!root.has("symbols") && !root.has("defaults")) return std::nullopt;
  std::vector<Declared> declared;
  declared.reserve(defaults.size());
  for (const Default& entry : defaults) declared.push_back({entry.name, entry.place});
  const toml::node* node = root.find("symbols");
  if (node == nullptr) return declared;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    report_type(root.context(), *node, "'symbols'", "an array of names");
    return declared;
  }
  for (const toml::node& element : *array) {
    if (const auto name = element.value_exact<std::string>()) {
      declared.push_back({*name, begin_of(element.source())});
    } else {
      report_type(root.context(), element, "an entry of 'symbols'", "a name in quotes");
    }
  }
  return declared;
}

/// The joint or the motor that a variable belongs to.
std::string owner(const Context& context, std::size_t index) {
  const std::size_t joints = context.variables.size() - context.motor_places.size();
  return index < joints ? "joint " + std::to_string(index + 1)
                        : "motor " + std::to_string(index - joints + 1);
}

void check_variables(Context& context) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < context.variables.size(); ++i) {
    const auto& [name, place] = context.variables[i];
    if (name.empty()) continue;
    const auto [known, is_new] = first.emplace(name, i);
    if (is_new) continue;
    context.error(
        place,
        "the variable '" + name + "' is used twice: " + owner(context, known->second) + " has it already",
        context.motor_places.empty() ? "give each joint a variable of its own"
                                     : "give each joint and each motor a variable of its own");
  }
}

/// The name without the number at its end.
std::string stem(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  return last == std::string::npos || last + 1 == name.size() ? "" : name.substr(0, last + 1);
}

/// A row theta = "theta2" without variable = "theta2", among others that have theirs.
void warn_of_forgotten_variables(Context& context) {
  std::set<std::string> stems;
  for (const Variable& variable : context.variables) stems.insert(stem(variable.name));
  for (const Variable& constant : context.constants_in_place_of_variables)
    if (!stem(constant.name).empty() && stems.count(stem(constant.name)) > 0)
      context.warning(
          constant.place,
          "'" + constant.name + "' is a constant here: the row has no variable and does not move",
          "add variable = \"" + constant.name + "\", or declare the constant in [defaults] or 'symbols'");
}

/// Joint number, from 1, of each variable.
std::map<std::string, std::size_t> joints_by_variable(const Context& context) {
  std::map<std::string, std::size_t> joints;
  for (std::size_t i = 0; i < context.variables.size(); ++i) joints.emplace(context.variables[i].name, i + 1);
  return joints;
}

std::string suggestion(const std::string& near, const std::string& otherwise) {
  return near.empty() ? otherwise : "did you mean '" + near + "'?";
}

void check_uses(Context& context, const std::optional<std::vector<Declared>>& declared) {
  std::vector<std::string> known;
  for (const Declared& entry : declared.value_or(std::vector<Declared>{})) known.push_back(entry.name);
  const std::set<std::string> known_names(known.begin(), known.end());
  const auto joints = joints_by_variable(context);
  std::set<std::string> written;
  for (const SymbolUse& use : context.uses) {
    if (!use.automatic) written.insert(use.name);
  }
  for (const SymbolUse& use : context.uses) {
    const std::string quoted = "'" + use.name + "'";
    if (context.diagnostics.size() > max_diagnostics) return;
    if (const auto joint = joints.find(use.name); joint != joints.end()) {
      const std::string variable = quoted + " is the variable of " + owner(context, joint->second - 1);
      if (use.automatic)
        context.error(use.place,
                      variable + ", and the name that free inertias and drives give a constant here",
                      "rename the variable, e.g. 'q" + std::to_string(joint->second) + "'");
      else
        context.error(use.place, variable + ", not a constant", "rename the variable or the symbol");
    } else if (use.role == Role::constant) {
      context.error(use.place, "undefined symbol " + quoted, "only a constant can stand here");
    } else if (use.automatic) {
      if (written.count(use.name) != 0) {
        context.error(use.place, quoted + " is also the name of a free inertial parameter of this joint",
                      "rename the symbol");
      }
    } else if (declared && known_names.count(use.name) == 0) {
      context.error(use.place, "undefined symbol " + quoted,
                    suggestion(nearest(use.name, known), "add it to [defaults] or to 'symbols'"));
    }
  }
}

void check_declared(Context& context, const std::vector<Declared>& declared) {
  std::set<std::string> names;
  for (const SymbolUse& use : context.uses) names.insert(use.name);
  const std::vector<std::string> used(names.begin(), names.end());
  for (const Declared& entry : declared) {
    if (context.diagnostics.size() > max_diagnostics) return;
    if (names.count(entry.name) > 0) continue;
    context.error(entry.place, "the symbol '" + entry.name + "' occurs nowhere in the chain",
                  suggestion(nearest(entry.name, used), "remove it"));
  }
}

void add_parameters(const std::vector<SymbolUse>& uses, const std::vector<Default>& defaults,
                    std::set<std::string>& known, std::vector<model::Parameter>& parameters) {
  for (const SymbolUse& use : uses) {
    if (!known.insert(use.name).second) continue;
    const auto found = std::find_if(defaults.begin(), defaults.end(),
                                    [&](const Default& entry) { return entry.name == use.name; });
    parameters.push_back({use.name, found == defaults.end() ? std::nullopt : found->value});
  }
}

std::vector<SymbolUse> uses_of(const Context& context, Role role) {
  std::vector<SymbolUse> uses;
  std::copy_if(context.uses.begin(), context.uses.end(), std::back_inserter(uses),
               [&](const SymbolUse& use) { return use.role == role; });
  return uses;
}

}  // namespace

void resolve_symbols(const Table& root, model::Robot& robot) {
  Context& context = root.context();
  const std::vector<Default> defaults = read_defaults(root);
  const auto declared = read_declared(root, defaults);
  const bool too_many = declared && declared->size() > max_symbols;
  if (too_many)
    context.error(declared->back().place, std::to_string(declared->size()) + " symbols are too many",
                  "a robot has at most " + std::to_string(max_symbols));
  check_variables(context);
  check_uses(context, declared);
  if (!declared) warn_of_forgotten_variables(context);
  if (declared && !too_many && !context.has_broken_expression) check_declared(context, *declared);

  std::vector<SymbolUse> geometry = uses_of(context, Role::geometry);
  std::stable_sort(geometry.begin(), geometry.end(),
                   [](const SymbolUse& a, const SymbolUse& b) { return a.place < b.place; });
  std::set<std::string> known;
  add_parameters(geometry, defaults, known, robot.geometry);
  add_parameters(uses_of(context, Role::inertia), defaults, known, robot.inertia_parameters);
}

void check_default_values(Context& context, const model::Robot& robot) {
  const model::Bindings bindings = model::default_bindings(robot);
  for (const Entry& entry : context.entries) {
    try {
      model::evaluate(entry.value, bindings);
    } catch (const model::EvaluationError& error) {
      using Reason = model::EvaluationError::Reason;
      if (error.reason == Reason::unbound_symbol || symbols(entry.value).empty()) continue;
      const std::string what =
          error.reason == Reason::division_by_zero ? "division by zero" : "a root is not real";
      context.error(entry.place, what + " at the default values: " + error.what(), "choose other defaults");
    }
  }
}

}  // namespace qvgen::description
