// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/image.h"

namespace qvgen::pipeline {

/// A file to write, path relative to the output folder.
struct OutputFile {
  std::string path;
  std::string content;
};

/// A part that a robot does not get.
struct Missing {
  enum class Kind {
    not_described,    ///< the description has nothing to make it from (no inertia, no dynamics)
    not_derived,      ///< what can be derived does not cover this arm
    on_request,       ///< the description leaves it to who names it
    not_in_language,  ///< it is there in another language
    not_finished,     ///< it has used up its budget of time or memory, or its process died
    refuted           ///< a certificate has failed: a defect of the generator, which says so
  };
  std::string part;
  Kind kind = Kind::not_derived;
  std::string reason;
};

/// Returns the message for a check of the generator that has failed.
std::string defect_text(const std::string& check);

/// Output of one robot: its files and its entry in operation_counts.json.
struct RobotOutput {
  std::string robot;
  std::vector<OutputFile> files = {};
  nlohmann::ordered_json counts = nlohmann::ordered_json::object();
  std::vector<Missing> missing = {};
  std::vector<model::Image> images = {};  ///< that get headers beside the robot's own (images.h)
};

/// Lets `generate` add a part to the output. If it throws, nothing of the part is left but the reason.
void attempt(const std::string& part, RobotOutput& output, const std::function<void(RobotOutput&)>& generate);

/// Part of a robot's output, made in a process of its own; parts do not need one another.
struct PartOfOutput {
  std::string part;
  std::function<void(RobotOutput&)> generate;
};
void attempt_all(const std::vector<PartOfOutput>& parts, RobotOutput& output);

/// Returns the parts without those on request, which are noted as missing from the output.
std::vector<PartOfOutput> without_requested(std::vector<PartOfOutput> parts,
                                            const std::vector<std::string>& on_request, RobotOutput& output);

/// Writes the missing parts as in operation_counts.json, and reads them back.
nlohmann::ordered_json missing_to_json(const std::vector<Missing>& missing);
std::vector<Missing> missing_from_json(const nlohmann::ordered_json& json);

/// The functions of a robot by its entry in operation_counts.json: those that are counted, and those of the
/// inverse kinematics, of which it has under "targets" what each of them takes.
std::vector<std::string> functions_in(const nlohmann::ordered_json& entry);

/// Lists what a robot does not get, with the reasons, as lines.
std::vector<std::string> lines_of_missing(const RobotOutput& output);

/// Appends what another process has made of the same robot.
void append(RobotOutput& output, const RobotOutput& more);

/// To and from text, for the way between processes.
std::string to_text(const RobotOutput& output);
RobotOutput robot_output_from_text(const std::string& text);

}  // namespace qvgen::pipeline
