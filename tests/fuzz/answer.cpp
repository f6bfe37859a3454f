// SPDX-License-Identifier: MIT
#include "answer.h"

#include <algorithm>
#include <stdexcept>

#include "description/reader.h"
#include "pipeline/products/product.h"

namespace qvgen::test {
namespace {

void check_place(const description::Diagnostic& diagnostic, long lines) {
  const bool has_place = diagnostic.line >= 1 && diagnostic.line <= lines + 1 && diagnostic.column >= 1;
  if (!has_place || diagnostic.message.empty() || diagnostic.hint.empty())
    throw std::logic_error("a mistake without place, reason or hint: " + description::to_string(diagnostic));
}

bool generates(const model::Robot& robot) {
  pipeline::RobotOutput output{robot.name};
  for (const pipeline::Product& product : pipeline::all_products())
    if (product.part == "model" || product.part == "kinematics")
      pipeline::attempt(product.part, output,
                        [&](pipeline::RobotOutput& made) { product.generate(robot, made); });
  for (const pipeline::Missing& missing : output.missing)
    if (missing.kind == pipeline::Missing::Kind::refuted)
      throw std::logic_error("no " + missing.part + ": " + missing.reason);
  return output.missing.empty();
}

}  // namespace

Answer answer(std::string_view text, std::size_t most_joints) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const bool is_xml = start != std::string_view::npos && text[start] == '<';
  const auto result = description::read_text(text, is_xml ? "fuzz.xml" : "fuzz.toml");
  const long lines = std::count(text.begin(), text.end(), '\n') + 1;
  for (const description::Diagnostic& diagnostic : result.diagnostics) check_place(diagnostic, lines);
  if (!result.robot) {
    if (result.diagnostics.empty()) throw std::logic_error("refused without a reason");
    return Answer::refused;
  }
  if (result.robot->joints.size() > most_joints) return Answer::read;
  return generates(*result.robot) ? Answer::generated : Answer::read;
}

}  // namespace qvgen::test
