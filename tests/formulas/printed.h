// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/chain.h"
#include "reference/expression.h"

namespace qvgen::test {

/// Path of the description of a robot of the library.
std::string file_of(const std::string& robot);

/// Values of formulas as they are printed for people, read by the reference's parser, line by line: each may
/// use what stands above it and nothing else. "name = formula", "name = [ x, y, z ]" (name_x, name_y,
/// name_z), and matrices with a row a line (name_11, ...). Rates are written theta1'. Other lines are words.
class Printed {
 public:
  Printed(const std::vector<std::string>& lines, reference::Values known);
  [[nodiscard]] bool has(const std::string& name) const { return values_.count(name) != 0; }
  /// 0 for entries of matrices that are not listed.
  [[nodiscard]] double at(const std::string& name) const;
  [[nodiscard]] reference::Vector3d vector(const std::string& name) const;
  [[nodiscard]] reference::MatrixXd matrix(const std::string& name, int rows, int columns) const;

 private:
  void read(const std::string& line);
  void read_row(const std::string& line);
  void set(const std::string& name, const std::string& formula);

  reference::Values values_;
  std::string matrix_;  ///< whose rows are being read
  int row_ = 0;
};

}  // namespace qvgen::test
