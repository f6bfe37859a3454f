// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/command_line.h"
#include "cli/documents.h"
#include "cli/examples.h"

namespace qvgen::cli {
namespace {

/// Text that roff prints as it stands.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const bool begins = escaped.empty() || escaped.back() == '\n';
    if (begins && (c == '.' || c == '\'')) escaped += "\\&";
    escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return escaped;
}

std::string usage(const CLI::App& command) {
  std::string text = fmt::format(".B qvgen {}\n[\\fIoptions\\fR]", plain(command.get_name()));
  for (const CLI::Option* argument : arguments_of(command)) {
    const std::string name = "\\fI" + plain(argument->get_name()) + "\\fR";
    const std::string dots = argument->get_items_expected_max() > 1 ? " ..." : "";
    text += argument->get_required() ? " " + name + dots : " [" + name + dots + "]";
  }
  return text + "\n";
}

std::string entry(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : names_of(option))
    names += (names.empty() ? "\\fB" : ", \\fB") + plain(name) + "\\fR";
  if (names.empty()) names = "\\fI" + plain(option.get_name()) + "\\fR";
  const Value value = value_of(option);
  const bool named = option.nonpositional();
  const std::string taken =
      value.kind == Value::Kind::none || !named ? "" : " \\fI" + plain(value.name) + "\\fR";
  const std::string standard =
      option.get_default_str().empty() ? "" : " [" + plain(option.get_default_str()) + "]";
  return fmt::format(".TP\n{}{}\n{}{}\n", names, taken, plain(option.get_description()), standard);
}

}  // namespace

std::string man_page(const CLI::App& app) {
  const std::string description = app.get_description();
  std::string page = fmt::format(".TH QVGEN 1 \"\" \"{}\" \"User Commands\"\n", plain(app.version()));
  page += ".SH NAME\nqvgen \\- " + plain(description.substr(description.find(": ") + 2)) + "\n";
  page += ".SH SYNOPSIS\n.B qvgen\n\\fIcommand\\fR [\\fIoptions\\fR] [\\fIarguments\\fR]\n.SH OPTIONS\n";
  for (const CLI::Option* option : options_of(app)) page += entry(*option);
  page += ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app)) {
    page += fmt::format(".SS {}\n{}.PP\n{}\n", plain(command->get_name()), usage(*command),
                        plain(command->get_description()));
    for (const CLI::Option* argument : arguments_of(*command)) page += entry(*argument);
    for (const CLI::Option* option : options_of(*command)) page += entry(*option);
  }
  page += fmt::format(".SH EXAMPLES\n.nf\n{}.fi\n", plain(std::string(examples).substr(1)));
  page += fmt::format(".SH EXIT STATUS\n{}", plain(exit_codes));
  return page;
}

}  // namespace qvgen::cli
