// SPDX-License-Identifier: MIT
// write_random_arms TOOL FOLDER ARMS_IN_A_FILE [FAMILY SEEDS IN_CXX]...: descriptions of random arms, what
// the tool generates from them, and C++ files that register all of it with the test. Each arm of the seeds
// ("1,6") is registered in C; those whose seeds IN_CXX names ("1", "all", "none"), and those that have no C,
// in C++ too.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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
const bool within = qvgen::test::add_rows_within("@NAME@", "C++", [](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) { return copy(robot::inverse_kinematics@SUFFIX@(asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@)@GIVEN@, robot::JointVector<double>(seed), qvgen::JointLimits<robot::dof>{lower, upper})); });
}
}
)";

constexpr const char* near_a_seed =
    R"([](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, double tolerance, const reference::Values&) { return copy(robot::inverse_kinematics_near@SUFFIX@(asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@)@GIVEN@, robot::JointVector<double>(seed), robot::Geometry{}, tolerance)); })";

constexpr const char* by_pitch =
    R"([](const Eigen::Vector3d& position, double pitch, [[maybe_unused]] double given) { return copy(robot::inverse_kinematics@SUFFIX@(qvgen::PositionAndPitch<double>{position, pitch}@GIVEN@)); })";

constexpr const char* by_inclination =
    R"([](const Eigen::Vector3d& position, const Eigen::Vector3d& up, [[maybe_unused]] double given) { return copy(robot::inverse_kinematics@SUFFIX@(qvgen::PositionAndInclination<double>{position, up}@GIVEN@)); })";

constexpr const char* header_in_cxx = "#include <qvgen/robots/@NAME@/inverse.h>\n";

constexpr const char* in_c_alone =
    R"(const bool alone = qvgen::test::add_inverse_in_c_alone({"@NAME@", "@DESCRIPTION@", robot::dof, robot::inverse_info@SUFFIX@, {}, functions()});
)";

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
  all.solve = +[](const Pose& pose, double given, double tolerance, const reference::Values&) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { return call(pose, given, nullptr, tolerance, set); }); };
  all.solve_from = +[](const Pose& pose, double given, const Eigen::VectorXd& seed, const reference::Values&) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { return call(pose, given, seed.data(), 1e-13, set); }); };
@NEAR@@PITCH@@INCLINATION@  return all;
}
const bool registered = qvgen::test::add_inverse_in_c("@NAME@", functions());
@ALONE@const bool within = qvgen::test::add_rows_within("@NAME@", "C", [](const Pose& pose, [[maybe_unused]] double given, const Eigen::VectorXd& seed, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) { return qvgen::test::found_in_c<Set>(robot::dof, [&](Set* set) { const auto task = asked<robot::inverse_info@SUFFIX@.task>(pose, robot::inverse_info@SUFFIX@); return @NAME@_inverse_kinematics@SUFFIX@@OF@_within_limits(@ARGUMENTS@@GIVEN@, seed.data(), lower.data(), upper.data(), &@NAME@_default_geometry, 1e-13, set); }); });
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

/// An arm of a family, and whether its C++ is compiled beside its C.
struct Arm {
  std::string name;
  bool in_cxx;
};

/// Registers the arm's functions in C behind the type of the C++ ones; empty if the arm has none.
std::string registration_in_c(const Folder& folder, const Arm& arm) {
  const std::string& name = arm.name;
  if (!fs::exists(folder.in_c(name))) return "";
  const fs::path header = folder.header(name);
  const std::string given = suffix(header), asked = task(header);
  const std::string pose = "wxyz(task.orientation).data(), task.position.data()";
  const bool has_pitch = asked == "position_and_pitch";
  const bool has_inclination = asked == "position_and_inclination";
  const bool whole =
      asked == "pose" || asked == "position" || asked == "position_and_yaw" || has_pitch || has_inclination;
  std::string text = arm.in_cxx ? arm_in_c : std::string(header_in_cxx) + arm_in_c;
  text = replaced(text, "@ALONE@", arm.in_cxx ? "" : in_c_alone);
  text = replaced(text, "@NEAR@", has_near(header, given) ? near_a_seed_in_c : "");
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
  text = replaced(text, "@DESCRIPTION@", folder.description(name).string());
  return replaced(text, "@NAME@", name);
}

/// A source in C for each arm, whether or not there is anything to compile.
void write_sources_in_c(const Folder& folder, const std::vector<Arm>& arms) {
  for (const Arm& arm : arms) {
    const fs::path inverse = folder.in_c(arm.name);
    std::ofstream file(folder.root / ("c_" + arm.name + ".c"));
    std::ofstream model(folder.root / ("c_model_" + arm.name + ".c"));
    const fs::path robot = inverse.parent_path() / ("qvgen_" + arm.name + ".c");
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

std::ofstream numbered(const Folder& folder, const std::string& name, std::size_t number) {
  return std::ofstream(folder.root / (name + std::to_string(number) + ".cpp"));
}

/// The lanes of several arms, a file of its own, for it is compiled for AVX2.
void write_lanes(const Folder& folder, std::ofstream file, std::span<const Arm> arms) {
  for (const Arm& arm : arms)
    if (arm.in_cxx && fs::exists(folder.lanes(arm.name)))
      file << "#include \"" << folder.lanes(arm.name).string() << "\"\n";
}

void write_registrations(const Folder& folder, std::ofstream& file, std::span<const Arm> arms) {
  for (const Arm& arm : arms) {
    if (arm.in_cxx) file << registration(folder, arm.name);
    file << registration_in_c(folder, arm);
  }
}

/// Names as C++ lists them: "\"pitch_002\", ".
std::string names(const std::vector<Arm>& arms) {
  std::string list;
  for (const Arm& arm : arms) list += "\"" + arm.name + "\", ";
  return list;
}

void write_files(const Folder& folder, const std::vector<Arm>& arms, std::size_t in_a_file) {
  for (std::size_t number = 0; number * in_a_file < arms.size(); ++number) {
    const std::size_t first = number * in_a_file;
    const std::span part = std::span(arms).subspan(first, std::min(in_a_file, arms.size() - first));
    write_lanes(folder, numbered(folder, "lanes_", number), part);
    std::ofstream file = numbered(folder, "arms_", number);
    file << "#include \"robot_in_c.h\"\n#include \"rows_within.h\"\n#include \"unsolved.h\"\n";
    if (first == 0)
      file << "namespace { const bool has_own_sines = (qvgen::test::most_others() = 15) > 0; }\n"
           << "std::vector<std::string> qvgen::test::written_arms() { return {" << names(arms) << "}; }\n";
    write_registrations(folder, file, part);
  }
}

/// True if a seed is among those of a list: "1,6", "all".
bool is_among(const std::string& seeds, std::uint32_t seed) {
  return seeds == "all" || ("," + seeds + ",").find("," + std::to_string(seed) + ",") != std::string::npos;
}

/// Writes the descriptions of a family's arms, whose seeds are a list: "1,6".
std::vector<Arm> describe(const Folder& folder, const std::string& family, const std::string& seeds,
                          const std::string& in_cxx) {
  std::vector<Arm> arms;
  std::istringstream list(seeds);
  for (std::string number; std::getline(list, number, ',');) {
    const auto seed = static_cast<std::uint32_t>(std::stoul(number));
    arms.push_back({arm_name(family, seed), is_among(in_cxx, seed)});
    std::ofstream(folder.description(arms.back().name)) << qvgen::test::arm_description(family, seed);
  }
  return arms;
}

/// Generates the arms in both languages; false if that fails, which it says.
bool generate(const Folder& folder, const std::string& tool, const std::vector<Arm>& arms) {
  std::string command = tool + " generate";
  for (const Arm& arm : arms) command += " " + folder.description(arm.name).string();
  command += " --only inverse --output " + (folder.root / "generated").string();
  const std::string log = (folder.root / "log.txt").string() + " 2>&1";
  if (std::system((command + " > " + log).c_str()) == 0 &&
      std::system((command + " --language c >> " + log).c_str()) == 0)
    return true;
  std::cerr << std::ifstream(folder.root / "log.txt").rdbuf() << command << " failed\n";
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 7 || argc % 3 != 1) return 2;
  const Folder folder{argv[2]};
  fs::remove_all(folder.root);
  fs::create_directories(folder.root);
  std::vector<Arm> arms;
  for (int i = 4; i < argc; i += 3)
    for (Arm& arm : describe(folder, argv[i], argv[i + 1], argv[i + 2])) arms.push_back(std::move(arm));
  if (!generate(folder, argv[1], arms)) return 1;
  for (Arm& arm : arms) arm.in_cxx = arm.in_cxx || !fs::exists(folder.in_c(arm.name));
  write_files(folder, arms, static_cast<std::size_t>(std::atoi(argv[3])));
  write_sources_in_c(folder, arms);
  return 0;
}
