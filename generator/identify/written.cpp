// SPDX-License-Identifier: MIT
#include "identify/written.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <cln/integer.h>
#include <cln/rational.h>
#include <fmt/format.h>
#include <toml++/toml.h>

#include "description/write.h"
#include "description/xml/urdf_edit.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;

constexpr std::array written_keys{"mass",          "centre_of_mass",   "inertia",
                                  "rotor_inertia", "viscous_friction", "coulomb_friction"};

/// Numbers of a link as a description has them.
struct Link {
  double mass;
  Eigen::Vector3d centre;
  std::array<double, 6> inertia;  ///< about the centre: xx yy zz xy yz xz
};

/// Rotor inertia, viscous and Coulomb friction, offset.
using Drive = std::array<double, 4>;

Link numbers_of(const Eigen::VectorXd& values, Index link) {
  const auto p = values.segment<10>(10 * link);
  Link result{p[0], Eigen::Vector3d::Zero(), {}};
  if (p[0] != 0) result.centre = p.segment<3>(1) / p[0];
  const Eigen::Vector3d& c = result.centre;
  const double squares = c.squaredNorm();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Index>(k), j = (i + 1) % 3;
    result.inertia[k] = p[4 + i] - p[0] * (squares - c[i] * c[i]);
    const Index a = k == 2 ? 0 : i, b = k == 2 ? 2 : j;  // xy, yz, xz
    result.inertia[3 + k] = p[7 + i] + p[0] * c[a] * c[b];
  }
  return result;
}

/// The drive of a joint, or behind those of so many links of a motor.
Drive drive_of(const Eigen::VectorXd& values, Index unit, Index links) {
  const auto d = values.segment<4>(10 * links + 4 * unit);
  return {d[0], d[1], d[2], d[3]};
}

/// The exact value of the shortest decimals that a double is read from.
model::Expression exact(double value) {
  const std::string digits = fmt::format("{:.17e}", value);
  const std::string shortest = fmt::format("{}", value);
  const std::string& text = std::stod(shortest) == value ? shortest : digits;
  const std::size_t mark = text.find('e');
  const std::string mantissa = text.substr(0, mark);
  const long exponent = mark == std::string::npos ? 0 : std::stol(text.substr(mark + 1));
  const std::size_t point = mantissa.find('.');
  const long places = point == std::string::npos ? 0 : static_cast<long>(mantissa.size() - point - 1);
  std::string whole = mantissa;
  if (point != std::string::npos) whole.erase(point, 1);
  const cln::cl_I number = whole.c_str();
  const long shift = exponent - places;
  return model::Expression(cln::cl_RA(number) * cln::expt(cln::cl_RA(10), static_cast<int>(shift)));
}

std::string list(const double* numbers, std::size_t count, double unit = 1) {
  std::string result;
  for (std::size_t k = 0; k < count; ++k)
    result += (k > 0 ? ", " : "") + fmt::format("{}", numbers[k] / unit);
  return "[" + result + "]";
}

std::vector<std::string> lines_of(const Link& link, double unit) {
  return {fmt::format("mass = {}", link.mass), "centre_of_mass = " + list(link.centre.data(), 3, unit),
          "inertia = " + list(link.inertia.data(), 6)};
}

void add_lines(const Drive& drive, std::vector<std::string>& lines) {
  for (std::size_t k = 0; k < 3; ++k)
    if (drive[k] != 0) lines.push_back(fmt::format("{} = {}", written_keys[3 + k], drive[k]));
  if (drive[3] != 0)
    lines.push_back(fmt::format("# constant force of the drive, which no description takes: {}", drive[3]));
}

/// The text by lines, some of which go and behind some of which others come.
class Lines {
 public:
  explicit Lines(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines_.push_back(line);
  }
  void remove(std::size_t first, std::size_t last) {
    for (std::size_t line = first; line <= last; ++line) gone_.insert(line);
  }
  void insert_behind(std::size_t line, const std::vector<std::string>& more) { more_[line] = more; }
  [[nodiscard]] std::string text() const {
    std::string result;
    for (std::size_t line = 1; line <= lines_.size(); ++line) {
      if (!gone_.contains(line)) result += lines_[line - 1] + "\n";
      if (const auto more = more_.find(line); more != more_.end())
        for (const std::string& each : more->second) result += each + "\n";
    }
    return result;
  }

 private:
  std::vector<std::string> lines_;
  std::set<std::size_t> gone_;
  std::map<std::size_t, std::vector<std::string>> more_;
};

struct Region {
  std::size_t first, last;
};

Region region_of(const toml::key& key, const toml::node& value) {
  return {key.source().begin.line, std::max(key.source().end.line, value.source().end.line)};
}

/// Removes entries of a table by their keys.
template <class Keys>
void remove_entries(const toml::table& table, const Keys& keys, Lines& lines) {
  for (const auto& [key, value] : table)
    for (const auto& name : keys)
      if (key.str() == name) {
        const Region region = region_of(key, value);
        lines.remove(region.first, region.last);
      }
}

/// Last line of a table's own entries; tables in it stand behind.
std::size_t last_line(const toml::table& table) {
  std::size_t line = table.source().begin.line;
  for (const auto& [key, value] : table)
    if (const toml::table* inner = value.as_table(); inner == nullptr || inner->is_inline())
      line = std::max(line, region_of(key, value).last);
  return line;
}

/// The tables of the joints, in the order of the chain, or those of the motors. None if one is written in a
/// line.
std::vector<const toml::table*> tables_of(const toml::table& root, const std::vector<const char*>& forms) {
  std::vector<const toml::table*> tables;
  for (const char* form : forms) {
    const toml::array* array = root[form].as_array();
    if (array == nullptr) continue;
    for (const toml::node& node : *array) {
      const toml::table* table = node.as_table();
      if (table == nullptr || table->is_inline()) return {};
      const bool moves = std::strcmp(form, "dh") != 0 || table->contains("variable");
      if (moves) tables.push_back(table);
    }
  }
  return tables;
}

double unit_of(const toml::table& root) {
  const std::string unit = root["unit"].value_or(std::string("m"));
  return unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : unit == "in" ? 0.0254 : 1;
}

std::string commented(const std::string& head) {
  std::istringstream stream(head);
  std::string result;
  for (std::string line; std::getline(stream, line);) result += line.empty() ? "#\n" : "# " + line + "\n";
  return result;
}

std::string edited(const toml::table& root, const std::string& text, const model::Robot& robot,
                   const Eigen::VectorXd& values) {
  Lines lines(text);
  const auto tables = tables_of(root, {"joint", "dh", "screw"}), motors = tables_of(root, {"motor"});
  if (tables.size() != robot.joints.size() || motors.size() != robot.motors.size())
    throw std::runtime_error(
        "the joints of the description are not [[joint]], [[dh]] or [[screw]] tables of their own, or its "
        "motors no [[motor]] tables, whose lines could be changed; write them so");
  remove_entries(root, std::array{"inertia", "drives"}, lines);
  std::vector<std::string> symbols;
  for (const model::Parameter& parameter : robot.inertia_parameters) symbols.push_back(parameter.name);
  if (const toml::table* defaults = root["defaults"].as_table();
      defaults != nullptr && !defaults->is_inline())
    remove_entries(*defaults, symbols, lines);
  const auto links = static_cast<Index>(tables.size());
  for (std::size_t i = 0; i < tables.size() + motors.size(); ++i) {
    const bool is_joint = i < tables.size();
    const auto unit = static_cast<Index>(i);
    const toml::table& table = is_joint ? *tables[i] : *motors[i - tables.size()];
    remove_entries(table, written_keys, lines);
    std::vector<std::string> more;
    if (is_joint) more = lines_of(numbers_of(values, unit), unit_of(root));
    add_lines(drive_of(values, unit, links), more);
    lines.insert_behind(last_line(table), more);
  }
  return lines.text();
}

}  // namespace

model::Robot with_values(model::Robot robot, const Eigen::VectorXd& values) {
  const auto links = static_cast<Index>(robot.joints.size());
  const auto exact_drive = [&](Index unit) {
    const Drive drive = drive_of(values, unit, links);
    return model::Drive{exact(drive[0]), exact(drive[1]), exact(drive[2])};
  };
  for (Index i = 0; i < links; ++i) {
    const Link link = numbers_of(values, i);
    model::Joint& joint = robot.joints[static_cast<std::size_t>(i)];
    joint.inertia.mass = exact(link.mass);
    for (std::size_t k = 0; k < 3; ++k)
      joint.inertia.centre_of_mass[k] = exact(link.centre[static_cast<Index>(k)]);
    for (std::size_t k = 0; k < 6; ++k) joint.inertia.inertia[k] = exact(link.inertia[k]);
    joint.drive = exact_drive(i);
  }
  for (std::size_t i = 0; i < robot.motors.size(); ++i)
    robot.motors[i].drive = exact_drive(links + static_cast<Index>(i));
  robot.inertia_parameters.clear();
  return robot;
}

std::string written(const std::string& text, const model::Robot& robot, const Eigen::VectorXd& values,
                    const std::string& head) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin != std::string::npos && text[begin] == '<')
    return commented(head) + description::write_text(with_values(robot, values));
  return commented(head) + edited(toml::parse(text), text, robot, values);
}

std::string written_urdf(const std::string& text, const description::ReadOptions& options,
                         const Eigen::VectorXd& values, const std::string& head) {
  description::xml::UrdfEdit edit(text, options);
  const auto& steps = edit.steps();
  const auto links = std::count_if(steps.begin(), steps.end(), [](const auto& step) { return step.moves; });
  std::string comment = head;
  Index number = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!steps[i].moves) continue;
    const Drive drive = drive_of(values, number, links);
    const Link link = numbers_of(values, number++);
    edit.set_inertia(i, {link.mass, {link.centre[0], link.centre[1], link.centre[2]}, link.inertia});
    edit.set_friction(i, drive[1], drive[2]);
    if (drive[0] != 0 || drive[3] != 0)
      comment += fmt::format("\n{}: rotor inertia {} kg m^2 (kg), constant force of the drive {} Nm (N)",
                             steps[i].joint, drive[0], drive[3]);
  }
  edit.add_comment(comment);
  return edit.text();
}

}  // namespace qvgen::identify
