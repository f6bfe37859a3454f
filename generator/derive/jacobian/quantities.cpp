// SPDX-License-Identifier: MIT
#include "derive/jacobian/quantities.h"

#include "derive/jacobian/forms.h"
#include "derive/jacobian/rates.h"
#include "derive/kinematics/forward_kinematics.h"
#include "derive/kinematics/orientation.h"
#include "model/followers.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

std::string twist_entry(std::size_t row) { return (row < 3 ? "v" : "w") + std::to_string(row % 3 + 1); }
std::string jacobian_entry(std::size_t row, std::size_t column) {
  return twist_entry(row) + "_" + std::to_string(column + 1);
}

namespace {

std::array<ex, 6> entries(const Twist& t) {
  return {t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
}

void output(Program& program, const Columns& columns) {
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t j = 0; j < columns.size(); ++j)
      program.output(jacobian_entry(row, j), entries(columns[j])[row]);
}

void output(Program& program, const Twist& twist) {
  for (std::size_t row = 0; row < 6; ++row) program.output(twist_entry(row), entries(twist)[row]);
}

/// A column for each joint that follows none.
Columns driven(const model::Robot& robot, const Columns& columns) {
  return model::gathered(robot, columns, [](const Twist& sum, const cln::cl_RA& ratio, const Twist& column) {
    const ex factor = GiNaC::numeric(ratio);
    return Twist{sum.linear + factor * column.linear, sum.angular + factor * column.angular};
  });
}

Program program_of(const model::Robot& robot, const ColumnsForm& form) {
  Program program;
  output(program, driven(robot, form.build(program)));
  return program;
}

Columns plain_columns(const model::Robot& robot, Program& program) {
  return plain_jacobian(robot, program).columns;
}

GiNaC::exmap seeds(const model::Robot& robot) {
  GiNaC::exmap result;
  for (const model::Joint& joint : robot.joints)
    result[symbol(joint.variable)] = symbol(rate_name(joint.variable));
  return result;
}

Twist times_rates(const model::Robot& robot, const Columns& columns) {
  Twist sum;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ex rate = symbol(rate_name(robot.joints[i].variable));
    sum = {sum.linear + rate * columns[i].linear, sum.angular + rate * columns[i].angular};
  }
  return sum;
}

Columns plain_column_rates(const model::Robot& robot, Program& program) {
  const Columns columns = plain_columns(robot, program);
  const Rates rate(program, seeds(robot));
  Columns rates;
  for (const Twist& column : columns) rates.push_back({rate(column.linear), rate(column.angular)});
  return rates;
}

void add_forms(Quantity& quantity, const model::Robot& robot, const std::vector<ColumnsForm>& forms) {
  for (const ColumnsForm& form : forms) quantity.forms.push_back({form.name, program_of(robot, form)});
}

/// One form for each frame in the middle.
template <class Build>
void add_forms_by_frames(Quantity& quantity, const model::Robot& robot, const Build& build) {
  for (std::size_t middle = 0; middle < frame_count(robot); ++middle) {
    Program program;
    output(program, build(program, middle));
    quantity.forms.push_back({"by way of frame " + std::to_string(middle), program});
  }
}

void output(Program& program, const Matrix3& r, const std::string& prefix) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      program.output(prefix + "r" + std::to_string(i + 1) + std::to_string(j + 1), r[i][j]);
}

std::vector<MatrixForm> orientations(const model::Robot& robot) {
  if (const auto chain = zero_reference_chain(robot)) return matrix_forms(*chain);
  return {{"axes turned", [=](Program& program) { return orientation_by_frames(program, robot); }}};
}

/// One form for each frame in which axes are written out. The orientation is a suggestion: it holds the axes.
template <class Build>
void add_forms_by_axes(Quantity& quantity, const model::Robot& robot, const Build& build) {
  const auto matrices = orientations(robot);
  for (std::size_t frame = 0; frame < frame_count(robot); ++frame) {
    Program program;
    output(program, matrices[frame % matrices.size()].build(program), "?");
    output(program, build(program, frame));
    quantity.forms.push_back({"axes in frame " + std::to_string(frame), program});
  }
}

Program plain_tool_jacobian(const model::Robot& robot) {
  Program program;
  const PlainJacobian plain = plain_jacobian(robot, program);
  Columns columns;
  for (const Twist& column : plain.columns)
    columns.push_back(
        {rotate(inverse(plain.tool.q), column.linear), rotate(inverse(plain.tool.q), column.angular)});
  output(program, driven(robot, columns));
  return program;
}

void output(Program& program, const Matrix3& r, const Vector& p, const std::string& prefix) {
  output(program, r, prefix);
  program.output(prefix + "px", p.x);
  program.output(prefix + "py", p.y);
  program.output(prefix + "pz", p.z);
}

/// Every way to the columns, each beside another form of the rotation matrix. With a prefix of '?' the
/// matrix and the position are only suggestions: axes of the joints are among the matrix's intermediate
/// results.
std::vector<Form> forms_with_orientation(const model::Robot& robot, const std::string& prefix) {
  const auto columns = columns_by_frames(robot, Target::base);
  const std::vector<MatrixForm> matrices = orientations(robot);
  std::vector<Form> forms;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const MatrixForm& matrix = matrices[i * matrices.size() / columns.size()];
    const ColumnsForm& way = columns[i];
    Program program;
    const Linkage arm = linkage(robot);
    const Vector position = Frames(program, arm).position().value;
    output(program, matrix.build(program), position, prefix);
    output(program, driven(robot, way.build(program)));
    forms.push_back({matrix.name + ", columns " + way.name, program});
  }
  return forms;
}

}  // namespace

Program jacobian_definition(const model::Robot& robot) {
  Program program;
  output(program, driven(robot, plain_columns(robot, program)));
  return program;
}

Quantity jacobian(const model::Robot& robot) {
  Quantity quantity{"jacobian", {}, jacobian_definition(robot)};
  quantity.forms = forms_with_orientation(robot, "?");
  return quantity;
}

std::vector<Form> jacobian_methods(const model::Robot& robot) {
  std::vector<Form> methods;
  for (const ColumnsForm& method : textbook_methods(robot))
    methods.push_back({method.name, program_of(robot, method)});
  return methods;
}

Quantity tool_jacobian(const model::Robot& robot) {
  Quantity quantity{"tool_jacobian", {}, plain_tool_jacobian(robot)};
  add_forms(quantity, robot, columns_by_frames(robot, Target::tool));
  return quantity;
}

Quantity jacobian_at(const model::Robot& robot) {
  Quantity quantity = jacobian(with_free_tool_point(robot));
  quantity.name = "jacobian_at";
  return quantity;
}

Quantity transform_and_jacobian(const model::Robot& robot) {
  Quantity quantity{"forward_kinematics_and_jacobian", forms_with_orientation(robot, ""), {}};
  const PlainJacobian plain = plain_jacobian(robot, quantity.definition);
  output(quantity.definition, to_matrix(plain.tool.q), plain.tool.p, "");
  output(quantity.definition, driven(robot, plain.columns));
  return quantity;
}

Quantity velocity(const model::Robot& robot) {
  Quantity quantity{"velocity", {}, {}};
  output(quantity.definition, times_rates(robot, plain_columns(robot, quantity.definition)));
  add_forms_by_frames(quantity, robot, [&](Program& program, std::size_t middle) {
    const MovingTwist twist = twist_by_frames(program, robot, middle, false);
    return Twist{twist.linear.value, twist.angular.value};
  });
  Program program;
  const Vector linear = position_in_motion(program, robot).rate;
  output(program, Twist{linear, twist_by_frames(program, robot, 0, false).angular.value});
  quantity.forms.push_back({"derivative of the position", program});
  return quantity;
}

Quantity jacobian_rate(const model::Robot& robot) {
  Quantity quantity{"jacobian_dot", {}, {}};
  output(quantity.definition, driven(robot, plain_column_rates(robot, quantity.definition)));
  add_forms_by_frames(quantity, robot, [&](Program& program, std::size_t middle) {
    return driven(robot, column_rates_by_frames(program, robot, middle));
  });
  add_forms_by_axes(quantity, robot, [&](Program& program, std::size_t frame) {
    return driven(robot, column_rates_by_axes(program, robot, frame));
  });
  return quantity;
}

Quantity acceleration_bias(const model::Robot& robot) {
  Quantity quantity{"jacobian_dot_times_qd", {}, {}};
  output(quantity.definition, times_rates(robot, plain_column_rates(robot, quantity.definition)));
  add_forms_by_frames(quantity, robot, [&](Program& program, std::size_t middle) {
    const MovingTwist twist = twist_by_frames(program, robot, middle, true);
    return Twist{twist.linear.rate, twist.angular.rate};
  });
  add_forms_by_axes(quantity, robot, [&](Program& program, std::size_t frame) {
    return acceleration_by_axes(program, robot, frame);
  });
  Program program;
  const Vector linear = position_in_motion(program, robot).second;
  output(program, Twist{linear, twist_by_frames(program, robot, 0, true).angular.rate});
  quantity.forms.push_back({"second derivative of the position", program});
  return quantity;
}

}  // namespace qvgen::derive
