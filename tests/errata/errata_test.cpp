// SPDX-License-Identifier: MIT
// Every erratum has evidence and a remark; conditions do not need the result of their own step.
#include <algorithm>
#include <cctype>

#include <gtest/gtest.h>

#include "arm_class.h"
#include "condition.h"
#include "counts.h"
#include "patterns.h"
#include "reused_parts.h"
#include "value.h"
#include "verdict.h"

namespace qvgen::test::sources {
namespace {

template <class Check>
void for_each_erratum(const Check& check) {
  for (const Part& part : judged_parts())
    for (const Table& table : errata_of(part).tables)
      for (const Row& row : table.rows) check(table, row);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// True if a row has a number, a reason in its verdict, a circle, or words of the source that contradict it.
bool has_evidence(const Row& row) {
  const std::vector<std::string> evidence{"gives ", "off by ", "sides of different", "words; ",
                                          "by computation: "};
  return row.verdict.rfind("wrong: ", 0) == 0 || has(row.verdict, "circular") ||
         std::any_of(evidence.begin(), evidence.end(),
                     [&](const std::string& e) { return has(row.remarks, e); });
}

/// True if something is said beside numbers and readings: which slip it is.
bool has_remark(const Row& row) {
  std::size_t at = 0;
  while (at < row.remarks.size()) {
    const std::size_t end = std::min(row.remarks.find("; ", at), row.remarks.size());
    const std::string remark = row.remarks.substr(at, end - at);
    const bool number = remark.rfind("gives ", 0) == 0 || remark.rfind("off by ", 0) == 0;
    if (!number && remark.rfind("read: ", 0) != 0) return true;
    at = end + 2;
  }
  return false;
}

TEST(Errata, EachHasEvidenceARemarkAndARightForm) {
  int errata = 0;
  for_each_erratum([&](const Table& table, const Row& row) {
    const std::string place = table.title + ", " + row.number + " " + row.of.plain;
    EXPECT_TRUE(has_evidence(row)) << place << ": " << row.remarks;
    EXPECT_TRUE(has_remark(row)) << place << ": " << row.remarks;
    EXPECT_FALSE(row.right.plain.empty()) << place;
    // A row may be wrong by its left side alone, which the verdict then names.
    const bool named = row.verdict.rfind("wrong: ", 0) == 0;
    EXPECT_TRUE(named || row.right.plain != row.printed.plain) << place;
    EXPECT_FALSE(row.number.empty()) << place << ": a reader cannot find it";
    ++errata;
  });
  EXPECT_EQ(errata, errata_in(judged_parts()));
}

/// No row is in both lists or in none.
TEST(Errata, TheListAndTheRestAreAllRows) {
  for (const Part& part : judged_parts())
    EXPECT_EQ(rows_of(errata_of(part)) + rows_of(rest_of(part)), rows_of(part)) << part.title;
}

/// A condition tells before a step when its equation may be used, so it must not need the step's own result.
TEST(Errata, NoConditionNeedsTheJointThatIsSolvedFor) {
  int conditions = 0;
  for_each_erratum([&](const Table& table, const Row& row) {
    const std::size_t iff = row.verdict.find(" iff ");
    if (iff == std::string::npos) return;
    ++conditions;
    std::string name;
    for (const char c : row.verdict.substr(iff + 5) + " ") {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
        name += c;
        continue;
      }
      EXPECT_FALSE(is_of_joint(name, row.of.plain))
          << table.title << " " << row.number << ": " << row.verdict;
      name.clear();
    }
  });
  EXPECT_GT(conditions, 20);
}

/// One rule for names: a reading closes a bracket or adds a comma, but it does not rename a joint or a
/// length.
TEST(Errata, NoReadingRenames) {
  const std::string renaming = "(theta|[dhl])_?\\d[^;]* read as |printed for ";
  for (const Chapter& chapter : transcriptions())
    for (const Section& section : chapter.sections)
      for (const Printed& equation : section.equations)
        EXPECT_FALSE(patterns::occurs(equation.reading, renaming))
            << equation.number << ": " << equation.reading;
}

/// A name that the arm does not have is wrong, where it is solved for too.
TEST(Errata, NamesThatTheArmDoesNotHave) {
  const auto verdict = [](const std::string& printed) {
    Section section;
    section.robot = "cr";
    section.inverse = true;
    section.equations.push_back({"", printed, "", "", "", "", "", "", false, {}});
    return judge(section).at(0);
  };
  EXPECT_EQ(verdict("d_2 = p_z + d_4 \\cos \\theta_3").kind, Judgement::Kind::inverse);
  EXPECT_EQ(verdict("d_1 = p_z + d_4 \\cos \\theta_3").trouble, "d1 is not a name of this arm");
  EXPECT_EQ(verdict("p_z - d_1 = -d_4 \\cos \\theta_3").trouble, "d1 is not a name of this arm");
}

std::set<std::string> slips(const std::string& printed, const std::string& right) {
  return differences(read_latex(printed), read_latex(right));
}

/// A bracket that closes too early is told from a sign, an index or a function beside it.
TEST(Errata, BracketsAreToldFromOtherSlips) {
  using Names = std::set<std::string>;
  EXPECT_EQ(slips("x = a b + c d", "x = a (b + c d)"), Names{"bracket"});
  EXPECT_EQ(slips("x = a b - c d", "x = a (b + c d)"), (Names{"bracket", "sign"}));
  EXPECT_EQ(slips("x = a \\sin \\theta_1 + c d", "x = a (\\cos \\theta_1 + c d)"),
            (Names{"bracket", "function"}));
  EXPECT_EQ(slips("x = a b + c_1 d", "x = a (b + c_2 d)"), (Names{"bracket", "index"}));
  EXPECT_EQ(slips("x = a b + c", "x = a (b + c d)"), Names{"form"});
}

/// The printed signs and factors in the right brackets: what is left is what the brackets alone do not
/// repair.
TEST(Errata, BracketsAloneAreRepaired) {
  for (const Chapter& chapter : transcriptions())
    for (const Section& section : chapter.sections)
      for (const Judgement& judgement : judgements_of(section)) {
        const bool brackets = judgement.slips.count("bracket") > 0;
        const bool more = brackets && judgement.slips.size() > 1;
        EXPECT_EQ(judgement.brackets_alone > 1e-9, more)
            << section.title << " " << latex(judgement.sides.at(0));
      }
}

/// The classes that the arms' axes give are the thesis's own for the arms whose rows of the two tables agree.
TEST(Errata, WorkspacesByAxes) {
  EXPECT_EQ(class_of("ss").workspace(), "prismatic");
  EXPECT_EQ(class_of("rs").workspace(), "cylindrical");
  EXPECT_EQ(class_of("nn").workspace(), "spherical");
  EXPECT_EQ(class_of("rn").relations, "parallel, perpendicular");
  EXPECT_EQ(class_of("cr").joints, "theta1 turns, d2 slides, theta3 turns");
}

}  // namespace
}  // namespace qvgen::test::sources
