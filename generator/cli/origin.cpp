// SPDX-License-Identifier: MIT
#include "cli/origin.h"

#include <sstream>

#include <cln/rational_io.h>

namespace qvgen::cli {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

}  // namespace

std::string origin_options(const description::ReadOptions& options) {
  std::string text;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) text += std::string(" ") + option + " " + value;
  };
  add("--name", options.name);
  add("--base", options.base);
  add("--tip", options.tip);
  add("--tips", joined(options.tips));
  if (options.floating) text += " --floating";
  add("--fixed", joined(options.fixed));
  add("--actuated", joined(options.actuated));
  for (const std::string& argument : options.xacro_arguments) add("--xacro-arg", argument);
  return text;
}

std::string snap_text(const description::ReadOptions& options) {
  std::ostringstream text;
  text << options.snap.mode << " " << options.snap.tolerance;
  return text.str();
}

}  // namespace qvgen::cli
