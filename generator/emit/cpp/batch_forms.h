// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace qvgen::emit {

/// The batch form of a generated function without branches: what goes in and out of it, as rows.
struct BatchForm {
  struct Input {
    std::string name;
    std::string rows;  ///< how many, as C++
  };

  std::string name;      ///< as operation_counts.json has it
  std::string function;  ///< as C++ has it: overloads share it
  std::string header;    ///< the part whose definitions have it
  std::vector<Input> inputs;
  std::string rows;                       ///< of the result, as C++
  std::string meaning;                    ///< of those rows, for its doc comment
  std::vector<std::string> members = {};  ///< of what the function returns, in the order of the rows; the
                                          ///< value itself if empty
  /// A function of dynamics is given the sines and cosines by the function of this name, and constants.
  std::string angles = {};
  std::string angles_header = {};  ///< the part whose definitions have that one
  std::string gravity = {};        ///< the type, as C++; empty: it takes none
  bool base_floats = false;
};

/// The batch form of the function of that name, if it can have one. `base_floats`: functions of dynamics are
/// told of the base's pose as well.
std::optional<BatchForm> batch_form(const std::string& name, bool base_floats = false);

/// Template values of batch.h and batch.cpp for these functions of a robot.
nlohmann::json batch_values(const std::string& robot, const std::vector<BatchForm>& forms);

}  // namespace qvgen::emit
