// SPDX-License-Identifier: MIT
#include "cli/build_files.h"

#include <array>
#include <stdexcept>

#include "pipeline/files.h"
#include "pipeline/output_folder.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& content) {
  if (pipeline::content_of(path) == content) return;
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  pipeline::replace_file(path, content, path.string() + ".new");
}

/// Spaces, as make and ninja want them.
std::string escaped(const fs::path& path) {
  std::string text;
  for (const char c : fs::absolute(path).string())
    text += (c == ' ' || c == '#' ? "\\" : c == '$' ? "$" : "") + std::string(1, c);
  return text;
}

std::string depfile(const GenerateArguments& arguments) {
  std::string text = escaped(fs::path(arguments.build.depfile).replace_extension()) + ":";
  for (const fs::path& description : arguments.descriptions) text += " \\\n  " + escaped(description);
  return text + "\n";
}

/// Every source that a robot may have.
constexpr std::array sources{"kinematics",           "inverse",        "inverse_avx2", "jacobian", "dynamics",
                             "dynamics_derivatives", "dynamics_loads", "regressor"};

void write_sources(const GenerateArguments& arguments, const std::string& robot) {
  const fs::path& folder = arguments.build.sources;
  for (const std::string source : sources) {
    const fs::path path = fs::absolute(arguments.output) / "source" / robot / (source + ".cpp");
    const std::string text =
        fs::exists(path)
            ? "#include \"" + path.lexically_relative(fs::absolute(folder)).generic_string() + "\"\n"
            : "// This robot has none.\n";
    write(folder / (source + ".cpp"), text);
  }
}

}  // namespace

void write_build_files(const GenerateArguments& arguments, const std::vector<std::string>& robots) {
  if (!arguments.build.outputs.empty()) {
    std::string list;
    for (const std::string& path : pipeline::files_of_robots(arguments.output, robots))
      list += (arguments.output / path).generic_string() + "\n";
    write(arguments.build.outputs, list);
  }
  if (!arguments.build.depfile.empty()) write(arguments.build.depfile, depfile(arguments));
  if (arguments.build.sources.empty()) return;
  if (robots.size() != 1) throw std::runtime_error("--sources is for one robot");
  write_sources(arguments, robots.front());
}

}  // namespace qvgen::cli
