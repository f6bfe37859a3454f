// SPDX-License-Identifier: MIT
#include "inverse_formulas.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "condition.h"

namespace qvgen::test::sources {
namespace {

constexpr int poses = 100;
constexpr double tolerance = 1e-6;

double root(double x) {
  // A root that is zero by identity must not fail over its rounding.
  return std::sqrt(x < 0 && x > -1e-9 ? 0 : x);
}

const reference::Functions& functions() {
  using Arguments = std::vector<double>;
  static const reference::Functions all{
      {"sqrt", [](const Arguments& x) { return root(x.at(0)); }},
      {"sin", [](const Arguments& x) { return std::sin(x.at(0)); }},
      {"cos", [](const Arguments& x) { return std::cos(x.at(0)); }},
      {"acos", [](const Arguments& x) { return std::acos(x.at(0)); }},
      {"atan", [](const Arguments& x) { return std::atan(x.at(0)); }},
      {"atan2", [](const Arguments& x) { return std::atan2(x.at(0), x.at(1)); }},
      {"sign", [](const Arguments& x) { return x.at(0) < 0 ? -1.0 : 1.0; }}};
  return all;
}

/// The values with each choice of the signs that occur.
std::vector<double> all_values(const Text& text, reference::Values values) {
  std::vector<double> result;
  const std::set<std::string> names = text.names();
  for (const double first : {1.0, -1.0}) {
    for (const double second : {1.0, -1.0}) {
      if ((first < 0 && names.count("pm") == 0) || (second < 0 && names.count("pm2") == 0)) continue;
      values["pm"] = first;
      values["pm2"] = second;
      result.push_back(value_of(text, values));
    }
  }
  return result;
}

/// Returns an angle between minus and plus half a turn; other values as they are.
double shown(double value, bool turns) { return turns ? std::remainder(value, 2 * pi) : value; }

/// "gives 0.312 or -0.312 for 0.624"
std::string counterexample(const std::vector<double>& given, double wanted, bool turns) {
  std::vector<std::string> numbers;
  for (const double value : given) {
    const std::string text = std::isnan(value) ? "no real value" : fmt::format("{:.3f}", shown(value, turns));
    if (std::find(numbers.begin(), numbers.end(), text) == numbers.end()) numbers.push_back(text);
  }
  return fmt::format("gives {} for {:.3f}", fmt::join(numbers, " or "), shown(wanted, turns));
}

void add_entries(const std::string& prefix, const Eigen::Matrix3d& r, reference::Values& values) {
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) values[prefix + std::to_string(i + 1) + std::to_string(k + 1)] = r(i, k);
}

/// Returns the values that formulas may refer to, at one solution of a pose.
reference::Values values_at(const Case& test, const Eigen::VectorXd& q, const Eigen::Isometry3d& tool) {
  reference::Values values = test.robot().geometry;
  const Eigen::Quaterniond pose(tool.linear());
  values.insert({{"w", pose.w()}, {"a", pose.x()}, {"b", pose.y()}, {"c", pose.z()}});
  values.insert(
      {{"px", tool.translation().x()}, {"py", tool.translation().y()}, {"pz", tool.translation().z()}});
  values["phi"] = std::atan2(tool.linear()(1, 0), tool.linear()(0, 0));
  add_entries("r", tool.linear(), values);
  for (int i = 0; i < test.dof(); ++i) {
    const std::string& name = test.chain().joints[static_cast<std::size_t>(i)].variable;
    values[name] = q[i];
    if (name.rfind("theta", 0) != 0) continue;
    const std::string digit = name.substr(5);
    values["c" + digit] = std::cos(q[i]);
    values["s" + digit] = std::sin(q[i]);
    values["hc" + digit] = std::cos(q[i] / 2);
    values["hs" + digit] = std::sin(q[i] / 2);
  }
  if (test.dof() < 6) return values;
  const Eigen::Matrix3d wrist = reference::frames(test.chain(), q)[2].linear().transpose() * tool.linear();
  const Eigen::Quaterniond n(wrist);
  values.insert({{"N41", n.w()}, {"N42", n.x()}, {"N43", n.y()}, {"N44", n.z()}});
  add_entries("w", wrist, values);
  return values;
}

}  // namespace

double value_of(const Text& text, reference::Values values) {
  for (const std::string& definition : text.where) {
    const std::size_t equals = definition.find(" = ");
    values[definition.substr(0, equals)] =
        reference::evaluate(definition.substr(equals + 3), values, functions());
  }
  return reference::evaluate(text.value, values, functions());
}

namespace {

/// Adds to one solution's values those of the expressions that a formula proposes for its condition.
reference::Values with_signs(const Formula& formula, reference::Values values) {
  for (const std::string& sign : formula.signs) values[sign] = value_of({{}, sign}, values);
  return values;
}

}  // namespace

std::string Text::written() const {
  std::string result = value;
  for (std::size_t i = 0; i < where.size(); ++i) result += (i == 0 ? ", where " : ", ") + where[i];
  return result;
}

std::set<std::string> Text::names() const {
  std::set<std::string> result;
  std::string name;
  for (const char c : written() + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      name += c;
      continue;
    }
    if (!name.empty()) result.insert(name);
    name.clear();
  }
  return result;
}

std::string Verdict::text() const {
  if (reached == 0) return "wrong";
  if (!condition.empty()) return "right iff " + condition;
  if (reached < solutions)
    return "right for " + std::to_string(100 * reached / solutions) + " % of the solutions";
  return spurious == 0 ? "right" : "right with one sign, which it does not tell";
}

const InverseUnderTest& inverse_of(const std::string& robot) {
  for (const InverseUnderTest& inverse : inverses())
    if (inverse.name == robot) return inverse;
  throw std::runtime_error("no inverse kinematics of " + robot);
}

Judge::Judge(const Arm& arm, const InverseUnderTest& robot) : arm_(arm), case_(robot) {
  for (unsigned number = 1; places_.size() < poses; ++number) {
    InverseUnderTest other = robot;
    for (const std::string& name : robot.constants) other.geometry[name] = case_.uniform(0.1, 1);
    Case drawn(other);
    drawn.seed(number);
    for (int i = 0; i < 10 && places_.size() < poses; ++i) add_pose(drawn);
  }
}

void Judge::add_pose(Case& drawn) {
  const Eigen::VectorXd q = drawn.joints();
  const Eigen::Isometry3d tool = drawn.tool(q);
  const Found found = drawn.solve(q);
  if (found.status != Status::solved || static_cast<int>(found.rows.size()) < drawn.robot().info.capacity)
    return;
  Place place;
  for (const Row& row : found.rows) {
    place.solutions.push_back(row.q);
    place.values.push_back(values_at(drawn, row.q, tool));
  }
  places_.push_back(std::move(place));
}

int Judge::joint(const std::string& name) const {
  for (int i = 0; i < case_.dof(); ++i)
    if (case_.chain().joints[static_cast<std::size_t>(i)].variable == name) return i;
  return -1;
}

std::set<int> Judge::joints_in(const Text& text) const {
  std::set<int> result;
  for (const std::string& name : text.names()) {
    for (const std::string prefix : {"", "c", "s", "hc", "hs"}) {
      const bool shorthand = !prefix.empty() && name.rfind(prefix, 0) == 0;
      const int found = joint(shorthand ? "theta" + name.substr(prefix.size()) : name);
      if (found >= 0) result.insert(found);
    }
    if (name.size() == 3 && (name[0] == 'N' || name[0] == 'w')) result.insert({0, 1, 2});
  }
  return result;
}

bool Judge::judge(const Place& place, std::size_t solution, const std::string& of, const Text& text,
                  const std::set<int>& known, Verdict& verdict) const {
  const int own = joint(of);
  const bool turns = own >= 0 && case_.revolute(own);
  const auto same = [&](double x, double y) {
    return std::abs(turns ? std::remainder(x - y, 2 * pi) : x - y) < tolerance;
  };
  const auto target = [&](std::size_t i) { return value_of({{}, of}, place.values[i]); };
  const auto alike = [&](std::size_t i) {
    const Eigen::VectorXd way = case_.difference(place.solutions[i], place.solutions[solution]);
    return std::all_of(known.begin(), known.end(), [&](int k) { return std::abs(way[k]) < tolerance; });
  };
  bool reached = false;
  bool spurious = false;
  const std::vector<double> given = all_values(text, place.values[solution]);
  for (const double value : given) {
    if (std::isnan(value)) continue;
    reached = reached || same(value, target(solution));
    bool true_somewhere = false;
    for (std::size_t i = 0; i < place.solutions.size(); ++i)
      true_somewhere = true_somewhere || (alike(i) && same(value, target(i)));
    spurious = spurious || !true_somewhere;
  }
  ++verdict.solutions;
  verdict.reached += reached ? 1 : 0;
  verdict.spurious += spurious ? 1 : 0;
  if ((!reached || spurious) && verdict.counterexample.empty())
    verdict.counterexample = counterexample(given, target(solution), turns);
  return reached;
}

std::string Judge::condition(const Formula& formula, const std::vector<bool>& reached) const {
  std::vector<reference::Values> values;
  for (const Place& place : places_)
    for (const reference::Values& each : place.values) values.push_back(with_signs(formula, each));
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < values.size(); ++i) outcomes.push_back({&values[i], reached[i]});
  return condition_of(outcomes, formula.of);
}

Verdict Judge::formula(std::size_t index, const Text& text) const {
  const std::string& of = arm_.formulas[index].of;
  std::set<int> known = joints_in(text);
  for (std::size_t i = 0; i < index; ++i)
    if (const int earlier = joint(arm_.formulas[i].of); earlier >= 0) known.insert(earlier);
  known.erase(joint(of));
  if (case_.robot().info.given_joint >= 0) known.insert(case_.robot().info.given_joint);
  Verdict verdict;
  std::vector<bool> reached;
  for (const Place& place : places_)
    for (std::size_t i = 0; i < place.solutions.size(); ++i)
      reached.push_back(judge(place, i, of, text, known, verdict));
  if (verdict.reached > 0 && verdict.reached < verdict.solutions)
    verdict.condition = condition(arm_.formulas[index], reached);
  return verdict;
}

bool Judge::circular(std::size_t index) const {
  std::set<int> seen;
  std::vector<int> open{joint(arm_.formulas[index].of)};
  const int start = open.front();
  while (start >= 0 && !open.empty()) {
    const int next = open.back();
    open.pop_back();
    for (const Formula& formula : arm_.formulas) {
      if (joint(formula.of) != next) continue;
      for (const int needed : joints_in(formula.printed)) {
        if (needed == start) return true;
        if (seen.insert(needed).second) open.push_back(needed);
      }
    }
  }
  return false;
}

}  // namespace qvgen::test::sources
