// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/report.h"
#include "compare/comparison.h"
#include "description/reader.h"
#include "model/robot.h"
#include "pipeline/parallel.h"
#include "pipeline/pipeline.h"

namespace qvgen::cli {

/// Exit codes of the tool; the last one is EX_SOFTWARE of sysexits.h.
enum ExitCode { success = 0, failure = 1, usage_error = 2, bad_description = 3, internal_error = 70 };

/// Files for other build systems; paths may be empty.
struct BuildFiles {
  std::filesystem::path outputs;  ///< a list of all files of the robots, one a line
  std::filesystem::path depfile;  ///< for make and ninja: what the file of that name without .d is made from
  std::filesystem::path
      sources;         ///< a folder of one source for each that a robot may have, the same for every robot
  bool quiet = false;  ///< no table
};

struct GenerateArguments {
  std::vector<std::filesystem::path> descriptions;
  std::filesystem::path known_robots;  ///< the folder of the tool's own descriptions
  std::filesystem::path output;
  bool all_known = false;  ///< the descriptions are all that the tool knows: others of its own are gone
  description::ReadOptions read;
  bool force = false;              ///< also what has not changed
  std::vector<std::string> parts;  ///< see pipeline.h
  pipeline::Language language = pipeline::Language::cxx;
  std::vector<std::string> required;  ///< parts without which a robot is an error
  std::uint64_t tool = 0;             ///< a number that another build of the tool has not
  pipeline::Budget budget;
  BuildFiles build;
};

struct ShowArguments {
  std::filesystem::path description;
  description::ReadOptions read;
  std::size_t joints = 0;  ///< the first ones alone; 0: all
  std::string masses;      ///< "middle" or "end" of the links in place of the described inertia
  bool latex = false;
  bool exact = false;  ///< fractions in place of decimals
  bool singularities = false;
  bool dynamics = false;   ///< the joint forces in place of the pose
  bool transform = false;  ///< the homogeneous matrices instead
  bool jacobian = false;   ///< the Jacobian by three methods instead
  bool workspace = false;  ///< the section of the workspace instead
  std::string dh;          ///< "standard" or "modified": the table of Denavit and Hartenberg instead
  bool structure = false;  ///< the class of the arm instead
  bool inverse = false;    ///< the derivation of inverse kinematics instead of the closed form of the pose
};

struct CountsArguments {
  std::filesystem::path folder;
  std::filesystem::path against;  ///< an operation_counts.json of before; may be empty
  CountsFilter filter;
  ReportFormat format = ReportFormat::table;
  bool forms = false;
};

struct CompareArguments {
  std::vector<std::filesystem::path> descriptions;
  description::ReadOptions read;
  bool all_known = false;  ///< no robot was named: those without inertia are left out of dynamics
  compare::Request request;
  bool time = false;
  int rounds = 101;  ///< of the benchmark
  ReportFormat format = ReportFormat::table;
};

struct ReportArguments {
  std::vector<std::filesystem::path> descriptions;
  std::filesystem::path known_robots;
  description::ReadOptions read;
  std::filesystem::path output;
  std::filesystem::path generated;  ///< folder of the generated code, whose counts and signatures are shown
  std::vector<std::filesystem::path> times;
  std::optional<std::filesystem::path> source_tree;
  bool all_known = false;
  bool force = false;      ///< also what has not changed
  std::uint64_t tool = 0;  ///< a number that another build of the tool has not
};

struct MapArguments {
  std::filesystem::path description;
  description::ReadOptions read;
  std::vector<std::filesystem::path> outputs;
  std::vector<std::filesystem::path> merged;  ///< parts, in place of a description
  double resolution = 0;                      ///< m; 0: a twentieth of the reach
  double reach = 0;                           ///< m; 0: the arm's own
  std::size_t orientations = 100;
  bool limits = false;
  int threads = 0;     ///< 0: as many as the machine has
  std::string blocks;  ///< FIRST:LAST; empty: all
  std::filesystem::path known_robots;
  std::optional<std::filesystem::path> source_tree;
  std::uint64_t tool = 0;  ///< a number that another build of the tool has not
};

/// Each command prints its results to stdout and messages to stderr, and returns an ExitCode.
/// `kept`: what other languages of the same run have left.
int run_generate(const GenerateArguments& arguments, pipeline::KeptProducts& kept);
/// Removes robots from a folder, their files and nothing else.
int run_remove(const std::vector<std::string>& robots, const std::filesystem::path& output);
int run_show(const ShowArguments& arguments);
/// The functions that a folder has of a robot, and why any is missing.
int run_show_functions(const std::string& robot, const std::filesystem::path& folder);
int run_counts(const CountsArguments& arguments);
/// Operation counts of competing formulations, each robot in a process of its own.
int run_compare(const CompareArguments& arguments);
/// Pages of robots, and those of all robots of the folder.
int run_report(const ReportArguments& arguments);
/// Which positions and orientations an arm reaches, as files; or such files of parts.
int run_map(const MapArguments& arguments);
/// `thorough`: derives and certifies everything as run_generate does.
int run_check(const std::vector<std::filesystem::path>& descriptions, const description::ReadOptions& options,
              bool thorough);

/// Prints a URDF or MJCF as TOML.
int run_import(const std::filesystem::path& description, const description::ReadOptions& options);
/// Prints a description to edit: a known robot's, or one of joints by their letters.
int run_new(const std::string& code, const std::string& name, bool euler_wrist,
            const std::filesystem::path& robots);

/// Reads all files and reports all their mistakes; nothing if there is an error in any.
std::optional<std::vector<description::ReadResult>> read_descriptions(
    const std::vector<std::filesystem::path>& paths, const description::ReadOptions& options);
/// Writes what was found while reading to standard error, a line each.
void print_diagnostics(const std::vector<description::Diagnostic>& diagnostics);

/// Returns the robot that was read, which there must be, with its tips.
model::Mechanism mechanism_of(const description::ReadResult& result);

/// Likewise for commands that work on chains: a robot whose joints branch is an error, which names its tips.
std::optional<std::vector<description::ReadResult>> read_chains(
    const std::vector<std::filesystem::path>& paths, const description::ReadOptions& options);
/// Likewise for commands that work on chains and on limbs of whole robots: closed loops are an error.
std::optional<std::vector<description::ReadResult>> read_open(const std::vector<std::filesystem::path>& paths,
                                                              const description::ReadOptions& options);

/// Returns robots that were read; nothing if the joints of one branch, which is reported.
std::optional<std::vector<model::Robot>> robots_of(const std::vector<description::ReadResult>& results);

/// Every *.toml of a folder, sorted by name.
std::vector<std::filesystem::path> descriptions_in(const std::filesystem::path& folder);

}  // namespace qvgen::cli
