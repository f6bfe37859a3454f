// SPDX-License-Identifier: MIT
#include "toolchain/xacro.h"

#include <cstdlib>
#include <sstream>

#include "toolchain/packages.h"
#include "toolchain/workshop.h"

namespace qvgen::toolchain {
namespace {

/// The module that xacro asks for packages: ROS 2 has one of that name, which knows installed packages only.
constexpr const char* module_for_find = R"(import os


class PackageNotFoundError(KeyError):
    def __str__(self):
        return "there is no package '%s';" % self.args[0]


def get_package_share_directory(name, print_warning=True):
    with open(os.path.join(os.path.dirname(__file__), "packages.txt")) as packages:
        for line in packages:
            package, folder = line.rstrip("\n").split("\t", 1)
            if package == name:
                return folder
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(":"):
        folder = os.path.join(prefix, "share", name)
        if prefix and os.path.isdir(folder):
            return folder
    raise PackageNotFoundError(name)
)";

std::string list_of(const Packages& packages) {
  std::string list;
  for (const auto& [name, folder] : packages) list += name + "\t" + folder.string() + "\n";
  return list;
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::vector<std::string> together(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Splits what `xacro --deps` writes, paths with blanks between. One that has a blank itself is not found in
/// it.
std::vector<std::string> split(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> paths;
  for (std::string path; stream >> path;)
    if (std::error_code error; std::filesystem::exists(path, error)) paths.push_back(path);
  return paths;
}

}  // namespace

bool uses_xacro(std::string_view text) {
  return text.find("<robot") != std::string_view::npos &&
         text.find("xmlns:xacro") != std::string_view::npos &&
         (text.find("<xacro:") != std::string_view::npos || text.find("${") != std::string_view::npos ||
          text.find("$(") != std::string_view::npos);
}

Outcome run_xacro(const std::filesystem::path& file, const std::vector<std::string>& arguments,
                  const std::vector<std::string>& package_folders, std::vector<std::string>* files) {
  std::vector<std::string> folders = package_folders;
  folders.push_back(variable("ROS_PACKAGE_PATH"));
  const Workshop workshop;
  workshop.write("ament_index_python/__init__.py", "");
  workshop.write("ament_index_python/packages.py", module_for_find);
  workshop.write("ament_index_python/packages.txt", list_of(packages_in(folders, file)));
  std::string ros_path;
  for (const std::string& folder : folders)
    if (!folder.empty()) ros_path += (ros_path.empty() ? "" : ":") + folder;
  const std::filesystem::path output = workshop.folder() / "robot.urdf",
                              list = workshop.folder() / "files.txt";
  std::vector<std::string> words{"env",
                                 "PYTHONDONTWRITEBYTECODE=1",
                                 "PYTHONPATH=" + workshop.folder().string() + ":" + variable("PYTHONPATH"),
                                 "ROS_PACKAGE_PATH=" + ros_path,
                                 "xacro",
                                 std::filesystem::absolute(file).string()};
  const auto run_to = [&](const std::filesystem::path& target, const std::vector<std::string>& more) {
    return run(together(together(words, {"-o", target.string()}), together(arguments, more)));
  };
  Outcome outcome = run_to(output, {});
  if (outcome.done && files != nullptr && run_to(list, {"--deps"}).done)
    *files = split(workshop.read("files.txt"));
  if (outcome.done) return {true, workshop.read("robot.urdf")};
  if (outcome.said.empty()) outcome.said = "it ended without a word: it may have taken too long";
  return outcome;
}

}  // namespace qvgen::toolchain
