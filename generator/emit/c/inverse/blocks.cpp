// SPDX-License-Identifier: MIT
#include "emit/c/inverse/blocks.h"

#include <regex>
#include <set>

#include "emit/blocks/runtime/runtime.h"
#include "emit/builtin_templates.h"
#include "emit/c/single_precision.h"

namespace qvgen::emit::c {
namespace {

using blocks::runtime::Reader;

/// The template that headers of the runtime call.
constexpr const char* before = "c/inverse/01_rotor.c";

/// Adds a header in C behind those that it includes.
void add_header(const std::string& name, std::set<std::string>& known, Reader& reader, std::string& result) {
  const auto header = builtin_templates().find("runtime/" + name);
  if (header == builtin_templates().end() || !known.insert(name).second) return;
  static const std::regex include(R"(#include <qvgen/inverse/([a-z_]+\.h)>)");
  const std::string& text = header->second;
  for (std::sregex_iterator each(text.begin(), text.end(), include), end; each != end; ++each)
    add_header((*each)[1], known, reader, result);
  result += reader.in_c({name, "inverse", false, text});
}

std::string joined() {
  Reader reader;
  const std::string& first = builtin_templates().at(before);
  reader.read_c({before, "inverse", false, in_double_precision(first)});
  std::string result = first + "\n";
  std::set<std::string> known;
  for (const auto& [name, text] : builtin_templates())
    if (name.rfind("runtime/", 0) == 0) add_header(name.substr(8), known, reader, result);
  for (const auto& [name, text] : builtin_templates())
    if (name > before && name.rfind("c/inverse/", 0) == 0) result += text + "\n";
  return result;
}

}  // namespace

const std::string& inverse_blocks() {
  static const std::string blocks = joined();
  return blocks;
}

}  // namespace qvgen::emit::c
