// SPDX-License-Identifier: MIT
#include "emit/math/transforms.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "canonical/arm.h"
#include "dag/import.h"
#include "derive/kinematics/forward_kinematics.h"
#include "derive/kinematics/orientation.h"
#include "derive/kinematics/position.h"
#include "emit/math/lines.h"
#include "emit/math/link_matrices.h"
#include "optimise/described.h"
#include "passes/pass.h"
#include "symbolic/model.h"
#include "verify/certificate.h"

namespace qvgen::emit {
namespace {

using namespace symbolic;
using GiNaC::ex;

/// The first three rows of a homogeneous matrix.
using Cells = std::array<std::array<std::string, 4>, 3>;

Program program_of(const Matrix3& r, const Vector& p) {
  Program program;
  const std::array<ex, 3> last{p.x, p.y, p.z};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      program.output(fmt::format("r{}{}", i + 1, j + 1), j < 3 ? r[i][j] : last[i]);
  return program;
}

Cells cells_of(const dag::Function& function, Notation notation) {
  Cells cells;
  for (std::size_t i = 0; i < 12; ++i)
    cells[i / 4][i % 4] = formula(function.graph, function.outputs[i].value, notation);
  return cells;
}

/// A matrix in full angles, held against the pair that it stands for.
dag::Function certified(const LinkMatrix& matrix, const Pair& pair, const std::string& what) {
  const dag::Function function = passes::simplify(dag::import(program_of(matrix.rotation, matrix.position)));
  verify::certify(function, program_of(to_matrix(pair.q), pair.p), 2, what);
  return function;
}

dag::Function constant_factor(const model::Displacement& displacement, const std::string& what) {
  return certified(matrix_of(displacement), to_symbolic(displacement), what);
}

dag::Function link_factor(const model::Joint& joint, const std::string& what) {
  return certified(matrix_of(joint), to_symbolic(joint.before) * motion(joint) * to_symbolic(joint.after),
                   what);
}

std::optional<dag::Function> whole(const model::Robot& described) {
  const canonical::Arm arm = canonical::for_kinematics(described);
  const auto chain = derive::zero_reference_chain(arm.robot);
  if (!chain) return std::nullopt;
  Program named;
  const Matrix3 r = derive::matrix_forms(*chain).front().build(named);
  const Vector p = derive::written_out_position(*chain);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) named.output(fmt::format("r{}{}", i + 1, j + 1), r[i][j]);
  named.output("px", p.x);
  named.output("py", p.y);
  named.output("pz", p.z);
  Program written;
  for (const auto& output : named.expanded()) written.output(output.name, output.value);
  const dag::Function function = passes::simplify(dag::import(written));
  verify::certify(function, derive::plain_transform(arm.robot), 2, described.name + ": transform");
  return optimise::in_terms_of_description(function, arm);
}

/// A matrix that fits a line: entries that are too long have names, and equations below it.
struct Entries {
  Cells cells;
  std::vector<std::string> lines = {};
};

Entries short_entries(const std::string& matrix, const Cells& cells, Notation notation) {
  // Most characters of four columns in a line of LaTeX's article, and of a terminal.
  const std::size_t most = notation.typeset ? 46 : 100;
  std::array<std::size_t, 4> widths{1, 1, 1, 1};
  for (const auto& row : cells)
    for (std::size_t j = 0; j < 4; ++j) widths[j] = std::max(widths[j], width(row[j], notation));
  Entries entries{cells};
  if (widths[0] + widths[1] + widths[2] + widths[3] <= most) return entries;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      if (width(cells[i][j], notation) <= most / 4) continue;
      const std::string name = notation.typeset ? fmt::format("({})_{{{}{}}}", matrix, i + 1, j + 1)
                                                : fmt::format("{}[{},{}]", matrix, i + 1, j + 1);
      entries.cells[i][j] = name;
      for (const std::string& line : equation_lines(name, cells[i][j], notation))
        entries.lines.push_back(line);
    }
  return entries;
}

class Lines {
 public:
  explicit Lines(Notation notation) : notation_(notation), latex_(notation.typeset) {}

  /// A factor; 1 is not worth a line.
  void factor(const std::string& subscript, const Cells& cells) {
    static const Cells one{{{"1", "0", "0", "0"}, {"0", "1", "0", "0"}, {"0", "0", "1", "0"}}};
    if (cells == one) return;
    product_ += (product_.empty() ? "" : " ") + name(subscript);
    latex_ ? typeset(subscript, cells) : columns(subscript, cells);
  }
  void product(const std::optional<dag::Function>& function, Notation notation) {
    lines_.push_back(latex_ ? "\\[T = " + product_ + "\\]" : "T = " + product_);
    if (!function) return;
    if (latex_) lines_.emplace_back("\\allowdisplaybreaks\n\\begin{align*}");
    for (const dag::Output& output : function->outputs) {
      const std::string entry = (output.name[0] == 'p' ? "p_" : "r_") + output.name.substr(1);
      const std::string value = formula(function->graph, output.value, notation);
      const std::string left = latex_ ? fmt::format("{}_{{{}}}", entry[0], entry.substr(2)) : entry;
      for (const std::string& line : equation_lines(left, value, notation)) lines_.push_back(line);
    }
    if (latex_) lines_.emplace_back("\\end{align*}");
  }
  [[nodiscard]] std::vector<std::string> take() { return std::move(lines_); }

 private:
  [[nodiscard]] std::string name(const std::string& subscript) const {
    return latex_ ? "A_{" + (subscript.size() > 1 ? "\\mathrm{" + subscript + "}" : subscript) + "}"
                  : "A_" + subscript;
  }
  /// The matrix, and below it what is too long for its columns.
  void typeset(const std::string& subscript, const Cells& cells) {
    const Entries entries = short_entries(name(subscript), cells, notation_);
    lines_.push_back("\\[" + name(subscript) + " = \\begin{bmatrix}");
    for (const auto& row : entries.cells) lines_.push_back(fmt::format("{} \\\\", fmt::join(row, " & ")));
    lines_.emplace_back("0 & 0 & 0 & 1 \\end{bmatrix}\\]");
    if (entries.lines.empty()) return;
    lines_.emplace_back("\\begin{align*}");
    for (const std::string& line : entries.lines) lines_.push_back(line);
    lines_.emplace_back("\\end{align*}");
  }
  void columns(const std::string& subscript, const Cells& cells) {
    const Entries entries = short_entries(name(subscript), cells, notation_);
    lines_.push_back(name(subscript) + " =");
    std::array<std::size_t, 4> width{1, 1, 1, 1};
    for (const auto& row : entries.cells)
      for (std::size_t j = 0; j < 4; ++j) width[j] = std::max(width[j], row[j].size());
    const auto line = [&](const std::array<std::string, 4>& row) {
      lines_.push_back(fmt::format("  [ {:{}}  {:{}}  {:{}}  {:{}} ]", row[0], width[0], row[1], width[1],
                                   row[2], width[2], row[3], width[3]));
    };
    for (const auto& row : entries.cells) line(row);
    line({"0", "0", "0", "1"});
    for (const std::string& entry : entries.lines) lines_.push_back("  " + entry);
  }

  Notation notation_;
  bool latex_;
  std::string product_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> transform_lines(const model::Robot& described, Notation notation) {
  const model::Robot robot = canonical::for_dynamics(described);
  Lines lines(notation);
  const auto add = [&](const std::string& subscript, const dag::Function& function) {
    lines.factor(subscript, cells_of(optimise::with_definitions(function, robot), notation));
  };
  add("base", constant_factor(robot.base, robot.name + ": base"));
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    add(std::to_string(i + 1), link_factor(robot.joints[i], robot.name + ": link " + std::to_string(i + 1)));
  add("tool", constant_factor(robot.tool, robot.name + ": tool"));
  lines.product(whole(described), notation);
  return lines.take();
}

}  // namespace qvgen::emit
