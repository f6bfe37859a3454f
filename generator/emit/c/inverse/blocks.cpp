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

/// Sizes that a robot's C says, of arrays for which it has room: any numbers, as only their names are printed.
constexpr const char* rooms = "enum { most_joints = 1, most_rows = 1 };\n";

void read_c(const std::string& name, const std::string& text, Reader& reader) {
  reader.read_c({name, "inverse", false, in_double_precision(text)});
}

/// Adds what C has in the place of a header whose order of operations it cannot say, if there is one.
void add_counterpart(const std::string& header, Reader& reader, std::string& result) {
  const std::string name = "c/headers/" + header.substr(0, header.size() - 1) + "c";
  const auto counterpart = builtin_templates().find(name);
  if (counterpart == builtin_templates().end()) return;
  read_c(name, counterpart->second, reader);
  result += counterpart->second + "\n";
}

/// Adds a header in C behind those that it includes.
void add_header(const std::string& name, std::set<std::string>& known, Reader& reader, std::string& result) {
  if (!known.insert(name).second) return;
  const auto header = builtin_templates().find("runtime/" + name);
  if (header == builtin_templates().end()) return add_counterpart(name, reader, result);
  static const std::regex include(R"(#include <qvgen/inverse/([a-z_]+\.h)>)");
  const std::string& text = header->second;
  for (std::sregex_iterator each(text.begin(), text.end(), include), end; each != end; ++each)
    add_header((*each)[1], known, reader, result);
  result += reader.in_c({name, "inverse", false, text});
}

std::string joined() {
  Reader reader;
  const std::string& first = builtin_templates().at(before);
  read_c("rooms", rooms, reader);
  read_c(before, first, reader);
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
