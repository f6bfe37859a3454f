// SPDX-License-Identifier: MIT
#include "printed.h"

#include <cmath>
#include <stdexcept>

#include "patterns.h"

namespace qvgen::test {
namespace {

const reference::Functions functions{{"sin", [](const auto& x) { return std::sin(x.at(0)); }},
                                     {"cos", [](const auto& x) { return std::cos(x.at(0)); }},
                                     {"sqrt", [](const auto& x) { return std::sqrt(x.at(0)); }}};

}  // namespace

std::string file_of(const std::string& robot) {
  return std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + robot + ".toml";
}

Printed::Printed(const std::vector<std::string>& lines, reference::Values known) : values_(std::move(known)) {
  for (const std::string& line : lines) read(line);
}

void Printed::read(const std::string& line) {
  if (line.rfind("  [ ", 0) == 0) return read_row(line);
  const auto equation = patterns::whole(line, R"(([A-Za-z][A-Za-z0-9_]*) =( (.*))?)");
  if (!equation) return;
  const std::string &name = equation->groups[1], &value = equation->groups[3];
  matrix_ = name;
  row_ = 0;
  if (value.empty()) return;
  if (value.front() != '[') return set(name, value);
  const auto entries = patterns::split(value.substr(2, value.size() - 4), ", ");
  if (entries.size() != 3) throw std::runtime_error("no vector: " + line);
  for (std::size_t k = 0; k < 3; ++k)
    set(name + (name.find('_') == std::string::npos ? "_" : "") + "xyz"[k], entries[k]);
}

void Printed::read_row(const std::string& line) {
  const std::string inside = line.substr(4, line.find_last_not_of(" ]") - 3);
  const auto entries = patterns::split(inside, "  +");
  ++row_;
  for (std::size_t j = 0; j < entries.size(); ++j)
    set(matrix_ + "_" + std::to_string(row_) + std::to_string(j + 1), entries[j]);
}

void Printed::set(const std::string& name, const std::string& formula) {
  values_[name] = reference::evaluate(patterns::replaced(formula, "'", "_rate"), values_, functions);
}

double Printed::at(const std::string& name) const {
  const auto place = values_.find(name);
  return place == values_.end() ? 0 : place->second;
}

reference::Vector3d Printed::vector(const std::string& name) const {
  const std::string prefix = name + (name.find('_') == std::string::npos ? "_" : "");
  return {values_.at(prefix + "x"), values_.at(prefix + "y"), values_.at(prefix + "z")};
}

reference::MatrixXd Printed::matrix(const std::string& name, int rows, int columns) const {
  reference::MatrixXd m(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      m(i, j) = at(name + "_" + std::to_string(i + 1) + std::to_string(j + 1));
  return m;
}

}  // namespace qvgen::test
