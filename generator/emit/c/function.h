// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/code.h"
#include "model/robot.h"

/// Functions in C99, from the graphs of the C++ ones: plain arrays, libm, no overloads. Expressions are those
/// of C++ but for their spelling.
namespace qvgen::emit::c {

/// Text of a robot's header and of its source.
struct Part {
  std::string header = {};
  std::string source = {};

  /// Puts another one behind it.
  Part& operator+=(const Part& more);
};

struct Parameter {
  std::string before;  ///< "const double "
  std::string name;
  std::string behind = {};  ///< "[6]"
};

/// A function before it is written.
struct Function {
  std::string name;              ///< behind the robot's name
  std::vector<std::string> doc;  ///< lines of its comment
  std::vector<Parameter> parameters;
  std::string result = "void";
  std::vector<std::string> statements = {};
};

/// Parameters that most functions have.
Parameter joint_array(const model::Robot& robot, const std::string& name);
Parameter geometry(const model::Robot& robot);
Parameter result_array(std::size_t size);
Parameter result_matrix(std::size_t rows, std::size_t columns);
Parameter result_struct(const model::Robot& robot, const std::string& type);

/// The sines and cosines that a function uses, as constants of the names of `emit::angle_name`.
std::vector<std::string> sine_cosine_statements(const model::Robot& robot, const dag::Function& function,
                                                const std::vector<dag::Angle>& angles);
/// Writes the last row of a homogeneous transformation: 0 0 0 1.
std::vector<std::string> last_row(const std::string& matrix);
/// "const double t0 = ...;"
std::vector<std::string> temporaries(const Code& code);
/// An entry of an Eigen matrix as one of a C array: "result(0, 1)" is result[0][1], result[0] of a vector.
std::string place(const std::string& target, bool of_vector);

/// Declarations and definitions.
Part written(const model::Robot& robot, const std::vector<Function>& functions);

void append(std::vector<std::string>& lines, const std::vector<std::string>& more);

}  // namespace qvgen::emit::c
