// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "errata.h"

namespace qvgen::test::errata {
namespace {

constexpr const char* introduction = R"(# Printed inverse kinematics, checked

Written by `qvgen_errata_table` from the formulas as printed (`*.toml` of this folder) and the generated inverse kinematics;
a test compares. Each formula is judged by itself, everything that it refers to having its true value, at every solution of
100 random poses of arms of random lengths: "right", right iff a condition holds (a branch is lost or a sign left out; the
shortest one that holds at exactly those solutions, or else their share), or "wrong". "Right with one sign, which it does not tell": its other sign gives a value that no solution with the
same earlier joints has. "Circular": it needs a joint that is itself computed from this one.

Notation: `pm`, `pm2` are printed signs ± or ∓; `c1`, `s1` cosine and sine of theta1, `hc1`, `hs1` of its half; `w, a, b, c` the
pose's quaternion, `px, py, pz` its position, `phi` its angle about z, `r11`... its rotation matrix; `N41`...`N44` the
quaternion left for the wrist, `w11`... its matrix. Names of the sources that would clash have an underscore: `a_`, `c_`.
)";

const InverseUnderTest& robot_of(const std::string& name) {
  for (const InverseUnderTest& robot : inverses())
    if (robot.name == name) return robot;
  throw std::runtime_error("no inverse kinematics of " + name);
}

std::string row(const std::string& number, const std::string& of, const std::string& printed,
                const std::string& verdict, const std::string& right) {
  return "| " + number + " | " + of + " | `" + printed + "` | " + verdict + " | " +
         (right.empty() ? "" : "`" + right + "`") + " |\n";
}

std::string rows(const Arm& arm) {
  const Judge judge(arm, robot_of(arm.robot));
  std::string text =
      "\n### " + arm.title + "\n\n| equation | of | printed | verdict | right |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < arm.quaternion.printed.size(); ++i) {
    const Verdict verdict = judge.quaternion(i, arm.quaternion.printed);
    text += row(arm.quaternion.number, "N4" + std::to_string(i + 1), arm.quaternion.printed[i],
                verdict.text(), verdict.right() ? "" : arm.quaternion.right[i]);
  }
  for (std::size_t i = 0; i < arm.formulas.size(); ++i) {
    const Formula& formula = arm.formulas[i];
    const Verdict verdict = judge.formula(i, formula.printed);
    const bool circular = judge.circular(i);
    std::string said = verdict.text() + (circular ? "; circular" : "");
    if (!formula.note.empty()) said += " (" + formula.note + ")";
    const bool enough = verdict.right() && !circular;
    text += row(formula.number, formula.of, formula.printed.written(), said,
                enough ? "" : formula.right.written());
  }
  return text;
}

}  // namespace

std::string table() {
  std::string text = introduction;
  for (const Source& source : sources()) {
    text += "\n## " + source.name + "\n";
    for (const Arm& arm : source.arms) text += rows(arm);
  }
  return text;
}

}  // namespace qvgen::test::errata
