// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"

namespace qvgen::model {

/// All tasks by the names that descriptions use.
struct NamedTask {
  Task task;
  const char* name;
};
const std::vector<NamedTask>& named_tasks();
std::string task_name(Task task);

/// "z", "-x" or the entries in brackets.
std::string axis_text(const Vector3& axis);

}  // namespace qvgen::model
