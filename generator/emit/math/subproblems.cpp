// SPDX-License-Identifier: MIT
#include "emit/math/subproblems.h"

#include <algorithm>
#include <optional>

#include "derive/inverse/attempt.h"
#include "emit/math/tidy.h"
#include "model/private_names.h"

namespace qvgen::emit {
namespace {

using derive::inverse::Attempt;
using derive::inverse::Screw;
using symbolic::cross;
using symbolic::Vector;

/// Points that the sequence rests on: where the wrist's axes meet, and where the first two do, if they do.
struct Points {
  Vector wrist;
  std::optional<Vector> shoulder;
};

bool is_on(const Vector& point, const Screw& axis, const derive::inverse::Scope& scope) {
  return scope.is_zero(cross(axis.axis, point - axis.point));
}

std::optional<Points> points_of(const Attempt& attempt) {
  const auto& screws = attempt.chain.screws;
  const auto& scope = attempt.scope;
  const auto turns = [](const Screw& screw) { return screw.revolute; };
  const bool simple = screws.size() == 6 && std::all_of(screws.begin(), screws.end(), turns) &&
                      attempt.plan.target.outputs().empty();
  if (!simple) return std::nullopt;
  const auto wrist = derive::inverse::meeting_point(screws[3], screws[4], scope);
  if (!wrist || !is_on(*wrist, screws[5], scope) || is_on(*wrist, screws[2], scope)) return std::nullopt;
  if (scope.is_zero(cross(screws[4].axis, screws[5].axis))) return std::nullopt;
  const auto shoulder = derive::inverse::meeting_point(screws[0], screws[1], scope);
  if (shoulder && !is_on(*shoulder, screws[2], scope)) return Points{*wrist, shoulder};
  const bool elbow = scope.is_zero(cross(screws[1].axis, screws[2].axis)) &&
                     !scope.is_zero(cross(screws[0].axis, screws[1].axis)) &&
                     !is_on(screws[1].point, screws[2], scope);
  return elbow ? std::optional(Points{*wrist, std::nullopt}) : std::nullopt;
}

class Sequence {
 public:
  Sequence(const Attempt& attempt, Notation notation) : screws_(attempt.chain.screws), notation_(notation) {}

  std::vector<Passage> write(const Points& points) {
    axes(points);
    points.shoulder ? by_shoulder() : by_parallel_pair();
    wrist();
    return std::move(passages_);
  }

 private:
  void axes(const Points& points) {
    Passage& passage = add(
        "In subproblems of Paden and Kahan: 1, a turn that takes a point to a point; 2, two turns about axes "
        "that meet; 3, a turn that takes a point to a distance from a point",
        "e_i turns about the axis of joint i, of direction omega_i through r_i with all joints at zero; g is "
        "the tool's pose, g_0 that at zero");
    for (std::size_t i = 0; i < 6; ++i) {
      const std::string index = "_" + std::to_string(i + 1);
      define(passage, "omega" + index, screws_[i].axis);
      if (i < 3) define(passage, "r" + index, screws_[i].point);
    }
    define(passage, "W", points.wrist);
    if (points.shoulder) define(passage, "S", *points.shoulder);
    passage.formulas.emplace_back(typeset() ? "P = g g_0^{-1} W" : "P = g g_0^-1 W");
  }

  /// |e_3 W - S| is the distance that the first two joints keep.
  void by_shoulder() {
    step({2}, 3, "about axis 3, that takes W to the distance of P from S, where axes 1 and 2 meet",
         {"|e_3 W - S| = |P - S|"});
    step({0, 1}, 2, "about axes 1 and 2, which meet in S, that take e_3 W to P", {"e_1 e_2 (e_3 W) = P"});
  }

  /// The height along the parallel axes as a distance: from a point one unit along them from axis 1.
  void by_parallel_pair() {
    step({0}, 3,
         "about axis 1, backwards, that takes P to the distance delta from A; axes 2 and 3, parallel, keep "
         "the "
         "height of W along them",
         typeset()
             ? Lines{"A = r_1 + \\omega_2", "\\delta^2 = |P - r_1|^2 - 2 \\omega_2 \\cdot (W - r_1) + 1",
                     "|e_1^{-1} P - A| = \\delta"}
             : Lines{"A = r_1 + omega_2", "delta^2 = |P - r_1|^2 - 2*omega_2.(W - r_1) + 1",
                     "|e_1^-1 P - A| = delta"});
    step({2}, 3, "about axis 3, that takes W to the distance that joint 2 keeps from its axis",
         {typeset() ? "|e_3 W - r_2| = |e_1^{-1} P - r_2|" : "|e_3 W - r_2| = |e_1^-1 P - r_2|"});
    step({1}, 1, "about axis 2, that takes one point to the other",
         {typeset() ? "e_2 (e_3 W) = e_1^{-1} P" : "e_2 (e_3 W) = e_1^-1 P"});
  }

  void wrist() {
    step({3, 4}, 2, "about axes 4 and 5, which meet in W, that take a point of axis 6 to where R has it",
         typeset() ? Lines{"R = e_3^{-1} e_2^{-1} e_1^{-1} g g_0^{-1}",
                           "e_4 e_5 (W + \\omega_6) = R (W + \\omega_6)"}
                   : Lines{"R = e_3^-1 e_2^-1 e_1^-1 g g_0^-1", "e_4 e_5 (W + omega_6) = R (W + omega_6)"});
    step({5}, 1, "about axis 6, that takes a point beside it to where it has to be",
         {typeset() ? "e_6 (W + \\omega_5) = e_5^{-1} e_4^{-1} R (W + \\omega_5)"
                    : "e_6 (W + omega_5) = e_5^-1 e_4^-1 R (W + omega_5)"});
  }

  using Lines = std::vector<std::string>;

  void step(const std::vector<std::size_t>& joints, int subproblem, const std::string& what,
            const Lines& formulas) {
    std::string title;
    for (const std::size_t joint : joints) {
      const std::string name = formula(described(screws_[joint].variable), notation_);
      title += (title.empty() ? "" : ", ") + (typeset() ? "$" + name + "$" : name);
    }
    add(title + ": subproblem " + std::to_string(subproblem) +
            (subproblem == 1 ? ", one value" : ", 2 values"),
        (joints.size() == 1 ? "the turn " : "the turns ") + what)
        .formulas = formulas;
  }

  static std::string described(const std::string& name) {
    return model::is_marked(name) ? model::described_name(name) : name;
  }

  [[nodiscard]] std::string entry(const GiNaC::ex& value) const {
    const dag::Function function = tidy(value);
    return formula(function.graph, function.outputs.front().value, notation_,
                   [&](const std::string& name) { return formula(described(name), notation_); });
  }

  void define(Passage& passage, const std::string& name, const Vector& v) const {
    const std::string entries = entry(v.x) + ", " + entry(v.y) + ", " + entry(v.z);
    const std::string left = name.size() > 1 ? formula(name, notation_) : name;
    passage.formulas.push_back(left + " = " +
                               (typeset() ? "\\langle " + entries + " \\rangle" : "<" + entries + ">"));
  }

  Passage& add(const std::string& title, const std::string& what) {
    std::string sentence = what;
    if (typeset())
      for (const char* name : {"e_i", "e_3 W", "omega_i", "r_i", "g_0"}) {
        const std::size_t at = sentence.find(name);
        if (at == std::string::npos) continue;
        const std::string letters = name;
        sentence.replace(at, letters.size(), (letters[0] == 'o' ? "$\\" : "$") + letters + "$");
      }
    passages_.push_back({0, title, sentence, {}, ""});
    return passages_.back();
  }

  [[nodiscard]] bool typeset() const { return notation_.typeset; }

  const std::vector<Screw>& screws_;
  Notation notation_;
  std::vector<Passage> passages_;
};

}  // namespace

std::vector<Passage> subproblem_passages(const derive::inverse::Derivation& derivation, Notation notation) {
  const derive::inverse::Problem& problem = derivation.problem;
  if (problem.given >= 0 || problem.has_frames || problem.has_phases() || problem.task != model::Task::pose)
    return {};
  const Attempt attempt(problem);
  const auto points = points_of(attempt);
  return points ? Sequence(attempt, notation).write(*points) : std::vector<Passage>{};
}

}  // namespace qvgen::emit
