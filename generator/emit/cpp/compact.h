// SPDX-License-Identifier: MIT
// Functions of robots of many joints, humanoids among them, in half as many bytes: numbers that come back
// have names, names are short, those used most the shortest, no spaces stand between operators, no brackets
// around the first terms of a sum, one declaration has many values, outputs are stored as soon as they are
// known, and zeros are set at once. What is computed stays the same, bit for bit. Example: `const Scalar
// t800 = t7 * Scalar(0.5);` becomes `w4=t*N(.5)` in a list.
#pragma once

#include "emit/code.h"
#include "model/robot.h"

namespace qvgen::emit {

/// True if a robot has so many coordinates, or a function so many values, that bytes count.
bool bytes_count(const model::Robot& robot, const Code& code);

/// Operations written inline in one expression of compact code.
inline constexpr int compact_inline = 8;

/// Returns code of C++ in fewer bytes: short names, no spaces; N is another name of Scalar.
Code compact(const Code& code);

/// True if the code has numbers by the short name of Scalar.
bool has_short_numbers(const Code& compact);

/// Returns references to sines and cosines, lines of `sine_cosine_declarations`, in fewer bytes; the arrays
/// are called s and c.
std::vector<std::string> compact_angles(const std::vector<std::string>& lines);

/// Returns an order of outputs, joints by joints, in which few values wait for their use: those of the last
/// joint's column and row, then those of the joint before. Values are computed when the first output needs
/// them; a humanoid's derivatives keep a quarter fewer of them in memory so.
std::vector<std::size_t> from_tips_to_base(const std::vector<std::string>& places);

/// Returns the statements that compute the values of compact code and bring outputs to their places, each
/// output as soon as what it reads is known, without the last semicolon.
std::string compact_statements(const std::vector<Code::Value>& values,
                               const std::vector<Assignment>& assignments);

/// Declarations and statements of a function, a line or more each, without semicolons.
struct Body {
  std::vector<std::string> declarations, statements;
};

/// The body that brings the outputs to their places, a line for each value, or compact.
Body body_of(const Code& code, const std::vector<std::string>& places);
Body compact_body_of(const Code& code, const std::vector<std::string>& places);

}  // namespace qvgen::emit
