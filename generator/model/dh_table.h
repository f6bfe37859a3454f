// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/robot.h"

namespace qvgen::model {

/// Standard (Denavit and Hartenberg 1955): a row is Rz(theta) Tz(d) Tx(a) Rx(alpha). Modified (Craig 1986): a
/// row is Rx(alpha) Tx(a) Rz(theta) Tz(d).
enum class DhConvention { standard, modified };

/// A row of a table. The variable of `joint` is added to theta (revolute) or to d (prismatic); a row without
/// a joint is a fixed displacement.
struct DhRow {
  std::optional<std::size_t> joint;
  Expression theta, d, a, alpha;
};

/// The forward kinematics of a robot as a table: tool pose = base * rows * tool.
struct DhTable {
  DhConvention convention = DhConvention::standard;
  Displacement base;
  std::vector<DhRow> rows;
  Displacement tool;
};

}  // namespace qvgen::model
