// SPDX-License-Identifier: MIT
#include "emit/kernels/device_text.h"

#include <sstream>
#include <utility>

namespace qvgen::emit::kernels {
namespace {

bool begins(const std::string& line, const std::string& with) { return line.rfind(with, 0) == 0; }

/// A line that declares the sine or the cosine of an angle; empty for any other.
struct Turn {
  std::string indent, name, angle;
};

Turn turn_of(const std::string& line, const std::string& function) {
  static const std::string declared = "const double ";
  const std::size_t begin = line.find_first_not_of(' '), call = line.find(" = " + function + "(");
  if (begin == std::string::npos || line.compare(begin, declared.size(), declared) != 0) return {};
  if (call == std::string::npos || line.substr(line.size() - 2) != ");") return {};
  const std::size_t name = begin + declared.size(), angle = call + function.size() + 4;
  return {line.substr(0, begin), line.substr(name, call - name), line.substr(angle, line.size() - 2 - angle)};
}

/// The text with one call in place of a sine and the cosine of the same angle behind it.
std::string with_pairs(const std::string& text) {
  std::istringstream lines(text);
  std::string result, last;
  Turn sine;
  for (std::string line; std::getline(lines, line);) {
    const Turn cosine = sine.name.empty() ? Turn{} : turn_of(line, "cos");
    if (!cosine.name.empty() && cosine.angle == sine.angle) {
      result.resize(result.size() - last.size());
      last = sine.indent + "double " + sine.name + ", " + cosine.name + ";\n" + sine.indent + "SINCOS(" +
             sine.angle + ", " + sine.name + ", " + cosine.name + ");\n";
      sine = {};
    } else {
      sine = turn_of(line, "sin");
      last = line + "\n";
    }
    result += last;
  }
  return result;
}

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

std::string device_text(const std::string& robot, const std::string& c) {
  return with_pairs(DeviceText(robot).of(c));
}

}  // namespace qvgen::emit::kernels
