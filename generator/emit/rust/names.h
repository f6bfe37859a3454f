// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// Names of C in Rust's habits: a crate says the robot's name, so that no name inside repeats it.
namespace qvgen::emit::rust {

/// "ik_Target" -> "IkTarget".
std::string type_name(const std::string& name, const std::string& robot);
/// "ur5_lower_limits" -> "LOWER_LIMITS".
std::string constant_name(const std::string& name, const std::string& robot);
/// A variable, field or function; a word of the language gets an underscore.
std::string value_name(const std::string& name, const std::string& robot = "");
/// Shortest decimal text of a number of C, hexadecimal ones too, with a point: "0.5", "1e-9".
std::string real_text(const std::string& number);

}  // namespace qvgen::emit::rust
