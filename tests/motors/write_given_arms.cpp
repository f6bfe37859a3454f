// SPDX-License-Identifier: MIT
// write_given_arms TOOL FOLDER COUNT ARMS_IN_A_FILE: descriptions of random arms with joints given anywhere,
// what the tool generates from them in C, or in C++ where an arm is solved by elimination, and files that
// register it with the test.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "inverse/families/given_writer.h"

namespace {

namespace fs = std::filesystem;
using qvgen::test::GivenWriter;

/// The first three arms have turns and slides given, between others; the third has two slides that are
/// parallel where the given turn between them is zero.
constexpr std::uint32_t first_seed = 15, with_slides = 67;
std::uint32_t seed_of(std::uint32_t number) { return number == 2 ? with_slides : first_seed + number; }

struct Arm {
  std::string name, task, text;
};

/// Arms of each kind in turn.
Arm arm_of(std::uint32_t number) {
  const std::string digits = std::to_string(number);
  const std::string name = "given_" + std::string(3 - std::min<std::size_t>(digits.size(), 3), '0') + digits;
  GivenWriter writer(name, seed_of(number), static_cast<GivenWriter::Asked>(number % 5));
  return {name, writer.task(), writer.write()};
}

/// Returns what stands behind a key of a description, without its quotes or brackets.
std::string value_of(const std::string& text, const std::string& key) {
  const std::size_t line = text.find("\n" + key + " = ");
  if (line == std::string::npos) return "";
  const std::size_t begin = line + key.size() + 5;
  return text.substr(begin, text.find('\n', begin) - begin - 1);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

constexpr const char* registration = R"(#include "@SOURCE@"
namespace {
const bool @NAME@_is_there = qvgen::test::add_given_arm({"@NAME@", "@DESCRIPTION@", qvgen::Task::@TASK@, {@GIVEN@}, @DOF@, {@AXIS@},
    @SOLVE@,
    @NEAR@});
}
)";
constexpr const char* arguments =
    "[](const qvgen::test::Part& part, const qvgen::test::VectorXd& at, const qvgen::test::Asked& asked) ";
constexpr const char* solve_in_c = R"({
      return qvgen::test::rows_in_c<@NAME@_solutions>([&](@NAME@_solutions* set) {
        if (asked.limits == nullptr)
          @NAME@_inverse_kinematics@SUFFIX@(@PART@, @AT@, qvgen::test::values_of(asked.seed), &@NAME@_default_geometry, @NAME@_default_tolerance, set);
        else
          @NAME@_inverse_kinematics@SUFFIX@_within_limits(@PART@, @AT@, qvgen::test::values_of(asked.seed), asked.limits->lower.data(), asked.limits->upper.data(), &@NAME@_default_geometry, @NAME@_default_tolerance, set);
      });
    })";
constexpr const char* near_in_c = R"({
      return qvgen::test::rows_in_c<@NAME@_solutions>([&](@NAME@_solutions* set) {
        @NAME@_inverse_kinematics_near@SUFFIX@(@PART@, @AT@, asked.seed->data(), &@NAME@_default_geometry, @NAME@_default_tolerance, set);
      });
    })";
constexpr const char* solve_in_cxx = R"({
      using namespace qvgen::test;
      const auto solve = [&](const auto&... more) { return rows_of(qvgen::robots::@NAME@::inverse_kinematics@GIVEN_NAMES@(@PART@, @AT@, more...)); };
      if (asked.seed == nullptr) return solve();
      return asked.limits == nullptr ? solve(fixed<@DOF@>(*asked.seed)) : solve(fixed<@DOF@>(*asked.seed), fixed<@DOF@>(*asked.limits));
    })";
constexpr const char* near_in_cxx = R"({
      return qvgen::test::rows_of(qvgen::robots::@NAME@::inverse_kinematics_near@GIVEN_NAMES@(@PART@, @AT@, qvgen::test::fixed<@DOF@>(*asked.seed)));
    })";

std::string part_in_c(const std::string& task) {
  if (task == "pose") return "qvgen::test::wxyz(part).data(), part.position.data()";
  if (task == "position") return "part.position.data()";
  return std::string("part.position.data(), ") +
         (task == "position_and_pitch" ? "part.pitch" : "part.direction.data()");
}

std::string part_in_cxx(const std::string& task) {
  if (task == "pose") return "qvgen::Pose<double>{part.orientation, part.position}";
  if (task == "position") return "part.position";
  if (task == "position_and_pitch") return "qvgen::PositionAndPitch<double>{part.position, part.pitch}";
  return std::string("qvgen::PositionAnd") +
         (task == "position_and_direction" ? "Direction" : "Inclination") +
         "<double>{part.position, part.direction}";
}

/// Returns what stands for each of the given joints, of which there is a list of names.
template <class Text>
std::string of_each(const std::string& given, const std::string& between, const Text& text) {
  std::string all;
  for (std::size_t at = 0; at < given.size();) {
    const std::size_t end = std::min(given.find(", ", at), given.size());
    all += (all.empty() ? "" : between) + text(given.substr(at, end - at));
    at = end + 2;
  }
  return all;
}

struct Folder {
  fs::path root;
  [[nodiscard]] fs::path description(const Arm& arm) const { return root / (arm.name + ".toml"); }
  [[nodiscard]] fs::path in_c(const Arm& arm, const std::string& end) const {
    return root / "generated/c" / ("qvgen_" + arm.name + end);
  }
  [[nodiscard]] bool has_c(const Arm& arm) const { return fs::exists(in_c(arm, "_inverse.c")); }
  [[nodiscard]] fs::path in_cxx(const Arm& arm) const {
    return root / "generated/source" / arm.name / "inverse.cpp";
  }
};

std::string registered(const Folder& folder, const Arm& arm) {
  const bool in_c = folder.has_c(arm);
  const std::string given = value_of(arm.text, "given");
  const std::string axis = value_of(arm.text, "tool_axis");
  const std::string names = "_given" + of_each(given, "", [](const std::string& name) { return "_" + name; });
  const auto index = [](const std::string& name) { return std::to_string(std::stoi(name.substr(1)) - 1); };
  const std::string key = "[[joint]]";
  int dof = 0;
  for (std::size_t at = arm.text.find(key); at != std::string::npos; at = arm.text.find(key, at + 1)) ++dof;
  std::string text = registration;
  text = replaced(text, "@SOLVE@", std::string(arguments) + (in_c ? solve_in_c : solve_in_cxx));
  text = replaced(text, "@NEAR@", std::string(arguments) + (in_c ? near_in_c : near_in_cxx));
  text = replaced(text, "@SOURCE@", (in_c ? folder.in_c(arm, "_inverse.h") : folder.in_cxx(arm)).string());
  text = replaced(text, "@DESCRIPTION@", folder.description(arm).string());
  text = replaced(text, "@SUFFIX@", names + (arm.task == "pose" ? "" : "_of_" + arm.task));
  text = replaced(text, "@GIVEN_NAMES@", names);
  text = replaced(text, "@PART@", in_c ? part_in_c(arm.task) : part_in_cxx(arm.task));
  text = replaced(text, "@AT@",
                  of_each(given, ", ", [&](const auto& name) { return "at[" + index(name) + "]"; }));
  text = replaced(text, "@GIVEN@", of_each(given, ", ", index));
  // A quotient in quotes is one in C++, too, of numbers with a point.
  text = replaced(text, "@AXIS@", axis.empty() ? "0, 0, 0" : replaced(replaced(axis, "/", "./"), "\"", ""));
  text = replaced(text, "@DOF@", std::to_string(dof));
  text = replaced(text, "@TASK@", arm.task);
  return replaced(text, "@NAME@", arm.name);
}

/// Generates arms; those that C does not have in C++. False if the tool fails, which is printed.
bool generate(const Folder& folder, const std::string& tool, const std::vector<Arm>& arms) {
  const std::string log = (folder.root / "log.txt").string();
  const auto run = [&](const std::string& options, const auto& serves) {
    std::string command =
        tool + " generate --quiet --output " + (folder.root / "generated").string() + options;
    int count = 0;
    for (const Arm& arm : arms)
      if (serves(arm)) ++count, command += " " + folder.description(arm).string();
    if (count == 0 || std::system((command + " >> " + log + " 2>&1").c_str()) == 0) return true;
    std::cerr << std::ifstream(log).rdbuf() << command << " failed\n";
    return false;
  };
  return run(" --only kinematics,inverse --language c", [](const Arm&) { return true; }) &&
         run(" --only inverse", [&](const Arm& arm) { return !folder.has_c(arm); });
}

/// Two sources in C for each arm, whether or not there is anything to compile.
void write_sources_in_c(const Folder& folder, const Arm& arm) {
  for (const char* end : {".c", "_inverse.c"}) {
    std::ofstream file(folder.root / (arm.name + end));
    if (folder.has_c(arm))
      file << "#include \"" << folder.in_c(arm, end).string() << "\"\n";
    else
      file << "typedef int nothing;\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const Folder folder{argv[2]};
  const int count = std::atoi(argv[3]), in_a_file = std::atoi(argv[4]);
  fs::remove_all(folder.root);
  fs::create_directories(folder.root);
  std::vector<Arm> arms;
  for (int i = 0; i < count; ++i) {
    arms.push_back(arm_of(static_cast<std::uint32_t>(i)));
    std::ofstream(folder.description(arms.back())) << arms.back().text;
  }
  if (!generate(folder, argv[1], arms)) return 1;
  for (int i = 0; i < count; ++i) {
    const Arm& arm = arms[static_cast<std::size_t>(i)];
    const fs::path path = folder.root / ("arms_" + std::to_string(i / in_a_file) + ".cpp");
    std::ofstream file(path, i % in_a_file == 0 ? std::ios::out : std::ios::app);
    if (i % in_a_file == 0) file << "#include \"given_arms.h\"\n";
    if (i == 0) file << "std::size_t qvgen::test::written_given_arms() { return " << count << "; }\n";
    if (folder.has_c(arm) || fs::exists(folder.in_cxx(arm))) file << registered(folder, arm);
    write_sources_in_c(folder, arm);
  }
  return 0;
}
