// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/documents.h"
#include "pipeline/pipeline.h"

namespace qvgen::cli {
namespace {

using Kind = Value::Kind;

/// For zsh's _arguments and _describe, which give a colon and brackets a meaning, inside single quotes.
std::string escaped(const std::string& text, const std::string& special) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (special.find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

/// ":what:how to complete it", nothing for a flag.
std::string action(const Value& value) {
  switch (value.kind) {
    case Kind::none:
      return "";
    case Kind::robot:
      return ":robot or file:_qvgen_robots";
    case Kind::file:
      return ":file:_files";
    case Kind::folder:
      return ":folder:_files -/";
    case Kind::parts:
      return fmt::format(":part:({})", fmt::join(pipeline::product_names(), " "));
    case Kind::choice:
      return fmt::format(":choice:({})", fmt::join(value.choices, " "));
    case Kind::other:
      return ":value: ";
  }
  return "";
}

std::string option_spec(const CLI::Option& option) {
  const std::string rest = "[" + escaped(option.get_description(), "[]:\\") + "]" + action(value_of(option));
  std::string specs;
  // An option may come again only if it takes several values.
  const std::string again = option.get_items_expected_max() > 1 ? "*" : "";
  for (const std::string& name : names_of(option))
    specs += fmt::format(" \\\n        '{}{}{}'", again, name, rest);
  return specs;
}

std::string command_case(const CLI::App& command) {
  std::string text = fmt::format("    {}) _arguments", command.get_name());
  for (const CLI::Option* option : options_of(command)) text += option_spec(*option);
  for (const CLI::Option* argument : arguments_of(command)) {
    const std::string many = argument->get_items_expected_max() > 1 ? "*" : "";
    text += fmt::format(" \\\n        '{}{}'", many, action(value_of(*argument)));
  }
  return text + " ;;\n";
}

constexpr const char* head = R"zsh(#compdef qvgen
# Completion of qvgen in zsh, by `qvgen completion zsh`.
_qvgen_robots() {
  local -a robots
  robots=(${(f)"$(qvgen list 2>/dev/null)"})
  compadd -a robots
  _files
}
_qvgen() {
  local context state line
  typeset -A opt_args
)zsh";

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string commands;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    commands += fmt::format("    '{}:{}'\n", command->get_name(), escaped(command->get_description(), ":\\"));
    cases += command_case(*command);
  }
  std::string options;
  for (const CLI::Option* option : options_of(app)) options += option_spec(*option);
  return fmt::format(
      "{}  local -a commands=(\n{}  )\n  _arguments -C{} \\\n        '1: :->command' '*:: :->rest'\n"
      "  case $state in\n    command) _describe command commands; return ;;\n  esac\n"
      "  case $line[1] in\n{}  esac\n}}\n"
      "if [[ $funcstack[1] == _qvgen ]]; then _qvgen \"$@\"; else compdef _qvgen qvgen; fi",
      head, commands, options, cases);
}

}  // namespace qvgen::cli
