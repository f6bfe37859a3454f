// SPDX-License-Identifier: MIT
#include "emit/math/jacobian_lines.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "emit/math/jacobian.h"
#include "emit/math/lines.h"
#include "emit/math/link_velocities.h"

namespace qvgen::emit {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t widest = 110;

class Writer {
 public:
  explicit Writer(Notation notation) : latex_(notation.typeset), notation_(notation) {}

  void title(const std::string& text) {
    if (!lines_.empty()) lines_.emplace_back();
    lines_.push_back(latex_ ? "\\paragraph{" + text + ".}" : text);
  }
  /// Formulas within the sentence differ.
  void sentence(const std::string& text, const std::string& latex) {
    lines_.push_back(latex_ ? latex : text);
  }
  void sentence(const std::string& text) { lines_.push_back(latex_ ? latex_words(text) : text); }

  void vector(const std::string& name, const std::string& index, const VectorText& v) {
    const std::string whole = name + (index.empty() ? "" : "_" + index);
    if (v[0].size() + v[1].size() + v[2].size() <= widest)
      return latex_ ? put(whole, {{v[0]}, {v[1]}, {v[2]}})
                    : lines_.push_back(fmt::format("{} = [ {}, {}, {} ]", whole, v[0], v[1], v[2]));
    Row formulas;
    for (std::size_t k = 0; k < 3; ++k) formulas.push_back(equation(component_name(name, index, k), v[k]));
    aligned(formulas);
  }
  /// As a matrix, or its entries one by one where its lines were too long.
  void matrix(const std::string& name, const std::vector<Row>& rows) {
    if (line_length(rows) <= widest) return latex_ ? put(name, rows) : columns(name, rows);
    Row formulas;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        if (rows[i][j] != "0")
          formulas.push_back(equation(fmt::format("{}_{}{}", name, i + 1, j + 1), rows[i][j]));
    aligned(formulas);
    sentence("The entries that are not listed are zero.");
  }
  void line(const std::string& name, const std::string& value) { aligned({equation(name, value)}); }
  [[nodiscard]] std::string name(const std::string& text) const { return formula(text, notation_); }
  [[nodiscard]] std::vector<std::string> take() { return std::move(lines_); }

 private:
  [[nodiscard]] std::string equation(const std::string& left, const std::string& right) const {
    return name(left) + " = " + right;
  }
  void aligned(const Row& formulas) {
    if (latex_) lines_.emplace_back("\\begin{align*}");
    for (const std::string& formula : formulas)
      if (latex_)
        for (const std::string& line : formula_lines(formula, notation_)) lines_.push_back(line);
      else
        lines_.push_back(formula);
    if (latex_) lines_.emplace_back("\\end{align*}");
  }
  void put(const std::string& left, const std::vector<Row>& rows) {
    lines_.push_back("\\[" + name(left) + " = \\begin{bmatrix}");
    for (const Row& row : rows) lines_.push_back(fmt::format("{} \\\\", fmt::join(row, " & ")));
    lines_.emplace_back("\\end{bmatrix}\\]");
  }
  static std::vector<std::size_t> widths(const std::vector<Row>& rows) {
    std::vector<std::size_t> width(rows.front().size(), 1);
    for (const Row& row : rows)
      for (std::size_t j = 0; j < row.size(); ++j) width[j] = std::max(width[j], row[j].size());
    return width;
  }
  static std::size_t line_length(const std::vector<Row>& rows) {
    const auto width = widths(rows);
    return std::accumulate(width.begin(), width.end(), 2 * width.size());
  }
  void columns(const std::string& left, const std::vector<Row>& rows) {
    const auto width = widths(rows);
    lines_.push_back(left + " =");
    for (const Row& row : rows) {
      std::string text = "  [";
      for (std::size_t j = 0; j < row.size(); ++j) text += fmt::format(" {:{}} ", row[j], width[j]);
      lines_.push_back(text + "]");
    }
  }

  bool latex_;
  Notation notation_;
  std::vector<std::string> lines_;
};

void write_links(Writer& writer, const model::Robot& robot, Notation notation) {
  writer.title("Iterative: velocities carried from link to link");
  writer.sentence(
      "omega_i: angular velocity of link i; v_i: velocity of its frame's origin; both in its frame. A prime "
      "is a\n"
      "rate, R_i and P_i are rotation and position of A_i (show --transform). From omega_0 = v_0 = 0:\n"
      "omega_i = R_i^T omega_(i-1) + z_i q_i', v_i = R_i^T (v_(i-1) + omega_(i-1) x P_i) + s_i q_i',\n"
      "with what the unit rate of joint i adds: z_i its axis (0 if it slides), s_i the origin's velocity",
      "Angular velocity $\\omega_i$ of link $i$ and velocity $v_i$ of its frame's origin, both in its "
      "frame;\n"
      "$R_i$ and $P_i$ are rotation and position of $A_i$. From $\\omega_0 = v_0 = 0$,\n"
      "$\\omega_i = R_i^T \\omega_{i-1} + z_i \\dot q_i$ and\n"
      "$v_i = R_i^T (v_{i-1} + \\omega_{i-1} \\times P_i) + s_i \\dot q_i$ with what the unit rate of joint "
      "$i$\n"
      "adds: $z_i$ its axis ($0$ if it slides), $s_i$ the origin's velocity:");
  const auto velocities = link_velocities(robot, notation);
  if (velocities.size() > robot.joints.size())
    writer.sentence(fmt::format("Link {} is the tool, fixed to the link before it.", velocities.size()));
  for (const LinkVelocity& velocity : velocities) {
    writer.vector("omega", velocity.link, velocity.angular);
    writer.vector("v", velocity.link, velocity.linear);
  }
  writer.sentence(
      "The last two, turned into the base frame by the rotation of T, are J times the joints' rates.",
      "The last two, turned into the base frame by the rotation of $T$, are $J$ times the joints' rates.");
}

void write_axes(Writer& writer, const JacobianFormulas& formulas) {
  writer.title("Vector products of axes (geometric)");
  writer.sentence(
      "z_i: axis of joint i, P_i: a point on it, P: the tool point, in the base frame. Columns of J: z_i x "
      "(P - P_i)\n"
      "over z_i if joint i turns, z_i over 0 if it slides",
      "$z_i$: axis of joint $i$, $P_i$: a point on it, $P$: the tool point, in the base frame. Columns of "
      "$J$:\n"
      "$z_i \\times (P - P_i)$ over $z_i$ if joint $i$ turns, $z_i$ over $0$ if it slides:");
  for (std::size_t i = 0; i < formulas.joints.size(); ++i) {
    const std::string index = std::to_string(i + 1);
    writer.vector("z", index, formulas.joints[i].axis);
    if (formulas.joints[i].turns) writer.vector("P", index, formulas.joints[i].point);
  }
  writer.vector("P", "", formulas.tool);
}

void write_matrix(Writer& writer, const JacobianFormulas& formulas) {
  writer.title("Differentiation");
  writer.sentence(
      "Columns of J: the derivative of P by q_i over the vector part of 2 dQ/dq_i Q^-1, Q the quaternion "
      "that\n"
      "show prints without options",
      "Columns of $J$: $\\partial P/\\partial q_i$ over the vector part of $2\\,(\\partial Q/\\partial "
      "q_i)\\,Q^{-1}$,\n"
      "$Q$ the quaternion of the tool.");
  writer.title("The Jacobian");
  writer.sentence(
      "Rows: vx, vy, vz, wx, wy, wz of the tool in the base frame. Columns: the joints, from the base.");
  std::vector<Row> rows(6);
  for (const auto& column : formulas.columns)
    for (std::size_t i = 0; i < 6; ++i) rows[i].push_back(column[i]);
  writer.matrix("J", rows);
  writer.sentence(
      "All three methods end in this matrix: computed, they are equal without error at three random points.");
}

void write_square(Writer& writer, const model::Robot& robot, Notation notation) {
  const SquarePart part = square_part(robot, notation);
  writer.title("Determinant and inverse");
  if (part.rows.empty()) return writer.sentence("No factored determinant: " + part.missing + ".");
  if (part.rows.size() < 6)
    writer.sentence(fmt::format("S: the rows {} of J.", fmt::join(part.rows, ", ")),
                    fmt::format("$S$: the rows {} of $J$.", fmt::join(part.rows, ", ")));
  const std::string square = part.rows.size() < 6 ? "S" : "J";
  writer.sentence("D: the determinant of " + square + ".", "$D$: the determinant of $" + square + "$.");
  writer.line("D", part.determinant);
  if (part.adjugate.empty())
    return writer.sentence("Inverses of more than three rows are not written out: inverse_velocity solves.");
  writer.sentence("S^-1 = K/D, where D is not 0, with", "$S^{-1} = K/D$, where $D$ is not $0$, with");
  writer.matrix("K", part.adjugate);
}

}  // namespace

std::vector<std::string> jacobian_lines(const model::Robot& described, Notation notation) {
  Writer writer(notation);
  write_links(writer, described, notation);
  const JacobianFormulas formulas = jacobian_formulas(described, notation);
  if (formulas.columns.empty()) {
    writer.title("The Jacobian");
    writer.sentence("Some neighbouring axes are neither parallel nor perpendicular: not written out.");
  } else {
    write_axes(writer, formulas);
    write_matrix(writer, formulas);
  }
  write_square(writer, described, notation);
  return writer.take();
}

}  // namespace qvgen::emit
