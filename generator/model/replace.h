// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "model/evaluate.h"
#include "model/robot.h"

namespace qvgen::model {

/// The robot with every symbol of its frames, axes and offsets replaced; parameters stay in its list.
Robot replace_symbols(const Robot& robot, const std::function<Expression(const std::string&)>& by);

/// Values of all parameters of a robot's geometry: the defaults, and numbers between 1 and 2 of those that
/// have none.
Bindings sample_geometry(const Robot& robot);

/// The robot with numbers in place of its geometry's parameters, rounded to doubles.
Robot with_geometry(const Robot& robot, const Bindings& values);

}  // namespace qvgen::model
