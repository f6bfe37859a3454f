// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/reader.h"
#include "model/arithmetic.h"

/// Shared parts of the tests of URDF and MJCF.
namespace qvgen::description {

/// Every diagnostic on a line of its own, without the name of the file.
inline std::string report(const std::string& text, const ReadOptions& options = {}) {
  const ReadResult result = read_text(text, "r.xml", options);
  std::string all;
  bool is_error = false;
  for (const auto& diagnostic : result.diagnostics) {
    all += to_string(diagnostic).substr(6) + "\n";
    is_error = is_error || diagnostic.severity == Diagnostic::error;
  }
  EXPECT_EQ(result.robot.has_value(), !is_error);
  return all;
}

inline model::Robot read(const std::string& text, const ReadOptions& options = {}) {
  const ReadResult result = read_text(text, "r.xml", options);
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity != Diagnostic::note) ADD_FAILURE() << to_string(diagnostic);
  return result.robot.value_or(model::Robot{});
}

inline std::string texts(const model::Vector3& v) {
  return to_string(v[0]) + ", " + to_string(v[1]) + ", " + to_string(v[2]);
}

/// "0, 0, 1 by 1/2*pi" for each turn, then the translation.
inline std::string texts(const model::Displacement& displacement) {
  std::string text;
  for (const model::Turn& turn : displacement.turns)
    text += texts(turn.axis) + " by " + to_string(turn.angle) + "; ";
  return text + texts(displacement.translation);
}

/// An MJCF of hinges about z, j0, j1, ..., each a metre behind the one before, with the given references, and
/// sections behind them.
inline std::string hinges(const std::vector<double>& references, const std::string& sections) {
  std::string bodies, ends;
  for (std::size_t i = 0; i < references.size(); ++i) {
    bodies += fmt::format("<body name=\"b{}\" pos=\"1 0 0\"><joint name=\"j{}\" ref=\"{}\"/>\n", i, i,
                          references[i]);
    ends += "</body>";
  }
  return "<mujoco model=\"arm\"><compiler angle=\"radian\"/><worldbody>\n" + bodies + ends +
         "</worldbody>\n" + sections + "</mujoco>\n";
}

}  // namespace qvgen::description
