// SPDX-License-Identifier: MIT
#include "model/tasks.h"

#include "model/arithmetic.h"

namespace qvgen::model {

const std::vector<NamedTask>& named_tasks() {
  static const std::vector<NamedTask> all{{Task::pose, "pose"},
                                          {Task::position, "position"},
                                          {Task::position_and_direction, "position_and_direction"},
                                          {Task::position_and_yaw, "position_and_yaw"},
                                          {Task::position_and_pitch, "position_and_pitch"},
                                          {Task::position_and_inclination, "position_and_inclination"},
                                          {Task::direction, "direction"},
                                          {Task::orientation, "orientation"}};
  return all;
}

std::string task_name(Task task) {
  for (const NamedTask& each : named_tasks())
    if (each.task == task) return each.name;
  return {};
}

bool leaves_heading(Task task) {
  return task == Task::position_and_pitch || task == Task::position_and_inclination;
}

std::string axis_text(const Vector3& axis) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (const long sign : {1, -1}) {
      const Vector3 unit = unit_vector(i, sign);
      if (same(axis[0], unit[0]) && same(axis[1], unit[1]) && same(axis[2], unit[2]))
        return std::string(sign < 0 ? "-" : "") + "xyz"[i];
    }
  }
  return "[" + to_string(axis[0]) + ", " + to_string(axis[1]) + ", " + to_string(axis[2]) + "]";
}

}  // namespace qvgen::model
