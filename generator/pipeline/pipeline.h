// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/robot.h"
#include "pipeline/language.h"
#include "pipeline/parallel.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// The products (headers of a robot: kinematics, jacobian, ...) that a run generates; none named means all
/// but the extras.
using Parts = std::vector<std::string>;

/// True if a language's files come from those of C: C itself, and what is translated from it.
inline bool comes_from_c(Language language) { return language != Language::cxx; }

/// Returns the folder entry of a robot; entries of C are "c/NAME", and so on for each language but C++.
std::string folder_name(const std::string& robot, Language language);
bool is_in(Language language, const std::string& folder_name);

/// The parts that can be named: products, and what may be missing of one while the rest is there.
std::vector<std::string> product_names();
std::vector<std::string> part_names();
/// Those that are made only if they are named.
std::vector<std::string> extra_names();
/// The product that a part belongs to.
std::string product_of(const std::string& part);

/// True if a robot has a part, by what is missing of it.
bool has_part(const std::vector<Missing>& missing, const std::string& part);

/// Products in C by robot and part, kept from one language of a run for the next that is made of C.
using KeptProducts = std::map<std::pair<std::string, std::string>, Outcome>;

/// description -> model -> symbolic -> derive -> dag -> passes -> emit: the files of each robot. Every
/// product of every robot is made in a process of its own; one that fails is left out and says why. Outputs
/// have the names that folders call them by. `limb_of`: for each robot the one that it is a limb of, if it is
/// one; limbs of C++ that are images of another limb are made with that (images.h). `kept`: products of the
/// same robots and parts, which are not made again, and where those in C are left.
std::vector<RobotOutput> generate(const std::vector<model::Robot>& robots, const Parts& parts,
                                  const Budget& budget = {},
                                  const std::function<void(const std::string& robot)>& progress = {},
                                  Language language = Language::cxx, std::vector<std::string> limb_of = {},
                                  KeptProducts* kept = nullptr);

/// In C, the functions that a report's page calls; see `page_products`.
RobotOutput generate_page_functions(const model::Robot& robot, const Budget& budget = {});

/// Files of no single robot.
std::vector<OutputFile> shared_files();

}  // namespace qvgen::pipeline
