// SPDX-License-Identifier: MIT
// What the sources print, judged, row by row.
#include <cmath>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "document.h"
#include "inverse_formulas.h"
#include "printed_tables.h"
#include "verdict.h"

namespace qvgen::test::sources {
namespace {

using Kind = Judgement::Kind;

Written written(const Tree& tree) { return {plain_text(tree), latex(tree)}; }

/// Sides from `first` on, with signs of equality between.
Written joined(const std::vector<Tree>& sides, std::size_t first) {
  Written result;
  for (std::size_t i = first; i < sides.size(); ++i) {
    result.plain += (i > first ? " = " : "") + plain_text(sides[i]);
    result.latex += (i > first ? " = " : "") + latex(sides[i]);
  }
  return result;
}

std::string verdict_of(const Judgement& judgement, const Printed& equation) {
  switch (judgement.kind) {
    case Kind::right:
      return "right";
    case Kind::wrong:
    case Kind::words:
      return "wrong";
    case Kind::meaningless:
      return "wrong: " + judgement.trouble;
    case Kind::local:
      return "name";
    case Kind::definition:
      return "definition: " + equation.definition;
    case Kind::excluded:
      return "not judged: " + equation.excluded;
    case Kind::inverse:
      break;
  }
  throw std::logic_error("a joint's equation has a verdict of its own");
}

std::string remarks_on(const Judgement& judgement, const Printed& equation) {
  std::vector<std::string> remarks;
  if (!judgement.slips.empty()) remarks.push_back(fmt::format("{}", fmt::join(judgement.slips, ", ")));
  if (!equation.note.empty()) remarks.push_back(equation.note);
  if (!equation.evidence.empty()) remarks.push_back("words; " + equation.evidence);
  if (judgement.brackets_alone > 0)
    remarks.push_back(
        fmt::format("off by {:.3f} if only the brackets are repaired", judgement.brackets_alone));
  if (!judgement.counterexample.empty()) remarks.push_back("gives " + judgement.counterexample);
  if (judgement.counterexample.empty() && judgement.kind == Kind::wrong)
    remarks.push_back(std::isinf(judgement.error) ? "sides of different kinds or sizes"
                                                  : fmt::format("off by {:.3f}", judgement.error));
  if (!equation.reading.empty()) remarks.push_back("read: " + equation.reading);
  return fmt::format("{}", fmt::join(remarks, "; "));
}

Row row_of(const Judgement& judgement, const Printed& equation) {
  Row row{equation.number, {}, {}, verdict_of(judgement, equation), {}, remarks_on(judgement, equation)};
  if (judgement.kind == Kind::words) {
    row.printed.plain = equation.latex;
    row.right.plain = equation.right;
    return row;
  }
  if (judgement.sides.empty()) {
    const bool formula = equation.latex.find_first_of("\\_^=") != std::string::npos;
    row.printed = {equation.latex, formula ? equation.latex : ""};
    return row;
  }
  // A left side that is no name stands with the rest; exponentials are short as text alone.
  const Tree& left = judgement.sides[0];
  const bool name = plain_text(left).size() <= 14 && latex(left).size() <= 60;
  if (name) row.of = written(judgement.sides[0]);
  row.printed = joined(judgement.sides, name ? 1 : 0);
  if (judgement.right.empty()) return row;
  const bool same_left = plain_text(judgement.right[0]) == row.of.plain;
  row.right = joined(judgement.right, same_left ? 1 : 0);
  return row;
}

/// The joints' equations of one arm, judged at all solutions of its poses.
class JointRows {
 public:
  explicit JointRows(const Arm& arm) : arm_(arm), judge_(arm, inverse_of(arm.robot)) {}

  [[nodiscard]] Row row(std::size_t i, const Judgement& judgement) const {
    Row row = this->row(i);
    row.printed.latex = joined(judgement.sides, 1).latex;
    return row;
  }

  [[nodiscard]] Row row(std::size_t i) const {
    const Formula& formula = arm_.formulas[i];
    const Verdict verdict = judge_.formula(i, formula.printed);
    const bool circular = judge_.circular(i);
    Row row{formula.number,
            {formula.of, {}},
            {formula.printed.written(), {}},
            verdict.text() + (circular ? "; circular" : ""),
            {},
            formula.note};
    if (!verdict.counterexample.empty())
      row.remarks += (row.remarks.empty() ? "" : "; ") + verdict.counterexample;
    if (!verdict.right() || circular) row.right.plain = formula.right.written();
    return row;
  }

  [[nodiscard]] std::size_t place(const std::string& number) const {
    for (std::size_t i = 0; i < arm_.formulas.size(); ++i)
      if (arm_.formulas[i].number == number) return i;
    throw std::runtime_error("no formula " + number + " of " + arm_.robot);
  }

 private:
  const Arm& arm_;
  Judge judge_;
};

const Arm* arm_of(const std::vector<Arm>& arms, const std::string& robot) {
  for (const Arm& arm : arms)
    if (arm.robot == robot) return &arm;
  return nullptr;
}

Table table_of(const Section& section, const std::vector<Arm>& arms) {
  Table table{section.title, section.pages, {}};
  const Arm* arm = section.inverse ? arm_of(arms, section.robot) : nullptr;
  const std::optional<JointRows> joints = arm == nullptr ? std::nullopt : std::optional<JointRows>(*arm);
  const std::vector<Judgement> judgements = judge(section);
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    const Printed& equation = section.equations[i];
    const bool joint = judgements[i].kind == Kind::inverse;
    table.rows.push_back(joint ? joints.value().row(joints->place(equation.number), judgements[i])
                               : row_of(judgements[i], equation));
  }
  return table;
}

Part part_of(const Chapter& chapter, const std::vector<Arm>& arms) {
  Part part{chapter.title, chapter.count, {}};
  for (const Section& section : chapter.sections) part.tables.push_back(table_of(section, arms));
  return part;
}

/// The lecture's steps leave the arm's name open; its joints' equations are transcribed apart.
constexpr const char* planar_lecture = "Inverse kinematics of the planar 3R arm";

void add_arms(const std::string& file, Part& part) {
  for (const Arm& arm : load_inverse_formulas(file)) {
    const JointRows joints(arm);
    Table table{arm.title, "", {}};
    for (std::size_t i = 0; i < arm.formulas.size(); ++i) table.rows.push_back(joints.row(i));
    part.tables.push_back(table);
  }
}

}  // namespace

std::vector<Part> parts() {
  std::vector<Arm> arms = load_inverse_formulas("thesis_inverse.toml");
  for (const Arm& arm : load_inverse_formulas("paden_kahan_inverse.toml")) arms.push_back(arm);
  std::vector<Part> result;
  for (const Chapter& chapter : transcriptions()) {
    result.push_back(part_of(chapter, arms));
    for (Table& table : tables_of_chapter(chapter.prefix)) result.back().tables.push_back(std::move(table));
    if (chapter.title == planar_lecture) add_arms("planar_3r_inverse.toml", result.back());
  }
  return result;
}

}  // namespace qvgen::test::sources
