// SPDX-License-Identifier: MIT
#include "emit/inverse/steps.h"

#include <array>

#include "derive/inverse/names.h"
#include "emit/inverse/backend.h"
#include "emit/inverse/target.h"
#include "emit/math/describe.h"
#include "emit/template_values.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;
namespace kind = derive::inverse::kind;

using ast::Expression;
using ast::Function;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using nlohmann::json;
using Call = TreeBackend::Call;

namespace {

int joint_of(const model::Robot& robot, const std::string& variable) {
  int joint = 0;
  while (robot.joints[static_cast<std::size_t>(joint)].variable != variable) ++joint;
  return joint;
}

std::vector<std::string> triples(const std::string& name, std::size_t count) {
  std::vector<std::string> list;
  for (std::size_t i = 1; i <= count; ++i) list.push_back(name + std::to_string(i));
  return list;
}

/// Newton's steps with the joints that they move, and the values they change in place.
ast::Polish polish_task(const model::Robot& robot, const LoweredPlan& plan, const kind::Newton& newton) {
  ast::Polish task;
  const Expression w = work(), zero = ast::real("0");
  for (std::size_t i = 0; i < newton.variables.size(); ++i) {
    const std::string& variable = newton.variables[i];
    const int index = joint_of(robot, variable);
    const auto& joint = plan.plan.joints[static_cast<std::size_t>(index)];
    const Expression cosine = ast::member(w, joint.cosine), sine = ast::member(w, joint.sine);
    const Expression value = ast::entry(ast::name("values", {"JointValues"}, ast::Reach::reference),
                                        ast::whole(static_cast<int>(i)));
    task.revolute.push_back(joint.revolute);
    task.from.push_back(ast::rotor(cosine, joint.revolute ? sine : zero));
    task.seed.push_back(joint.revolute ? seed_turn(plan, index) : ast::rotor(seed_slide(plan, index), zero));
    task.back.push_back(ast::assign(cosine, ast::member(value, "cosine")));
    if (joint.revolute) task.back.push_back(ast::assign(sine, ast::member(value, "sine")));
    for (const Step& other : plan.plan.steps)
      if (other.keeps_length() && other.unknown == variable)
        task.back.push_back(ast::assign(length_place(w, other.unknown), ast::real("1")));
  }
  task.axes = triples("axis", newton.variables.size());
  task.points = triples("point", newton.variables.size());
  task.start = triples("start", static_cast<std::size_t>(newton.points));
  task.goal = triples("goal", static_cast<std::size_t>(newton.points));
  task.size_square = ast::convert(ast::member(target(), "size_square"));
  return task;
}

/// Values that a step leaves besides those of its program.
ast::Statements further(const Step& step) {
  ast::Statements result;
  const Expression found = ast::name("result");
  if (step.wrist() != nullptr && !step.ends_plan()) {
    const std::array<const char*, 3> parts = {"first", "middle", "last"};
    for (std::size_t i = 0; i < 3; ++i) {
      const Expression part = ast::member(found, parts[i]);
      const std::string& variable = step.wrist()->variables[i];
      result.push_back(
          ast::assign(ast::member(work(), names::cosine(variable)), ast::member(part, "cosine")));
      result.push_back(ast::assign(ast::member(work(), names::sine(variable)), ast::member(part, "sine")));
    }
  }
  if (step.is<kind::TwoTurns>())
    result.push_back(
        ast::guard(ast::member(found, "meets"),
                   {ast::Statement::Kind::assign, "", {}, {mark(work(), "unsure"), ast::truth(true)}}));
  if (step.is<kind::SlideTurn>())
    result.push_back(ast::guard(ast::member(found, "chosen"),
                                {ast::Statement::Kind::assign,
                                 "",
                                 {},
                                 {mark(work(), "continuum"), mark(work(), "doubtful"), ast::truth(true)}}));
  return result;
}

ast::Statements inputs(const ast::Straight& before) {
  ast::Statements result = ast::declarations(before.temporaries);
  ast::append(result, ast::declarations(before.outputs));
  return result;
}

ast::Statements kept(const ast::Straight& after) {
  ast::Statements result = ast::declarations(after.temporaries);
  for (const ast::Straight::Value& value : after.outputs)
    result.push_back(ast::assign(ast::member(work(), value.name), value.expression));
  return result;
}

/// The angle in the middle of an oblique wrist is measured from delta.
ast::Statements oblique_angles(const Expression& call) {
  const Expression middle = ast::member(ast::name("angles"), "middle");
  const Expression delta = ast::angle(ast::name("cosine_delta"), ast::name("sine_delta"));
  const Expression from_delta = ast::convert(ast::sum({middle, ast::negative(delta)}));
  ast::Statement angles = ast::declare({"WristAngles"}, "angles");
  angles.values = {call};
  return {angles,
          ast::assign(middle, ast::call(Expression::Kind::runtime, "wrapped", {from_delta, ast::pi()})),
          ast::give(ast::name("angles"))};
}

bool takes_sign(const Step& step) {
  return step.branches == 2 && (!step.ends_plan() || step.is<kind::ObliqueWrist>());
}

ast::Statements solving(const Step& step, const ast::Statements& before, const Call& call) {
  ast::Statements result;
  if (!call.first.empty() && !step.ends_plan()) {
    ast::Statements block = before;
    block.push_back(ast::assign(ast::name("result"), call.second));
    return {ast::declare({call.first}, "result"), ast::scope(block)};
  }
  result = {ast::gap()};
  ast::append(result, before);
  if (step.ends_plan()) result.push_back(ast::gap());
  if (!step.ends_plan()) {
    if (call.second.kind != Expression::Kind::nothing) result.push_back(ast::evaluate(call.second));
  } else if (takes_sign(step)) {
    ast::append(result, oblique_angles(call.second));
  } else {
    result.push_back(ast::give(call.second));
  }
  return result;
}

class StepFunctions {
 public:
  StepFunctions(const model::Robot& robot, const LoweredPlan& plan, std::size_t index)
      : robot_(robot),
        plan_(plan),
        step_(plan.plan.steps[index]),
        name_(step_name(plan, index)),
        comment_(step_comment(plan, index)),
        before_(inputs(ast::straight(plan.steps[index].before, step_leaves(robot, plan, step_)))),
        after_(kept(ast::straight(plan.steps[index].after, step_leaves(robot, plan, step_)))) {}

  [[nodiscard]] std::vector<Function> write() const {
    const TreeBackend backend(plan_);
    const Call call = std::visit([&](const auto& kind) { return kind.apply(step_, backend); }, step_.kind);
    if (const auto* newton = step_.as<kind::Newton>()) return {polish(*newton)};
    if (step_.is_quartic()) return {roots(call), take()};
    return {solve(call)};
  }

 private:
  [[nodiscard]] Function solve(const Call& call) const {
    const std::string result = step_.ends_plan() ? call.first : "";
    Function function{Function::Role::solve, comment_, {result}, "solve_" + name_};
    function.parameters = {target_};
    if (takes_sign(step_)) function.parameters.push_back({{"real"}, "sign"});
    function.parameters.push_back(work_);
    function.body = solving(step_, before_, call);
    ast::Statements left = further(step_);
    ast::append(left, after_);
    if (!left.empty()) function.body.push_back(ast::gap());
    ast::append(function.body, left);
    return function;
  }

  [[nodiscard]] Function roots(const Call& call) const {
    Function function{Function::Role::roots, comment_, {call.first}, "roots_" + name_};
    function.parameters = {target_, {{"Work"}, "w"}};
    function.body = before_;
    function.body.push_back(ast::give(call.second));
    return function;
  }

  [[nodiscard]] Function take() const {
    const std::string root = step_.is<kind::SlideTurn>()  ? "SlideTurn"
                             : step_.is<kind::TwoTurns>() ? "TurnPair"
                                                          : "Rotor";
    Function function{Function::Role::take, {}, {}, "take_" + name_};
    function.parameters = {target_, {{root}, "result"}, work_};
    function.body = further(step_);
    if (!function.body.empty()) function.body.push_back(ast::gap());
    ast::append(function.body, after_);
    return function;
  }

  [[nodiscard]] Function polish(const kind::Newton& newton) const {
    Function function{Function::Role::polish, comment_, {"bool"}, "solve_" + name_};
    const std::string tracker = plan_.plan.searches_nearby() ? "Visited" : "Tracker";
    function.parameters = {target_, {{"int"}, "label"}, {{tracker}, "tracker", true}, work_};
    function.body = before_;
    function.task = polish_task(robot_, plan_, newton);
    return function;
  }

  const model::Robot& robot_;
  const LoweredPlan& plan_;
  const Step& step_;
  std::string name_;
  std::vector<std::string> comment_;
  ast::Statements before_, after_;
  Function::Parameter target_{{"Target"}, "t"}, work_{{"Work"}, "w", true};
};

}  // namespace

std::vector<Function> step_functions(const model::Robot& robot, const LoweredPlan& plan, std::size_t step) {
  return StepFunctions(robot, plan, step).write();
}

json step_values(const model::Robot& robot, const LoweredPlan& plan, const ast::Printer& language) {
  json functions = json::array();
  for (std::size_t i = 0; i < plan.steps.size(); ++i)
    for (const Function& function : step_functions(robot, plan, i))
      functions.push_back({{"in_lanes", function.role == Function::Role::solve},
                           {"lines", lines_of(language.function(function))}});
  return functions;
}

std::vector<std::string> work_fields(const LoweredPlan& plan) {
  std::vector<std::string> fields;
  for (const Step& step : plan.plan.steps) {
    if (step.ends_plan()) continue;
    if (const auto* wrist = step.wrist())
      for (const std::string& variable : wrist->variables)
        for (const char* part : {"cos_", "sin_"}) fields.push_back(part + variable);
    fields.insert(fields.end(), step.kept.begin(), step.kept.end());
    if (step.keeps_length()) fields.push_back(names::length(step.unknown));
  }
  return fields;
}

}  // namespace qvgen::emit
