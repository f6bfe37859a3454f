// SPDX-License-Identifier: MIT
#include "emit/c/function.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>

#include "emit/c/printer.h"
#include "emit/leaves.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "model/followers.h"

namespace qvgen::emit::c {
namespace {

using nlohmann::json;

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool names(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_name(text[at - 1])) && (end == text.size() || !is_name(text[end]))) return true;
  }
  return false;
}

/// A parameter that a robot's function does not need is still there: arms can be exchanged.
json unused(const Function& function) {
  std::vector<std::string> lines;
  for (const Parameter& parameter : function.parameters)
    if (std::none_of(function.statements.begin(), function.statements.end(),
                     [&](const std::string& statement) { return names(statement, parameter.name); }))
      lines.push_back("(void)" + parameter.name + ";");
  return lines_of(lines);
}

json doc_of(const Function& function) {
  std::vector<std::string> lines;
  for (const std::string& line : function.doc) lines.push_back("///" + (line.empty() ? "" : " " + line));
  return lines_of(lines);
}

json values_of(const Function& function) {
  std::string parameters;
  for (const Parameter& each : function.parameters)
    parameters += (parameters.empty() ? "" : ", ") + each.before + each.name + each.behind;
  return {{"function", function.name},  {"doc", doc_of(function)},
          {"parameters", parameters},   {"result", function.result},
          {"unused", unused(function)}, {"statements", lines_of(function.statements)}};
}

std::string dimension(std::size_t size) { return "[" + std::to_string(size) + "]"; }

}  // namespace

Part& Part::operator+=(const Part& more) {
  for (const auto& text : {&Part::header, &Part::source}) {
    const bool both = !(this->*text).empty() && !(more.*text).empty();
    this->*text += (both ? "\n" : "") + more.*text;
  }
  return *this;
}

Parameter joint_array(const model::Robot& robot, const std::string& name) {
  return {"const double ", name, dimension(model::driven_count(robot))};
}

Parameter geometry(const model::Robot& robot) { return {"const " + robot.name + "_geometry* ", "g"}; }

Parameter result_array(std::size_t size) { return {"double ", "result", dimension(size)}; }

Parameter result_matrix(std::size_t rows, std::size_t columns) {
  return {"double ", "result", dimension(rows) + dimension(columns)};
}

Parameter result_struct(const model::Robot& robot, const std::string& type) {
  return {robot.name + "_" + type + "* ", "result"};
}

std::vector<std::string> sine_cosine_statements(const model::Robot& robot, const dag::Function& function,
                                                const std::vector<dag::Angle>& angles) {
  const ast::Leaves leaves = robot_leaves(robot, angles);
  std::map<std::size_t, std::vector<std::string>> used;  // sine, cosine or both of an angle
  for (const auto& [place, op] : sines_and_cosines_of(function, angles))
    used[place].push_back(op == dag::Op::sine ? "s" : "c");
  std::vector<std::string> lines;
  for (const auto& [place, letters] : used) {
    const std::string name = angle_name(robot, angles[place], place);
    std::string angle = angle_code(angles[place], leaves, printer());
    if (letters.size() > 1 && angle.find(' ') != std::string::npos) {
      lines.push_back("const double a" + name + " = " + angle + ";");
      angle = "a" + name;
    }
    for (const std::string& letter : letters)
      lines.push_back("const double " + letter + name + " = " + (letter == "s" ? "sin(" : "cos(") + angle +
                      ");");
  }
  return lines;
}

std::vector<std::string> last_row(const std::string& matrix) {
  std::vector<std::string> lines;
  for (const char* column : {"0", "1", "2", "3"})
    lines.push_back(matrix + "[3][" + column + "] = " + (*column == '3' ? "1.0;" : "0.0;"));
  return lines;
}

std::vector<std::string> temporaries(const Code& code) {
  std::vector<std::string> lines;
  for (const Code::Value& value : code.temporaries)
    lines.push_back("const double " + value.name + " = " + value.expression + ";");
  return lines;
}

std::string place(const std::string& target, bool of_vector) {
  std::string text = target;
  for (std::size_t at = text.find('('); at != std::string::npos; at = text.find('(', at + 1)) {
    int row = 0, column = 0, length = 0;
    std::sscanf(text.c_str() + at, "(%d, %d)%n", &row, &column, &length);
    if (length == 0) continue;  // no entry of a matrix
    const std::string of_matrix = of_vector ? "" : "[" + std::to_string(column) + "]";
    text.replace(at, static_cast<std::size_t>(length), "[" + std::to_string(row) + "]" + of_matrix);
  }
  return text;
}

Part written(const model::Robot& robot, const std::vector<Function>& functions) {
  json values{{"name", robot.name}, {"functions", json::array()}};
  for (const Function& function : functions) values["functions"].push_back(values_of(function));
  return {render("c/functions.h", values), render("c/functions.c", values)};
}

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

}  // namespace qvgen::emit::c
