// SPDX-License-Identifier: MIT
#include "cli/build_files.h"

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "exact/hash.h"
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

std::string depfile(const GenerateArguments& arguments, const std::vector<std::string>& files) {
  std::string text = escaped(fs::path(arguments.build.depfile).replace_extension()) + ":";
  for (const fs::path& description : arguments.descriptions) text += " \\\n  " + escaped(description);
  std::error_code error;
  for (const std::string& file : files)
    if (fs::exists(file, error)) text += " \\\n  " + escaped(file);
  return text + "\n";
}

/// Every C++ source that a robot may have.
constexpr std::array sources{"kinematics",
                             "inverse",
                             "inverse_avx2",
                             "arm_angle",
                             "jacobian",
                             "dynamics",
                             "dynamics_derivatives",
                             "dynamics_loads",
                             "regressor",
                             "batch",
                             "batch_derivatives",
                             "inverse_batch",
                             "assembly",
                             "certified",
                             "mass",
                             "frames",
                             "geometry_jacobian",
                             "regressor_with_drives"};

/// Sources of so many limbs have names that a build knows (runtime/cmake/qvgenGenerate.cmake). In C, other
/// than in C++, a limb's code cannot stand in one source with another's.
constexpr std::size_t most_limbs_in_c = 4;

/// Returns the fingerprint of all files of these robots.
std::string fingerprint(const fs::path& output, const std::vector<std::string>& robots) {
  std::uint64_t all = 0;
  for (const std::string& path : pipeline::files_of_robots(output, robots))
    all = exact::combine(all, exact::hash(pipeline::content_of(output / path).value_or("")));
  return fmt::format("{:016x}", all);
}

/// Names of all sources in C with the generated files that they include, empty for limbs that are not there.
std::vector<std::pair<std::string, std::string>> c_sources(const std::vector<std::string>& robots) {
  std::vector<std::pair<std::string, std::string>> list;
  const auto add = [&](const std::string& name, std::size_t robot, const std::string& part) {
    const bool is_there = robot < robots.size();
    list.emplace_back(name + ".c",
                      is_there ? "qvgen_" + fs::path(robots[robot]).filename().string() + part + ".c" : "");
  };
  add("robot", 0, "");
  for (const std::string part : {"inverse", "metrics", "velocity", "loops"}) add(part, 0, "_" + part);
  for (std::size_t i = 1; i <= most_limbs_in_c; ++i) {
    const std::string limb = "limb_" + std::to_string(i);
    add(limb, i, "");
    for (const std::string part : {"inverse", "metrics", "velocity"}) add(limb + "_" + part, i, "_" + part);
  }
  return list;
}

/// Sources whose names, and being there, a build knows before anything is generated. They differ whenever a
/// file of the robot does: a build system that has read what they include one build ago compiles them again.
/// Limbs of a robot that branches are in the sources of the whole robot, the first one, but in C.
void write_sources(const GenerateArguments& arguments, const std::vector<std::string>& robots) {
  const std::string& robot = robots.front();
  const fs::path folder = fs::absolute(arguments.build.sources), output = fs::absolute(arguments.output);
  const std::string mark = "// Code " + fingerprint(output, robots) + "\n";
  const auto include = [&](const fs::path& generated) -> std::string {
    const std::string path = generated.lexically_relative(folder).generic_string();
    return fs::exists(generated) ? "#include \"" + path + "\"\n" : "";
  };
  // Parts that a robot lacks get a declaration: no C source may be empty.
  const auto write_code = [&](const std::string& name, const std::string& code) {
    write(folder / name, mark + (code.empty() ? "struct qvgen_has_none;\n" : code));
  };
  if (comes_from_c(arguments.language)) {
    for (const auto& [name, generated] : c_sources(robots))
      write_code(name, generated.empty() ? "" : include(output / "c" / generated));
    return;
  }
  const fs::path model = output / "include/qvgen/robots" / robot / "model.h";
  const std::optional<std::string> before = pipeline::content_of(folder / "kinematics.cpp");
  // The header that all others include, for the sources of users: first, in case that this is the end.
  if (before && before->substr(0, mark.size()) != mark && fs::exists(model))
    fs::last_write_time(model, fs::file_time_type::clock::now());
  for (const std::string source : sources) {
    std::string code;
    for (const std::string& each : robots) code += include(output / "source" / each / (source + ".cpp"));
    write_code(source + ".cpp", code);
  }
}

}  // namespace

void write_build_files(const GenerateArguments& arguments, const std::vector<std::string>& robots,
                       const std::vector<std::string>& files) {
  if (!arguments.build.outputs.empty()) {
    std::string list;
    for (const std::string& path : pipeline::files_of_robots(arguments.output, robots))
      list += (arguments.output / path).generic_string() + "\n";
    write(arguments.build.outputs, list);
  }
  if (!arguments.build.depfile.empty()) write(arguments.build.depfile, depfile(arguments, files));
  if (arguments.build.sources.empty()) return;
  if (pipeline::is_translated(arguments.language))
    throw std::runtime_error("--sources is for C++ and C: others take the files as they are");
  if (arguments.descriptions.size() != 1)
    throw std::runtime_error("--sources is for one robot: compile the files that --outputs lists");
  if (robots.size() > 1 + most_limbs_in_c && comes_from_c(arguments.language))
    throw std::runtime_error(fmt::format(
        "--sources is in C for at most {} limbs: compile the files that --outputs lists, or name fewer "
        "tips",
        most_limbs_in_c));
  write_sources(arguments, robots);
}

}  // namespace qvgen::cli
