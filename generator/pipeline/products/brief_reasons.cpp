// SPDX-License-Identifier: MIT
#include "pipeline/products/brief_reasons.h"

#include <algorithm>
#include <array>

namespace qvgen::pipeline {
namespace {

/// Text before and behind the name of the choice that a reason is about, and how many rows of three joints
/// the arm has then: fewer than joints by so many. A turn that is left is one more joint.
struct Frame {
  std::string begin;
  std::string end;
  std::size_t fewer = 2;
};

const std::array<Frame, 2> frames{
    {{"with the direction of the tool's axis ", " left: ", 1}, {"with ", " given: ", 3}}};

/// "with q1 given: " and what follows.
struct Reason {
  std::string given;  ///< the joint's variable, or the axis; empty if the reason is about no choice
  std::string text;
  Frame frame = {};
};

Reason read(const std::string& line) {
  for (const Frame& frame : frames) {
    const std::size_t end = line.find(frame.end);
    if (line.rfind(frame.begin, 0) != 0 || end == std::string::npos) continue;
    return {line.substr(frame.begin.size(), end - frame.begin.size()), line.substr(end + frame.end.size()),
            frame};
  }
  return {"", line};
}

/// Returns the statement about the axes of three joints; empty if the text is about something else.
std::string of_three_axes(const std::string& text) {
  if (text.rfind("joints ", 0) != 0) return "";
  for (const char* said : {"meet in one point", "parallel"})
    if (text.ends_with(std::string(": their axes do not ") + said) ||
        text.ends_with(std::string(": their axes are not ") + said))
      return said;
  return "";
}

std::string of_all(const std::string& said) {
  return "no three axes in a row " + (said == "parallel" ? "are " + said : said);
}

/// With one line where every three joints in a row have the same to say.
std::vector<Reason> joined(const std::vector<Reason>& reasons, std::size_t joints) {
  std::vector<Reason> result;
  for (const Reason& reason : reasons) {
    const std::string said = of_three_axes(reason.text);
    const auto alike = [&](const Reason& other) {
      return other.given == reason.given && of_three_axes(other.text) == said;
    };
    const std::size_t rows = joints - reason.frame.fewer;
    const bool all = !said.empty() && std::count_if(reasons.begin(), reasons.end(), alike) ==
                                          static_cast<std::ptrdiff_t>(rows);
    const Reason line{reason.given, all ? of_all(said) : reason.text, reason.frame};
    const bool known = std::any_of(result.begin(), result.end(), [&](const Reason& other) {
      return other.given == line.given && other.text == line.text;
    });
    if (!known) result.push_back(line);
  }
  return result;
}

/// "a, b or c".
std::string one_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return text;
}

}  // namespace

std::vector<std::string> brief_reasons(const std::vector<std::string>& lines, std::size_t joints) {
  std::vector<Reason> reasons;
  for (const std::string& line : lines) reasons.push_back(read(line));
  reasons = joined(reasons, joints);
  std::vector<std::string> result;
  std::vector<std::string> told;
  for (const Reason& reason : reasons) {
    if (std::find(told.begin(), told.end(), reason.text) != told.end()) continue;
    told.push_back(reason.text);
    std::vector<std::string> given;
    for (const Reason& other : reasons)
      if (other.text == reason.text && !other.given.empty()) given.push_back(other.given);
    result.push_back((given.empty() ? "" : reason.frame.begin + one_of(given) + reason.frame.end) +
                     reason.text);
  }
  return result;
}

}  // namespace qvgen::pipeline
