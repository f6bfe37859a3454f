// SPDX-License-Identifier: MIT
// write_random_arms TOOL FAMILY FOLDER COUNT ARMS_IN_A_FILE: descriptions of random arms, what the tool
// generates from them, and C++ files that register all of it with the test.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "random_arm.h"

namespace {

namespace fs = std::filesystem;
using qvgen::test::arm_name;

struct Folder {
  fs::path root;
  [[nodiscard]] fs::path description(const std::string& name) const { return root / (name + ".toml"); }
  [[nodiscard]] fs::path source(const std::string& name) const {
    return root / "generated/source" / name / "inverse.cpp";
  }
  [[nodiscard]] fs::path lanes(const std::string& name) const {
    return root / "generated/source" / name / "inverse_avx2.cpp";
  }
  [[nodiscard]] fs::path in_c(const std::string& name) const {
    return root / "generated/c" / ("qvgen_" + name + "_inverse.c");
  }
  [[nodiscard]] fs::path header(const std::string& name) const {
    return root / "generated/include/qvgen/robots" / name / "inverse.h";
  }
};

constexpr const char* solved_arm = R"(#include "@SOURCE@"
namespace {
namespace @NAME@ {
namespace robot = qvgen::robots::@NAME@;
using Pose = qvgen::Pose<double>;
using qvgen::test::asked;
using qvgen::test::copy;
const bool registered = qvgen::test::add_inverse({"@NAME@", "@DESCRIPTION@", robot::dof, robot::inverse_info@SUFFIX@, {}, {
    [](const Pose& pose, [[maybe_unused]] double given, double tolerance, const reference::Values&) { return copy(robot::inverse_kinematics@SUFFIX@(asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@)@GIVEN@, robot::Geometry{}, tolerance)); },
    [](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, const reference::Values&) { return copy(robot::inverse_kinematics@SUFFIX@(asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@)@GIVEN@, robot::JointVector<double>(seed))); },
    {}, {}, {}, @NEAR@, @PITCH@, @INCLINATION@}});
const bool within = qvgen::test::rows_within("@NAME@").emplace("C++", [](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) { return copy(robot::inverse_kinematics@SUFFIX@(asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@)@GIVEN@, robot::JointVector<double>(seed), qvgen::JointLimits<robot::dof>{lower, upper})); }).second;
}
}
)";

constexpr const char* near_a_seed =
    R"([](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, double tolerance, const reference::Values&) { return copy(robot::inverse_kinematics_near@SUFFIX@(asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@)@GIVEN@, robot::JointVector<double>(seed), robot::Geometry{}, tolerance)); })";

constexpr const char* by_pitch =
    R"([](const Eigen::Vector3d& position, double pitch, [[maybe_unused]] double given) { return copy(robot::inverse_kinematics@SUFFIX@(qvgen::PositionAndPitch<double>{position, pitch}@GIVEN@)); })";

constexpr const char* by_inclination =
    R"([](const Eigen::Vector3d& position, const Eigen::Vector3d& up, [[maybe_unused]] double given) { return copy(robot::inverse_kinematics@SUFFIX@(qvgen::PositionAndInclination<double>{position, up}@GIVEN@)); })";

constexpr const char* unsolved_arm =
    R"(const bool @NAME@ = qvgen::test::add_unsolved({"@NAME@", "@DESCRIPTION@", R"text(@REASONS@)text"});
)";

constexpr const char* arm_in_c = R"(#include "@HEADER@"
namespace {
namespace @NAME@_in_c {
namespace robot = qvgen::robots::@NAME@;
using Pose = qvgen::Pose<double>;
using qvgen::test::asked;
using qvgen::test::wxyz;
using Set = @NAME@_solutions;
int call(const Pose& pose, [[maybe_unused]] double given, const double* seed, double tolerance, Set* set) {
  const auto task = asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@);
  return @NAME@_inverse_kinematics@SUFFIX@@OF@(@ARGUMENTS@@GIVEN@, seed, &@NAME@_default_geometry, tolerance, set);
}
qvgen::test::InverseFunctions functions() {
  qvgen::test::InverseFunctions all;
  all.solve = [](const Pose& pose, double given, double tolerance, const reference::Values&) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { return call(pose, given, nullptr, tolerance, set); }); };
  all.solve_from = [](const Pose& pose, double given, const Eigen::VectorXd& seed, const reference::Values&) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { return call(pose, given, seed.data(), 1e-13, set); }); };
@NEAR@@PITCH@@INCLINATION@  return all;
}
const bool registered = qvgen::test::inverses_in_c().emplace("@NAME@", functions()).second;
const bool within = qvgen::test::rows_within("@NAME@").emplace("C", [](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { const auto task = asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@); return @NAME@_inverse_kinematics@SUFFIX@@OF@_within_limits(@ARGUMENTS@@GIVEN@, seed.data(), lower.data(), upper.data(), &@NAME@_default_geometry, 1e-13, set); }); }).second;
}
}
)";

constexpr const char* near_a_seed_in_c =
    R"(  all.solve_near = [](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, double tolerance, const reference::Values&) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { const auto task = asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@); return @NAME@_inverse_kinematics_near@SUFFIX@@OF@(@ARGUMENTS@@GIVEN@, seed.data(), &@NAME@_default_geometry, tolerance, set); }); };
)";

constexpr const char* by_pitch_in_c =
    R"(  all.solve_pitch = [](const Eigen::Vector3d& position, double pitch, [[maybe_unused]] double given) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { return @NAME@_inverse_kinematics@SUFFIX@_of_position_and_pitch(position.data(), pitch@GIVEN@, nullptr, &@NAME@_default_geometry, 1e-13, set); }); };
)";

constexpr const char* by_inclination_in_c =
    R"(  all.solve_inclination = [](const Eigen::Vector3d& position, const Eigen::Vector3d& up, [[maybe_unused]] double given) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { return @NAME@_inverse_kinematics@SUFFIX@_of_position_and_inclination(position.data(), up.data()@GIVEN@, nullptr, &@NAME@_default_geometry, 1e-13, set); }); };
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

/// The lines of a header without functions that say what was looked for.
std::string reasons(const fs::path& header) {
  std::ifstream file(header);
  std::string result;
  for (std::string line; std::getline(file, line);)
    if (line.rfind("//   ", 0) == 0) result += line.substr(5) + "\n";
  return result;
}

/// Returns the end of the functions' names: "_given_q7", or nothing.
std::string suffix(const fs::path& header) {
  const std::string start = "inline constexpr InverseInfo inverse_info";
  std::ifstream file(header);
  for (std::string line; std::getline(file, line);)
    if (line.rfind(start, 0) == 0) return line.substr(start.size(), line.find('{') - start.size());
  return "";
}

/// True if an arm takes every pose next to one that it has.
bool has_near(const fs::path& header, const std::string& given) {
  const std::string start = "NearSolution inverse_kinematics_near" + given + "(";
  std::ifstream file(header);
  for (std::string line; std::getline(file, line);)
    if (line.rfind(start, 0) == 0) return true;
  return false;
}

/// The task that the functions' main entry takes: "direction".
std::string task(const fs::path& header) {
  const std::string before = "Task::";
  std::ifstream file(header);
  for (std::string line; std::getline(file, line);) {
    const std::size_t begin = line.find(before);
    if (line.rfind("inline constexpr InverseInfo", 0) != 0 || begin == std::string::npos) continue;
    const std::size_t end = line.find(',', begin);
    return line.substr(begin + before.size(), end - begin - before.size());
  }
  return "";
}

/// Registers the arm's functions in C behind the type of the C++ ones; empty if the arm has none.
std::string registration_in_c(const Folder& folder, const std::string& name) {
  if (!fs::exists(folder.in_c(name))) return "";
  const fs::path header = folder.header(name);
  const std::string given = suffix(header), asked = task(header);
  const std::string pose = "wxyz(task.orientation).data(), task.position.data()";
  const bool has_pitch = asked == "position_and_pitch";
  const bool has_inclination = asked == "position_and_inclination";
  const bool whole =
      asked == "pose" || asked == "position" || asked == "position_and_yaw" || has_pitch || has_inclination;
  std::string text = replaced(arm_in_c, "@NEAR@", has_near(header, given) ? near_a_seed_in_c : "");
  text = replaced(text, "@PITCH@", has_pitch ? by_pitch_in_c : "");
  text = replaced(text, "@INCLINATION@", has_inclination ? by_inclination_in_c : "");
  text = replaced(text, "@OF@", whole ? "" : "_of_" + asked);
  text = replaced(text, "@ARGUMENTS@",
                  whole                    ? pose
                  : asked == "orientation" ? "wxyz(task).data()"
                  : asked == "direction"   ? "task.vector.data()"
                                           : "task.position.data(), task.direction.data()");
  text = replaced(text, "@SUFFIX@", given);
  text = replaced(text, "@GIVEN@", given.empty() ? "" : ", given");
  text = replaced(text, "@HEADER@", fs::path(folder.in_c(name)).replace_extension(".h").string());
  return replaced(text, "@NAME@", name);
}

/// A source in C for each arm, whether or not there is anything to compile.
void write_sources_in_c(const Folder& folder, const std::string& family, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const fs::path inverse = folder.in_c(arm_name(family, i));
    std::ofstream file(folder.root / ("c_" + std::to_string(i) + ".c"));
    std::ofstream model(folder.root / ("c_model_" + std::to_string(i) + ".c"));
    const fs::path robot = inverse.parent_path() / ("qvgen_" + arm_name(family, i) + ".c");
    file << (fs::exists(inverse) ? "#include \"" + inverse.string() + "\"\n" : "typedef int nothing;\n");
    model << (fs::exists(inverse) ? "#include \"" + robot.string() + "\"\n" : "typedef int nothing;\n");
  }
}

std::string registration(const Folder& folder, const std::string& name) {
  const bool solved = fs::exists(folder.source(name));
  std::string text = solved ? solved_arm : unsolved_arm;
  const std::string given = suffix(folder.header(name));
  text = replaced(text, "@NEAR@", has_near(folder.header(name), given) ? near_a_seed : "{}");
  text = replaced(text, "@PITCH@", task(folder.header(name)) == "position_and_pitch" ? by_pitch : "{}");
  text = replaced(text, "@INCLINATION@",
                  task(folder.header(name)) == "position_and_inclination" ? by_inclination : "{}");
  text = replaced(text, "@NAME@", name);
  text = replaced(text, "@SUFFIX@", given);
  text = replaced(text, "@GIVEN@", given.empty() ? "" : ", given");
  text = replaced(text, "@SOURCE@", folder.source(name).string());
  text = replaced(text, "@DESCRIPTION@", folder.description(name).string());
  return replaced(text, "@REASONS@", solved ? "" : reasons(folder.header(name)));
}

/// The lanes of several arms, a file of its own, for it is compiled for AVX2.
void write_lanes(const Folder& folder, std::ofstream file, const std::string& family, std::uint32_t first,
                 std::uint32_t end) {
  for (std::uint32_t i = first; i < end; ++i) {
    const fs::path lanes = folder.lanes(arm_name(family, i));
    if (fs::exists(lanes)) file << "#include \"" << lanes.string() << "\"\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  const std::string family = argv[2];
  const Folder folder{argv[3]};
  const auto count = static_cast<std::uint32_t>(std::atoi(argv[4]));
  const auto in_a_file = static_cast<std::uint32_t>(std::atoi(argv[5]));
  fs::remove_all(folder.root);
  fs::create_directories(folder.root);
  std::string command = std::string(argv[1]) + " generate";
  for (std::uint32_t i = 0; i < count; ++i) {
    const fs::path description = folder.description(arm_name(family, i));
    std::ofstream(description) << qvgen::test::arm_description(family, i);
    command += " " + description.string();
  }
  command += " --only inverse --output " + (folder.root / "generated").string();
  const std::string log = (folder.root / "log.txt").string() + " 2>&1";
  if (std::system((command + " > " + log).c_str()) != 0 ||
      std::system((command + " --language c >> " + log).c_str()) != 0) {
    std::cerr << std::ifstream(folder.root / "log.txt").rdbuf() << command << " failed\n";
    return 1;
  }
  for (std::uint32_t first = 0; first < count; first += in_a_file) {
    const std::string number = std::to_string(first / in_a_file);
    const std::uint32_t end = std::min(count, first + in_a_file);
    write_lanes(folder, std::ofstream(folder.root / ("lanes_" + number + ".cpp")), family, first, end);
    std::ofstream file(folder.root / ("arms_" + number + ".cpp"));
    file << "#include \"robot_in_c.h\"\n#include \"rows_within.h\"\n#include \"unsolved.h\"\n";
    if (first == 0)
      file << "namespace { const bool has_own_sines = (qvgen::test::most_others() = 15) > 0; }\n";
    if (first == 0) file << "std::size_t qvgen::test::written_arms() { return " << count << "; }\n";
    for (std::uint32_t i = first; i < end; ++i) {
      file << registration(folder, arm_name(family, i));
      file << registration_in_c(folder, arm_name(family, i));
    }
  }
  write_sources_in_c(folder, family, count);
  return 0;
}
