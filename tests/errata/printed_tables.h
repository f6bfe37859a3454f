// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "document.h"

namespace qvgen::test::sources {

/// A row of table 3.17 of the thesis: an arm's joints, its axes and its workspace, as printed. Empty: a dash.
struct ClassRow {
  std::string robot;
  std::string types;      ///< "RPR"
  std::string relations;  ///< of axes 1 and 2, of 2 and 3: "perpendicular, parallel"
  std::string by_joints;
  std::string by_transformation;
};

/// A row of table 3.18: seconds as printed, by matrices and by pairs.
struct TimeRow {
  std::string robot;
  std::string matrices;
  std::string pairs;
  std::string difference;
  std::string workspace;
};

/// The caption of a figure in chapter 2: an arm's code and its joints.
struct Caption {
  std::string figure;
  std::string robot;
  std::string types;
};

/// Chapter 4's words on an arm's first three joints: "theta1 turns, d2 slides, theta3 turns".
struct Sentence {
  std::string robot;
  std::string joints;
};

struct PrintedTables {
  std::vector<Caption> captions;
  std::vector<ClassRow> classes;
  std::vector<TimeRow> times;
  std::vector<Sentence> sentences;
};
PrintedTables printed_tables();

/// Returns the tables of a chapter that are judged cell by cell: for "2." the captions of its figures, for
/// "3." tables 3.17 and 3.18, for "4." its sentences on the joints.
std::vector<Table> tables_of_chapter(const std::string& prefix);

}  // namespace qvgen::test::sources
