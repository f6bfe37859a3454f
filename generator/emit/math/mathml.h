// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::emit {

/// A formula in the LaTeX that this folder writes as the children of a MathML row. Throws
/// std::invalid_argument for a command that it does not know.
std::string mathml(const std::string& latex);

/// Writes a formula as an element within a line of text.
std::string inline_mathml(const std::string& latex);

/// Formulas "left = right" below each other, aligned at the sign; long sums are continued on further lines.
std::string aligned_mathml(const std::vector<std::string>& formulas);

}  // namespace qvgen::emit
