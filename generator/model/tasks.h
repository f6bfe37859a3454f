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

/// True if a task says how the tool is inclined and leaves its heading, the turn about the first axis.
bool leaves_heading(Task task);

/// "z", "-x" or the entries in brackets.
std::string axis_text(const Vector3& axis);

}  // namespace qvgen::model
