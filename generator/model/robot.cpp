// SPDX-License-Identifier: MIT
// Special members of the large value types: compiled here once, and not in each of the hundred files that
// copy robots.
#include "model/robot.h"

namespace qvgen::model {

Joint::Joint() = default;
Joint::Joint(const Joint&) = default;
Joint::Joint(Joint&&) noexcept = default;
Joint& Joint::operator=(const Joint&) = default;
Joint& Joint::operator=(Joint&&) noexcept = default;
Joint::~Joint() = default;

Motor::Motor() = default;
Motor::Motor(const Motor&) = default;
Motor::Motor(Motor&&) noexcept = default;
Motor& Motor::operator=(const Motor&) = default;
Motor& Motor::operator=(Motor&&) noexcept = default;
Motor::~Motor() = default;

Robot::Robot() = default;
Robot::Robot(const Robot&) = default;
Robot::Robot(Robot&&) noexcept = default;
Robot& Robot::operator=(const Robot&) = default;
Robot& Robot::operator=(Robot&&) noexcept = default;
Robot::~Robot() = default;

}  // namespace qvgen::model
