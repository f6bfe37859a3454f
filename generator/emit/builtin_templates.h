// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace qvgen::emit {

/// The files of templates/ by path without ".mustache", as they were when the tool was built.
const std::map<std::string, std::string>& builtin_templates();

}  // namespace qvgen::emit
