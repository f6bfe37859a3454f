// SPDX-License-Identifier: MIT
#include "emit/inverse/target.h"

#include <algorithm>
#include <stdexcept>

#include "derive/inverse/divisors.h"
#include "derive/inverse/names.h"
#include "emit/ast/angle.h"
#include "emit/ast/literal.h"
#include "emit/inverse/places.h"
#include "emit/leaves.h"
#include "emit/template_values.h"
#include "exact/named_constant.h"
#include "model/private_names.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;
namespace kind = derive::inverse::kind;

using ast::Expression;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using nlohmann::json;

std::map<std::string, std::string> geometry_fields(const model::Robot& robot) {
  std::map<std::string, std::string> fields;
  for (const auto& parameter : robot.geometry) fields[parameter.name] = model::described_name(parameter.name);
  // The only symbol without a mark is a held joint's.
  for (auto& [name, field] : fields)
    if (!model::is_marked(name)) field = "given_";
  std::size_t index = 0;
  for (const auto& definition : robot.definitions)
    fields[definition.first] = "defined_" + std::to_string(++index) + "_";
  return fields;
}

namespace {

/// Results of a step's block, by the names that programs have for them.
std::map<std::string, Expression> results_of(const Step& step) {
  const Expression result = ast::name("result");
  const bool is_pair = step.is<kind::TwoTurns>();
  const Expression turn = step.is<kind::SlideTurn>() ? ast::member(result, "turn")
                          : is_pair                  ? ast::member(result, "first")
                                                     : result;
  const Expression second = is_pair ? ast::member(result, "second") : turn;
  const Expression cosine = ast::member(turn, "cosine"), sine = ast::member(turn, "sine");
  const Expression length =
      step.keeps_length()
          ? ast::grouped(ast::product({ast::name("sign"), length_place(work(), step.unknown)}))
      : step.is<kind::SlideTurn>() ? ast::member(result, "slide")
                                   : result;
  return {{names::cosine_result, cosine},
          {names::sine_result, sine},
          {names::result_1, ast::member(second, "cosine")},
          {names::result_2, ast::member(second, "sine")},
          {names::result, length}};
}

}  // namespace

ast::Leaves step_leaves(const model::Robot& robot, const LoweredPlan& plan, const Step& step) {
  const auto symbol = [fields = geometry_fields(robot), kept = plan.plan.target_kept,
                       results = results_of(step)](const std::string& name) -> Expression {
    if (const auto constant = exact::named_value(name)) return ast::real(literal(exact::Number(*constant)));
    if (const auto field = fields.find(name); field != fields.end())
      return ast::convert(geometry(target(), field->second));
    if (const auto result = results.find(name); result != results.end()) return result->second;
    if (std::find(kept.begin(), kept.end(), name) != kept.end())
      return ast::convert(ast::member(target(), name));
    return ast::member(work(), name);
  };
  const auto constant = [](std::string (*literal_of)(const exact::Angle&)) {
    return [literal_of](const dag::Angle& angle) -> Expression {
      const std::string text = literal_of(angle);
      if (text.empty()) throw std::logic_error("inverse kinematics: angle " + to_string(angle));
      return ast::real(text);
    };
  };
  return {symbol, constant(sine_literal), constant(cosine_literal)};
}

namespace {

/// Sines of twists that are symbols, and of a joint that is held, computed before the rest.
class TargetCode {
 public:
  TargetCode(const model::Robot& robot, const LoweredPlan& plan)
      : robot_(robot), plan_(plan), fields_(geometry_fields(robot)), angles_(angles_of(plan.target)) {}

  [[nodiscard]] ast::Straight write() const {
    const auto symbol_of = [this](const std::string& name) { return symbol(name); };
    const auto named = [this](const std::string& function) {
      return [this, function](const dag::Angle& angle) { return ast::name(name(function, angle)); };
    };
    ast::Straight code = ast::straight(plan_.target, {symbol_of, named("sin"), named("cos")});
    std::vector<ast::Straight::Value> sines;
    for (const dag::Angle& angle : angles_)
      for (const char* function : {"sin", "cos"})
        if (ast::mentions(code, name(function, angle)))
          sines.push_back({name(function, angle), ast::call(Expression::Kind::mathematical, function,
                                                            {ast::angle_value(angle, symbol_of)})});
    code.temporaries.insert(code.temporaries.begin(), sines.begin(), sines.end());
    return code;
  }

 private:
  [[nodiscard]] Expression symbol(const std::string& name) const {
    if (const auto constant = exact::named_value(name)) return ast::name(literal(exact::Number(*constant)));
    const auto field = fields_.find(name);
    return field != fields_.end() ? geometry(target(), field->second) : ast::name(name);
  }

  [[nodiscard]] std::string name(const std::string& function, const dag::Angle& angle) const {
    const auto place =
        static_cast<std::size_t>(std::find(angles_.begin(), angles_.end(), angle) - angles_.begin());
    std::string of = angle_name(robot_, angle, place);
    if (const auto mark = of.find("g."); mark != std::string::npos) of.erase(mark, 2);
    return function + (of.front() == '_' ? "" : "_") + of;
  }

  const model::Robot& robot_;
  const LoweredPlan& plan_;
  std::map<std::string, std::string> fields_;
  std::vector<dag::Angle> angles_;
};

/// Names of the pose's values, any of which a target may read.
std::vector<std::string> pose_names() {
  std::vector<std::string> result{names::pose_scale};
  for (const char* part : {"_w", "_x", "_y", "_z"})
    for (const char* quaternion : {names::pose_given, names::pose_quaternion})
      result.push_back(std::string(quaternion) + part);
  for (const char* part : {"_x", "_y", "_z"}) result.push_back(std::string(names::pose_position) + part);
  return result;
}

}  // namespace

json target_values(const model::Robot& robot, const LoweredPlan& plan, const ast::Printer& language) {
  const ast::Straight code = TargetCode(robot, plan).write();
  json values = values_of(code, language);
  values["reads"] = json::array();
  for (const std::string& name : pose_names())
    if (ast::mentions(code, name)) values["reads"].push_back(name);
  return values;
}

json range_test_values(const model::Robot& robot, const LoweredPlan& plan, const ast::Printer& language) {
  const derive::inverse::RangeTest& test = plan.plan.range_test;
  if (!test.exists()) return false;
  const ast::Straight code = ast::straight(plan.range_test, step_leaves(robot, plan, {}));
  return {{"unknown", test.unknown}, {"equation", test.equation}, {"values", values_of(code, language)}};
}

json divisor_values(const model::Robot& robot, const LoweredPlan& plan) {
  json divisors = json::array();
  for (const auto& [name, field] : geometry_fields(robot)) {
    if (!derive::inverse::divides_by(plan.plan, name)) continue;
    const auto definition = robot.definitions.find(name);
    const std::string text = definition == robot.definitions.end()
                                 ? field
                                 : model::without_marks(model::to_string(definition->second));
    divisors.push_back({{"field", field}, {"text", text}, {"last", false}});
  }
  if (!divisors.empty()) divisors.back()["last"] = true;
  return divisors;
}

}  // namespace qvgen::emit
