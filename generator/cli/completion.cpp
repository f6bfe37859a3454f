// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/documents.h"
#include "pipeline/pipeline.h"

namespace qvgen::cli {
namespace {

using Kind = Value::Kind;

/// For bash: the words that a value may be, as lines that follow each other.
std::string bash_words(const Value& value) {
  switch (value.kind) {
    case Kind::robot:
      return "_qvgen_from \"$(qvgen list 2>/dev/null)\"; _qvgen_add -f";
    case Kind::file:
      return "_qvgen_add -f";
    case Kind::folder:
      return "_qvgen_add -d";
    case Kind::parts:
      return fmt::format("_qvgen_from \"{}\"", fmt::join(pipeline::product_names(), " "));
    case Kind::choice:
      return fmt::format("_qvgen_from \"{}\"", fmt::join(value.choices, " "));
    default:
      return ":";
  }
}

constexpr const char* bash_head = R"(# Completion of qvgen in bash, by `qvgen completion bash`.
_qvgen_add() { local IFS=$'\n'; COMPREPLY+=($(compgen "$@" -- "${COMP_WORDS[COMP_CWORD]}")); }
_qvgen_from() { COMPREPLY+=($(compgen -W "$1" -- "${COMP_WORDS[COMP_CWORD]}")); }
_qvgen() {
  local command= word
  COMPREPLY=()
)";

std::string bash_options(const std::string& command, const CLI::App& app) {
  std::vector<std::string> all;
  for (const CLI::Option* option : options_of(app))
    for (const std::string& name : names_of(*option)) all.push_back(name);
  return fmt::format("    \"{} \"*\" -\"*) _qvgen_from \"{}\" ;;\n", command, fmt::join(all, " "));
}

std::string bash_command(const CLI::App& command) {
  std::string lines;
  for (const CLI::Option* option : options_of(command)) {
    const Value value = value_of(*option);
    if (value.kind == Kind::none) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : names_of(*option))
      patterns.push_back(fmt::format("\"{} {} \"*", command.get_name(), name));
    lines += fmt::format("    {}) {} ;;\n", fmt::join(patterns, "|"), bash_words(value));
  }
  lines += bash_options(command.get_name(), command);
  for (const CLI::Option* argument : arguments_of(command))
    lines += fmt::format("    \"{} \"*) {} ;;\n", command.get_name(), bash_words(value_of(*argument)));
  return lines;
}

/// Looked up by the command, the word before and the one to complete, in this order.
std::string bash(const CLI::App& app) {
  std::vector<std::string> names;
  std::string lines;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
    lines += bash_command(*command);
  }
  return fmt::format(
      "{}  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n"
      "    case $word in {}) command=$word; break ;; esac\n  done\n"
      "  case \"$command ${{COMP_WORDS[COMP_CWORD-1]}} ${{COMP_WORDS[COMP_CWORD]}}\" in\n{}{}"
      "    \" \"*) _qvgen_from \"{}\" ;;\n  esac\n}}\ncomplete -o filenames -F _qvgen qvgen",
      bash_head, fmt::join(names, "|"), lines, bash_options("", app), fmt::join(names, " "));
}

/// For fish, in single quotes.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) inside += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return "'" + inside + "'";
}

std::string fish_words(const Value& value) {
  switch (value.kind) {
    case Kind::none:
      return "";
    case Kind::robot:
      return " -F -a '(qvgen list 2>/dev/null)'";
    case Kind::file:
      return " -r -F";
    case Kind::folder:
      return " -x -a '(__fish_complete_directories)'";
    case Kind::parts:
      return " -x -a " + quoted(fmt::format("{}", fmt::join(pipeline::product_names(), " ")));
    case Kind::choice:
      return " -x -a " + quoted(fmt::format("{}", fmt::join(value.choices, " ")));
    case Kind::other:
      return " -x";
  }
  return "";
}

std::string fish_option(const std::string& condition, const CLI::Option& option) {
  std::string line = "complete -c qvgen -n " + quoted(condition);
  for (const std::string& name : option.get_snames()) line += " -s " + name;
  for (const std::string& name : option.get_lnames()) line += " -l " + name;
  return line + fish_words(value_of(option)) + " -d " + quoted(option.get_description()) + "\n";
}

std::string fish(const CLI::App& app) {
  std::string lines = "# Completion of qvgen in fish, by `qvgen completion fish`.\ncomplete -c qvgen -f\n";
  for (const CLI::Option* option : options_of(app)) lines += fish_option("__fish_use_subcommand", *option);
  for (const CLI::App* command : commands_of(app)) {
    lines += fmt::format("complete -c qvgen -n __fish_use_subcommand -a {} -d {}\n", command->get_name(),
                         quoted(command->get_description()));
    const std::string here = "__fish_seen_subcommand_from " + command->get_name();
    for (const CLI::Option* option : options_of(*command)) lines += fish_option(here, *option);
    for (const CLI::Option* argument : arguments_of(*command))
      lines += fmt::format("complete -c qvgen -n {}{}\n", quoted(here), fish_words(value_of(*argument)));
  }
  lines.pop_back();
  return lines;
}

}  // namespace

std::string completion(const CLI::App& app, const std::string& shell) {
  if (shell == "zsh") return zsh_completion(app);
  return shell == "bash" ? bash(app) : fish(app);
}

}  // namespace qvgen::cli
