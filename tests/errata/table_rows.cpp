// SPDX-License-Identifier: MIT
// Tables 3.17 and 3.18 of the thesis, the captions of chapter 2 and chapter 4's sentences on the joints, cell
// by cell: each is compared with the arm's class.
#include <array>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "arm_class.h"
#include "printed_tables.h"

namespace qvgen::test::sources {
namespace {

std::string upper(std::string name) {
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

/// A printed cell beside what it should be.
Row cell(const std::string& number, const std::string& of, const std::string& printed,
         const std::string& right, const std::string& evidence) {
  if (printed.empty()) return {number, {of, {}}, {"-", {}}, "not judged: a dash", {}, {}};
  if (printed == right) return {number, {of, {}}, {printed, {}}, "right", {}, {}};
  return {number, {of, {}}, {printed, {}}, "wrong", {right, {}}, "by computation: " + evidence};
}

std::string span(const ArmClass& arm) {
  static const std::array<const char*, 4> spans{"it has no turn", "all its turns have one direction",
                                                "the axes of its turns span a plane",
                                                "the axes of its turns span all directions"};
  return spans.at(static_cast<std::size_t>(arm.directions));
}

void add_class(const ClassRow& printed, Table& table) {
  const ArmClass arm = class_of(printed.robot);
  const std::string number = "table 3.17, " + upper(printed.robot);
  const auto add = [&](const char* of, const std::string& cell_text, const std::string& right,
                       const std::string& evidence) {
    table.rows.push_back(cell(number, of, cell_text, right, evidence));
  };
  add("joints", printed.types, arm.types, "the joints of its model, as its equations have them");
  add("axes", printed.relations, arm.relations,
      "axes 1 and 2, then 2 and 3, of its model, as its equations have them");
  add("by joints", printed.by_joints, arm.workspace(), span(arm));
  add("by matrix", printed.by_transformation, arm.workspace(), span(arm));
}

std::string decimals(double value) {
  std::string result = fmt::format("{:.3f}", value);
  while (result.back() == '0') result.pop_back();
  if (result.back() == '.') result.pop_back();
  return result;
}

void add_times(const TimeRow& printed, Table& table) {
  const std::string number = "table 3.18, " + upper(printed.robot);
  const ArmClass arm = class_of(printed.robot);
  const auto measured = [&](const char* of, const std::string& seconds) {
    table.rows.push_back(
        {number, {of, {}}, {seconds, {}}, "not judged: a time measured on a computer of 2007", {}, {}});
  };
  measured("matrices", printed.matrices);
  measured("pairs", printed.pairs);
  table.rows.push_back(cell(number, "difference", printed.difference,
                            decimals(std::stod(printed.matrices) - std::stod(printed.pairs)),
                            "the two columns before it"));
  table.rows.push_back(cell(number, "workspace", printed.workspace, arm.workspace(), span(arm)));
}

Table captions(const PrintedTables& printed) {
  Table table{"2.1: captions of the figures, by the arms' joints", "pages 13 to 21", {}};
  for (const Caption& caption : printed.captions)
    table.rows.push_back(cell("figure " + caption.figure, upper(caption.robot), caption.types,
                              class_of(caption.robot).types,
                              "the joints of its model, as its equations and table 3.17 have them"));
  return table;
}

Table sentences(const PrintedTables& printed) {
  Table table{"4.1: the sentences on the first three joints", "pages 57 to 95", {}};
  for (const Sentence& sentence : printed.sentences)
    table.rows.push_back(cell("4.1, text", upper(sentence.robot), sentence.joints,
                              class_of(sentence.robot).joints,
                              "the joints of its model, as its equations have them"));
  return table;
}

}  // namespace

std::vector<Table> tables_of_chapter(const std::string& prefix) {
  const PrintedTables printed = printed_tables();
  if (prefix == "2.") return {captions(printed)};
  if (prefix == "4.") return {sentences(printed)};
  if (prefix != "3.") return {};
  Table classes{"3.2: table 3.17, classes of workspaces, cell by cell", "page 54", {}};
  Table times{"3.3: table 3.18, seconds for a million poses, cell by cell", "page 55", {}};
  for (const ClassRow& row : printed.classes) add_class(row, classes);
  for (const TimeRow& row : printed.times) add_times(row, times);
  return {classes, times};
}

}  // namespace qvgen::test::sources
