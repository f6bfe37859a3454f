// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/robot.h"
#include "pipeline/robot_output.h"
#include "report/times.h"
#include "toolchain/generated.h"

namespace qvgen::report {

/// Inputs of pages besides descriptions.
struct Ingredients {
  std::filesystem::path generated;              ///< folder of generated code: counts and signatures
  const toolchain::Runtime* runtime = nullptr;  ///< null where its sources are not on this machine
  Times times;                                  ///< may be none
};

/// One page for each robot, NAME.html, a single file that needs no network; `counts` of an output is what the
/// pages of all robots say of it. Each part of a page is made in a process of its own; one that fails says
/// why in its place.
std::vector<pipeline::RobotOutput> robot_pages(const std::vector<model::Robot>& robots,
                                               const Ingredients& ingredients,
                                               const std::function<void(const std::string& robot)>& progress);

/// Returns the fingerprint of all inputs of a robot's page besides its description: equal for equal pages.
std::string made_of(const std::string& robot, const Ingredients& ingredients);

/// index.html and comparison.html, by the entries of all robots of a folder; errata.html where there is such
/// a document.
std::vector<pipeline::OutputFile> common_pages(const nlohmann::ordered_json& entries,
                                               const std::string& errata);

/// Returns the name of a robot in a folder of pages, which is not that of a folder of code.
std::string page_name(const std::string& robot);

/// A folder's file of the entries.
inline constexpr const char* entries_name = "report.json";

}  // namespace qvgen::report
