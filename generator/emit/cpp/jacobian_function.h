// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "emit/code.h"
#include "emit/cpp/printer.h"
#include "model/robot.h"
#include "optimise/optimise.h"
#include "verify/accuracy.h"

namespace qvgen::emit {

/// A generated function of jacobian.h: what it computes and how it looks.
struct JacobianFunction {
  std::string name;
  std::string result;  ///< template of the result, one parameter Scalar
  struct Argument {
    std::string type;  ///< likewise
    std::string name;
  };
  std::vector<Argument> arguments;  ///< behind q
  std::vector<std::string> text;    ///< lines of the doc comment
  std::string last_statement;       ///< before the result is returned; may be empty
  /// Place of output `i` of the function: "result(0, 3)".
  std::vector<std::string> targets;
  optimise::Optimised optimised;
};

/// Angles whose sines and cosines any of the functions uses.
std::vector<dag::Angle> angles_of(const std::vector<JacobianFunction>& functions);

/// The code of a function whose angles these are.
Code jacobian_code(const JacobianFunction& function, const model::Robot& robot,
                   const std::vector<dag::Angle>& angles, const ast::Printer& language = plain_cpp());

/// Template values of a function. `all` are the angles of the header's JacobianAngles; `no_angles` is the
/// type of what holds the sines and cosines of a function without any.
nlohmann::json to_values(const JacobianFunction& function, const model::Robot& robot,
                         const std::vector<dag::Angle>& all,
                         const std::string& no_angles = "detail::NoAngles");

}  // namespace qvgen::emit
