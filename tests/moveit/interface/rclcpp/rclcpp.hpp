// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <memory>
#include <string>

/// Stands in for the header of ROS 2 of this name. What is logged as an error is kept for the test.
namespace rclcpp {

class Node {
 public:
  using SharedPtr = std::shared_ptr<Node>;
};

struct Logger {
  std::string name;
};
inline Logger get_logger(const std::string& name) { return {name}; }

inline std::string last_error;

template <class... Arguments>
void log_error(const Logger& logger, const char* format, Arguments... arguments) {
  char text[500];
  std::snprintf(text, sizeof text, format, arguments...);
  last_error = logger.name + ": " + text;
}

}  // namespace rclcpp

#define RCLCPP_ERROR(logger, ...) ::rclcpp::log_error(logger, __VA_ARGS__)
