// SPDX-License-Identifier: MIT
#include "emit/kernels/device_text.h"

#include <sstream>
#include <utility>

namespace qvgen::emit::kernels {
namespace {

bool begins(const std::string& line, const std::string& with) { return line.rfind(with, 0) == 0; }

class DeviceText {
 public:
  explicit DeviceText(std::string robot) : robot_(std::move(robot)) {}

  std::string of(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) take(line);
    return kept_ + comment_;
  }

 private:
  void take(const std::string& line) {
    if (is_for_cxx_) {
      is_for_cxx_ = !begins(line, "#endif");
    } else if (is_constant_) {
      is_constant_ = line.back() != ';';
    } else if (begins(line, "#")) {
      is_for_cxx_ = begins(line, "#ifdef __cplusplus");
    } else if (begins(line, "extern const ") || begins(line, "const ")) {
      comment_.clear();
      is_constant_ = line.back() != ';';
    } else if (begins(line, "///")) {
      comment_ += line + "\n";
    } else if (!begins(line, "//") && !begins(line, "/*")) {
      keep(line);
    }
  }

  void keep(const std::string& line) {
    const bool is_function = begins(line, "void " + robot_ + "_") || begins(line, "double " + robot_ + "_");
    const bool follows_nothing = line.empty() && (kept_.empty() || kept_.substr(kept_.size() - 2) == "\n\n");
    if (!follows_nothing) kept_ += comment_ + (is_function ? "DEVICE " : "") + line + "\n";
    comment_.clear();
  }

  std::string robot_, kept_, comment_;
  bool is_for_cxx_ = false, is_constant_ = false;
};

}  // namespace

std::string device_text(const std::string& robot, const std::string& c) { return DeviceText(robot).of(c); }

}  // namespace qvgen::emit::kernels
