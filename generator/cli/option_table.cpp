// SPDX-License-Identifier: MIT
#include <map>

#include "cli/documents.h"

namespace qvgen::cli {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::vector<const CLI::Option*> options_where(const CLI::App& command, bool named) {
  return command.get_options([named](const CLI::Option* option) { return option->nonpositional() == named; });
}

}  // namespace

Value value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  const std::string type = option.get_type_name();
  const auto open = type.find('{');
  if (open != std::string::npos)
    return {Value::Kind::choice, type.substr(open),
            split(type.substr(open + 1, type.find('}') - open - 1), ',')};
  const std::string name = type.substr(0, type.find(':'));
  const std::map<std::string, Value::Kind> kinds{{"ROBOT", Value::Kind::robot},
                                                 {"FILE", Value::Kind::file},
                                                 {"FOLDER", Value::Kind::folder},
                                                 {"PARTS", Value::Kind::parts}};
  const auto known = kinds.find(name);
  return {known == kinds.end() ? Value::Kind::other : known->second, name, {}};
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) { return options_where(command, true); }
std::vector<const CLI::Option*> arguments_of(const CLI::App& command) {
  return options_where(command, false);
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

}  // namespace qvgen::cli
