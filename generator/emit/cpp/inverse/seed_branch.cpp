// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/seed_branch.h"

#include <algorithm>

#include "emit/cpp/inverse/joint_code.h"
#include "emit/cpp/inverse/step_code.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

/// The joints that tell how far a step's branch is from the seed: also one that a later step writes out.
std::vector<int> joints_of(const Step& step) {
  std::vector<int> joints = step.joints();
  if (const auto* both = step.as<kind::SlideTurn>()) joints.push_back(both->slide);
  return joints;
}

bool chooses(const Step& step) { return step.is_quartic() || step.branches > 1; }

class SeedBranch {
 public:
  SeedBranch(const LoweredPlan& plan, Pass pass, const Dialect& dialect)
      : plan_(plan), careful_(pass == Pass::careful), dialect_(dialect) {}

  std::vector<std::string> write() {
    lines(dialect_.new_work("w", true));
    line(dialect_.new_row(plan_.plan.row_size));
    if (plan_.plan.given >= 0)
      line("q[" + std::to_string(plan_.plan.given) + "] = " + dialect_.member("t", "geometry.given_") + ";");
    const auto order = derive::inverse::order(plan_.plan, careful_);
    for (const std::size_t i : order) step(i);
    for (const std::size_t i : order)
      if (!plan_.plan.steps[i].ends_plan())
        for (const std::string& text : joint_lines(plan_, plan_.plan.steps[i], work_, dialect_)) line(text);
    line(dialect_.append_nearest(work_));
    line(leave());
    return std::move(lines_);
  }

 private:
  [[nodiscard]] std::string call(std::size_t i, const std::string& sign, const std::string& work) const {
    return step_call(plan_, i, sign, work, target_, dialect_);
  }
  [[nodiscard]] std::string leave() const {
    return careful_ ? "return;" : "return !" + dialect_.member(work_, "branch.doubtful") + ";";
  }
  void line(const std::string& text) { lines_.push_back(text); }
  void lines(const std::vector<std::string>& texts) {
    lines_.insert(lines_.end(), texts.begin(), texts.end());
  }
  [[nodiscard]] std::string place(int joint) const {
    return std::to_string(plan_.plan.places[static_cast<std::size_t>(joint)]);
  }

  [[nodiscard]] std::string seed(const std::string& what, int joint) const {
    return dialect_.member("t", "preference->" + what + "[" + place(joint) + "]");
  }
  [[nodiscard]] std::string branch_of(const std::string& work) const {
    return dialect_.reference(dialect_.member(work, "branch"));
  }

  /// Squared distance of a step's joints from the seed's.
  [[nodiscard]] std::string apart(const Step& step, const std::string& work) const {
    std::string sum;
    for (const int joint : joints_of(step)) {
      const auto& value = plan_.plan.joints[static_cast<std::size_t>(joint)];
      const std::string cosine = dialect_.member(work, value.cosine);
      const std::string term =
          value.revolute ? dialect_.turn_apart(cosine, dialect_.member(work, value.sine), seed("turn", joint))
                         : dialect_.slide_apart(cosine, seed("slide", joint));
      sum += (sum.empty() ? "" : " + ") + term;
    }
    return sum;
  }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.is<kind::Newton>()) return polished(i);
    if (step.ends_plan()) return wrist(i);
    if (step.is_quartic()) return quartic(i);
    if (step.branches == 1) {
      line(call(i, "", work_) + ";");
      if (step.is<kind::Require>()) leave_without_branch();
      return;
    }
    const std::string other = "other" + std::to_string(choices_++);
    lines(dialect_.copied_work(other, "w"));
    line(call(i, "1.0", "w") + ";");
    line(call(i, "-1.0", other) + ";");
    line(dialect_.take_nearer(other, apart(step, other), "w", apart(step, "w")));
    leave_without_branch();
  }

  void leave_without_branch() { line("if (!" + dialect_.member(work_, "branch.exists") + ") " + leave()); }

  void quartic(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    const std::string number = std::to_string(choices_++);
    const std::string each = "each" + number;
    line(quartic_roots(plan_, i, dialect_));
    lines(dialect_.nearest_root(number, take_root(plan_, i, "k" + number, each, dialect_), apart(step, each),
                                step.branches));
    leave_without_branch();
    line(dialect_.member("w", "branch.unsure") + " = true;");
  }

  void polished(std::size_t i) {
    lines(dialect_.copied_work("p", "w"));
    work_ = "p";
    target_ = "goal";
    line("if (!" + dialect_.polishes(step_name(plan_, i), target_, "0", "p", true) + ") return;");
  }

  void wrist(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    const auto& joints = step.wrist()->joints;
    const Dialect::Arguments seeds{seed("angle", joints[0]), seed("angle", joints[1]),
                                   seed("angle", joints[2])};
    const auto takes_other = [&](const std::string& other_work, const std::string& other,
                                 const std::string& one) {
      return "const bool is_other = " +
             dialect_.takes_other(branch_of(other_work), dialect_.wrist_apart(other, seeds), branch_of(work_),
                                  dialect_.wrist_apart(one, seeds)) +
             ";";
    };
    if (step.is<kind::ObliqueWrist>()) {
      lines(dialect_.copied_work("other", work_));
      line(dialect_.variable("WristAngles", "angles", call(i, "1.0", work_)));
      line(dialect_.constant("WristAngles", "others", call(i, "-1.0", "other")));
      line(takes_other("other", "others", "angles"));
      line("if (is_other) angles = others;");
      line("if (is_other) " + dialect_.assign_work(work_, "other"));
      leave_without_branch();
    } else {
      line(dialect_.constant("WristBranches", "both", call(i, "", work_)));
      line(takes_other(work_, "both.other", "both.one"));
      line(dialect_.chosen("WristAngles", "angles", "is_other ? both.other : both.one"));
    }
    line(joint_place(plan_.plan, joints[0]) + " = angles.first;");
    line(joint_place(plan_.plan, joints[1]) + " = angles.middle;");
    line(joint_place(plan_.plan, joints[2]) + " = angles.last;");
  }

  const LoweredPlan& plan_;
  bool careful_;
  const Dialect& dialect_;
  std::string work_ = "w";
  std::string target_ = "t";
  std::vector<std::string> lines_;
  int choices_ = 0;
};

}  // namespace

std::vector<std::string> seed_branch_lines(const LoweredPlan& plan, Pass pass, const Dialect& dialect) {
  return SeedBranch(plan, pass, dialect).write();
}

bool has_seed_branch(const LoweredPlan& plan) {
  const auto& steps = plan.plan.steps;
  return std::all_of(steps.begin(), steps.end(),
                     [&](const Step& step) { return !chooses(step) || !joints_of(step).empty(); });
}

}  // namespace qvgen::emit
