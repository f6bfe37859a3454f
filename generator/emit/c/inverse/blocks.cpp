// SPDX-License-Identifier: MIT
#include "emit/c/inverse/blocks.h"

#include <set>
#include <vector>

#include "emit/blocks/runtime/runtime.h"
#include "emit/builtin_templates.h"
#include "emit/c/single_precision.h"

namespace qvgen::emit::c {
namespace {

using blocks::runtime::Reader;

/// The template that headers of the runtime call.
constexpr const char* before = "c/inverse/01_rotor.c";

/// Text in front of the blocks, as a robot's C has it: sizes of arrays for which it has room, of which only
/// the names are printed, and the struct that its header has.
constexpr const char* robot = R"(
enum { most_joints = 1, most_rows = 1, most_points = 3 };
typedef struct Effort {
  int passes, steps, used_up;
} Effort;
)";

void read_c(const std::string& name, const std::string& text, Reader& reader) {
  reader.read_c({name, "inverse", false, in_double_precision(text)});
}

/// Takes the lines out of a text that include headers of inverse kinematics, and returns the headers' names.
std::vector<std::string> take_includes(std::string& text) {
  const std::string opening = "#include <qvgen/inverse/";
  std::vector<std::string> names;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    const std::size_t name = at + opening.size(), end = text.find(">\n", name);
    names.push_back(text.substr(name, end - name));
    text.erase(at, end + 2 - at);
  }
  return names;
}

/// Adds a header in C, or what C has of its own in the place of it, behind those that it includes.
void add_header(const std::string& name, std::set<std::string>& known, Reader& reader, std::string& result) {
  if (!known.insert(name).second) return;
  const std::string in_place = "c/headers/" + name.substr(0, name.size() - 1) + "c";
  const auto header = builtin_templates().find("runtime/" + name), own = builtin_templates().find(in_place);
  const bool is_read = header != builtin_templates().end();
  if (!is_read && own == builtin_templates().end()) return;
  const std::string& text = (is_read ? header : own)->second;
  std::string alone = text;
  for (const std::string& each : take_includes(alone)) add_header(each, known, reader, result);
  if (is_read) {
    result += reader.in_c({name, "inverse", false, text});
    return;
  }
  read_c(in_place, text, reader);
  result += alone + "\n";
}

std::string joined() {
  Reader reader;
  const std::string& first = builtin_templates().at(before);
  read_c("robot", robot, reader);
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
