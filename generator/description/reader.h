// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/mechanism.h"

namespace qvgen::description {

/// One mistake of a description; lines and columns count from 1, columns in characters.
struct Diagnostic {
  enum Severity { error, warning, note };
  std::string file;
  int line = 1;
  int column = 1;
  Severity severity = error;
  std::string message;  ///< what is wrong
  std::string hint;     ///< what would be right
};

/// `file:line:column: error: what is wrong; what would be right`; warnings and notes likewise
std::string to_string(const Diagnostic& diagnostic);

struct ReadResult {
  std::optional<model::Robot> robot;  ///< absent as soon as there is an error
  std::vector<Diagnostic> diagnostics;
  /// Place of the robot's name in the file, for mistakes between files.
  Diagnostic name_place;
  std::string text;  ///< all that was read
  /// The ends of limbs, where the robot is a whole tree of links: `robot` has the joints of all of them.
  std::vector<model::Frame> tips = {};
  model::Loops loops = {};  ///< closures of loops, if there are any
  /// Files that were read besides, sorted: what an MJCF or a xacro includes, meshes whose volume counts.
  std::vector<std::string> files = {};

  ReadResult();
  ReadResult(const ReadResult&);
  ReadResult(ReadResult&&) noexcept;
  ReadResult& operator=(const ReadResult&);
  ReadResult& operator=(ReadResult&&) noexcept;
  ~ReadResult();
};

/// Which rounded numbers of a URDF or MJCF are read as the exact ones that they were (xml/snap.h).
struct SnapOptions {
  enum Mode { automatic, within, off };
  Mode mode = automatic;
  cln::cl_RA tolerance = 0;  ///< of `within`: radians, or in a unit vector
};

/// "auto", "off", or a tolerance such as 1e-4; nothing if it is none of them.
std::optional<SnapOptions> parse_snap(const std::string& text);

struct ReadOptions {
  bool strict = false;    ///< warnings are errors
  std::string name = {};  ///< of the robot, instead of the file's
  // The rest is for URDF and MJCF.
  std::string base = {};  ///< link where the chain begins; empty: the root
  std::string tip = {};   ///< link where it ends; empty: the only one that can be meant
  /// Links at which limbs end, for a whole tree in place of a chain; `every_tip` alone: all ends of the tree.
  std::vector<std::string> tips = {};
  bool floating = false;  ///< the base moves freely: a whole tree, with all tips if none is named
  std::vector<std::string> fixed = {};     ///< joints that are held at zero
  std::vector<std::string> actuated = {};  ///< joints with motors, where the file closes loops
  SnapOptions snap = {};
  // For who reads files: what xacro is given, and where packages are.
  std::vector<std::string> xacro_arguments = {};
  std::vector<std::string> package_folders = {};
  bool lists_files = false;  ///< also those that xacro includes, which takes another run of it
};

/// The largest file that is read: no description of one robot comes near.
inline constexpr std::size_t max_file_size = 4'000'000;

/// The largest number of joints a chain may have, and a whole tree.
inline constexpr std::size_t max_joints = 16;
inline constexpr std::size_t max_joints_of_tree = 64;

/// In place of the names of tips.
inline constexpr const char* every_tip = "all";

/// Reads a robot description, TOML (the format: generator/robots/README.md), URDF or MJCF, and reports all of
/// its mistakes.
ReadResult read_text(std::string_view text, const std::string& file, const ReadOptions& options = {});
ReadResult read_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// Mistakes between the robots of one run: two with the same name would overwrite each other's code.
std::vector<Diagnostic> check_together(const std::vector<ReadResult>& robots);

}  // namespace qvgen::description
